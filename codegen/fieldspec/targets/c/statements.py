"""Statements of C: frozen trees over expressions, which `printer.py` writes."""

from __future__ import annotations

from typing import TypeAlias

from fieldspec.foundation.classes import dataclass
from fieldspec.targets.c.expressions import Call, Expression, Identifier, Initializer, Literal, Local, Type


@dataclass(frozen=True, slots=True)
class Assignment:
    """`target = value;`, or with an operator such as `/=`"""

    target: Expression
    value: Expression
    operator: str = "="


@dataclass(frozen=True, slots=True)
class Evaluation:
    """`expression;`, for what it does"""

    expression: Expression


@dataclass(frozen=True, slots=True)
class Expectation:
    """`expect(left == right, what);`: what a self-test tests most of the time"""

    left: Expression
    right: Expression
    what: Literal


@dataclass(frozen=True, slots=True)
class Return:
    """`return value;`"""

    value: Expression | None = None


@dataclass(frozen=True, slots=True)
class Break:
    """`break;`"""


@dataclass(frozen=True, slots=True)
class If:
    """`if (test) { ... }`, then an `else` with more statements, or `else if` where they are a single If."""

    test: Expression
    body: Body
    alternative: Body = ()


@dataclass(frozen=True, slots=True)
class CountUp:
    """`for (at = 0; at < limit; at++) { ... }`"""

    index: Local
    limit: Expression
    body: Body


@dataclass(frozen=True, slots=True)
class CountDown:
    """`for (at = start; at-- > 0;) { ... }`: the index runs from the one before `start` down to 0."""

    index: Local
    start: Expression
    body: Body


@dataclass(frozen=True, slots=True)
class Switch:
    """`switch (value) { ... }`; each branch has its labels and ends with `break`; one without labels is left out."""

    value: Expression
    branches: tuple[tuple[tuple[Expression, ...], Body], ...]
    default: Body


@dataclass(frozen=True, slots=True)
class Variable:
    """`storage type name[dimensions] = value;`: a local variable, a parameter or the member of a struct.

    A dimension that is None is left to the compiler, which counts the values.
    """

    type: Type
    name: str
    dimensions: tuple[Expression | None, ...] = ()
    value: Expression | None = None
    storage: str = ""


@dataclass(frozen=True, slots=True)
class Constant:
    """`enum { name = value };`: a constant that only the function knows."""

    name: str
    value: Expression


@dataclass(frozen=True, slots=True)
class Variables:
    """`type first, second;`"""

    type: Type
    names: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Table:
    """`static const type name[] = { ... };`, one row a line."""

    type: Type
    name: str
    rows: tuple[Initializer, ...]


@dataclass(frozen=True, slots=True)
class Block:
    """Statements in braces of their own."""

    body: Body


@dataclass(frozen=True, slots=True)
class CompileIf:
    """`#if condition`, `#ifdef` or `#ifndef` around statements."""

    directive: str
    condition: str
    body: Body


@dataclass(frozen=True, slots=True)
class Printed:
    """Statements as the lines that they were printed as, at the indent of a function's body."""

    lines: tuple[str, ...]


Statement: TypeAlias = (
    Assignment
    | Evaluation
    | Expectation
    | Return
    | Break
    | If
    | CountUp
    | CountDown
    | Switch
    | Variable
    | Variables
    | Constant
    | Table
    | Block
    | CompileIf
    | Printed
)
Body: TypeAlias = tuple[Statement, ...]


def call(function: str, *arguments: Expression) -> Evaluation:
    """`function(arguments);`"""
    return Evaluation(Call(function, arguments))


def assign(target: Expression, value: Expression) -> Assignment:
    """`target = value;`"""
    return Assignment(target, value)


def return_if(test: Expression, status: Expression) -> If:
    """`if (test) { return status; }`"""
    return If(test, (Return(status),))


def discard(name: str) -> Evaluation:
    """`(void)name;`, so that no compiler warns of a parameter that is not used."""
    return Evaluation(Identifier(name).cast("void"))


def contains(tree: object, node: Expression) -> bool:
    """Whether a node is somewhere in statements or expressions, which are tuples and classes of data."""
    parts = [tree]
    while parts:
        part = parts.pop()
        if part is node:
            return True
        if isinstance(part, tuple):
            parts += part
        elif not isinstance(part, str):
            parts += [getattr(part, name) for name in getattr(part, "__match_args__", ())]
    return False
