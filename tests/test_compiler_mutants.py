"""Mutants of the compiler are noticed: a fixed sample of what `make mutants-compiler` tries, by the nearest tests."""

from __future__ import annotations

from pathlib import Path

import pytest

from compiler_judges import GUIDE, PACKAGE, Copy, call, commands, folders, main, rows
from compiler_mutants import Mutant, Source, changeable, mutants, sample
from proofs import share

CODE = b'''
def word(low, high):
    """A text."""
    if low in (1, 2) and not high:
        return [low + high]
    send(zip(low, high, strict=True))
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


@pytest.mark.proof
def test_every_mutant_can_be_compiled_and_differs() -> None:
    for mutant in share(mutants(PACKAGE, "codec/reference"), 60):
        source = (PACKAGE / mutant.path).read_bytes()
        assert mutant.applied(source) != source
        compile(mutant.applied(source), mutant.path, "exec")


def test_tests_are_named_for_every_module_that_can_be_changed() -> None:
    paths = {path for folder in folders() for path in changeable(PACKAGE, folder)}
    assert sorted(path for path in paths if not commands(path)) == []


def test_every_folder_and_test_in_the_table_is_there() -> None:
    for places, named in rows(GUIDE.read_text("utf-8")):
        folders_of_modules = set(places) - {"docs/", "extension/"}
        assert sorted(place for place in folders_of_modules if not (PACKAGE / place).exists()) == []
        for command in named:
            call(command, "memory")


TABLE = """
| you change | run | seconds |
|---|---|---|
| `codec/layout/`, `codegen/fieldspec/cli.py` | `make accept`, then `pytest tests/test_bits.py tests/test_c*s.py` | 9 |
| `codec/layout/inner/` and what uses it | `python tests/recorded_outputs.py c`, then `pytest tests/test_bits.py` | 9 |
"""


@pytest.mark.parametrize(
    ("path", "named"),
    [
        ("codec/layout/a.py", ["pytest tests/test_bits.py tests/test_c*s.py"]),
        ("cli.py", ["pytest tests/test_bits.py tests/test_c*s.py"]),
        ("codec/layout/inner/deep/a.py", ["python tests/recorded_outputs.py c", "pytest tests/test_bits.py"]),
        ("codec/layouts/a.py", []),
        ("codec/inner/layout/a.py", []),
    ],
)
def test_the_row_of_the_nearest_folder_says_who_judges_a_module(path: str, named: list[str]) -> None:
    assert commands(path, TABLE) == named


def test_a_folder_without_named_tests_does_not_pass(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    guide = tmp_path / "CONTRIBUTING.md"
    guide.write_text(TABLE, "utf-8")
    monkeypatch.setattr("compiler_judges.GUIDE", guide)
    assert main(1, 1, names=["codec/reference"]) == 1
    assert "names no tests for: codec/reference/" in capsys.readouterr().out


def test_a_folder_that_is_not_there_does_not_pass(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(1, 1, names=["referenc"]) == 1
    assert "names no tests for: referenc\n" in capsys.readouterr().out


def test_the_same_seed_gives_the_same_mutants() -> None:
    assert (
        sample(PACKAGE, "codec/layout", 5, 1)
        == sample(PACKAGE, "codec/layout", 5, 1)
        != sample(PACKAGE, "codec/layout", 5, 2)
    )


def test_a_mutant_is_noticed_and_the_right_compiler_is_not(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    command = "pytest tests/test_checksums.py"
    monkeypatch.setattr("compiler_judges.commands", lambda path: [command])
    copy, path = Copy(tmp_path), "codec/reference/checksums.py"
    source = (PACKAGE / path).read_bytes()
    mutant = next(mutant for mutant in Source(path, source).mutants() if mutant.kind == "condition")
    assert copy.judge("codec/reference", mutant).judge == command
    assert (copy.package / path).read_bytes() == source
    assert not copy.fails(command, str(tmp_path / "memory"))


def test_a_command_that_refuses_the_right_compiler_does_not_pass(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("compiler_judges.commands", lambda path: ["python -c raise"])
    assert main(1, 1, names=["codec/reference"]) == 1
    assert capsys.readouterr().out == "fails without a mutant too: python -c raise\n"
