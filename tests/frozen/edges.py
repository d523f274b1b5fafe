"""The edges of a value: ends of ranges and one beyond, special values, all ones, sign bits, NaN and infinities."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.language.model.device import Device
from fieldspec.language.model.digits import digit_bounds, digits_bytes
from fieldspec.language.model.encoding import (
    Precision,
    Real,
    is_array,
    is_octets,
    is_real,
    is_signed,
    is_text,
    is_truth,
    real_bits,
)
from fieldspec.language.model.value import Value

Place = tuple[int, Value, str, bool]
"""Where a value is in the data of a record, the value, its byte order, and whether its words are swapped."""

_MEMBERS = 8
"""Members of an enum that are edges, from each of its ends."""
_ELEMENTS = 2
"""Elements of a list whose edges are tried."""
_REALS = (
    0.0,
    -0.0,
    1.0,
    -1.5,
    1e-45,
    5e-324,
    3.4028234663852886e38,
    3.5e38,
    1.7976931348623157e308,
    math.inf,
    -math.inf,
)
_PATTERNS = {
    Precision.HALF: ("7e00", "7c01", "fe12", "7c00", "fc00", "0001", "8000", "7bff"),
    Precision.SINGLE: ("7fc00000", "7f800001", "ffc12345", "7f800000", "ff800000", "00000001", "80000000", "7f7fffff"),
    Precision.DOUBLE: (
        *("7ff8000000000000", "7ff0000000000001", "fff8000000012345"),
        *("7ff0000000000000", "0000000000000001"),
    ),
}
"""Bits of NaN, of infinities, and of the least and the greatest numbers."""


def edge_numbers(device: Device, value: Value) -> list[Any]:
    """The raw values at the edges of a value, also such as it cannot have."""
    encoding = value.encoding
    if is_text(encoding):
        return ["", "A" * value.size, "A" * (value.size + 1), " A ", "A\0B", "\xe4", "\u20ac", "\r\n", "\x7f"]
    if is_octets(encoding):
        return [bytes(value.size), b"\xff" * value.size, bytes(value.size + 1), bytes(max(0, value.size - 1))]
    intervals = [interval for ranges in (value.ranges, value.write_ranges) if ranges for interval in ranges.intervals]
    ends = [end for interval in intervals for end in interval]
    special = [sentinel.value for sentinel in value.sentinels if not sentinel.is_nan]
    if is_real(encoding):
        near = [other for end in ends for other in (end, math.nextafter(end, -math.inf), math.nextafter(end, math.inf))]
        return [float(number) for number in (*near, *special, *_REALS, math.inf, -math.inf, math.nan)]
    if is_truth(encoding):
        return [False, True]
    members = [member.value for member in device.enums[value.enum].members] if value.enum else []
    numbers = [*ends, *special, value.type.low, value.type.high, value.low, value.high, 0]
    numbers += [number for number in (value.const, value.default) if isinstance(number, int)]
    numbers += [*members[:_MEMBERS], *members[-_MEMBERS:]]
    if value.digits:
        numbers += digit_bounds(value)
    if value.flags:
        numbers += [1 << bit for bit in range(8 * value.type.size - is_signed(value.encoding))]
    return sorted({other for number in numbers for other in (number - 1, number, number + 1)})


def edge_data(device: Device, value: Value, order: str, swapped: bool) -> list[bytes]:
    """The bytes of the edges of a value, and bytes that are all zeros, all ones, or a sign alone."""
    size, encoding = value.size, value.encoding
    ones = b"\xff" * size
    patterns = [bytes(size), ones, b"\x80" + bytes(size - 1), b"\x7f" + ones[1:], bytes(size - 1) + b"\x01"]
    if is_array(encoding):
        return [*patterns, b"A" * size, b"A".ljust(size, b"\0"), b"A".ljust(size), b" " * size]
    if isinstance(encoding, Real):
        numbers = [number for number in edge_numbers(device, value) if _fits(encoding.precision, number)]
        patterns += [real_bits(encoding.precision, number).to_bytes(size, "big") for number in numbers]
        patterns += map(bytes.fromhex, _PATTERNS[encoding.precision])
    elif value.digits:
        numbers = [number for number in edge_numbers(device, value) if value.low <= number <= value.high]
        patterns += [digits_bytes(value, number) for number in numbers]
        patterns += [b"0" * size, b" " * size, b"-".rjust(size), b"-" + b"9" * (size - 1), b"+" + b"0" * (size - 1)]
    else:
        patterns += [(number % (1 << 8 * size)).to_bytes(size, "big") for number in edge_numbers(device, value)]
    return list(dict.fromkeys(_placed(pattern, order, swapped) for pattern in patterns))


def _fits(precision: Precision, number: float) -> bool:
    try:
        real_bits(precision, number)
    except OverflowError:
        return False
    return True


def _placed(pattern: bytes, order: str, swapped: bool) -> bytes:
    """Bytes with the most significant first, as they are sent."""
    data = pattern if (order == "big") != swapped else pattern[::-1]
    return b"".join(data[at : at + 2][::-1] for at in range(0, len(data), 2)) if swapped else data


def places(record: RecordLayout, start: int = 0) -> Iterator[Place]:
    """The values of a record, also those of records in it, where they are in data of the image."""
    for field in record.fields:
        for number in range(_ELEMENTS if field.count is None else min(field.count, _ELEMENTS)):
            yield from _places(field, start + field.offset + number * field.size)


def _places(field: FieldLayout, offset: int) -> Iterator[Place]:
    if field.record is not None:
        yield from places(field.record, offset)
    elif field.value is not None:
        yield offset, field.value, field.order, field.swapped
    for case in field.cases:
        yield offset, case.value, case.order, case.swapped
