"""What runtimes in other languages are told of an encoding: the name of its kind, its sign, and whether it is wide."""

from __future__ import annotations

from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.encoding import (
    Digits,
    Encoding,
    Octets,
    OfEncoding,
    OfSign,
    Real,
    Text,
    Truth,
    Whole,
    number_of,
)

WIDEST_DOUBLE = 48
"""The bits of the widest whole number that is a floating-point number in languages that have no other ones."""


kind_of = OfEncoding(whole="integer", digits="integer", truth="boolean", real="float", text="text", octets="bytes")
"""The name of the kind of an encoding."""


def sign_data(encoding: Encoding) -> bool | str:
    """How a number shows that it is below zero: not at all, a name for a bit beside the magnitude, true otherwise."""
    match encoding:
        case Whole():
            return _sign_data(encoding.sign)
        case Digits():
            return _sign_data(encoding.number.sign)
        case Real():
            return True
        case Truth() | Text() | Octets():
            return False
        case _:
            assert_never(encoding)


_sign_data: OfSign[bool | str] = OfSign(none=False, complement=True, magnitude="magnitude")


def is_wide(encoding: Encoding) -> bool:
    """Whether its raw value is a whole number that such a floating-point number may not have exactly."""
    number = number_of(encoding)
    return number is not None and number.bits > WIDEST_DOUBLE
