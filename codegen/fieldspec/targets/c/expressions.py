"""Expressions of C: frozen trees, which `printer.py` writes with the parentheses that C needs."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import lru_cache
from typing import TypeAlias

from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.encoding import Precision, Sign, Whole

_CACHE_SIZE = 1 << 14
"""How many literals are remembered: versions have most of theirs in common."""


@dataclass(frozen=True, slots=True)
class Type:
    """A type where something is declared: `const uint8_t *`"""

    name: str
    const: bool = False
    pointer: bool = False


@dataclass(frozen=True, slots=True)
class Identifier:
    """A parameter, a constant or a macro by its name."""

    name: str


@dataclass(frozen=True, slots=True)
class Local:
    """A local variable, which is declared where the function that may have it is printed, if it uses it."""

    name: str
    type: Type


@dataclass(frozen=True, slots=True)
class Literal:
    """A constant as it is written; only the functions below make one."""

    text: str


@dataclass(frozen=True, slots=True)
class Call:
    """A call of a function, or of a macro that looks like one."""

    function: str
    arguments: tuple[Expression, ...]


@dataclass(frozen=True, slots=True)
class Member:
    """`structure.name`"""

    structure: Expression
    name: str


@dataclass(frozen=True, slots=True)
class PointerMember:
    """`pointer->name`"""

    pointer: Expression
    name: str


@dataclass(frozen=True, slots=True)
class Element:
    """`array[index]`"""

    array: Expression
    index: Expression


@dataclass(frozen=True, slots=True)
class Unary:
    """An operator before its operand: `!`, `~`, `&` or `*`"""

    operator: str
    operand: Expression


@dataclass(frozen=True, slots=True)
class Cast:
    """`(uint16_t)operand`"""

    type: str
    operand: Expression


@dataclass(frozen=True, slots=True)
class SizeOf:
    """`sizeof operand`"""

    operand: Expression


@dataclass(frozen=True, slots=True)
class Operation:
    """Operands joined by one operator, from left to right."""

    operator: str
    operands: tuple[Expression, ...]


@dataclass(frozen=True, slots=True)
class Group:
    """Parentheses that C does not need and readers do."""

    content: Expression


@dataclass(frozen=True, slots=True)
class Conditional:
    """`test ? positive : negative`"""

    test: Expression
    positive: Expression
    negative: Expression


@dataclass(frozen=True, slots=True)
class Initializer:
    """The values of an array or a struct: `{0x01, 0x02}`"""

    values: tuple[Expression, ...]


Expression: TypeAlias = (
    Identifier
    | Local
    | Literal
    | Call
    | Member
    | PointerMember
    | Element
    | Unary
    | Cast
    | SizeOf
    | Operation
    | Group
    | Conditional
    | Initializer
)

SIZE_TYPE = Type("size_t")
INPUT_BYTES = Type("uint8_t", const=True, pointer=True)
OUTPUT_BYTES = Type("uint8_t", pointer=True)

INT32, UINT32 = Whole(32, Sign.COMPLEMENT), Whole(32, Sign.NONE)
INT64, UINT64 = Whole(64, Sign.COMPLEMENT), Whole(64, Sign.NONE)
"""Types of constants."""

# What functions that read and write bytes call their parameters and variables.
IN = Identifier("in")
OUT = Identifier("out")
VALUE = Identifier("value")
LENGTH = Identifier("length")
CAPACITY = Identifier("capacity")
NUMBER = Identifier("number")
INDEX = Local("at", SIZE_TYPE)
TRUE = Literal("true")
FALSE = Literal("false")
ZERO = Literal("0")
NULL = Literal("NULL")

_ESCAPES = {"\\": "\\\\", '"': '\\"', "\n": "\\n", "\r": "\\r", "\t": "\\t", "?": "\\?"}
_ESCAPED = re.compile(r'[^ -~]|[\\"?]')


@lru_cache(maxsize=_CACHE_SIZE)
def string(text: str) -> Literal:
    """A string in UTF-8. Octal escapes have three digits, so that no digit behind them joins in."""
    return Literal(f'"{_ESCAPED.sub(_escape, text)}"')


def _escape(match: re.Match[str]) -> str:
    char = match[0]
    return _ESCAPES.get(char) or "".join(f"\\{byte:03o}" for byte in char.encode("utf-8", "replace"))


_OCTAL_BYTES = tuple([f"\\{byte:03o}" for byte in range(256)])


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
    """A constant in hexadecimal with at least so many digits: `0x3A`"""
    return Literal(f"0x{value:0{digits}X}{unsigned_mark}")


def whole_double(value: int) -> Literal:
    """A whole number as a double: `16384.0`"""
    return Literal(f"{value}.0")


def real(value: float, precision: Precision) -> Literal:
    """A number as a float, `16384.0f`, which those of half precision are too, or as a double: `16384.0`"""
    text = repr(value) if isinstance(value, float) else f"{value}.0"
    match precision:
        case Precision.HALF | Precision.SINGLE:
            return Literal(f"{text}f")
        case Precision.DOUBLE:
            return Literal(text)
        case _:
            assert_never(precision)


def double(value: float) -> Literal:
    """A number as a double, with as many digits as tell it from all others."""
    return Literal(repr(value))


_HEXADECIMAL_BYTES = tuple([f"0x{byte:02X}" for byte in range(256)])


def byte_initializer(data: bytes) -> Literal:
    """The bytes of an array: `{0x01, 0x02}`"""
    return Literal(f"{{{', '.join([_HEXADECIMAL_BYTES[byte] for byte in data])}}}")


def equal(left: Expression, right: Expression) -> Operation:
    """`left == right`"""
    return Operation("==", (left, right))


def different(left: Expression, right: Expression) -> Operation:
    """`left != right`"""
    return Operation("!=", (left, right))


def less(left: Expression, right: Expression) -> Operation:
    """`left < right`"""
    return Operation("<", (left, right))


def greater(left: Expression, right: Expression) -> Operation:
    """`left > right`"""
    return Operation(">", (left, right))


def at_least(left: Expression, right: Expression) -> Operation:
    """`left >= right`"""
    return Operation(">=", (left, right))


def at_most(left: Expression, right: Expression) -> Operation:
    """`left <= right`"""
    return Operation("<=", (left, right))


def add(left: Expression, right: Expression) -> Operation:
    """`left + right`"""
    return Operation("+", (left, right))


def subtract(left: Expression, right: Expression) -> Operation:
    """`left - right`"""
    return Operation("-", (left, right))


def multiply(left: Expression, right: Expression) -> Operation:
    """`left * right`"""
    return Operation("*", (left, right))


def add_size(size: Expression, number: int) -> Expression:
    """`size + 2u`, `size - 2u`, or the size itself where there is nothing to add."""
    if number < 0:
        return Operation("-", (size, unsigned(-number)))
    return Operation("+", (size, unsigned(number))) if number else size


def all_of(tests: Sequence[Expression]) -> Expression:
    """`first && second`; a single test stands alone."""
    return tests[0] if len(tests) == 1 else Operation("&&", tuple(tests))


def any_of(tests: Sequence[Expression]) -> Expression:
    """`first || second`; a single test stands alone."""
    return tests[0] if len(tests) == 1 else Operation("||", tuple(tests))


def negate(test: Expression) -> Unary:
    """`!test`"""
    return Unary("!", test)


def address_of(variable: Expression) -> Unary:
    """`&variable`"""
    return Unary("&", variable)


def dereference(pointer: Expression) -> Unary:
    """`*pointer`"""
    return Unary("*", pointer)
