"""The encodings of values: a closed set of types, each with what it alone has.

A branch over them is a `match` that ends with `assert_never`, a table such as `OfEncoding`, or one of the questions of
this module, each of which is one of both. So a type checker names what a new encoding still needs.
"""

from __future__ import annotations

import struct
from enum import Enum

from fieldspec.foundation.classes import TYPE_CHECKING, dataclass
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.foundation.runtime._typing import Generic, T

if TYPE_CHECKING:
    from fieldspec.language.model.text_form import TextForm


MACHINE_BITS = (8, 16, 32, 64)
"""The widths of the numbers of machines."""


class Sign(Enum):
    """How a whole number shows that it is below zero: not at all, in two's complement, or by its highest bit alone."""

    NONE = "none"
    COMPLEMENT = "complement"
    MAGNITUDE = "magnitude"

    @property
    def is_signed(self) -> bool:
        """Whether there are numbers below zero."""
        return _IS_SIGNED(self)

    @property
    def has_two_zeros(self) -> bool:
        """Whether 0 has bits for a second time, with the sign of a number below it."""
        return _HAS_TWO_ZEROS(self)


@dataclass(frozen=True, slots=True)
class OfSign(Generic[T]):
    """What belongs to each sign: a new one is an attribute, which type checkers miss wherever nothing is stated."""

    none: T
    complement: T
    magnitude: T

    def __call__(self, sign: Sign) -> T:
        match sign:
            case Sign.NONE:
                return self.none
            case Sign.COMPLEMENT:
                return self.complement
            case Sign.MAGNITUDE:
                return self.magnitude
            case _:
                assert_never(sign)


_IS_SIGNED = OfSign(none=False, complement=True, magnitude=True)
_HAS_TWO_ZEROS = OfSign(none=False, complement=False, magnitude=True)


class Precision(Enum):
    """The widths in bits of the floating-point numbers of IEEE 754."""

    HALF = 16
    SINGLE = 32
    DOUBLE = 64


@dataclass(frozen=True, slots=True)
class OfPrecision(Generic[T]):
    """What belongs to each precision, as `OfSign` has it."""

    half: T
    single: T
    double: T

    def __call__(self, precision: Precision) -> T:
        match precision:
            case Precision.HALF:
                return self.half
            case Precision.SINGLE:
                return self.single
            case Precision.DOUBLE:
                return self.double
            case _:
                assert_never(precision)


@dataclass(frozen=True, slots=True)
class Whole:
    """A whole number of `bits` bits."""

    bits: int
    sign: Sign

    @property
    def bounds(self) -> tuple[int, int]:
        """The least and the greatest number."""
        match self.sign:
            case Sign.NONE:
                return 0, (1 << self.bits) - 1
            case Sign.COMPLEMENT:
                return -(1 << self.bits - 1), (1 << self.bits - 1) - 1
            case Sign.MAGNITUDE:
                return 1 - (1 << self.bits - 1), (1 << self.bits - 1) - 1
            case _:
                assert_never(self.sign)


@dataclass(frozen=True, slots=True)
class Real:
    """A floating-point number."""

    precision: Precision

    @property
    def bits(self) -> int:
        """Its width."""
        return self.precision.value


@dataclass(frozen=True, slots=True)
class Truth:
    """0 for false or 1 for true, in `bits` bits."""

    bits: int


@dataclass(frozen=True, slots=True)
class Digits:
    """A whole number as digits: `form` is decimal, upper_hex, lower_hex or bcd; `number` is the type of the number.

    `size` is in bytes. `places` digits follow a point. With `has_blanks`, blanks are in place of leading zeros.
    """

    number: Whole
    form: str
    size: int
    places: int
    has_blanks: bool


@dataclass(frozen=True, slots=True)
class Text:
    """A text of `size` bytes; `form` is None for ASCII that is padded with zeros."""

    size: int
    form: TextForm | None


@dataclass(frozen=True, slots=True)
class Octets:
    """`size` bytes without a meaning of their own."""

    size: int


Encoding = Whole | Real | Truth | Digits | Text | Octets
"""How a value is on the wire."""


@dataclass(frozen=True, slots=True)
class OfEncoding(Generic[T]):
    """What belongs to each encoding, as `OfSign` has it."""

    whole: T
    digits: T
    truth: T
    real: T
    text: T
    octets: T

    def __call__(self, encoding: Encoding) -> T:
        match encoding:
            case Whole():
                return self.whole
            case Digits():
                return self.digits
            case Truth():
                return self.truth
            case Real():
                return self.real
            case Text():
                return self.text
            case Octets():
                return self.octets
            case _:
                assert_never(encoding)


is_array = OfEncoding(whole=False, digits=False, truth=False, real=False, text=True, octets=True)
"""Whether it is a sequence, a text or bytes, and not a number."""

is_count = OfEncoding(whole=True, digits=True, truth=False, real=False, text=False, octets=False)
"""Whether its raw value is a whole number that may be scaled, bounded, and named by an enum."""

is_real = OfEncoding(whole=False, digits=False, truth=False, real=True, text=False, octets=False)
"""Whether it is a floating-point number."""

is_truth = OfEncoding(whole=False, digits=False, truth=True, real=False, text=False, octets=False)
"""Whether it is true or false."""

is_text = OfEncoding(whole=False, digits=False, truth=False, real=False, text=True, octets=False)
"""Whether it is a text."""

is_octets = OfEncoding(whole=False, digits=False, truth=False, real=False, text=False, octets=True)
"""Whether it is bytes without a meaning of their own."""

is_exact = OfEncoding(whole=True, digits=True, truth=True, real=False, text=False, octets=False)
"""Whether its raw value is a whole number, which may be 0 or 1 alone."""


def is_signed(encoding: Encoding) -> bool:
    """Whether it has numbers below zero."""
    match encoding:
        case Whole():
            return encoding.sign.is_signed
        case Digits():
            return encoding.number.sign.is_signed
        case Real():
            return True
        case Truth() | Text() | Octets():
            return False
        case _:
            assert_never(encoding)


def has_magnitude(encoding: Encoding) -> bool:
    """Whether the highest bit alone says that a number is below zero."""
    match encoding:
        case Whole():
            return encoding.sign.has_two_zeros
        case Real() | Truth() | Digits() | Text() | Octets():
            return False
        case _:
            assert_never(encoding)


def is_odd(encoding: Encoding) -> bool:
    """Whether it is a whole number of a width that machines do not have: 24, 40, 48 or 56 bits."""
    whole = number_of(encoding)
    return whole is not None and whole.bits not in MACHINE_BITS


def has_single_bytes(encoding: Encoding) -> bool:
    """Whether each value has bytes of its own: no other bytes after the end of a text, and no second zero."""
    match encoding:
        case Whole():
            return not encoding.sign.has_two_zeros
        case Real() | Truth() | Digits() | Octets():
            return True
        case Text():
            return False
        case _:
            assert_never(encoding)


def number_of(encoding: Encoding) -> Whole | None:
    """The type of the whole number that its raw value is; None if it is not a number, or is a truth value."""
    match encoding:
        case Whole():
            return encoding
        case Digits():
            return encoding.number
        case Real() | Truth() | Text() | Octets():
            return None
        case _:
            assert_never(encoding)


def sign_of(encoding: Encoding) -> Sign:
    """The sign of the whole number that its raw value is; NONE for all other encodings."""
    number = number_of(encoding)
    return Sign.NONE if number is None else number.sign


def bounds_of(encoding: Encoding) -> tuple[int, int]:
    """The least and the greatest whole number that it can have; for digits, the limits of their number's type.

    Those of a real number are what its bits would be as a whole number.
    """
    match encoding:
        case Whole():
            return encoding.bounds
        case Digits():
            return encoding.number.bounds
        case Truth():
            return 0, 1
        case Real():
            return Whole(encoding.bits, Sign.COMPLEMENT).bounds
        case Text() | Octets():
            return 0, 0
        case _:
            assert_never(encoding)


def struct_letter(encoding: Encoding) -> str:
    """The letter of `struct` for one element; empty where it has none, as for three bytes, and for a sign by a bit."""
    match encoding:
        case Whole():
            return _whole_letter(encoding)
        case Real():
            return _real_letter(encoding.precision)
        case Truth():
            return _whole_letter(Whole(encoding.bits, Sign.NONE))
        case Digits() | Text() | Octets():
            return "s"
        case _:
            assert_never(encoding)


def _whole_letter(whole: Whole) -> str:
    letter = {8: "b", 16: "h", 32: "i", 64: "q"}.get(whole.bits, "")
    return OfSign(none=letter.upper(), complement=letter, magnitude="")(whole.sign)


_real_letter = OfPrecision(half="e", single="f", double="d")


def whole_number(whole: Whole, bits: int) -> int:
    """The number that some bits represent, from 0 on, one bit for each bit of the encoding."""
    half = 1 << whole.bits - 1
    match whole.sign:
        case Sign.NONE:
            return bits
        case Sign.COMPLEMENT:
            return bits - 2 * half if bits >= half else bits
        case Sign.MAGNITUDE:
            return half - bits if bits >= half else bits
        case _:
            assert_never(whole.sign)


def whole_bits(whole: Whole, number: int) -> int:
    """The bits of a number within its bounds, as a number from 0 on."""
    half = 1 << whole.bits - 1
    match whole.sign:
        case Sign.NONE:
            return number
        case Sign.COMPLEMENT:
            return number % (2 * half)
        case Sign.MAGNITUDE:
            return half - number if number < 0 else number
        case _:
            assert_never(whole.sign)


def real_number(precision: Precision, bits: int) -> float:
    """The number that some bits are."""
    number: float = struct.unpack(f">{_real_letter(precision)}", bits.to_bytes(precision.value // 8, "big"))[0]
    return number


def real_bits(precision: Precision, number: float) -> int:
    """The bits of the nearest number of a precision. Raises OverflowError for one that would become infinite."""
    # `struct` raises its own error for a whole number that no half holds.
    return int.from_bytes(struct.pack(f">{_real_letter(precision)}", float(number)), "big")


def quiet_nan(precision: Precision) -> int:
    """The bits of the NaN that machines produce."""
    return infinity(precision) | 1 << significant_bits(precision) - 2


def infinity(precision: Precision) -> int:
    """The bits of the number that is greater than all others: all bits of the exponent are 1, all others 0."""
    return (1 << precision.value - 1) - (1 << significant_bits(precision) - 1)


significant_bits = OfPrecision(half=11, single=24, double=53)
"""The bits of the greatest whole number up to which all whole numbers are exact."""
