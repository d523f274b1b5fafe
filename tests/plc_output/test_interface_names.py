"""Inputs and outputs of blocks have the names of one house: PLCopen's, or Siemens' for TIA Portal."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from test_named_constants import CASES, blocks

ROLES = {"INPUT": "inputVars", "OUTPUT": "outputVars", "IN_OUT": "inOutVars"}
LETTERS = r"(?:x|by|w|dw|lw|u?s?i|u?[ld]i|l?r|st|fb|[aeth])(?=[A-Z])"
"""The letters for a type that a name may begin with."""
FORMS = {"PLCopen": r"[A-Z][A-Za-z0-9]*", "Siemens": r'[a-z][A-Za-z0-9]*|"[a-z]+"'}
INSIDE = r"(?:stat|inst)[A-Z]\w*"
"""What Siemens calls the variables that a block keeps, and its instances of other blocks."""
MOTION = {
    "PLCopen": {"Done", "Busy", "Active", "CommandAborted", "Error", "ErrorID"},
    "Siemens": {"done", "busy", "active", "commandAborted", "error", "status"},
}
NAMED = re.compile(r"\b(?:FB_\w+|\w+(?:ModbusMaster|PointToPoint|Program|Input|Output)|(?<=FUNCTION_BLOCK \")\w+)\b")
MOVES = re.compile(r"(?:FB_)?[A-Za-z0-9]+_(?:Telegram\d+)?(?:Move\w+|Home|Jog|Grip|Release|RunPoint\w*|Halt)$")


def house(target: str) -> str:
    return "Siemens" if target == "scl" else "PLCopen"


def interfaces(target: str, device: str) -> Iterator[tuple[str, str, list[tuple[str, str]]]]:
    """The blocks with the variables of each role: names and types."""
    for block in blocks(target, device):
        name = NAMED.search(block)
        if name is None or re.search(r"^FUNCTION |FUNCTION F_|pouType=\"function\"", block, re.MULTILINE):
            continue
        for role, element in ROLES.items():
            if target == "plcopen":
                section = "".join(re.findall(rf"<{element}>(.*?)</{element}>", block, re.DOTALL))
                variables = re.findall(r'<variable name="(\w+)".*?<type>\s*<(.*?)/>', section, re.DOTALL)
            else:
                section = "".join(re.findall(rf"^VAR_{role}$(.*?)^END_VAR$", block, re.DOTALL | re.MULTILINE))
                variables = re.findall(r"^ +(\S+) : ([^;:]+)", section, re.MULTILINE)
            yield name[0], role, [(variable, kind.strip()) for variable, kind in variables]


@pytest.mark.parametrize(("target", "device"), CASES)
def test_inputs_and_outputs_are_called_as_the_house_calls_them(target: str, device: str) -> None:
    form = FORMS[house(target)]
    wrong = {
        (block, name)
        for block, _, variables in interfaces(target, device)
        for name, _ in variables
        if re.match(LETTERS, name) or not re.fullmatch(form, name)
    }
    assert not wrong


@pytest.mark.parametrize(("target", "device"), CASES)
def test_names_of_a_block_differ_in_more_than_their_capitals(target: str, device: str) -> None:
    names: dict[str, list[str]] = {}
    for block, _, variables in interfaces(target, device):
        names.setdefault(block, []).extend(name.lower() for name, _ in variables)
    assert names
    assert [block for block, its in names.items() if len(set(its)) < len(its)] == []


@pytest.mark.parametrize(("target", "device"), CASES)
def test_a_block_that_moves_says_how_it_is_in_the_words_of_the_house(target: str, device: str) -> None:
    outputs = {
        block: {name for name, _ in variables}
        for block, role, variables in interfaces(target, device)
        if role == "OUTPUT" and MOVES.search(block)
    }
    assert outputs
    assert {
        block: MOTION[house(target)] - names for block, names in outputs.items() if MOTION[house(target)] - names
    } == {}


@pytest.mark.parametrize("device", sorted({case.values[1] for case in CASES}))
def test_a_block_for_tia_portal_has_a_word_for_its_status_and_no_other_number(device: str) -> None:
    outputs = {block: dict(variables) for block, role, variables in interfaces("scl", device) if role == "OUTPUT"}
    with_error = {block: kinds for block, kinds in outputs.items() if "error" in kinds and "_" in block}
    assert with_error
    assert {kinds["status"] for kinds in with_error.values()} == {"WORD"}
    assert [block for block, kinds in outputs.items() if "errorid" in map(str.lower, kinds)] == []


@pytest.mark.parametrize("device", sorted({case.values[1] for case in CASES}))
def test_what_a_block_for_tia_portal_keeps_is_called_static_or_instance(device: str) -> None:
    texts = [block for block in blocks("scl", device) if re.match(r'FUNCTION_BLOCK "\w+_', block)]
    inside = [
        name
        for block in texts
        for section in re.findall(r"^VAR$(.*?)^END_VAR$", block, re.DOTALL | re.MULTILINE)
        for name in re.findall(r"^ +(\S+) : ", section, re.MULTILINE)
    ]
    assert inside
    assert [name for name in inside if not re.fullmatch(INSIDE, name)] == []
