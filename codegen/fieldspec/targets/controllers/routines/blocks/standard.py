"""What all blocks have in common: their variables, their steps, and the numbers of their errors."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, TypeAlias

from fieldspec.foundation.classes import dataclass, replace
from fieldspec.targets.controllers.routines.blocks.ports import port_members
from fieldspec.targets.controllers.routines.exchanges import ERRORS as EXCHANGE_ERRORS
from fieldspec.targets.controllers.routines.exchanges import reasons
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.sources.expansion import Expansion
from fieldspec.targets.controllers.statements.expressions import (
    BOOL,
    TIME,
    TIMER,
    Expression,
    Member,
    StructType,
    Truth,
    Variable,
    either,
    every,
    number,
)
from fieldspec.targets.controllers.statements.interfaces import BlockVariables
from fieldspec.targets.controllers.statements.routine import (
    Assignment,
    Body,
    Condition,
    Remark,
    Routine,
    Statement,
    Timing,
    when,
)

ERRORS = {
    **EXCHANGE_ERRORS,
    "alarm": (8, "alarm"),
    "late": (9, "too late"),
    "servo": (10, "servo off"),
    "unready": (11, "not ready"),
    "locked": (12, "being stopped"),
    "idle": (13, "not begun"),
    "short": (14, "ended before its target"),
}
"""The numbers of ErrorID, and what they mean."""
TRANSFER_ERRORS = {**EXCHANGE_ERRORS, "late": ERRORS["late"]}
"""Those of blocks that move nothing."""
REASONS = reasons(ERRORS)


@dataclass(frozen=True, slots=True)
class Section:
    """A step of a block: the statements that send its request, and those that take the response."""

    ask: tuple[Statement, ...]
    take: tuple[Statement, ...] = ()
    remark: str = ""


Branches: TypeAlias = tuple[tuple[tuple[tuple[int, int], ...], tuple[Statement, ...]], ...]


class BlockDraft(BlockVariables):
    """A block while it is being made. Its steps are numbered from 1 on; the step 0 is after the last one.

    `carrier` is the source of what carries its requests, `slots` is what the sources may name.
    `refusal` is the variable that says whether a value of an input is refused, by the number of an error.
    """

    carrier = "telegram"
    expansion: Expansion
    refusal: Variable

    def __init__(self, world: World, name: str, group: str) -> None:
        super().__init__()
        self.world, self.name, self.group = world, name, group
        self.remarks: list[str] = []
        self.steps: list[Section] = []
        self.at_start: list[Statement] = []
        self.timed: list[tuple[Variable, Expression, Variable]] = []
        self.settling: list[int] = []
        self.status = world.status
        self.slots: dict[str, Any] = {"is_asked_for": False}

    def expand(self, expansion: Expansion) -> None:
        """Takes the source of the block, which has declared its variables."""
        self.expansion, self.action = expansion, expansion.action
        self.result, self.step = self.variable("Diagnostics"), self.variable("iStep")
        self.reason = self.refusal = self.variable("uiReason")
        self.good = self.result.compared("=", self.status.of("ok"))

    def variable(self, name: str) -> Variable:
        """A variable of the source."""
        variable = self.expansion.scope[name]
        assert isinstance(variable, Variable)
        return variable

    def flag(self, name: str, remark: str = "") -> Variable:
        """A BOOL that the block keeps between scans."""
        return self.declared_once(name, BOOL, "local", remark)

    def struct(self, name: str, key: str, remark: str = "") -> Variable:
        """A struct that the block has as VAR_IN_OUT, by its key."""
        kind = StructType(self.world.names.structs[key])
        return self.declared_once(name, kind, "in_out", remark)

    def lend_axis(self) -> Variable:
        """The struct that says who moves the axis."""
        axis = self.slots["Axis"]
        assert isinstance(axis, Variable)
        return axis

    def of_axis(self, name: str) -> Member:
        """A member of the struct that says who moves the axis."""
        axis = self.lend_axis()
        assert isinstance(axis.type, StructType)
        return Member(axis, *port_members(self.world)[axis.type.name][name])

    def fail(self, reason: str) -> Statement:
        """The statement that gives the block a reason to end with an error."""
        return Assignment(self.reason, REASONS[reason])

    def refuse(self) -> Statement:
        """The statement that refuses a value of an input."""
        return Assignment(self.refusal, REASONS["request"])

    def unrefused(self) -> Expression:
        """Whether no value of an input is refused."""
        return self.refusal.compared("=", 0)

    def add(self, ask: Iterable[Statement], take: Iterable[Statement] = (), remark: str = "") -> int:
        """Adds a step, and gives its number."""
        self.steps.append(Section(tuple(ask), tuple(take), remark))
        return len(self.steps)

    @property
    def next(self) -> int:
        """The number of the step that is added next."""
        return len(self.steps) + 1

    def go(self, step: int) -> Statement:
        """The statement that goes to a step."""
        return Assignment(self.step, number(step))

    def end(self) -> Statement:
        """The statement that goes to step 0, after the last one."""
        return self.go(0)

    def timer(self, name: str, running: Expression, time: str, initial: str, remark: str) -> Expression:
        """Declares a timer with its time as an input, and gives whether the time is over."""
        timer = self.declared_once(name, TIMER, "local")
        if all(timer != other for other, _, _ in self.timed):
            self.timed.append((timer, running, self.declared_once(time, TIME, "input", remark, initial)))
        return Member(timer, "Q", BOOL)

    def settle(self, initial: str) -> None:
        """Adds a step that waits a time in which the device takes over what it was sent."""
        step = self.next
        self.settling.append(step)
        timer = self.declared_once("fbSettle", TIMER, "local")
        remark = "how long the device has to read a telegram before the next change or read"
        self.declared_once("SettlingTime", TIME, "input", remark, initial)
        self.add([when(Member(timer, "Q", BOOL), [self.go(step + 1)])], remark="the device sees what was sent")

    def timers(self) -> list[Statement]:
        """The statements that call the timers of steps."""
        return [Timing(timer, running, time) for timer, running, time in self.timed]

    def settling_timer(self) -> list[Statement]:
        """The statement that calls the timer of what was sent, where a step waits for it."""
        if not self.settling:
            return []
        running = either([self.step.compared("=", step) for step in self.settling])
        return [Timing(Variable("fbSettle", TIMER), running, Variable("SettlingTime", TIME))]

    def between(self, first: int, last: int) -> Expression:
        """Whether the step lies between two steps, both included; FALSE where there is no last one."""
        if not last:
            return Truth(False)
        if first == last:
            return self.step.compared("=", first)
        return every([self.step.compared(">=", first), self.step.compared("<=", last)])

    def branches(self, asks: bool) -> Branches:
        """The branches of a CASE over the step, without those for steps that have no statements."""
        bodies = [
            (position, step.ask if asks else step.take, step.remark) for position, step in enumerate(self.steps, 1)
        ]
        return tuple(
            (((position, position),), (Remark(remark), *body) if remark else body)
            for position, body, remark in bodies
            if body
        )

    def unharmed(self) -> Expression:
        """Whether there is no reason to end with an error."""
        return self.reason.compared("=", 0)

    def attempts(self, calls: Iterable[Expression], success: Body, reason: str) -> list[Statement]:
        """The statements that call functions while each returns Ok, and go on with `success`, or fail."""
        first, *following = (Assignment(self.result, call) for call in calls)
        return [
            first,
            *(when(self.good, [call]) for call in following),
            when(self.good, success, [self.fail(reason)]),
        ]

    def finished(self) -> Routine:
        """The routine of the block, without local variables that no statement uses."""
        routine = self.expansion.routine(self.name, self.group)
        return replace(routine, remarks=tuple(filter(None, self.remarks)))


def assigned(variable: Expression, value: bool) -> Statement:
    """The statement that makes a BOOL TRUE or FALSE."""
    return Assignment(variable, Truth(value))


def chain(branches: Sequence[tuple[Expression, Sequence[Statement]]], otherwise: Sequence[Statement] = ()) -> Statement:
    """An IF statement with a branch for each test."""
    return Condition(tuple((test, tuple(body)) for test, body in branches), tuple(otherwise))
