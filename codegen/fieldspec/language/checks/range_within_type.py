"""Ranges, sentinels and the printed range of unit addresses fit their types.

Why: a bound that does not fit its type cannot be sent. Either the type is too narrow, its sign is wrong, or a
digit of the bound is wrong.

Example: a range of -1..127 on a `u16`.

Fix: Correct the type or the bound. Use a signed type if the manual prints negative values.
"""

from __future__ import annotations

from math import copysign

from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.checks.finding import Findings, finding, outside, range_key, type_text
from fieldspec.language.checks.settled import of_values, of_words
from fieldspec.language.model.device import Device
from fieldspec.language.model.digits import digit_count
from fieldspec.language.model.encoding import (
    Digits,
    Octets,
    Precision,
    Real,
    Text,
    Truth,
    Whole,
    infinity,
    is_exact,
    quiet_nan,
    real_bits,
    real_number,
    significant_bits,
    whole_number,
)
from fieldspec.language.model.enums import Flags
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.link import Link
from fieldspec.language.model.primitives import Primitive
from fieldspec.language.model.ranges import Ranges, bound_text
from fieldspec.language.model.value import Value

_HELP = "correct the type or the bound"


def range_within_type(device: Device) -> Findings:
    yield from of_values(device, _of_encoding)
    yield from of_words(device, _of_word)
    for link in device.links.values():
        yield from _of_unit_addresses(link)


def _of_word(flags: Flags) -> Findings:
    if outside(flags.ranges, flags.type.low, flags.type.high):
        text = f"{flags.name} cannot be {_ranges_text(flags.ranges)} as {_type_range(flags.type)}"
        yield finding(flags.place, "range", text, _HELP)
    for bit in flags.bits:
        if outside(bit.ranges, bit.low, bit.high):
            bits = f"{bit.width} bits{' with a sign' * bit.signed}, which have the range {bit.low}..{bit.high}"
            text = f"{bit.name} cannot be {_ranges_text(bit.ranges)} as {bits}"
            help = "correct the range, or the number of bits"
            yield finding(bit.place, range_key(bit.place), text, help)


def _of_encoding(fact: Fact, value: Value) -> Findings:
    encoding = value.encoding
    match encoding:
        case Whole() | Digits() | Truth():
            yield from _of_value(fact, value)
        case Real():
            yield from _of_float(fact, value, encoding.precision)
        case Text() | Octets():
            pass
        case _:
            assert_never(encoding)


def _of_value(fact: Fact, value: Value) -> Findings:
    if outside(value.ranges, value.low, value.high):
        text = f"{fact.name} cannot be {_ranges_text(value.ranges)} as {_range_of(value)}"
        yield finding(fact.place, range_key(fact.place), text, _HELP)
    for sentinel in value.sentinels:
        low, high = sentinel.interval
        if not value.low <= low <= high <= value.high:
            text = f"{fact.name} cannot be {sentinel.text} ({sentinel.name}) as {_range_of(value)}"
            yield finding(fact.place, "sentinels", text, _sentinel_help(value, sentinel.value))


def _sentinel_help(value: Value, bits: int) -> str:
    """The help for a sentinel that is stated by its bits, which a signed type has for a negative number."""
    encoding = value.packed_number or value.encoding
    if not isinstance(encoding, Whole) or not encoding.sign.is_signed or bits >> encoding.bits - 1 != 1:
        return _HELP
    number = whole_number(encoding, bits)
    return f"0x{bits:X} are the bits of {number}: write it as `{number}` or `-0x{-number:X}`"


def _of_float(fact: Fact, value: Value, precision: Precision) -> Findings:
    """Bounds and sentinels that the type has exactly, and bits of a NaN."""
    width, digits = precision.value, significant_bits(precision)
    infinite, quiet = infinity(precision), quiet_nan(precision)
    for bound in (bound for pair in (value.ranges.intervals if value.ranges else ()) for bound in pair):
        if isinstance(bound, float):
            nearest = _nearest(bound, precision)
            if nearest != bound:
                text = f"{fact.name} cannot be exactly {bound_text(bound)} as {value.type.name}"
                help = f"use the nearest number that it can be, {bound_text(nearest)}"
                yield finding(fact.place, range_key(fact.place), text, help)
        elif not _exact(bound, precision):
            text = f"{fact.name} cannot be exactly {bound} as {value.type.name}"
            help = f"use a bound of at most {digits} bits"
            yield finding(fact.place, range_key(fact.place), text, help)
    for sentinel in value.sentinels:
        high, bits = 1 << width, f"{sentinel.value:#0{width // 4 + 2}x}"
        nan = sentinel.value < high and sentinel.value & (high // 2 - 1) > infinite
        if sentinel.is_nan and not nan:
            text = f"the bits {bits} ({sentinel.name}) of {fact.name} represent a number"
            yield finding(fact.place, "sentinels", text, "state the number under `value`")
        elif sentinel.is_nan and sentinel.value != quiet and getattr(fact, "access", "") != "ro":
            text = f"{fact.name} can be written, and NaN is written as {quiet:#0{width // 4 + 2}x}"
            help = f"set `access: ro` if it is only read, or state the value as a `u{width}` of bits"
            yield finding(fact.place, "sentinels", text, help)
        elif not sentinel.is_nan and infinite < sentinel.value and nan:
            text = f"{bits} ({sentinel.name}) of {fact.name} looks like the bits of a NaN"
            yield finding(fact.place, "sentinels", text, "state them under `bits`")
        elif not sentinel.is_nan and not _exact(sentinel.value, precision):
            text = f"{fact.name} cannot be exactly {sentinel.value} ({sentinel.name}) as {value.type.name}"
            yield finding(fact.place, "sentinels", text, f"use a number of at most {digits} bits")
    if sum(sentinel.is_nan for sentinel in value.sentinels) > 1:
        text = f"{fact.name} has several special values that are NaN, which many machines cannot distinguish"
        yield finding(fact.place, "sentinels", text, "remove one of them")


def _nearest(number: float, precision: Precision) -> float:
    """The finite number of a precision that is nearest to another one."""
    try:
        return real_number(precision, real_bits(precision, number))
    except OverflowError:
        return copysign(real_number(precision, infinity(precision) - 1), number)


def _exact(number: int, precision: Precision) -> bool:
    """Whether a floating-point number can be exactly a whole number."""
    try:
        return real_number(precision, real_bits(precision, number)) == number
    except OverflowError:
        return False


def _of_unit_addresses(link: Link) -> Findings:
    part = next((p for p in link.request if p.role == "unit_address" and p.value is not None), None)
    if link.unit_addresses is None or part is None or part.value is None or not is_exact(part.value.encoding):
        return
    if outside(link.unit_addresses.ranges, part.value.low, part.value.high):
        text = f"{part.name} cannot be {_ranges_text(link.unit_addresses.ranges)} as {_range_of(part.value)}"
        yield finding(link.unit_addresses.place, "range", text, _HELP)


def _type_range(primitive: Primitive) -> str:
    return f"{primitive.name}, which has the range {primitive.low}..{primitive.high}"


def _range_of(value: Value) -> str:
    if not value.digits and not value.packed_bits:
        return _type_range(value.type)
    verb = "has" if 1 in (value.packed_bits, digit_count(value) if value.digits else 0) else "have"
    return f"{type_text(value)}, which {verb} the range {value.low}..{value.high}"


def _ranges_text(ranges: Ranges | None) -> str:
    return ranges.text() if ranges else ""
