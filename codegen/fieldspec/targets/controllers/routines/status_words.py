"""The status of a Siemens block in one WORD: busy, done, or an error."""

from __future__ import annotations

from fieldspec.targets.controllers.routines.named_numbers import named
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.statements.expressions import BOOL, UINT, WORD, Expression, Whole, either, every
from fieldspec.targets.controllers.statements.routine import Assignment, Condition, Routine, Variables

_IDLE, _FIRST, _FURTHER = (
    named(value, WORD, "status", name, hexadecimal=True)
    for value, name in ((0x7000, "no_call"), (0x7001, "first_call"), (0x7002, "subsequent_call"))
)
_CLASSES = {1: (0x8200, "parameter"), 7: (0x8600, "exchange"), 65535: (0x8400, "device")}
"""What errors are added to, by the greatest number that belongs to each class: as SINA_POS has them."""


def status_word(world: World) -> Routine:
    """The function that gives the status of a block: 16#7000 no job, 7001 begins, 7002 works, 0 done, 16#8xxx an error.

    The low byte of an error is the number of its reason.
    """
    variables = Variables()
    status = variables.declare("wBefore", WORD, "input", "the status so far")
    reason = variables.declare("uiErrorID", UINT, "input", "0, or why there is an error")
    busy, done = (variables.declare(name, BOOL, "input") for name in ("xBusy", "xDone"))
    routine = Routine(world.routine("status_word"), "blocks", WORD, tuple(variables.declared), (), _REMARKS)
    errors = [(reason.compared("<=", maximum), _error(reason, *names)) for maximum, names in _CLASSES.items()]
    works = every([busy, either([status.compared("=", own) for own in (_FIRST, _FURTHER)])])
    values: list[tuple[Expression, Expression]] = [(works, _FURTHER), (busy, _FIRST), (done, Whole(0, WORD, True))]
    none = reason.compared("=", 0)
    branches = [(every([none, test]), value) for test, value in values] + [(none, _IDLE), *errors[:-1]]
    body = Condition(
        tuple((test, (Assignment(routine.result, value),)) for test, value in branches),
        (Assignment(routine.result, errors[-1][1]),),
    )
    return Routine(routine.name, routine.group, WORD, routine.declared, (body,), routine.remarks)


_REMARKS = (
    "The status of a block: 16#7000 no job, 16#7001 begins, 16#7002 works, 0 done, 16#82xx a refused value, 16#84xx "
    "the device, 16#86xx the exchange of messages; xx is the number of the reason.",
)


def _error(reason: Expression, base: int, name: str) -> Expression:
    first = named(base, UINT, "status", name, hexadecimal=True)
    return first.combined("+", reason).converted(WORD)
