"""Numbers that are sent as digits, characters or two decimal digits in each byte, or by the codec of a package."""

from __future__ import annotations

from fieldspec.foundation.classes import TYPE_CHECKING
from fieldspec.foundation.runtime._digits import LETTERS, digits
from fieldspec.language.model import codecs
from fieldspec.language.model.encoding import is_signed

if TYPE_CHECKING:
    from typing import Protocol

    from fieldspec.language.model.encoding import Encoding

    class Number(Protocol):
        """The type of the number that the digits represent."""

        @property
        def name(self) -> str: ...
        @property
        def encoding(self) -> Encoding: ...

    class Digits(Protocol):
        """What matters of a `Value` that is sent as digits. The model of values is made of this module."""

        @property
        def type(self) -> Number: ...
        @property
        def size(self) -> int: ...
        @property
        def width(self) -> int: ...
        @property
        def digits(self) -> str: ...
        @property
        def is_low_first(self) -> bool: ...
        @property
        def places(self) -> int: ...
        @property
        def has_blanks(self) -> bool: ...
        @property
        def codec(self) -> str: ...


BCD = "bcd"
"""Two decimal digits in each byte. Below zero, a nibble of ones takes the place of the highest digit."""

PACKED_DECIMAL = "packed_decimal"
"""Two decimal digits in each byte, and the sign in the last nibble: C and D, or F where there is none."""

CODEC = "codec"
"""The form of a number that the codec of a package reads and writes."""

NIBBLES = (BCD, PACKED_DECIMAL)
"""The forms with two digits in each byte."""

NO_CHARACTERS = (*NIBBLES, CODEC)
"""The forms without characters."""


def has_sign(value: Digits) -> bool:
    """Whether a sign has a place of its own before the digits.

    A hexadecimal number has none, as it is in two's complement. Where blanks are in place of leading zeros, `-` comes
    after them, and takes the place of a digit.
    """
    return value.digits == "decimal" and is_signed(value.type.encoding) and not value.has_blanks


def is_complement(value: Digits) -> bool:
    """Whether the digits represent a number in two's complement."""
    return is_signed(value.type.encoding) and value.digits in ("upper_hex", "lower_hex")


def digit_count(value: Digits) -> int:
    """How many digits a number has, without its sign and its decimal point; 0 or less where there is no room.

    Where blanks are in place of leading zeros, it is how many it has at most, when no sign takes the place of one.
    """
    if value.digits in NIBBLES:
        return 2 * value.size - (value.digits == PACKED_DECIMAL)
    return value.size - has_sign(value) - (value.places > 0)


def is_hexadecimal_count(value: Digits, size: int) -> bool:
    """Whether two hexadecimal digits are sent for each of the `size` bytes of a number without a sign."""
    has_pairs = value.digits in ("upper_hex", "lower_hex") and not value.width and value.size == 2 * size
    return has_pairs and not is_signed(value.type.encoding)


def digits_letters(value: Digits) -> bytes:
    """The characters that may be digits of a value."""
    return LETTERS[value.digits]


def widest_digits(value: Digits) -> int:
    """How many digits a number that varies in width has at most, without those after the point."""
    return value.width - (value.places + 1 if value.places else 0)


def digit_bounds(value: Digits) -> tuple[int, int]:
    """The least and the greatest number that the digits of a value can express."""
    if value.codec:
        codec = codecs.number_codec(value.codec)
        return codec.low, codec.high
    count = max(digit_count(value), 0)
    if value.digits in ("upper_hex", "lower_hex"):
        high = 16**count - 1
        return (-(high + 1) // 2, high // 2) if is_signed(value.type.encoding) else (0, high)
    high = 10**count - 1
    if value.digits in NIBBLES and is_signed(value.type.encoding):
        return (1 - 10 ** (count - 1) if value.digits == BCD else -high), high
    if value.width:
        # The sign is sent below zero only, and takes the place of a digit; one stands before a point.
        return (_least_below_zero(value, count) if has_sign(value) else 0), high
    if value.has_blanks:
        return (_least_below_zero(value, count) if is_signed(value.type.encoding) else 0), high
    return (-high if has_sign(value) else 0), high


def _least_below_zero(value: Digits, count: int) -> int:
    """The least number of `count` characters, of which one is `-` and one digit comes before the point."""
    return 1 - 10 ** (count - 1) if count - 1 > value.places else 0


def digits_arguments(value: Digits, is_reversed: bool = False, form: str = "") -> str:
    """The arguments of the runtime for digits: order and type, their form, the bytes, and the places after a point.

    `is_reversed` if the lowest byte comes first; `form` stands for a codec.
    """
    form = form or ("blank_decimal" if value.has_blanks else value.digits)
    return f"{'<' if is_reversed or value.is_low_first else '>'}{value.type.name} {form} {value.size} {value.places}"


def digits_number(value: Digits, data: bytes) -> int | None:
    """The number of digits in `data`, the most significant digit first; None for anything but such digits."""
    if value.codec:
        return codecs.decoded(value.codec, data)
    return digits(digits_arguments(value)).unpack(data)[0]


def digits_bytes(value: Digits, number: int) -> bytes:
    """The digits of a number within the bounds of a value, the most significant digit first."""
    if value.codec:
        return codecs.encoded(value.codec, number)
    return digits(digits_arguments(value)).pack(number)


def digits_text(value: Digits) -> str:
    """How people call the digits: `5 decimal digits, 2 of them after a point, with a sign`."""
    if value.codec:
        return f"{value.size} byte{'s' * (value.size != 1)} of the codec {value.codec}"
    name = {"decimal": "decimal", BCD: "BCD", PACKED_DECIMAL: "BCD"}.get(value.digits, "hexadecimal")
    if value.width:
        return _varying_text(value, name)
    count = digit_count(value)
    places = f", {value.places} of them after a point" if value.places else ""
    case = {"upper_hex": " in upper case", "lower_hex": " in lower case"}.get(value.digits, "")
    sign = ", with a sign" if has_sign(value) else ", the low byte first" if value.is_low_first else ""
    if value.digits in NIBBLES and is_signed(value.type.encoding):
        sign = ", the sign in the last nibble" if value.digits == PACKED_DECIMAL else ", F for the first below zero"
    if value.has_blanks:
        sign = f", blanks in place of leading zeros{', a sign below zero' if is_signed(value.type.encoding) else ''}"
    return f"{count} {name} digit{'s' * (count != 1)}{case}{places}{sign}"


def _varying_text(value: Digits, name: str) -> str:
    """`1 to 8 characters: decimal digits, 2 places after a point, a sign below zero`"""
    case = {"upper_hex": " in upper case", "lower_hex": " in lower case"}.get(value.digits, "")
    places = f", {value.places} place{'s' * (value.places != 1)} after a point" if value.places else ""
    sign = ", a sign below zero" if has_sign(value) else ""
    minimum = 1 + (value.places + 1 if value.places else 0)
    return f"{minimum} to {value.width} characters: {name} digits{case}{places}{sign}"
