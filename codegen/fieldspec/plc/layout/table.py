"""The members of a struct in memory as rows of a table."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from fieldspec.plc.layout.fitting import direct
from fieldspec.plc.layout.memory import Placed, PlacedMember
from fieldspec.plc.routines.expressions import ArrayType, Elementary, EnumType, StructType, Type
from fieldspec.spreadsheet import Cell

COLUMNS = ("struct", "member", "type", "byte", "bit", "size", "elements", "stride", "wire_byte", "read")
"""The columns of a file: places and sizes in bytes; `wire_byte` and `read` only of images."""


def table(structs: Iterable[Placed]) -> list[Sequence[Cell]]:
    """The heading, then for each struct a row with its size and one for each member; no bits within other structs."""
    rows: list[Sequence[Cell]] = [COLUMNS]
    for one in structs:
        rows.append((type_name(StructType(one.struct.name)), None, "STRUCT", 0, None, one.size, None, None, None, None))
        rows += [(type_name(StructType(one.struct.name)), *row) for row in member_rows(one, bits=False)]
    return rows


def member_rows(placed: Placed, bits: bool = True) -> Iterator[tuple[Cell, ...]]:
    """For each member its path, type, byte, bit, size, elements, bytes from one to the next, and how it lies there."""
    wires = wire_bytes(placed)
    for path, at, one in placed.rows(bits=bits):
        listed = (one.count, one.stride) if one.is_array else (None, None)
        size = one.size or None
        yield path, type_name(one.member.type), at, one.bit, size, *listed, wires.get(path), read(placed, one)


def wire_bytes(placed: Placed, before: str = "", start: int = 0) -> dict[str, int]:
    """Where the members of an image lie on the wire, by their paths; nothing for another struct."""
    found: dict[str, int] = {}
    for one in placed.members:
        if one.member.at is not None:
            path = f"{before}{one.member.name}"
            found[path] = start + one.member.at
            if one.inner is not None:
                inner = f"{path}[]." if one.is_array else f"{path}."
                found |= wire_bytes(one.inner, inner, start + one.member.at)
    return found


def read(placed: Placed, one: PlacedMember) -> str:
    """What a program does to read a number of an image."""
    if one.member.at is None or one.inner is not None:
        return ""
    if direct(placed, one):
        return "as it lies"
    return "swap words" if one.member.order == placed.memory.order else "swap bytes"


def type_name(kind: Type) -> str:
    """`ARRAY[0..3] OF INT`"""
    if isinstance(kind, ArrayType):
        return f"ARRAY[{kind.low}..{kind.high}] OF {type_name(kind.of)}"
    return kind.name if isinstance(kind, Elementary | EnumType) else kind.name.strip('"')
