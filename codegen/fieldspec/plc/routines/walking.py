"""A way through the statements of a routine and the expressions in them."""

from __future__ import annotations

from fieldspec.plc.routines.expressions import (
    Call,
    Conversion,
    Element,
    Expression,
    Fraction,
    Listed,
    Member,
    Negation,
    Operation,
    Shift,
    Truth,
    Variable,
    Whole,
)
from fieldspec.plc.routines.routine import Routine
from fieldspec.plc.routines.statements import Assignment, Condition, Loop, Return, Selection, Statement

# Most of what there is.
_LEAVES = frozenset({Variable, Whole, Listed, Fraction, Truth, Return})


def called(routine: Routine) -> set[str]:
    """The names of the routines that it calls."""
    found: set[str] = set()
    left: list[Statement | Expression] = [*routine.body]
    while left:
        one = left.pop()
        if one.__class__ in _LEAVES:
            continue
        if isinstance(one, Assignment):
            left += (one.target, one.value)
        elif isinstance(one, Operation):
            left += one.operands
        elif isinstance(one, Member | Negation | Shift | Conversion):
            left.append(one.of)
        elif isinstance(one, Element):
            left += (one.of, one.index)
        elif isinstance(one, Condition):
            for test, body in one.branches:
                left.append(test)
                left += body
            left += one.otherwise
        elif isinstance(one, Call):
            found.add(one.routine)
            left += [given for _, given in (*one.inputs, *one.outputs)]
        elif isinstance(one, Loop):
            left += (one.first, one.last, *one.body)
        elif isinstance(one, Selection):
            left.append(one.of)
            for _, body in one.branches:
                left += body
            left += one.otherwise
    return found
