"""Expressions of C: frozen trees, which `printer.py` writes with the parentheses that C needs."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from fieldspec.foundation.classes import dataclass


@dataclass(frozen=True, slots=True)
class Type:
    """A type where something is declared: `const uint8_t *`"""

    name: str
    const: bool = False
    pointer: bool = False


def _operator(symbol: str) -> Callable[[Expression, Expression], Operation]:
    return lambda left, right: Operation(symbol, (left, right))


class Expression:
    """A tree that has a value. Its operators make larger trees: `size + unsigned(2)` is `size + 2u` in C."""

    __slots__ = ()

    __add__ = _operator("+")
    __sub__ = _operator("-")
    __mul__ = _operator("*")
    __truediv__ = _operator("/")
    __mod__ = _operator("%")
    __and__ = _operator("&")
    __or__ = _operator("|")
    __xor__ = _operator("^")
    __lshift__ = _operator("<<")
    __rshift__ = _operator(">>")
    equals = _operator("==")
    differs = _operator("!=")
    less = _operator("<")
    greater = _operator(">")
    at_least = _operator(">=")
    at_most = _operator("<=")

    def plus(self, number: int) -> Expression:
        """`size + 2u`, `size - 2u`, or the size itself where there is nothing to add."""
        if number < 0:
            return self - Literal(f"{-number}u")
        return self + Literal(f"{number}u") if number else self

    def negated(self) -> Unary:
        """`!test`"""
        return Unary("!", self)

    def address(self) -> Unary:
        """`&variable`"""
        return Unary("&", self)

    def dereferenced(self) -> Unary:
        """`*pointer`"""
        return Unary("*", self)

    def member(self, name: str) -> Member:
        """`structure.name`"""
        return Member(self, name)

    def arrow(self, name: str) -> PointerMember:
        """`pointer->name`"""
        return PointerMember(self, name)

    def element(self, index: Expression) -> Element:
        """`array[index]`"""
        return Element(self, index)

    def cast(self, name: str) -> Cast:
        """`(uint16_t)operand`"""
        return Cast(name, self)


@dataclass(frozen=True, slots=True)
class Identifier(Expression):
    """A parameter, a constant or a macro by its name."""

    name: str


@dataclass(frozen=True, slots=True)
class Local(Expression):
    """A local variable, which is declared where the function that may have it is printed, if it uses it."""

    name: str
    type: Type


@dataclass(frozen=True, slots=True)
class Literal(Expression):
    """A constant as it is written; only the functions below make one."""

    text: str


@dataclass(frozen=True, slots=True)
class Call(Expression):
    """A call of a function, or of a macro that looks like one."""

    function: str
    arguments: tuple[Expression, ...]


@dataclass(frozen=True, slots=True)
class Member(Expression):
    """`structure.name`"""

    structure: Expression
    name: str


@dataclass(frozen=True, slots=True)
class PointerMember(Expression):
    """`pointer->name`"""

    pointer: Expression
    name: str


@dataclass(frozen=True, slots=True)
class Element(Expression):
    """`array[index]`"""

    array: Expression
    index: Expression


@dataclass(frozen=True, slots=True)
class Unary(Expression):
    """An operator before its operand: `!`, `~`, `&` or `*`"""

    operator: str
    operand: Expression


@dataclass(frozen=True, slots=True)
class Cast(Expression):
    """`(uint16_t)operand`"""

    type: str
    operand: Expression


@dataclass(frozen=True, slots=True)
class SizeOf(Expression):
    """`sizeof operand`"""

    operand: Expression


@dataclass(frozen=True, slots=True)
class Operation(Expression):
    """Operands joined by one operator, from left to right."""

    operator: str
    operands: tuple[Expression, ...]


@dataclass(frozen=True, slots=True)
class Group(Expression):
    """Parentheses that C does not need and readers do."""

    content: Expression


@dataclass(frozen=True, slots=True)
class Conditional(Expression):
    """`test ? positive : negative`"""

    test: Expression
    positive: Expression
    negative: Expression


@dataclass(frozen=True, slots=True)
class Initializer(Expression):
    """The values of an array or a struct: `{0x01, 0x02}`"""

    values: tuple[Expression, ...]


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


def all_of(tests: Sequence[Expression]) -> Expression:
    """`first && second`; a single test stands alone."""
    return tests[0] if len(tests) == 1 else Operation("&&", tuple(tests))


def any_of(tests: Sequence[Expression]) -> Expression:
    """`first || second`; a single test stands alone."""
    return tests[0] if len(tests) == 1 else Operation("||", tuple(tests))
