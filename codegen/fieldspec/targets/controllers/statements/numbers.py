"""The types of variables for numbers on the wire."""

from __future__ import annotations

from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.encoding import Digits, Encoding, Octets, OfPrecision, OfSign, Real, Text, Truth, Whole
from fieldspec.targets.controllers.statements.expressions import SIGNED, UNSIGNED, Elementary

_INTEGERS = OfSign(none=UNSIGNED, complement=SIGNED, magnitude=SIGNED)


def whole_type(encoding: Encoding) -> Elementary:
    """The integer type that holds all numbers of an encoding. Raises AssertionError for other values."""
    match encoding:
        case Whole():
            return _INTEGERS(encoding.sign)[encoding.bits // 8]
        case Digits():
            return whole_type(encoding.number)
        case Truth():
            return UNSIGNED[encoding.bits // 8]
        case Real() | Text() | Octets():
            raise AssertionError(f"{encoding} is not a whole number")
        case _:
            assert_never(encoding)


def is_single(encoding: Encoding) -> bool:
    """Whether it is a floating-point number that a REAL has exactly."""
    match encoding:
        case Real():
            return _is_within_single(encoding.precision)
        case Whole() | Truth() | Digits() | Text() | Octets():
            return False
        case _:
            assert_never(encoding)


_is_within_single = OfPrecision(half=True, single=True, double=False)
