"""The numbers in the bytes of values: in which order they are, and what they are."""

from __future__ import annotations

from decimal import ROUND_HALF_UP, Context, Decimal
from math import isfinite

from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.digits import digits_bytes, digits_number
from fieldspec.language.model.encoding import (
    Digits,
    Octets,
    Precision,
    Real,
    Text,
    Truth,
    Whole,
    real_bits,
    real_number,
    whole_bits,
    whole_number,
)
from fieldspec.language.model.value import Value

_SHORT_DIGITS = 10
"""Nine digits tell all numbers of four bytes apart."""


class SinglePrecision(float):
    """A number of four bytes in floating point, printed with the fewest digits that read back as the same bytes.

    Its text is `50.02`; that of the same number as a double is `50.02000045776367`.
    """

    __slots__ = ()
    precision = Precision.SINGLE

    def __repr__(self) -> str:
        if isfinite(self):
            exact, bits = Decimal(self), real_bits(self.precision, self)
            for digits in range(1, _SHORT_DIGITS):
                rounded = float(Context(prec=digits, rounding=ROUND_HALF_UP).plus(exact))
                try:
                    if real_bits(self.precision, rounded) == bits:
                        return repr(rounded)
                except OverflowError:
                    pass  # the nearest number of so few digits is greater than all that the bytes have
        return float.__repr__(self)


class HalfPrecision(SinglePrecision):
    """A number of two bytes in floating point, printed like one of four."""

    __slots__ = ()
    precision = Precision.HALF


def printable(precision: Precision, number: float) -> float:
    """The same number, which is printed with the fewest digits that read back as the same bits."""
    match precision:
        case Precision.HALF:
            return HalfPrecision(number)
        case Precision.SINGLE:
            return SinglePrecision(number)
        case Precision.DOUBLE:
            return number
        case _:
            assert_never(precision)


def orders_of(value: Value | None, byte: str, word: str) -> tuple[str, bool]:
    """The byte order of a value, and whether its words are swapped; characters and the bytes of a codec are big-endian.

    `byte` and `word` are the orders of values without their own; `word` is empty where nothing has words.
    """
    if value is not None and value.is_as_sent:
        return "big", False
    own_byte = value.byte_order if value and value.byte_order else byte
    own_word = value.word_order if value and value.word_order else word
    return own_byte, bool(value and value.has_words and own_word and own_word != own_byte)


def byte_places(size: int, order: str, swapped: bool) -> tuple[int, ...]:
    """Where the bytes of a number are, the most significant first.

    With `swapped`, the order of the 16-bit words is opposite to the order of the bytes in each.
    """
    in_order = range(size) if (order == "big") != swapped else range(size - 1, -1, -1)
    return tuple(byte ^ 1 for byte in in_order) if swapped else tuple(in_order)


def number_in(value: Value, data: bytes, order: str, swapped: bool) -> int | float | None:
    """The number in all bytes of a value that is not a text and no bytes; None where they are not its digits.

    Raises AssertionError for a text and for bytes.
    """
    first_to_last = data
    if swapped or order != "big":
        first_to_last = bytes(data[byte] for byte in byte_places(len(data), order, swapped))
    bits = int.from_bytes(first_to_last, "big")
    encoding = value.encoding
    match encoding:
        case Whole():
            return whole_number(encoding, bits)
        case Real():
            return printable(encoding.precision, real_number(encoding.precision, bits))
        case Truth():
            return bits
        case Digits():
            return digits_number(value, first_to_last)
        case Text() | Octets():
            raise AssertionError("a text or bytes are not a number")
        case _:
            assert_never(encoding)


def bytes_of_number(value: Value, number: int) -> bytes:
    """The bytes of a whole number that is a value, in big-endian order. Raises AssertionError for other values."""
    encoding = value.encoding
    match encoding:
        case Whole():
            return whole_bits(encoding, number).to_bytes(value.size, "big")
        case Digits():
            return digits_bytes(value, number)
        case Truth():
            return number.to_bytes(value.size, "big")
        case Real() | Text() | Octets():
            raise AssertionError("its raw value is not a whole number")
        case _:
            assert_never(encoding)
