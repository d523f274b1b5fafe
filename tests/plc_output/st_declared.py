"""What declarations mean: the sizes of structs in memory, and whether initial values fit their types."""

from __future__ import annotations

import re
from typing import Any

from st_syntax import StError, Unit
from st_values import BITS, ELEMENTARY, REALS, SIGNED, SIZES, bounds

NATURAL = 8
"""The alignment of TwinCAT 3 and of CODESYS on most processors, where no pragma says another one."""

_OF = {**SIZES, **SIGNED, "bool": 1, "real": 4, "lreal": 8}
_CHARACTER = re.compile(r"\$(?:[0-9A-Fa-f]{4}|[0-9A-Fa-f]{2}|.)|[^$]", re.DOTALL)


def pack_mode(unit: Unit, struct: str) -> int:
    """The alignment that a pragma gives a struct; 0 and 1 mean none."""
    for pragma in unit.pragmas.get(struct, []):
        match = re.fullmatch(r"\{attribute 'pack_mode' := '(\d)'\}", pragma)
        if match:
            return max(1, int(match[1]))
    return NATURAL


def size_of(unit: Unit, kind: Any, pack: int = NATURAL) -> tuple[int, int]:
    """The bytes and the alignment of a type within a struct that is packed so."""
    if isinstance(kind, tuple) and kind[0] == "array":
        low, high = (end if isinstance(end, int) else end[1] for end in kind[1:3])
        size, alignment = size_of(unit, kind[3], pack)
        return size * (high - low + 1), alignment
    if isinstance(kind, tuple):
        return (kind[1][1] + 1) * (2 if kind[0] == "wstring" else 1), min(pack, 2 if kind[0] == "wstring" else 1)
    if kind in unit.structs:
        own, at, most = pack_mode(unit, kind), 0, 1
        for _, member, _ in unit.structs[kind]:
            size, alignment = size_of(unit, member, own)
            at = -(-at // alignment) * alignment + size
            most = max(most, alignment)
        return -(-at // most) * most, min(pack, most)
    size = _OF[unit.enums[kind][0] if kind in unit.enums else kind]
    return size, min(pack, size)


def check_constants(unit: Unit) -> None:
    """Refuses a constant of a type that is not declared, or whose value does not fit it."""
    for name, kind, initial in unit.globals:
        if initial is None:
            raise StError(f"{name} has no value")
        check_constant(unit, name, kind, initial)


def check_constant(unit: Unit, name: str, kind: Any, initial: Any) -> None:
    """Refuses a value that does not fit its type."""
    if isinstance(kind, tuple) and kind[0] == "array":
        low, high = kind[1][1], kind[2][1]
        if initial[0] != "list" or len(initial[1]) != high - low + 1:
            raise StError(f"{name} has not {high - low + 1} elements")
        for item in initial[1]:
            check_constant(unit, name, kind[3], item)
    elif isinstance(kind, tuple):
        text = "".join(initial[1][1:-1])
        number = len(_CHARACTER.findall(text))
        wide = {"string": "text", "wstring": "wide"}
        if initial[0] != "string" or initial[2] != wide[kind[0]] or number > kind[1][1]:
            raise StError(f"{name}: {initial[1]} is not a valid {kind[0]} of {kind[1][1]}")
        if kind[0] == "string" and not text.isascii():
            raise StError(f"{name}: {initial[1]} needs WSTRING")
    elif kind in unit.structs:
        members = {member: of for member, of, _ in unit.structs[kind]}
        if initial[0] != "fields" or set(initial[1]) != set(members):
            raise StError(f"{name}: {initial} is not a valid {kind}")
        for member, value in initial[1].items():
            check_constant(unit, f"{name}.{member}", members[member], value)
    elif kind in REALS:
        if initial[0] != "number" or not isinstance(initial[1], float):
            raise StError(f"{name}: {initial[1]} is not a literal of {kind}")
    elif kind not in ELEMENTARY or kind == "bool":
        raise StError(f"{name}: {kind} is not a type of constants")
    else:
        low, high = bounds(kind)
        if initial[0] != "number" or not isinstance(initial[1], int) or not low <= initial[1] <= high:
            raise StError(f"{name} is {initial[1]}, which {kind} does not hold")
        if kind in BITS and initial[1] < 0:
            raise StError(f"{name} is {initial[1]}, a bit string")
