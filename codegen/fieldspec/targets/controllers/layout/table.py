"""The members of a struct in memory as rows of a table."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from fieldspec.foundation.spreadsheet import Cell
from fieldspec.targets.controllers.layout.fitting import direct
from fieldspec.targets.controllers.layout.memory import Placed, PlacedMember
from fieldspec.targets.controllers.statements.expressions import ArrayType, Elementary, EnumType, StructType, Type

COLUMNS = ("struct", "member", "type", "byte", "bit", "size", "elements", "stride", "wire_byte", "read")
"""The columns of a file: places and sizes in bytes; `wire_byte` and `read` only of images."""


def table(structs: Iterable[Placed]) -> list[Sequence[Cell]]:
    """The heading, then for each struct a row with its size and one for each member; no bits within other structs."""
    rows: list[Sequence[Cell]] = [COLUMNS]
    for placed in structs:
        rows.append(
            (type_name(StructType(placed.struct.name)), None, "STRUCT", 0, None, placed.size, None, None, None, None)
        )
        rows += [(type_name(StructType(placed.struct.name)), *row) for row in member_rows(placed, bits=False)]
    return rows


def member_rows(placed: Placed, bits: bool = True) -> Iterator[tuple[Cell, ...]]:
    """For each member its path, type, byte, bit, size, elements, bytes from one to the next, and how it lies there."""
    wires = wire_bytes(placed)
    for path, offset, placed_member in placed.rows(bits=bits):
        repetition = (placed_member.count, placed_member.stride) if placed_member.is_array else (None, None)
        size = placed_member.size or None
        yield (
            path,
            type_name(placed_member.member.type),
            offset,
            placed_member.bit,
            size,
            *repetition,
            wires.get(path),
            read(placed, placed_member),
        )


def wire_bytes(placed: Placed, before: str = "", start: int = 0) -> dict[str, int]:
    """Where the members of an image lie on the wire, by their paths; nothing for another struct."""
    places: dict[str, int] = {}
    for placed_member in placed.members:
        if placed_member.member.at is not None:
            path = f"{before}{placed_member.member.name}"
            places[path] = start + placed_member.member.at
            if placed_member.inner is not None:
                inner = f"{path}[]." if placed_member.is_array else f"{path}."
                places |= wire_bytes(placed_member.inner, inner, start + placed_member.member.at)
    return places


def read(placed: Placed, placed_member: PlacedMember) -> str:
    """The conversion of a program that reads a number of an image."""
    if placed_member.member.at is None or placed_member.inner is not None:
        return ""
    if direct(placed, placed_member):
        return "as it lies"
    return "swap words" if placed_member.member.order == placed.memory.order else "swap bytes"


def type_name(kind: Type) -> str:
    """The name of a type without a dialect: `ARRAY[0..3] OF INT`"""
    if isinstance(kind, ArrayType):
        return f"ARRAY[{kind.low}..{kind.high}] OF {type_name(kind.of)}"
    return kind.name if isinstance(kind, Elementary | EnumType) else kind.name.strip('"')
