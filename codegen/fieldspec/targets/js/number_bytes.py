"""Expressions and statements of the numbers in the bytes of an array."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.encoding import OfPrecision, Sign

BYTES_OF_OPERATOR = 4
"""The bytes of the widest number that operators on bits take."""

BYTES_OF_DOUBLE = 6
"""The bytes of the widest whole number that is not a bigint."""

LONGEST = 0x3FFF_FFFF
"""The bytes of the longest data, so that offsets within a frame have 31 bits."""


def with_offset(lines: Sequence[str]) -> list[str]:
    """The statements of a function that uses the offset `o`, which has 31 bits.

    Engines that know this add to it without a look at the sum, which takes a quarter of the time of a long function.
    """
    return ["o &= 0x7fffffff;", *lines] if sum(line.count("b[") for line in lines) > BYTES_OF_OPERATOR else list(lines)


def byte(base: str, offset: int) -> str:
    """The byte at `base` + `offset` of the array `b`."""
    return f"b[{place(base, offset)}]"


def place(base: str, offset: int) -> str:
    """The expression of an offset from the start of the data: `o + 4`, or `o` for 0."""
    return f"{base} + {offset}" if offset else base


real_functions = OfPrecision(
    half=("halfOf", "halfBitsOf"), single=("floatOf", "bitsOf"), double=("doubleOf", "doubleBitsOf")
)
"""The functions of the runtime that make a number of bits, and check it and make its bits."""


def whole_number(sign: Sign, terms: list[str]) -> str:
    """The whole number of some bytes, the most significant one first."""
    match sign:
        case Sign.NONE:
            return _unsigned(terms)
        case Sign.COMPLEMENT:
            return _complement(terms)
        case Sign.MAGNITUDE:
            return f"magnitudeOf({_unsigned(terms)}, {8 * len(terms)})"
        case _:
            assert_never(sign)


def _unsigned(terms: list[str]) -> str:
    """The number of bytes without a sign."""
    if len(terms) == 1:
        return terms[0]
    if len(terms) <= BYTES_OF_OPERATOR:
        return _short(terms)
    return f"({_long(terms)})"


def _complement(terms: list[str]) -> str:
    """The number of bytes in two's complement."""
    bits = 8 * len(terms)
    if len(terms) < BYTES_OF_OPERATOR:
        return f"({_joined(terms) if len(terms) == 1 else f'({_joined(terms)})'} << {32 - bits}) >> {32 - bits}"
    if len(terms) == BYTES_OF_OPERATOR:
        return f"({_joined(terms)})"
    if len(terms) <= BYTES_OF_DOUBLE:
        return f"signed48({_long(terms)}, {bits})"
    return f"BigInt.asIntN({bits}, {_long(terms)})"


def _joined(terms: list[str]) -> str:
    """The number of up to four bytes, with the sign that operators on bits give it."""
    last = len(terms) - 1
    return " | ".join(f"({term} << {8 * (last - index)})" if index < last else term for index, term in enumerate(terms))


def _short(terms: list[str]) -> str:
    """The number of up to four bytes, without a sign."""
    return f"(({_joined(terms)}) >>> 0)" if len(terms) == BYTES_OF_OPERATOR else f"({_joined(terms)})"


def _long(terms: list[str]) -> str:
    """The number of more than four bytes, without a sign: a bigint where there are more than six."""
    high, low = _short(terms[:-BYTES_OF_OPERATOR]), _short(terms[-BYTES_OF_OPERATOR:])
    if len(terms) <= BYTES_OF_DOUBLE:
        return f"{high} * 4294967296 + {low}"
    return f"(BigInt({high}) << 32n) | BigInt({low})"


def stored_bits(number: str, targets: Sequence[str]) -> list[str]:
    """The statements that write the bits of a number, or of its two's complement, the last byte first.

    It is given by the name of a variable, and `targets` by their expressions, the most significant one first.
    """
    places = list(enumerate(reversed(targets)))
    if len(targets) > BYTES_OF_DOUBLE:
        return [f"{byte} = Number({f'({number} >> {8 * k}n)' if k else number} & 255n);" for k, byte in places]
    if len(targets) > BYTES_OF_OPERATOR:
        return [f"{byte} = {f'Math.floor({number} / {256**k})' if k else number} % 256;" for k, byte in places]
    return [f"{byte} = {f'{number} >>> {8 * k}' if k else number};" for k, byte in places]
