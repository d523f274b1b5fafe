"""Numbers and quantities as people write them: `8`, `-0x1F`, `20.00 mm`, and `-0.500` of a value without a unit.

A decimal number has no leading zeros: `007` may be a name, a number of octal digits or a slip, so nothing guesses.
"""

from __future__ import annotations

import math
import re
from decimal import Decimal

_HEXADECIMAL = "0x[0-9A-Fa-f]{1,16}"
_WHOLE = "0|[1-9][0-9]{0,19}"
_COUNT = re.compile(rf"[-+]?(?:{_HEXADECIMAL}|{_WHOLE})")
_NUMBER = re.compile(rf"[-+]?(?:{_WHOLE})(?:\.[0-9]{{1,30}})?(?:[eE][-+]?[0-9]{{1,3}})?")
_POINT = re.compile(r"[-+]?(?:0|[1-9][0-9]{0,29})\.[0-9]{1,30}")
_QUANTITY = re.compile(r"([-+]?(?:0|[1-9][0-9]{0,29})(?:\.[0-9]{1,30})?)(?: (?=.)|(?=[^0-9 ]))(.*)")

_FIFTEEN_DIGITS = 1e15


def count_of(text: str) -> int | None:
    """The whole number that a text is, in decimal or hexadecimal; None for other texts."""
    return int(text, 0) if _COUNT.fullmatch(text) else None


def number_of(text: str) -> float | None:
    """The finite number that a text such as `-0.5` or `2.5e-3` is; None for other texts."""
    number = float(text) if _NUMBER.fullmatch(text) else math.inf
    return number if math.isfinite(number) else None


def decimal_of(text: str) -> Decimal | None:
    """The number that a text with a decimal point is, such as `-0.500` and `2.0`; None for any other text."""
    return Decimal(text) if _POINT.fullmatch(text) else None


def point_text(number: float | Decimal) -> str:
    """A number with a decimal point and without an exponent: `2.0`, and `0.0000001` for 1e-07."""
    exact = number if isinstance(number, Decimal) else Decimal(repr(number))
    text = f"{exact:f}"
    return text if "." in text or not exact.is_finite() else f"{text}.0"


def real_text(number: float) -> str:
    """A computed number: `25` for 25.0, `0.3` for 0.30000000000000004, with the fifteen digits that a double holds."""
    return f"{number:.15g}" if abs(number) < _FIFTEEN_DIGITS else repr(number)


def quantity_of(text: str) -> tuple[Decimal, str] | None:
    """The number and the unit of a text such as `20.00 mm` or `50%`; None where it is not a quantity."""
    match = _QUANTITY.fullmatch(text)
    return (Decimal(match[1]), match[2]) if match is not None else None
