"""The facts of values with names: enums and tables of codes, and words of bits."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from fieldspec.facts.row import Cell, Kept, Row, of_fact, of_ranges, row
from fieldspec.model.device import Device
from fieldspec.model.enum import Enum, Member
from fieldspec.model.flags import Flags


def codes(device: Device, kept: Kept) -> Iterator[Row]:
    """The rows of enums and of words of flags."""
    for enum in device.enums.values():
        yield from kept.rows(enum, partial(_enum, enum))
    for word in device.flags.values():
        yield from kept.rows(word, partial(_flags, word))


def _enum(enum: Enum) -> Iterator[Row]:
    kind = "enum_value" if enum.kind == "enum" else enum.kind
    values = [member.value for member in enum.members]
    yield from of_fact("enum", enum, min=min(values, default=None), max=max(values, default=None))
    for member in enum.members:
        yield from of_fact(kind, member, code=member.value, number=member.number)
        yield from _remedies(member)


def _remedies(member: Member) -> Iterator[Row]:
    """The causes of a code, and what to do about it, in our own words."""
    path = member.place.path
    for number, cause in enumerate(member.causes):
        name, inner = f"{member.name}_cause_{number + 1}", f"{path}/causes/{number}"
        sources = cause.sources or member.sources
        yield row("cause", inner, sources, code=member.value, name=name, label=cause.cause)
        for at, remedy in enumerate(cause.remedies):
            cells: Row = {"code": member.value, "name": f"{name}_remedy_{at + 1}", "label": remedy}
            yield row("remedy", f"{inner}/remedies/{at}", sources, **cells)
    for at, remedy in enumerate(member.remedies):
        cells = {"code": member.value, "name": f"{member.name}_remedy_{at + 1}", "label": remedy}
        yield row("remedy", f"{path}/remedies/{at}", member.sources, **cells)


def _flags(word: Flags) -> Iterator[Row]:
    cells: Row = {"type": word.type.name, "bytes": word.type.size, **of_ranges(word.ranges)}
    yield from of_fact("flags", word, None, **cells)
    for bit in word.bits:
        number: Cell = bit.first if bit.width == 1 else f"{bit.first}..{bit.last}"
        yield from of_fact("bit", bit, bit=number)
    for state in word.states:
        mask, value = word.masked(state)
        yield from of_fact("state", state, code=value, bit=_bits(mask))


def _bits(mask: int) -> str:
    """The bits of a mask: `0..2, 6`."""
    bits = [bit for bit in range(mask.bit_length()) if mask >> bit & 1]
    firsts = [bit for bit in bits if bit - 1 not in bits]
    lasts = [bit for bit in bits if bit + 1 not in bits]
    return ", ".join(str(a) if a == b else f"{a}..{b}" for a, b in zip(firsts, lasts, strict=True))
