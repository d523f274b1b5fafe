"""The functions in SCL are typed as strictly as those in Structured Text, and do the same with the same values."""

from __future__ import annotations

import random
import re
import sys
from functools import cache
from pathlib import Path
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from compiled import Compiled
from loaded import REAL, program_of, programs
from scans import of_siemens
from st_machine import Machine
from st_syntax import parsed
from st_values import WHOLE, MachineError, bounds
from standard_text import named, without_comments

from fieldspec.targets.scl.backend import files
from fieldspec.targets.st.backend import text
from layouts import SPECS, newest

TRIES = 20
PADDING = "abypadding"
"""How the members begin that only Structured Text has, to fill up gaps."""


def siemens_text(device: str) -> str:
    """The types and functions for TIA Portal as Structured Text."""
    result = {path: content for path, content in files([newest(SPECS, device)]).items() if isinstance(content, str)}
    source = "".join(
        of_siemens(content.lstrip("\ufeff").replace("\r\n", "\n"))
        for kind in (".udt", ".scl")
        for path, content in result.items()
        if path.endswith((".udt", "_functions.scl")) and path.endswith(kind)
    )
    for mine, theirs in (("VAR_TEMP", "VAR"), ("SHL(IN := ", "SHL("), ("SHR(IN := ", "SHR("), (", N := ", ", ")):
        source = source.replace(mine, theirs)
    return source


@cache
def siemens(device: str) -> Machine:
    """The same, ready to run; that they can be loaded means that their types agree."""
    return Machine(parsed(siemens_text(device)))


def compiled_siemens(device: str, folder: Path) -> Compiled:
    """The same, compiled; texts of codes, which no function uses, are left out."""
    text = without_comments(siemens_text(device))
    text = re.sub(r"^TYPE \w+CodeText :.*?^END_TYPE$", "", text, flags=re.MULTILINE | re.DOTALL)
    # SCL takes a reserved word in quotes for a name.
    text = re.sub(r"\bon\b", "onMember", text).replace("TON_TIME", "TON")
    return Compiled(named(text), folder, unit=parsed(text))


@cache
def structured(device: str) -> Machine:
    """The same functions in Structured Text."""
    return Machine(parsed(text(program_of(SPECS, device))))


def shape(machine: Machine, kind: Any) -> Any:
    """A type without names: what it holds, in order. Enums are their numbers."""
    kind = machine.kind(kind)
    if isinstance(kind, tuple) and kind[0] == "array":
        return ("array", kind[1], kind[2], shape(machine, kind[3]))
    if kind in machine.unit.structs:
        members = machine.unit.structs[kind]
        return ("struct", *(shape(machine, of) for name, of, _ in members if not name.startswith(PADDING)))
    return machine.unit.enums[kind][0] if kind in machine.unit.enums else kind


def drawn(form: Any, dice: random.Random) -> Any:
    """A value of a shape: often a small one, since ranges begin there."""
    if isinstance(form, tuple):
        if form[0] == "array":
            return [drawn(form[3], dice) for _ in range(form[1], form[2] + 1)]
        return [drawn(item, dice) for item in form[1:]]
    if form == "bool":
        return dice.random() < 0.5
    if form in WHOLE:
        low, high = bounds(form)
        return dice.choice([0, 1, dice.randint(0, min(60, high)), dice.randint(low, high)])
    return dice.choice([0.0, 1.5, dice.uniform(-1e4, 1e4)])


def put(machine: Machine, kind: Any, value: Any) -> Any:
    """A value with the names that a type gives to its members."""
    kind = machine.kind(kind)
    if isinstance(kind, tuple) and kind[0] == "array":
        return [put(machine, kind[3], item) for item in value]
    if kind in machine.unit.structs:
        left = iter(value)
        members = machine.unit.structs[kind]
        return {
            name: machine.fresh(of) if name.startswith(PADDING) else put(machine, of, next(left))
            for name, of, _ in members
        }
    return value


def bare(value: Any) -> Any:
    """A value without names."""
    if isinstance(value, dict):
        return [bare(item) for name, item in value.items() if not name.startswith(PADDING)]
    return [bare(item) for item in value] if isinstance(value, list) else value


def parameters(machine: Machine, name: str) -> list[tuple[str, Any, Any]]:
    """What a function is given and lent: name, type and shape."""
    function = machine.unit.functions[name]
    value = [(variable, kind) for role, variable, kind, _ in function.variables if role in ("VAR_INPUT", "VAR_IN_OUT")]
    return [(variable, kind, shape(machine, kind)) for variable, kind in value]


def run(machine: Machine, name: str, values: list[Any]) -> tuple[Any, Any]:
    """What a function gives, and what it leaves in what it was lent; or that the values made it fail.

    The values, and those left, are in the order of the parameters, which have other names in each language.
    """
    named_values = zip(parameters(machine, name), values, strict=True)
    value = {text: put(machine, kind, item) for (text, kind, _), item in named_values}
    try:
        return machine.call(name, **value), bare([*value.values()])
    except MachineError as error:
        return str(error), None


@pytest.mark.proof(1)
@pytest.mark.parametrize("device", REAL)
def test_scl_does_what_structured_text_does(device: str) -> None:
    ours, theirs, dice, compared = structured(device), siemens(device), random.Random(device), 0
    # TIA Portal has the same names, without the letter for a function.
    by_name = {name.removeprefix("f_"): name for name in ours.unit.functions}
    for name in sorted(by_name.keys() & theirs.unit.functions.keys()):
        forms = [form for _, _, form in parameters(ours, by_name[name])]
        if forms != [form for _, _, form in parameters(theirs, name)]:
            continue
        compared += 1
        for _ in range(TRIES):
            values = [drawn(form, dice) for form in forms]
            assert run(ours, by_name[name], values) == run(theirs, name, values), (name, values)
    # Whole numbers of 64 bits are split in two there.
    shared = [name for name in theirs.unit.functions if not name.endswith("_statusword")]
    assert compared >= len(shared) - 1


@pytest.mark.proof(1)
@pytest.mark.parametrize("device", REAL)
def test_compiled_scl_does_what_interpreted_scl_does(device: str, tmp_path_factory: pytest.TempPathFactory) -> None:
    ours, theirs = siemens(device), compiled_siemens(device, programs(tmp_path_factory))
    dice = random.Random(device)
    succeeded = 0
    for name in sorted(ours.unit.functions):
        forms = [form for _, _, form in parameters(ours, name)]
        for _ in range(TRIES):
            values = [drawn(form, dice) for form in forms]
            expected = run(ours, name, values)
            # What makes the interpreter fail, such as an index outside an array, is not a call that a program makes.
            if expected[1] is not None:
                succeeded += 1
                assert run(theirs, name, values) == expected, (name, values)
    assert succeeded > 10 * len(ours.unit.functions)
