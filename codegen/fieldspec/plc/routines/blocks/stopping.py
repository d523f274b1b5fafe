"""How blocks stop an axis, and lock it."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.plc.routines.blocks.kinds import Edged
from fieldspec.plc.routines.blocks.motion import AxisPort, between
from fieldspec.plc.routines.blocks.ports import increment
from fieldspec.plc.routines.blocks.standard import BlockDraft, assigned, chain
from fieldspec.plc.routines.expressions import UDINT, UINT, Expression, Negation, Operation, Whole, every
from fieldspec.plc.routines.routine import Assignment, Statement, when


class Stopping(Edged):
    """A block that stops the axis, and locks it while Execute is TRUE. It asks until it is answered."""

    comment = (
        "While it is Busy or Execute is TRUE, the axis is locked: no motion starts. It asks for the stop until it is "
        "answered, and is Busy until the device stands."
    )

    def __init__(self, draft: BlockDraft, axis: AxisPort) -> None:
        super().__init__(draft, aborted=False)
        self.axis = axis
        remark = "why its last request has failed, an ErrorID; it asks again"
        self.last_error = draft.declare("uiLastError", UINT, "output", remark)
        self.lock = draft.flag("xLocking", "the axis is locked by this block")
        self.stop = 0
        self.insists: Sequence[Statement] = ()

    def take_over(self) -> list[Statement]:
        """The statements that give the axis to the block, whose stop is accepted."""
        return [increment(self.axis.motion)]

    def edges(self) -> list[Statement]:
        """See `Kind`."""
        draft, stops = self.draft, self.axis.stops
        successor = Operation("+", (stops, Whole(1, UDINT)), UDINT)
        lock = [Assignment(stops, successor), assigned(self.lock, True)]
        begin = [*self.begun(), Assignment(self.last_error, Whole(0, UINT)), draft.forgotten(), *draft.at_start]
        allowed = [Negation(self.lock), *([draft.unharmed()] if draft.at_start else [])]
        begin.append(when(every(allowed), lock))
        return [*self.find_edge(), chain([(self.edge, begin), self.idle()])]

    def urgent(self) -> Expression | None:
        """See `Kind`."""
        return between(self.draft, 1, self.stop) if self.stop else None

    def tail(self) -> list[Statement]:
        """See `Kind`."""
        draft = self.draft
        repeat = [Assignment(self.last_error, draft.reason), draft.forgotten(), *self.drop, draft.go(1)]
        refused = [(every([draft.failed(), self.edge]), draft.erroneous())] if draft.at_start else []
        return [*self.insists, chain([*refused, (draft.failed(), repeat), self.done()]), self.over()]

    def unlock(self) -> Statement:
        """The statement that unlocks the axis, for each scan."""
        stops = self.axis.stops
        releases = every([self.lock, Negation(self.draft.busy), Negation(self.execute)])
        less = Assignment(stops, Operation("-", (stops, Whole(1, UDINT)), UDINT))
        return when(releases, [when(self.axis.locked, [less]), assigned(self.lock, False)])
