"""What all blocks have in common: their variables, their steps, and the numbers of their errors."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from fieldspec.foundation.classes import dataclass
from fieldspec.targets.controllers.routines.exchanges import ERRORS as EXCHANGE_ERRORS
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.statements.expressions import (
    BOOL,
    INT,
    TIME,
    TIMER,
    UINT,
    Expression,
    Member,
    StructType,
    Truth,
    Variable,
    Whole,
    compared,
    either,
    number,
)
from fieldspec.targets.controllers.statements.routine import (
    Assignment,
    Body,
    Condition,
    Remark,
    Routine,
    Selection,
    Statement,
    Timing,
    Variables,
    when,
)

ERRORS = {
    "request": (EXCHANGE_ERRORS["request"][0], "a value is refused, see eStatus"),
    "timeout": (EXCHANGE_ERRORS["timeout"][0], "no answer in time"),
    "damaged": (EXCHANGE_ERRORS["damaged"][0], "a damaged answer, or a value that is not listed, see eStatus"),
    "station": (EXCHANGE_ERRORS["station"][0], "an answer of another station"),
    "other": (EXCHANGE_ERRORS["other"][0], "an answer to another request"),
    "exception": (EXCHANGE_ERRORS["exception"][0], "the device refuses"),
    "transport": (EXCHANGE_ERRORS["transport"][0], "nothing could be sent or received"),
    "alarm": (8, "the device has an alarm"),
    "late": (9, "its time is over"),
    "servo": (10, "the servo is off"),
    "unready": (11, "the device is not ready for the task"),
    "locked": (12, "the axis is being stopped"),
    "idle": (13, "the motion did not begin"),
    "short": (14, "the motion ended before its target"),
}
"""The numbers of ErrorID, and what they mean."""


@dataclass(frozen=True, slots=True)
class Section:
    """A step of a block: the statements that send its request, and those that take the response."""

    ask: tuple[Statement, ...]
    take: tuple[Statement, ...] = ()
    remark: str = ""


class BlockDraft(Variables):
    """A block while it is being made. Its steps are numbered from 1 on; the step 0 is behind the last one.

    `refusal` is the variable that says whether a value of an input is refused, by the number of an error.
    """

    def __init__(self, world: World, name: str, group: str) -> None:
        super().__init__()
        self.world, self.name, self.group = world, name, group
        self.remarks: list[str] = []
        self.steps: list[Section] = []
        self.at_start: list[Statement] = []
        self.timed: list[tuple[Variable, Expression, Variable]] = []
        self.settling: list[int] = []
        self.status = world.status

    def outputs(self, done: str, aborted: bool) -> None:
        """Declares the outputs that say how a block ends."""
        self.done = self.declare(done, BOOL, "output")
        self.busy = self.declare("Busy", BOOL, "output")
        self.aborted = self.declare("CommandAborted", BOOL, "output") if aborted else None
        self.error = self.declare("Error", BOOL, "output")
        self.error_id = self.declare("ErrorID", UINT, "output", "0, or why Error is TRUE")
        self.result = self.declare("eStatus", self.status.type, "output", "what the last function has returned")
        self.reason = self.refusal = self.declare("uiReason", UINT, "local")
        self.good = compared(self.result, "=", self.status.of("ok"))

    def steps_from(self, initial: int) -> None:
        """Declares the variable for the number of the step, with its initial value."""
        self.step = self.declare("iStep", INT, "local", "0 behind the last one", f"{initial}" if initial else "")

    def flag(self, name: str, remark: str = "") -> Variable:
        """A BOOL that the block keeps between scans."""
        return self.declared_once(name, BOOL, "local", remark)

    def struct(self, name: str, key: str, remark: str = "") -> Variable:
        """A struct that the block has as VAR_IN_OUT, by its key."""
        kind = StructType(self.world.names.structs[key])
        return self.declared_once(self.world.variable(name, kind), kind, "in_out", remark)

    def fail(self, reason: str) -> Statement:
        """The statement that gives the block a reason to end with an error."""
        return Assignment(self.reason, Whole(ERRORS[reason][0], UINT))

    def refuse(self) -> Statement:
        """The statement that refuses a value of an input."""
        return Assignment(self.refusal, Whole(ERRORS["request"][0], UINT))

    def unrefused(self) -> Expression:
        """Whether no value of an input is refused."""
        return compared(self.refusal, "=", Whole(0, UINT))

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
        remark = "how long the device has to see what it was sent, before that changes or is looked at"
        self.declared_once("tSettle", TIME, "input", remark, initial)
        self.add([when(Member(timer, "Q", BOOL), [self.go(step + 1)])], remark="the device sees what was sent")

    def timers(self) -> list[Statement]:
        """The statements that call the timers."""
        calls: list[Statement] = [Timing(timer, running, time) for timer, running, time in self.timed]
        if self.settling:
            running = either([compared(self.step, "=", number(step)) for step in self.settling])
            calls.append(Timing(Variable("fbSettle", TIMER), running, Variable("tSettle", TIME)))
        return calls

    def selected(self, asks: bool) -> list[Statement]:
        """A CASE over the step, without branches for steps that have no statements."""
        bodies = [
            (position, step.ask if asks else step.take, step.remark) for position, step in enumerate(self.steps, 1)
        ]
        branches = tuple(
            (((position, position),), (Remark(remark), *body) if remark else body)
            for position, body, remark in bodies
            if body
        )
        return [Selection(self.step, branches)] if branches else []

    def cleared(self) -> list[Statement]:
        """The statements that reset the outputs for the end of the block."""
        ends = [variable for variable in (self.done, self.aborted, self.error) if variable is not None]
        return [*(assigned(variable, False) for variable in ends), Assignment(self.error_id, Whole(0, UINT))]

    def ends(self) -> list[Expression]:
        """The outputs that are TRUE when the block has ended."""
        return [variable for variable in (self.done, self.aborted, self.error) if variable is not None]

    def erroneous(self) -> list[Statement]:
        """The statements that end the block with an error."""
        return [Assignment(self.error_id, self.reason), assigned(self.error, True)]

    def unharmed(self) -> Expression:
        """Whether there is no reason to end with an error."""
        return compared(self.reason, "=", Whole(0, UINT))

    def failed(self) -> Expression:
        """Whether there is a reason to end with an error."""
        return compared(self.reason, "<>", Whole(0, UINT))

    def forgotten(self) -> Statement:
        """The statement that clears the reason to end with an error."""
        return Assignment(self.reason, Whole(0, UINT))

    def attempt(self, call: Expression, success: Body, reason: str) -> list[Statement]:
        """The statements that call a function and go on with `success` where it returns Ok, else fail."""
        return [Assignment(self.result, call), when(self.good, success, [self.fail(reason)])]

    def finished(self, body: Sequence[Statement]) -> Routine:
        """The routine of the block, without local variables that no statement uses."""
        remarks = tuple(filter(None, self.remarks))
        return Routine(self.name, self.group, None, self.needed(tuple(body)), tuple(body), remarks)


def assigned(variable: Expression, value: bool) -> Statement:
    """The statement that makes a BOOL TRUE or FALSE."""
    return Assignment(variable, Truth(value))


def chain(branches: Sequence[tuple[Expression, Sequence[Statement]]], otherwise: Sequence[Statement] = ()) -> Statement:
    """An IF statement with a branch for each test."""
    return Condition(tuple((test, tuple(body)) for test, body in branches), tuple(otherwise))
