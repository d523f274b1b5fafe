"""Scales and units as expressions, as names and as texts."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from math import lcm

from fieldspec.language.model.value import Value


def ratio(value: Value) -> tuple[int, int, int]:
    """The scale as (a, b, c) of value = (count * a + b) / c, exactly."""
    scale, offset = Fraction(value.scale), Fraction(value.offset)
    below = lcm(scale.denominator, offset.denominator)
    return int(scale * below), int(offset * below), below


def in_unit(count: str, scale: tuple[int, int, int]) -> str:
    """The expression of a count in its unit as a float, rounded once."""
    a, b, c = scale
    above = count if a == 1 else f"{count} * {a}"
    if b:
        above = f"({above} {'+' if b > 0 else '-'} {abs(b)})" if c != 1 else f"{above} {'+' if b > 0 else '-'} {abs(b)}"
    return f"{above} / {c}" if c != 1 else f"float({above})"


def decimal_text(number: Decimal) -> str:
    """A decimal without an exponent or needless zeros."""
    text = f"{number:f}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def quantity(value: Value) -> str:
    """The scale and unit of a count: `in 0.01 mm`, `in %`, `in 0.5 V from -40 V`, or an empty text."""
    if not value.scaled:
        return f"in {value.unit}" if value.unit else ""
    unit = f" {value.unit}" if value.unit else ""
    start = f" from {decimal_text(value.offset)}{unit}" if value.offset else ""
    exact = value.scale_number
    scale = value.scale_text if "/" in value.scale_text or isinstance(exact, str) else decimal_text(exact)
    return f"in {scale}{unit}{start}"
