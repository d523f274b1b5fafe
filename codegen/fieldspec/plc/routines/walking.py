"""Ways through the statements of a routine."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.plc.routines.expressions import (
    Call,
    Conversion,
    Element,
    Expression,
    Member,
    Negation,
    Operation,
    Shift,
)
from fieldspec.plc.routines.routine import Routine
from fieldspec.plc.routines.statements import Assignment, Condition, Loop, Selection, every_statement


def calls(routine: Routine) -> Iterator[Call]:
    """The calls of other routines."""
    for statement in every_statement(routine.body):
        match statement:
            case Assignment(target, value):
                roots: tuple[Expression, ...] = (target, value)
            case Condition(branches):
                roots = tuple(test for test, _ in branches)
            case Loop(_, first, last):
                roots = (first, last)
            case Selection(of):
                roots = (of,)
            case _:
                roots = ()
        for root in roots:
            yield from (one for one in every_expression(root) if isinstance(one, Call))


def every_expression(of: Expression) -> Iterator[Expression]:
    """An expression and those within it."""
    yield of
    match of:
        case Member(inner) | Negation(inner) | Shift(_, inner) | Conversion(inner):
            yield from every_expression(inner)
        case Element(inner, index):
            yield from every_expression(inner)
            yield from every_expression(index)
        case Operation(_, operands):
            for one in operands:
                yield from every_expression(one)
        case Call(_, inputs, outputs):
            for _, one in (*inputs, *outputs):
                yield from every_expression(one)
