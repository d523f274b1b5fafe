"""No block tests what is known from the statements before: such a branch is always taken, or never."""

from __future__ import annotations

import operator
from collections.abc import Iterator

import pytest

from fieldspec.targets.controllers.statements.expressions import (
    BOOL,
    Call,
    Expression,
    Member,
    Negation,
    Operation,
    Truth,
    Variable,
    Whole,
)
from fieldspec.targets.controllers.statements.routine import Assignment, Body, Condition, Selection, Statement
from fieldspec.targets.iec.backend import source
from layouts import SPECS, layouts, newest

COMPARISONS = {
    "=": operator.eq,
    "<>": operator.ne,
    "<": operator.lt,
    ">": operator.gt,
    "<=": operator.le,
    ">=": operator.ge,
}
Known = dict[Expression, int]


def outcome(expression: Expression, known: Known) -> int | None:
    """The value of an expression; None where the statements before do not decide it."""
    match expression:
        case Whole() | Truth():
            return expression.value
        case Variable() | Member():
            return known.get(expression)
        case Negation():
            inner = outcome(expression.of, known)
            return None if inner is None else not inner
        case Operation() if expression.type == BOOL:
            values = [outcome(operand, known) for operand in expression.operands]
            if expression.operator in COMPARISONS:
                left, right = values
                return None if left is None or right is None else COMPARISONS[expression.operator](left, right)
            decides = expression.operator == "OR"
            if decides in values:
                return decides
            return None if None in values else not decides
    return None


def decided(body: Body, known: Known) -> Iterator[Statement]:
    """The statements whose test, or whose BOOL, is known; `known` is what variables hold, before and then after."""
    for statement in body:
        match statement:
            case Assignment():
                value = outcome(statement.value, known)
                if value is not None and isinstance(statement.value, Operation | Negation):
                    yield statement
                known.pop(statement.target, None)
                known |= {} if value is None else {statement.target: value}
                if isinstance(statement.value, Call):
                    known.clear()
            case Condition():
                if any(outcome(test, known) is not None for test, _ in statement.branches):
                    yield statement
                ends = []
                for branch in (*(body for _, body in statement.branches), statement.otherwise):
                    ends.append(dict(known))
                    yield from decided(branch, ends[-1])
                same = {key: ends[0][key] for key in ends[0] if all(end.get(key) == ends[0][key] for end in ends)}
                known.clear()
                known |= same
            case Selection():
                for _, branch in statement.branches:
                    yield from decided(branch, dict(known))
                known.clear()
            case _:
                known.clear()


@pytest.mark.parametrize("device", layouts(SPECS))
def test_no_block_tests_what_is_known(device: str) -> None:
    blocks = [routine for routine in source(newest(SPECS, device)).routines if routine.returns is None]
    assert len(blocks) > 10
    statements = {block.name: list(decided(block.body, {})) for block in blocks}
    assert [name for name, known in statements.items() if known] == []
