"""Quantities and special values as the reference codec has them: exact fractions, and the names of states."""

from __future__ import annotations

import math
from fractions import Fraction

from fieldspec.codec.reference.bits import number_of_bits
from fieldspec.codec.reference.structs import value_construct
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_real
from fieldspec.language.model.value import Value


class NoQuantityError(ValueError):
    """A quantity that no count is, or that would be sent as a special value; `state` has the name of that one."""

    def __init__(self, text: str, state: str = "") -> None:
        super().__init__(text)
        self.state = state


def scale_of(value: Value, power: int | None = None) -> Fraction:
    """How much a count is, as the spec writes it; `power` is the exponent of a scale that is read from the device."""
    if power is not None:
        return Fraction(10) ** power
    if not value.scale_text:
        return Fraction(1)
    above, _, below = value.scale_text.partition("/")
    base, _, exponent = (below or "1").partition("^")
    return Fraction(above) / Fraction(base) ** int(exponent or "1")


def special_name(value: Value, raw: float) -> str:
    """The name of the state that a number stands for; empty for a quantity."""
    for sentinel in value.sentinels:
        low, high = map(Fraction, sentinel.interval)
        if math.isnan(raw) if sentinel.is_nan else not math.isnan(raw) and low <= raw <= high:
            return sentinel.name
    return ""


def state_name(device: Device, value: Value, raw: float) -> str:
    """The name of the state that a number which is read stands for, or `out_of_range`; empty for any other number."""
    special = special_name(value, raw)
    is_within = value.ranges is None or any(low <= raw <= high for low, high in value.ranges.intervals)
    if value.flags:
        word = device.flags[value.flags]
        is_within &= all(bit.ranges is None or number_of_bits(word, bit, int(raw)) in bit.ranges for bit in word.bits)
    return special if special or is_within else "out_of_range"


def special_number(value: Value, name: str) -> int | float:
    """The number that is sent for a state."""
    sentinel = next(sentinel for sentinel in value.sentinels if sentinel.name == name)
    if not sentinel.is_nan:
        return float(sentinel.value) if is_real(value.encoding) else sentinel.value
    return float(value_construct(value, "big", False).parse(sentinel.value.to_bytes(value.size, "big")))


def quantity(value: Value, raw: float, power: int | None = None) -> Fraction | None:
    """The number in the unit; None for a special value, and for what is not a finite number."""
    if special_name(value, raw) or not math.isfinite(raw):
        return None
    return Fraction(raw) * scale_of(value, power) + Fraction(value.offset)


def count_of_quantity(value: Value, number: Fraction, power: int | None = None) -> int:
    """The count of a quantity. Raises NoQuantityError if it is not a quantity, or is a special value."""
    count = (number - Fraction(value.offset)) / scale_of(value, power)
    if count.denominator != 1:
        raise NoQuantityError(f"{number} is not a whole number of counts")
    state = special_name(value, count.numerator)
    if state:
        raise NoQuantityError(f"{number} is the count {count.numerator}, which stands for {state}", state)
    return count.numerator
