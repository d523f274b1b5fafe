"""The text of external sources of TIA Portal, read without any knowledge of the compiler."""

from __future__ import annotations

import re
from dataclasses import dataclass

_TYPE = re.compile(r'^TYPE "([^"]+)"\nVERSION : 0\.1\n   STRUCT\n(.*?)   END_STRUCT;\n\nEND_TYPE$', re.M | re.S)
_BLOCK = re.compile(r'^DATA_BLOCK "([^"]+)"\n(.*?)^END_DATA_BLOCK$', re.M | re.S)
_MEMBER = re.compile(r'      ("?)(\w+)\1 : ([^;]+);(?:   // (.*))?')
_ARRAY = re.compile(r"ARRAY\[0\.\.(\d+)\] OF (.+)")

# The types of STEP 7 as wide as those that it lacks: its memory is the same.
_SIGNED_TYPES = {"UINT": "INT", "UDINT": "DINT", "USINT": "BYTE", "SINT": "BYTE"}
WIDTHS = {"BYTE": 1, "INT": 2, "WORD": 2, "DINT": 4, "DWORD": 4, "REAL": 4}


@dataclass(frozen=True)
class Member:
    """A member of a type as it is written, with its comment."""

    name: str
    type: str
    comment: str


def types(text: str) -> dict[str, list[Member]]:
    """The types of a source by name, in its order."""
    name = text.removeprefix("\ufeff").replace("\r\n", "\n")
    members: dict[str, list[Member]] = {}
    for match in _TYPE.finditer(name):
        lines = [_MEMBER.fullmatch(line) for line in match[2].splitlines()]
        assert all(lines), match[1]
        members[match[1]] = [Member(line[2], line[3], line[4] or "") for line in lines if line]
    assert len(members) == name.count("\nTYPE ")
    return members


def blocks(text: str) -> dict[str, str]:
    """The data blocks of a source by name."""
    name = text.removeprefix("\ufeff").replace("\r\n", "\n")
    return {match[1]: match[2] for match in _BLOCK.finditer(name)}


def step7(name: str, members: dict[str, list[Member]], values: dict[str, int], path: str = "") -> list[str]:
    """The members of a type in STEP 7's own form, types written out, with initial values by their paths."""
    lines = []
    # It takes names of at most 24 characters.
    for at, member in enumerate(members[name]):
        inner = member.type.strip('"')
        array = _ARRAY.fullmatch(member.type)
        where = f"{path}{member.name}"
        if inner in members:
            lines += [f"m{at} : STRUCT", *step7(inner, members, values, f"{where}."), "END_STRUCT;"]
        elif array:
            twin = _SIGNED_TYPES.get(array[2], array[2])
            count = int(array[1]) + 1
            text = ", ".join(_literal(twin, values.get(f"{where}[{number}]", 0)) for number in range(count))
            lines.append(f"m{at} : ARRAY[0 .. {array[1]}] OF {twin} := {text};")
        else:
            twin = _SIGNED_TYPES.get(member.type, member.type)
            lines.append(f"m{at} : {twin} := {_literal(twin, values.get(where, 0))};")
    return lines


def _literal(kind: str, value: int) -> str:
    if kind == "BOOL":
        return "TRUE" if value else "FALSE"
    width = WIDTHS[kind]
    bits = value % (1 << 8 * width)
    if kind == "INT":
        return str(bits - (1 << 16) if bits >> 15 else bits)
    if kind == "DINT":
        return f"L#{bits - (1 << 32) if bits >> 31 else bits}"
    return f"{ {1: 'B', 2: 'W', 4: 'DW'}[width] }#16#{bits:X}"
