"""The numbers of C in which the numbers of values are: their types, their literals, and how they come from bits."""

from __future__ import annotations

from fieldspec.foundation.caches import ByIdentity
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.encoding import (
    MACHINE_BITS,
    Digits,
    Encoding,
    Octets,
    OfPrecision,
    Real,
    Sign,
    Text,
    Truth,
    Whole,
    real_bits,
    whole_bits,
)
from fieldspec.targets.c.expressions import Call, Conditional, Expression, Group, Literal
from fieldspec.targets.c.literals import ZERO, decimal, integer, real
from fieldspec.targets.c.naming import Naming


@dataclass(frozen=True, slots=True)
class Machine:
    """A type of C, the unsigned type that has its bits on the wire, and the functions of the runtime between both.

    Without a function from bits, they are the number; without one to bits, `cast` says whether it is cast to them.
    """

    type: str
    word: str
    from_bits: str = ""
    to_bits: str = ""
    is_cast: bool = False


_MACHINES: ByIdentity[Encoding, Machine] = ByIdentity(limit=1024)
"""The types of C of the newest encodings, which values of one type share."""


def machine(encoding: Encoding) -> Machine:
    """The type of C that has an element of a value; of a text, a character, and of bytes, one of them."""
    return _MACHINES.get_or_compute(encoding, _machine)


def _machine(encoding: Encoding) -> Machine:
    match encoding:
        case Whole():
            return _whole(encoding)
        case Digits():
            return _whole(encoding.number)
        case Real():
            return _real(encoding.precision)
        case Truth():
            return Machine("bool", _word(encoding.bits))
        case Text():
            return Machine("char", "uint8_t")
        case Octets():
            return Machine("uint8_t", "uint8_t")
        case _:
            assert_never(encoding)


def machine_bits(bits: int) -> int:
    """The width of the narrowest machine number with at least this number of bits."""
    return next(width for width in MACHINE_BITS if width >= bits)


def machine_whole(whole: Whole) -> Whole:
    """The number of C that has all numbers of another one, and perhaps more: `int32_t` holds all numbers of 24 bits."""
    return Whole(machine_bits(whole.bits), Sign.COMPLEMENT if whole.sign.is_signed else Sign.NONE)


def _word(bits: int) -> str:
    return f"uint{machine_bits(bits)}_t"


def _whole(whole: Whole) -> Machine:
    word = _word(whole.bits)
    match whole.sign:
        case Sign.NONE:
            return Machine(word, word)
        case Sign.COMPLEMENT:
            return Machine(word[1:], word, f"signed_{whole.bits}", is_cast=True)
        case Sign.MAGNITUDE:
            return Machine(word[1:], word, f"of_magnitude_{whole.bits}", f"magnitude_of_{whole.bits}")
        case _:
            assert_never(whole.sign)


_real = OfPrecision(
    half=Machine("float", "uint16_t", "float_of_half", "half_of"),
    single=Machine("float", "uint32_t", "float_of", "bits_of"),
    double=Machine("double", "uint64_t", "double_of", "bits_of_double"),
)


def of_bits(naming: Naming, encoding: Encoding, bits: Expression) -> Expression:
    """`signed_16(bits)`, `float_of(bits)`: the number that bits stand for. Raises AssertionError for texts."""
    match encoding:
        case Truth():
            return bits.differs(ZERO)
        case Whole() | Real() | Digits():
            function = machine(encoding).from_bits
            return Call(naming.own(function), (bits,)) if function else bits
        case Text() | Octets():
            raise AssertionError("a text or bytes are not a number")
        case _:
            assert_never(encoding)


def to_bits(naming: Naming, encoding: Encoding, number: Expression) -> Expression:
    """`(uint16_t)number`, `bits_of(number)`: the bits of a number. Raises AssertionError for texts."""
    kind = machine(encoding)
    match encoding:
        case Truth():
            return Conditional(number, decimal(1), ZERO).cast(kind.word)
        case Whole() | Real() | Digits():
            if kind.to_bits:
                return Call(naming.own(kind.to_bits), (number,))
            return number.cast(kind.word) if kind.is_cast else number
        case Text() | Octets():
            raise AssertionError("a text or bytes are not a number")
        case _:
            assert_never(encoding)


def fixed_bits(encoding: Encoding, number: int) -> Literal:
    """A number that no user sets, as its bits. Raises AssertionError for other values."""
    match encoding:
        case Whole():
            bits = whole_bits(encoding, number)
        case Real():
            bits = real_bits(encoding.precision, number)
        case Truth():
            bits = number
        case Digits() | Text() | Octets():
            raise AssertionError("digits, texts and bytes are not bits of a number")
        case _:
            assert_never(encoding)
    return integer(bits, Whole(encoding.bits, Sign.NONE))


def literal(encoding: Encoding, number: int) -> Literal:
    """A number of a value as a constant of its type. Raises AssertionError for texts."""
    match encoding:
        case Whole():
            return integer(number, encoding)
        case Digits():
            return integer(number, encoding.number)
        case Truth():
            return integer(number, Whole(encoding.bits, Sign.NONE))
        case Real():
            return real(number, encoding.precision)
        case Text() | Octets():
            raise AssertionError("a text or bytes are not a number")
        case _:
            assert_never(encoding)


def macro_literal(encoding: Encoding, number: int) -> Expression:
    """A number of a value as a macro has it: with its sign in parentheses."""
    constant = literal(encoding, number)
    return Group(constant) if constant.text.startswith("-") else constant
