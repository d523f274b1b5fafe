"""Statements: frozen trees over expressions."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TypeAlias

from fieldspec.classes import dataclass
from fieldspec.plc.routines.expressions import Expression, Listed, Variable


@dataclass(frozen=True, slots=True)
class Assignment:
    """`target := value;`"""

    target: Expression
    value: Expression


@dataclass(frozen=True, slots=True)
class Condition:
    """IF, with as many further tests as there are branches; `otherwise` may be empty."""

    branches: tuple[tuple[Expression, Body], ...]
    otherwise: Body = ()


@dataclass(frozen=True, slots=True)
class Loop:
    """FOR from `first` to `last`, both included; nothing is done where `last` is less."""

    index: Variable
    first: Expression
    last: Expression
    body: Body


@dataclass(frozen=True, slots=True)
class Selection:
    """CASE; each branch has the intervals of whole numbers, or the members of an enum, for which it is taken."""

    of: Expression
    branches: tuple[tuple[tuple[tuple[int, int] | Listed, ...], Body], ...]
    otherwise: Body = ()


@dataclass(frozen=True, slots=True)
class Return:
    """RETURN."""


Statement: TypeAlias = Assignment | Condition | Loop | Selection | Return
Body: TypeAlias = tuple[Statement, ...]


def when(test: Expression, body: Iterable[Statement], otherwise: Iterable[Statement] = ()) -> Condition:
    """IF with one test."""
    return Condition(((test, tuple(body)),), tuple(otherwise))
