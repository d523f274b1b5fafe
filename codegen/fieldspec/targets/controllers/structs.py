"""Structs: of the values that programs work with, and images of what lies on the wire."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.encoding import (
    Digits,
    Octets,
    OfPrecision,
    Real,
    Text,
    Truth,
    Whole,
    has_magnitude,
    is_odd,
    is_real,
)
from fieldspec.language.model.enums import Flags
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.value import Value
from fieldspec.targets.controllers.statements.expressions import BITS, BYTE, LREAL, REAL, WORD, Type, sequence
from fieldspec.targets.controllers.statements.numbers import whole_type


def places(size: int, order: str, swapped: bool) -> list[int]:
    """By how many bits each byte of a number is moved to the left, the byte at the lowest place first."""
    steps = [8 * position for position in range(size)]
    if (order == "big") != swapped:
        steps.reverse()
    return [steps[position ^ 1] for position in range(size)] if swapped else steps


@dataclass(frozen=True, slots=True)
class StructMember:
    """A member of a struct. `remark` is what a comment says of it.

    In an image, `at` is its place in bytes after the begin of the record, and `order` and `swapped` are as in a
    layout; `bit` is its place within the byte where it is a BOOL. Elsewhere `at` is None.
    """

    name: str
    type: Type
    remark: str
    fact: Fact | None
    value: Value | None = None
    at: int | None = None
    bit: int = 0
    order: str = ""
    swapped: bool = False


@dataclass(frozen=True, slots=True)
class Struct:
    """A declared struct. `key` is the name of the record, of the group of registers, or of the data of a message.

    `kind` is record, registers, telegram, or bits for the bits of a word of flags. `size` is what it has on the wire
    in bytes, None where it holds values, or where that is not fixed.
    """

    name: str
    key: str
    kind: str
    title: str
    members: tuple[StructMember, ...]
    size: int | None = None
    fact: Fact | None = None


def wire_type(value: Value) -> Type:
    """The type with the size of a value on the wire: integers for numbers, bit strings for bits.

    A number of a width that no type has is its bytes, and so is one that is sent as digits. A number that no type has
    as it is sent is its bits.
    """
    encoding = value.encoding
    match encoding:
        case Text() | Octets() | Digits():
            return sequence(value.size, BYTE)
        case Whole():
            if is_odd(encoding):
                return sequence(value.size, BYTE)
            return BITS[value.size] if value.flags or has_magnitude(encoding) else whole_type(encoding)
        case Real():
            return _real_type(encoding.precision)
        case Truth():
            return BITS[value.size]
        case _:
            assert_never(encoding)


_real_type = OfPrecision(half=WORD, single=REAL, double=LREAL)


def bits_remark(value: Value | None) -> str:
    """The comment of an image member that has the bits of a number instead of the number; otherwise empty."""
    if value is None or is_odd(value.encoding) or value.flags:
        return ""
    is_bits = is_real(value.encoding) or has_magnitude(value.encoding)
    return f"The bits of a number: {value.type.name}." if is_bits and wire_type(value) in BITS.values() else ""


def elements(field: FieldLayout) -> int:
    """The most elements of a field."""
    repeat = field.field.repeat
    return repeat.high if repeat is not None else field.count or 1


def bit_places(size: int, order: str, swapped: bool) -> Iterator[tuple[int, int, int]]:
    """The bits of a word as they lie in its bytes: the byte, the bit in it, the bit of the word."""
    for byte, moved in enumerate(places(size, order, swapped)):
        for bit in range(8):
            yield byte, bit, moved + bit


def bit_names(flags: Flags) -> dict[int, tuple[str, Fact]]:
    """The name of each bit of a word that has one, and what states it; bits of a field have their numbers after it."""
    names: dict[int, tuple[str, Fact]] = {}
    for bit in flags.bits:
        if bit.reserved:
            continue
        for number, place in enumerate(bit.places):
            names[place] = (f"{bit.name}_{number}" if bit.width > 1 else bit.name, bit)
    return names


def fixed(record: RecordLayout) -> bool:
    """Whether a record always has the same size and no field whose type another one decides."""
    return record.size is not None and not any(field.cases for field in record.fields)
