"""Parameters and quantities as users enter them, and the raw values nearest to quantities."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction

from fieldspec.codec.explain.values import in_unit
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.device import Device
from fieldspec.language.model.registers import ParameterSet
from fieldspec.language.model.value import Value

_PLACES = 4


def number_of_text(parameter_set: ParameterSet, text: str) -> int | None:
    """The number of a set that the manual prints as `text`, whether or not the spec lists it; None if there is none."""
    if parameter_set.numbers is None or not parameter_set.printed_as:
        return None
    for low, high in parameter_set.numbers.intervals:
        for number in range(low, high + 1):
            if parameter_set.number_text(number).lower() == text.lower():
                return number
    return None


@dataclass(frozen=True, slots=True)
class Count:
    """The raw value nearest to a quantity. `exact` is the quantity in counts, `text` that of `raw`."""

    raw: int
    exact: str
    text: str
    is_whole: bool


def nearest(device: Device, value: Value, text: str) -> Count | None:
    """The raw value nearest to `50 %`, the even one of two; None if the text is not a quantity in the unit."""
    number = device.entered_quantity(value, text.strip())
    if number is None:
        return None
    counts = (number - Fraction(value.offset)) / Fraction(value.scale)
    raw = round(counts)
    exact = f"{Decimal(round(counts * 10**_PLACES)).scaleb(-_PLACES).normalize():f}"
    return Count(raw, exact, in_unit(value, raw), counts == raw)


def rounded(device: Device, name: str, value: Value, text: str) -> tuple[int, str] | None:
    """The nearest count for a quantity between two counts, as the generated code rounds, and a remark; else None."""
    count = nearest(device, value, text)
    if count is None or count.is_whole:
        return None
    count_text = "" if count.text.replace(" ", "") == text.replace(" ", "") else f", which is {count.text}"
    return count.raw, f"{name}: {text} is {count.exact} counts; {count.raw} is sent{count_text}"


def parameter_number(device: Device, name: str, text: str) -> int | None:
    """The number on the wire of a parameter in a set or in a space of sets; None if there is none.

    `text` is its name, its printed name, or its number as the manual prints it.
    """
    for parameter_set in device.sets(name):
        for parameter in parameter_set.parameters:
            if text.lower() in (parameter.name, parameter.printed_name.lower()):
                return parameter_set.base + parameter.number
        number = number_of_text(parameter_set, text)
        if number is not None:
            return parameter_set.base + number
    return None
