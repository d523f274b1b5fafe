"""What all blocks have in common: variables, edges, and the outputs that say how a block has ended."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from fieldspec.classes import dataclass
from fieldspec.plc.routines.blocks.ports import increment
from fieldspec.plc.routines.exchanges import ERRORS as EXCHANGE_ERRORS
from fieldspec.plc.routines.expressions import (
    BOOL,
    INT,
    TIME,
    TIMER,
    UDINT,
    UINT,
    Expression,
    Member,
    Negation,
    StructType,
    Truth,
    Variable,
    Whole,
    compared,
    either,
    every,
    number,
)
from fieldspec.plc.routines.routine import (
    Assignment,
    Body,
    Condition,
    Routine,
    Selection,
    Statement,
    Timing,
    Variables,
    when,
)
from fieldspec.plc.routines.world import World

ERRORS = {
    "request": (EXCHANGE_ERRORS["request"][0], "a value is refused, see eStatus"),
    "timeout": (EXCHANGE_ERRORS["timeout"][0], "no answer in time"),
    "damaged": (EXCHANGE_ERRORS["damaged"][0], "a damaged answer, or a value that is not listed, see eStatus"),
    "station": (EXCHANGE_ERRORS["station"][0], "an answer of another station"),
    "other": (EXCHANGE_ERRORS["other"][0], "an answer to another request"),
    "exception": (EXCHANGE_ERRORS["exception"][0], "the device refuses"),
    "transport": (EXCHANGE_ERRORS["transport"][0], "nothing could be sent or received"),
    "alarm": (8, "the device has an alarm"),
    "late": (9, "tLimit is over"),
    "servo": (10, "the servo is off"),
    "unready": (11, "the device is not ready for the task"),
}
"""The numbers of ErrorID, and what they mean."""


@dataclass(frozen=True, slots=True)
class Section:
    """What a block does while it has a number as its step: `ask` when it may, and `take` when it was answered."""

    ask: tuple[Statement, ...]
    take: tuple[Statement, ...] = ()


class BlockDraft(Variables):
    """A block while it is being made. `levelled` blocks work while Enable is TRUE; the others start by an edge.

    `port` is the struct through which it asks; its `steps` are numbered from 1 on, and a block that has the number
    behind the last one is done.
    """

    def __init__(self, world: World, name: str, group: str, levelled: bool = False) -> None:
        super().__init__()
        self.world, self.name, self.group, self.levelled = world, name, group, levelled
        self.remarks: list[str] = []
        self.steps: list[Section] = []
        self.at_start: list[Statement] = []
        self.settling: list[int] = []
        self.status = world.status
        start = "reads while it is TRUE" if levelled else "a rising edge starts"
        self.start = self.declare("Enable" if levelled else "Execute", BOOL, "input", start)
        self.abort = None if levelled else self.declare("Abort", BOOL, "input", "ends the block with CommandAborted")
        self.done = self.declare("Valid" if levelled else "Done", BOOL, "output")
        self.busy = self.declare("Busy", BOOL, "output")
        self.aborted = None if levelled else self.declare("CommandAborted", BOOL, "output")
        self.error = self.declare("Error", BOOL, "output")
        self.error_id = self.declare("ErrorID", UINT, "output", "0, or why Error is TRUE")
        self.result = self.declare("eStatus", self.status.type, "output", "what the last function has returned")
        self.step = self.declare("iStep", INT, "local")
        self.reason = self.declare("uiReason", UINT, "local")
        self.good = compared(self.result, "=", self.status.of("ok"))

    def struct(self, name: str, key: str, remark: str = "") -> Variable:
        """A struct that the block is lent, by its key."""
        kind = StructType(self.world.names.structs[key])
        return self.declared_once(self.world.variable(name, kind), kind, "in_out", remark)

    def fail(self, reason: str) -> Statement:
        """The statement that says why the block ends."""
        return Assignment(self.reason, Whole(ERRORS[reason][0], UINT))

    def add(self, ask: Iterable[Statement], take: Iterable[Statement] = ()) -> int:
        """Adds a step, and gives its number."""
        self.steps.append(Section(tuple(ask), tuple(take)))
        return len(self.steps)

    @property
    def next(self) -> int:
        """The number of the step that is added next."""
        return len(self.steps) + 1

    def go(self, step: int) -> Statement:
        """The statement that goes to a step."""
        return Assignment(self.step, number(step))

    def settle(self) -> None:
        """Adds a step that waits until the device can show what it was told."""
        step = self.next
        self.settling.append(step)
        timer = self.declared_once("fbSettle", TIMER, "local")
        self.add([when(_over(timer), [self.go(step + 1)])])

    def limit(self) -> None:
        """Ends the block with an error when its time is over."""
        time = self.declared_once("tLimit", TIME, "input", "the longest time until Done", "T#60s")
        timer = self.declared_once("fbLimit", TIMER, "local")
        assert time
        self.late = _over(timer)

    late: Expression | None = None
    steady: Variable | None = None
    """What fbSettle times in place of the steps that wait for it: a command that stands."""

    def take_over(self, count: Expression) -> None:
        """Ends the motion of every other block with the same count, and this one when another takes over."""
        owner = self.declare("udiOwner", UDINT, "local")
        self.claim = [when(self.unharmed(), [increment(count)]), Assignment(owner, count)]
        self.displaced = compared(owner, "<>", count)

    displaced: Expression | None = None
    claim: Sequence[Statement] = ()

    def selected(self, bodies: Sequence[tuple[Statement, ...]]) -> list[Statement]:
        """CASE over the step, without the steps that have nothing to do."""
        branches = tuple((((at, at),), body) for at, body in enumerate(bodies, 1) if body)
        return [Selection(self.step, branches)] if branches else []

    def timers(self) -> list[Statement]:
        """The calls of the timers."""
        calls: list[Statement] = []
        names = {declared.variable.name: declared.variable for declared in self.declared}
        if "fbSettle" in names:
            settling = either([compared(self.step, "=", number(step)) for step in self.settling])
            running = settling if self.steady is None else self.steady
            calls.append(Timing(names["fbSettle"], running, names["tSettle"]))
        if "fbLimit" in names:
            calls.append(Timing(names["fbLimit"], self.busy, names["tLimit"]))
        return calls

    def settle_input(self, initial: str) -> None:
        """Declares the time that the device has to show what it was told."""
        remark = "how long the device may take to show what it was told; the manual does not print it"
        self.declared_once("tSettle", TIME, "input", remark, initial)

    def begins(self) -> list[Statement]:
        """What starts and ends the block by its input, while it is not busy."""
        reset: list[Statement] = [Assignment(variable, Truth(False)) for variable in self._ends()]
        reset.append(Assignment(self.error_id, Whole(0, UINT)))
        begin: list[Statement] = [
            Assignment(self.busy, Truth(True)),
            Assignment(self.reason, Whole(0, UINT)),
            self.go(1),
            *self.at_start,
            *self.claim,
        ]
        if self.levelled:
            return [
                when(Negation(self.start), reset),
                when(every([self.start, Negation(self.error)]), begin),
            ]
        edge = self.declare("xEdge", BOOL, "local")
        before = self.declare("xExecuteBefore", BOOL, "local", "so that nothing starts in the first scan", "TRUE")
        self.edges: list[Statement] = [
            Assignment(edge, every([self.start, Negation(before)])),
            Assignment(before, self.start),
        ]
        return [when(either([edge, Negation(self.start)]), reset), when(edge, begin)]

    edges: Sequence[Statement] = ()

    def _ends(self) -> list[Variable]:
        return [variable for variable in (self.done, self.aborted, self.error) if variable is not None]

    def outcome(self, early: Sequence[tuple[Expression, Sequence[Statement]]] = ()) -> Statement:
        """What sets the output that says how the block ends, unless one of some tests holds before."""
        branches = list(early)
        stops = [test for test in (self.displaced, self.abort) if test is not None]
        if self.aborted is not None and stops:
            branches.append((either(stops), [Assignment(self.aborted, Truth(True))]))
        branches += [
            (self.failed(), [Assignment(self.error_id, self.reason), Assignment(self.error, Truth(True))]),
            (compared(self.step, ">", number(len(self.steps))), [Assignment(self.done, Truth(True))]),
        ]
        return chain(branches)

    def over(self, *others: Statement) -> Statement:
        """What a block does when one of its outputs says that it has ended."""
        return when(either(self._ends()), [*others, Assignment(self.busy, Truth(False)), self.go(0)])

    def again(self, *others: Statement) -> Statement:
        """The end of a block that reads while Enable is TRUE: it begins again, or stops."""
        invalid = Assignment(self.done, Truth(False))
        off: list[Statement] = [invalid, *others, Assignment(self.busy, Truth(False))]
        wrong: list[Statement] = [
            *(invalid, Assignment(self.error_id, self.reason), Assignment(self.error, Truth(True))),
            Assignment(self.busy, Truth(False)),
        ]
        round_again: list[Statement] = [Assignment(self.done, Truth(True)), self.go(1)]
        behind = compared(self.step, ">", number(len(self.steps)))
        return chain([(Negation(self.start), off), (self.failed(), wrong), (behind, round_again)])

    def finished(self, body: Sequence[Statement]) -> Routine:
        """The block; local variables that no statement uses are left out."""
        declared = self.needed(tuple(body))
        return Routine(self.name, self.group, None, declared, tuple(body), tuple(filter(None, self.remarks)))

    def unharmed(self) -> Expression:
        """Whether there is no reason to end with an error."""
        return compared(self.reason, "=", Whole(0, UINT))

    def failed(self) -> Expression:
        """Whether there is a reason to end with an error."""
        return compared(self.reason, "<>", Whole(0, UINT))

    def attempt(self, call: Expression, then: Body, reason: str) -> list[Statement]:
        """Calls a function, and goes on where it returns Ok; else ends with an error."""
        return [Assignment(self.result, call), when(self.good, then, [self.fail(reason)])]


def _over(timer: Variable) -> Expression:
    return Member(timer, "Q", BOOL)


def meanings(reasons: Mapping[str, tuple[int, str]]) -> str:
    """A line of a comment that says what the numbers of ErrorID mean."""
    return "ErrorID: " + "; ".join(f"{code} {text}" for code, text in reasons.values()) + "."


def chain(branches: Sequence[tuple[Expression, Sequence[Statement]]], otherwise: Sequence[Statement] = ()) -> Statement:
    """IF with several tests."""
    return Condition(tuple((test, tuple(body)) for test, body in branches), tuple(otherwise))
