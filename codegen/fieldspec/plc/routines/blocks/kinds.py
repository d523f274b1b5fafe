"""How blocks start and end: by an edge, or while an input is TRUE. What moves an axis is in `motion.py`."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import TypeAlias

from fieldspec.plc.routines.blocks.standard import BlockDraft, assigned, chain
from fieldspec.plc.routines.expressions import BOOL, Expression, Negation, compared, either, every, number
from fieldspec.plc.routines.routine import Assignment, Statement, when

Branch: TypeAlias = tuple[Expression, Sequence[Statement]]
EDGES = (
    "Nothing starts without a rising edge of Execute, the first scan included; a rising edge while Busy starts again, "
    "with the inputs of its scan. Done, CommandAborted and Error stay until Execute is FALSE, and at least one scan. "
    "Call the block in each scan."
)


class Kind(ABC):
    """How a block starts and ends.

    `release` gives up what it has asked for, `drop` does so at the end of the scan; both are empty where it asks for
    nothing.
    """

    def __init__(self, draft: BlockDraft) -> None:
        self.draft = draft
        self.release: Sequence[Statement] = ()
        self.drop: Sequence[Statement] = ()

    @abstractmethod
    def edges(self) -> list[Statement]:
        """The statements that evaluate the inputs in each scan."""

    def guards(self) -> list[Branch]:
        """The branches that precede the step: where the test of one holds, the step is not carried out."""
        return []

    def active(self) -> Expression:
        """The condition under which the block carries out its steps."""
        return self.draft.busy

    def may_ask(self) -> list[Expression]:
        """The conditions under which the block may send a request."""
        return []

    def on_ask(self) -> list[Statement]:
        """The statements that follow when the block has sent a request."""
        return []

    def accepted(self) -> list[Statement]:
        """The statements that follow from a response, whichever step has parsed it."""
        return []

    def urgent(self) -> Expression | None:
        """The condition under which it stops, which precedes other requests; None where it never does."""
        return None

    def pressing(self) -> Expression | None:
        """The condition under which its requests precede all but stops; None where they never do."""
        return None

    @abstractmethod
    def tail(self) -> list[Statement]:
        """The statements that end the block."""


class Edged(Kind):
    """A block that each rising edge of Execute starts."""

    comment = EDGES

    def __init__(self, draft: BlockDraft, aborted: bool) -> None:
        super().__init__(draft)
        self.fresh: list[Statement] = []
        self.declare_start()
        draft.outputs("Done", aborted)
        draft.steps_from(0)
        self.declare_edge()

    def declare_start(self) -> None:
        """Declares the input that starts the block."""
        self.execute: Expression = self.draft.declare("Execute", BOOL, "input", "a rising edge starts")

    def declare_edge(self) -> None:
        """Declares the variables that detect the rising edge."""
        self.edge = self.draft.declare("xEdge", BOOL, "local")
        remark = "so that nothing starts in the first scan"
        self.before = self.draft.declare("xExecuteBefore", BOOL, "local", remark, "TRUE")

    def find_edge(self) -> list[Statement]:
        """The statements that detect the rising edge."""
        return [
            Assignment(self.edge, every([self.execute, Negation(self.before)])),
            Assignment(self.before, self.execute),
        ]

    def idle(self) -> Branch:
        """The branch that resets the outputs of a block that has ended."""
        draft = self.draft
        return every([Negation(draft.busy), Negation(self.execute)]), draft.cleared()

    def begun(self) -> list[Statement]:
        """The statements that begin the block at the edge."""
        draft = self.draft
        return [*self.release, *draft.cleared(), assigned(draft.busy, True), draft.go(1), *self.fresh]

    def forget_first(self, flag: Expression) -> None:
        """Adds the reset of a flag to what the block does at the edge."""
        if assigned(flag, False) not in self.fresh:
            self.fresh.append(assigned(flag, False))

    def may_ask(self) -> list[Expression]:
        """See `Kind`."""
        return [Negation(self.edge)]

    def over(self, *statements: Statement) -> Statement:
        """The statement that leaves the block once one of its outputs says that it has ended."""
        draft = self.draft
        return chain([(either(draft.ends()), [*self.drop, *statements, assigned(draft.busy, False), draft.end()])])

    def done(self) -> Branch:
        """The branch that ends the block after its last step."""
        return compared(self.draft.step, "=", number(0)), self.ended_well()

    def ended_well(self) -> list[Statement]:
        """The statements for an end without an error."""
        return [assigned(self.draft.done, True)]


class Executed(Edged):
    """A block that carries out its steps once; its input Abort, if it has one, ends it."""

    def __init__(self, draft: BlockDraft, abort: bool) -> None:
        self._has_abort = abort
        super().__init__(draft, abort)

    def declare_start(self) -> None:
        """See `Edged`."""
        super().declare_start()
        if self._has_abort:
            self.abort = self.draft.declare("Abort", BOOL, "input", "ends the block with CommandAborted")

    def limit(self) -> None:
        """Ends the block with an error when its time is over."""
        self.late = self.draft.timer("fbLimit", self.draft.busy, "tLimit", "T#60s", "the longest time until Done")

    late: Expression | None = None

    def edges(self) -> list[Statement]:
        """See `Kind`."""
        draft = self.draft
        begin = [*self.begun(), draft.forgotten(), *draft.at_start]
        return [*self.find_edge(), chain([(self.edge, begin), self.idle()])]

    def tail(self) -> list[Statement]:
        """See `Kind`."""
        draft = self.draft
        late = [when(self.late, [draft.fail("late")])] if self.late is not None else []
        branches: list[Branch] = []
        if draft.aborted is not None:
            branches.append((self.abort, [assigned(draft.aborted, True)]))
        branches += [(draft.failed(), draft.erroneous()), self.done()]
        return [*late, chain(branches), self.over()]


class Reading(Kind):
    """A block that reads while Enable is TRUE. It goes on after an error, and recovers by itself."""

    comment = "Reads again and again while Enable is TRUE, after an error too. Call the block in each scan."

    def __init__(self, draft: BlockDraft) -> None:
        super().__init__(draft)
        self.enable = draft.declare("Enable", BOOL, "input", "reads while it is TRUE")
        draft.outputs("Valid", False)
        draft.steps_from(1)

    def edges(self) -> list[Statement]:
        """See `Kind`."""
        draft = self.draft
        off: list[Statement] = [*self.release, *draft.cleared(), assigned(draft.busy, False), draft.go(1)]
        return [when(Negation(self.enable), off)]

    def active(self) -> Expression:
        """See `Kind`."""
        return self.enable

    def tail(self) -> list[Statement]:
        """See `Kind`."""
        draft = self.draft
        wrong = [assigned(draft.done, False), *draft.erroneous(), draft.forgotten(), draft.go(1)]
        right = [*draft.cleared()[1:], assigned(draft.done, True), draft.go(1)]
        finished = compared(draft.step, "=", number(0))
        return [
            chain([(draft.failed(), wrong), (finished, right)]),
            Assignment(draft.busy, Negation(draft.error)),
        ]
