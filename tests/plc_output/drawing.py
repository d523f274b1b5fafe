"""Random bytes and values for records, near what they may be."""

from __future__ import annotations

import random
from typing import Any

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.encoding import Digits, Octets, Precision, Real, Text, Truth, Whole, bounds_of
from fieldspec.language.model.value import Value


def drawn_bytes(record: RecordLayout, dice: random.Random) -> bytes:
    """Bytes of a record with a fixed size: any, or small ones, which more often have a meaning."""
    size = record.size or 0
    if dice.random() < 0.4:
        return dice.randbytes(size)
    return bytes(dice.choice([0, 0, 0, 0, 1, 1, 2, 0x30, 0x41, 0x7F, 0x80, 0xFF]) for _ in range(size))


def drawn_values(layout: DeviceLayout, record: RecordLayout, dice: random.Random) -> dict[str, Any]:
    """Values of all fields but constants, measures and reserved ones: mostly right, now and then beside a limit."""
    if record.selector is not None:
        number = dice.choice(sorted(record.chosen))
        values = drawn_values(layout, record.chosen[number], dice)
        return {**values, record.selector.name: number}
    return {
        field.name: drawn_field(layout, field, dice)
        for field in record.fields
        if not (field.field.reserved or field.field.measures or (field.value and field.value.const is not None))
    }


def drawn_field(layout: DeviceLayout, field: FieldLayout, dice: random.Random) -> Any:
    """One value, or as many as the list may have."""
    if not field.is_list:
        return draw_value(layout, field, dice)
    repeat = field.field.repeat
    count = dice.randint(repeat.low, min(repeat.high, repeat.low + 9)) if repeat is not None else field.count or 0
    if repeat is not None and dice.random() < 0.1:
        count = repeat.high
    return [draw_value(layout, field, dice) for _ in range(count)]


def draw_value(layout: DeviceLayout, field: FieldLayout, dice: random.Random) -> Any:
    """One element."""
    if field.record is not None:
        return drawn_values(layout, field.record, dice)
    assert field.value is not None
    return drawn_value(layout, field.value, dice)


def drawn_value(layout: DeviceLayout, value: Value, dice: random.Random) -> Any:
    """One value."""
    encoding = value.encoding
    match encoding:
        case Text():
            return "".join(dice.choice("aZ09 ~") for _ in range(dice.randint(0, value.size)))
        case Octets():
            return dice.randbytes(value.size)
        case Real():
            return dice.choice([*_REALS[encoding.precision], dice.randint(-(1 << 24), 1 << 24) / 64])
        case Truth():
            return dice.random() < 0.5
        case Whole() | Digits():
            return _drawn_count(layout, value, dice)
        case _:
            assert_never(encoding)


# All are numbers of 32 bits. Of the halves, some lie in the middle of two, and the last ones are at their end.
_REALS = {
    Precision.HALF: [0.0, 1.0, -2.5, 2**-24, -(2**-25), 3 * 2**-25, 2049.0, 2051.0, 65519.0, -65504.0, 65520.0],
    Precision.SINGLE: [0.0, 1.0, -2.5, 1.0e-40, -3.0e38, 1.1754943508222875e-38],
}


def _drawn_count(layout: DeviceLayout, value: Value, dice: random.Random) -> int:
    members = [member.value for member in layout.device.enums[value.enum].members] if value.enum else []
    if members and dice.random() < 0.95:
        return dice.choice(members)
    low, high = bounds_of(value.encoding)
    if value.ranges is not None and dice.random() < 0.9:
        first, last = dice.choice(value.ranges.intervals)
        return dice.choice([first, last, dice.randint(first, last)])
    bounds = value.ranges.intervals if value.ranges else ()
    beside = [number for first, last in bounds for number in (first - 1, last + 1)]
    drawn = dice.choice(
        [low, high, 0, dice.randint(low, high), *beside, *(sentinel.value for sentinel in value.sentinels)]
    )
    return min(max(drawn, low), high)
