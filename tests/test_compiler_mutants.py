"""Mutants of the compiler are noticed: a fixed sample of what `make mutants-compiler` tries, by the nearest tests."""

from __future__ import annotations

from pathlib import Path

from compiler_judges import JUDGES, PACKAGE, Copy, calls
from compiler_mutants import Mutant, Source, mutants, sample

CODE = b'''
def word(low, high):
    """A text."""
    if low in (1, 2) and not high:
        return [low + high]
    send(low)
    return None
'''


def texts(mutant: Mutant) -> str:
    """The line that a mutant changes."""
    return mutant.applied(CODE).decode().splitlines()[mutant.line - 1].strip()


def test_every_condition_number_operator_and_statement_has_a_mutant() -> None:
    assert sorted(texts(mutant) for mutant in Source("x.py", CODE).mutants()) == [
        "if ((low in (1, 2)) or (not high)):",
        "if (not (low in (1, 2) and not high)):",
        "if low in ((2), 2) and not high:",
        "if low in (1, (3)) and not high:",
        "if low in (1, 2) and (high):",
        "if low not in (1, 2) and not high:",
        "pass",
        "return None",
        "return [low - high]",
    ]


def test_every_mutant_can_be_compiled_and_differs() -> None:
    for mutant in mutants(PACKAGE, "reference"):
        source = (PACKAGE / mutant.path).read_bytes()
        assert mutant.applied(source) != source
        compile(mutant.applied(source), mutant.path, "exec")


def test_every_part_that_says_what_bytes_mean_has_judges() -> None:
    parts = {"reading", "checks", "layout", "changes", "reference", "proofs", "model", "plc"}
    backends = {f"backends/{path.parent.name}" for path in PACKAGE.glob("backends/*/backend.py")}
    assert set(JUDGES) == parts | backends


def test_the_same_seed_gives_the_same_mutants() -> None:
    assert sample(PACKAGE, "layout", 5, 1) == sample(PACKAGE, "layout", 5, 1) != sample(PACKAGE, "layout", 5, 2)


def test_a_mutant_is_noticed_and_the_right_compiler_is_not(tmp_path: Path) -> None:
    copy, path = Copy(tmp_path), "reference/checksums.py"
    source = (PACKAGE / path).read_bytes()
    mutant = next(mutant for mutant in Source(path, source).mutants() if mutant.kind == "condition")
    assert copy.judge("reference", mutant).judge != ""
    assert (copy.package / path).read_bytes() == source
    _, call = next(iter(calls("reference", path)))
    assert not copy.fails(call)
