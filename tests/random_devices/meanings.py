"""What the values of a record mean, by the reference: quantities, units, states, members, and single bits."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.codec.reference.bits import number_of_bits, unlisted_bits
from fieldspec.codec.reference.quantities import quantity, special_name
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_array, is_real, is_truth
from fieldspec.language.model.enums import Bit, Enum, Flags
from fieldspec.language.model.value import Value


@dataclass(frozen=True)
class Leaf:
    """A value of a record by its path, such as `items[0].size`, with its raw value.

    `power` is the exponent of its scale, None where that is not beside it, or stands for none.
    """

    path: str
    value: Value
    raw: Any
    order: str
    swapped: bool
    is_reserved: bool
    power: int | None = None


def leaves(record: RecordLayout, values: Mapping[str, Any], before: str = "") -> Iterator[Leaf]:
    """The values of a record, and of the records in it, as the reference has decoded them."""
    chosen = record.decided_by(values)
    for field in chosen.fields:
        items = list(enumerate(values[field.name])) if field.is_list else [(None, values[field.name])]
        for number, item in items:
            path = before + field.name + ("" if number is None else f"[{number}]")
            if field.record is not None:
                yield from leaves(field.record, item, f"{path}.")
            else:
                yield _leaf(field, path, item, _power(chosen, field, values))


def _power(record: RecordLayout, field: FieldLayout, values: Mapping[str, Any]) -> int | None:
    beside = record.named(field.value.scale_by) if field.value is not None and field.value.scale_by else None
    if beside is None or beside.value is None or beside.value.ranges is None or record.spans:
        return None
    power = values[beside.name]
    return power if power in beside.value.ranges and not special_name(beside.value, power) else None


def _leaf(field: FieldLayout, path: str, raw: Any, power: int | None) -> Leaf:
    assert field.value is not None
    return Leaf(path, field.value, raw, field.order, field.swapped, field.field.reserved, power)


@dataclass(frozen=True)
class Meaning:
    """What a raw value means.

    `exact` is the quantity, None for a special value, for words, enums, texts and bytes. `names` are the member, the
    state, or the bits that show, `others` the places of bits that are not listed. `is_member` is false for a number
    that an enum does not list, `is_within` for one outside of the printed range.
    """

    exact: Fraction | float | None = None
    names: tuple[str, ...] = ()
    others: tuple[int, ...] = ()
    is_member: bool = True
    is_within: bool = True
    state: str = ""


def meaning_of(device: Device, value: Value, raw: Any) -> Meaning:
    """What a raw value means that is not reserved."""
    encoding = value.encoding
    if is_array(encoding):
        return Meaning()
    state = special_name(value, raw) if not is_truth(encoding) and value.const is None else ""
    if state:
        return Meaning(names=(state,), state=state)
    is_within = value.ranges is None or is_truth(encoding) or raw in value.ranges
    if value.enum:
        member = device.enums[value.enum].member(int(raw))
        names = () if member is None else (member.name,)
        return Meaning(names=names, is_member=member is not None, is_within=is_within)
    if value.flags:
        word = device.flags[value.flags]
        number = raw % (1 << 8 * word.type.size)
        names = tuple(name for bit in word.bits if (name := bit_text(device.enums, word, bit, number)))
        is_sound = all(bit.ranges is None or number_of_bits(word, bit, number) in bit.ranges for bit in word.bits)
        return Meaning(names=names, others=tuple(unlisted_bits(word, number)), is_within=is_within and is_sound)
    exact = quantity(value, raw)
    return Meaning(exact=float(raw) if exact is None else exact, is_within=is_within)


def bit_text(enums: Mapping[str, Enum], word: Flags, bit: Bit, number: int) -> str:
    """How a bit, or a field of bits, of a word shows: `ready`, `mode=3`, `mode=manual`; empty where it does not."""
    own = number_of_bits(word, bit, number)
    member = enums[bit.enum].member(own) if bit.enum else None
    always = not bit.reserved and (bool(bit.enum) or bit.signed or bool(bit.unit) or bit.scale != 1 or bit.offset != 0)
    if not own and not always:
        return ""
    if member is not None:
        return f"{bit.name}={member.name}"
    return f"{bit.name}={own}" if bit.last > bit.first else bit.name


def is_nearest(value: Value, raw: float, exact: Fraction | float, number: float) -> bool:
    """Whether a number is the one nearest to a quantity; where raw * scale has more than 53 bits, one very near."""
    if isinstance(exact, float) or is_real(value.encoding):
        return number == float(exact) or (math.isnan(number) and math.isnan(exact))
    scaled = abs(raw) * Fraction(value.scale)
    size = scaled.numerator * Fraction(value.offset).denominator
    size += abs(Fraction(value.offset).numerator) * Fraction(value.scale).denominator
    if max(size, abs(raw) * Fraction(value.scale).numerator) < 1 << 53:
        return number == float(exact)
    terms = float(scaled + abs(Fraction(value.offset)))
    return math.isclose(number, float(exact), rel_tol=1e-15, abs_tol=terms * 1e-15)
