"""Expressions of C: frozen trees, which `printer.py` writes with the parentheses that C needs."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeAlias

from fieldspec.foundation.classes import dataclass


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


# What functions that read and write bytes call their parameters and variables.
IN = Identifier("in")
OUT = Identifier("out")
VALUE = Identifier("value")
LENGTH = Identifier("length")
CAPACITY = Identifier("capacity")
NUMBER = Identifier("number")
INDEX = Local("at", SIZE_TYPE)


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
        return Operation("-", (size, Literal(f"{-number}u")))
    return Operation("+", (size, Literal(f"{number}u"))) if number else size


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
