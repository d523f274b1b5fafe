"""Constants as C prints them: numbers, strings, bytes."""

from __future__ import annotations

import re
from functools import lru_cache

from fieldspec.language.model.encoding import OfPrecision, Precision, Sign, Whole
from fieldspec.targets.c.expressions import Literal

INT32, UINT32 = Whole(32, Sign.COMPLEMENT), Whole(32, Sign.NONE)
INT64, UINT64 = Whole(64, Sign.COMPLEMENT), Whole(64, Sign.NONE)
"""Types of constants."""

TRUE = Literal("true")
FALSE = Literal("false")
ZERO = Literal("0")
NULL = Literal("NULL")

_CACHE_SIZE = 1 << 14
"""How many literals are remembered: versions have most of theirs in common."""
_OCTAL_BYTES = tuple([rf"\{byte:03o}" for byte in range(256)])
_ESCAPES = {"\\": "\\\\", '"': '\\"', "\n": "\\n", "\r": "\\r", "\t": "\\t", "?": "\\?"}
_ESCAPED = re.compile(r'[^ -~]|[\\"?]')


@lru_cache(maxsize=_CACHE_SIZE)
def string(text: str) -> Literal:
    """A string in UTF-8. Octal escapes have three digits, so that no digit after them joins in."""
    return Literal(f'"{_ESCAPED.sub(_escape, text)}"')


def _escape(match: re.Match[str]) -> str:
    char = match[0]
    return _ESCAPES.get(char) or "".join(f"\\{byte:03o}" for byte in char.encode("utf-8", "replace"))


def byte_string(data: bytes) -> Literal:
    """Bytes as a string, each as an octal escape: `"\\001\\377"`"""
    return Literal(f'"{"".join([_OCTAL_BYTES[byte] for byte in data])}"')


@lru_cache(maxsize=_CACHE_SIZE)
def integer(value: int, whole: Whole = INT32) -> Literal:
    """A constant of a type that every compiler takes, the least values of signed types included."""
    return Literal(_integer_text(value, whole))


def _integer_text(value: int, whole: Whole) -> str:
    is_long = whole.bits > 32
    if not whole.sign.is_signed:
        return f"UINT64_C({value})" if is_long else f"{value}u"
    if value == -(1 << 63):
        return "(-INT64_C(9223372036854775807) - 1)"
    if value == -(1 << 31):
        return "(-2147483647 - 1)"
    if is_long:
        return f"(-INT64_C({-value}))" if value < 0 else f"INT64_C({value})"
    return f"({value})" if value < 0 else str(value)


@lru_cache(maxsize=_CACHE_SIZE)
def unsigned(value: int) -> Literal:
    """A size, an offset or a code: `28u`"""
    return Literal(f"{value}u")


@lru_cache(maxsize=_CACHE_SIZE)
def decimal(value: int) -> Literal:
    """A number without a mark of its type: `28`"""
    return Literal(str(value))


@lru_cache(maxsize=_CACHE_SIZE)
def hexadecimal(value: int, size: int) -> Literal:
    """An unsigned constant in hexadecimal, as wide as its type of `size` bytes."""
    digits = f"0x{value:0{2 * size}X}"
    return Literal(f"UINT64_C({digits})" if size > 4 else f"{digits}u")


def hexadecimal_digits(value: int, digits: int = 1, unsigned_mark: str = "") -> Literal:
    """A constant in hexadecimal with at least this number of digits: `0x3A`"""
    return Literal(f"0x{value:0{digits}X}{unsigned_mark}")


def whole_double(value: int) -> Literal:
    """A whole number as a double: `16384.0`"""
    return Literal(f"{value}.0")


_SUFFIX = OfPrecision(half="f", single="f", double="")


def real(value: float, precision: Precision) -> Literal:
    """A number as a float, `16384.0f`, also for half precision, or as a double: `16384.0`"""
    text = repr(value) if isinstance(value, float) else f"{value}.0"
    return Literal(text + _SUFFIX(precision))


def double(value: float) -> Literal:
    """A number as a double, with the digits that distinguish it from all others."""
    return Literal(repr(value))


_HEXADECIMAL_BYTES = tuple([f"0x{byte:02X}" for byte in range(256)])


def byte_initializer(data: bytes) -> Literal:
    """The bytes of an array: `{0x01, 0x02}`"""
    return Literal(f"{{{', '.join([_HEXADECIMAL_BYTES[byte] for byte in data])}}}")
