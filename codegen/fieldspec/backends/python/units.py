"""Units as words of a name, and scales as whole numbers."""

from __future__ import annotations

import re
from decimal import Decimal
from fractions import Fraction
from math import lcm

from fieldspec.model.value import Value

_WORDS = {"%": "percent", "0.1%": "tenths_of_percent", "°C": "celsius"}


def unit_word(unit: str) -> str:
    """What a property of a scaled value is called after: `mm`, `percent`, `per_s`; `scaled` where there is no unit."""
    above, _, below = _WORDS.get(unit, unit.lower() or "scaled").partition("/")
    words = f"{above if above != '1' else ''}_per_{below}".strip("_") if below else above
    return re.sub(r"[^a-z0-9]+", "_", words)


def ratio(value: Value) -> tuple[int, int, int]:
    """The scale as (a, b, c) of value = (count * a + b) / c, exactly."""
    scale, offset = Fraction(value.scale), Fraction(value.offset)
    below = lcm(scale.denominator, offset.denominator)
    return int(scale * below), int(offset * below), below


def in_unit(count: str, held: tuple[int, int, int]) -> str:
    """The expression that gives a count in the unit as a float, rounded once."""
    a, b, c = held
    above = count if a == 1 else f"{count} * {a}"
    if b:
        above = f"({above} {'+' if b > 0 else '-'} {abs(b)})" if c != 1 else f"{above} {'+' if b > 0 else '-'} {abs(b)}"
    return f"{above} / {c}" if c != 1 else f"float({above})"


def shown(number: Decimal) -> str:
    """A decimal without an exponent or needless zeros."""
    text = f"{number:f}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def quantity(value: Value) -> str:
    """How a count relates to its unit: `in 0.01 mm`, `in %`, `in 0.5 V from -40 V`, or nothing."""
    if not value.scaled:
        return f"in {value.unit}" if value.unit else ""
    unit = f" {value.unit}" if value.unit else ""
    start = f" from {shown(value.offset)}{unit}" if value.offset else ""
    scale = value.scale_text if "/" in value.scale_text else shown(value.scale)
    return f"in {scale}{unit}{start}"
