"""How blocks jog: while an input is TRUE, in its direction."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.targets.controllers.routines.blocks.kinds import Branch
from fieldspec.targets.controllers.routines.blocks.motion import AxisPort, Moving
from fieldspec.targets.controllers.routines.blocks.standard import BlockDraft, assigned, chain
from fieldspec.targets.controllers.statements.expressions import (
    BOOL,
    Expression,
    Negation,
    compared,
    either,
    every,
    number,
)
from fieldspec.targets.controllers.statements.routine import Assignment, Statement, when


class Jogging(Moving):
    """A block that moves the axis in a direction while the input of that direction alone is TRUE."""

    comment = (
        "It moves while one of its inputs is TRUE; with both TRUE, or none, it stops, and is Busy until the device "
        "stands. Nothing starts in the first scan, and after an error or CommandAborted not before both inputs were "
        "FALSE. These outputs stay while an input is TRUE, and at least one scan. Call the block in each scan."
    )

    def __init__(self, draft: BlockDraft, axis: AxisPort, forward: bool, backward: bool) -> None:
        self._directions = {"JogForward": ("positive", forward), "JogBackward": ("negative", backward)}
        super().__init__(draft, axis)

    remembers = False

    def declare_start(self) -> None:
        """See `Edged`."""
        self.levels = [
            self.draft.declare(name, BOOL, "input", f"moves in the {direction} direction while it is TRUE")
            for name, (direction, exists) in self._directions.items()
            if exists
        ]

    def declare_edge(self) -> None:
        """See `Edged`."""
        draft = self.draft
        self.edge = draft.declare("xEdge", BOOL, "local", "a motion begins in this scan")
        self.ready = draft.flag("xReady", "no input was TRUE since the first scan, or the last error")
        self.execute = either(self.levels)
        self.pressed = draft.flag("xPressed", "an input was TRUE in the scan before")
        self.backward = draft.flag("xBackward", "the direction of the motion")
        self.released = draft.flag("xReleased", "an input that was TRUE alone is so no more")
        self.held = [draft.flag(f"x{level.name}Before", "it was TRUE in the scan before") for level in self.levels]
        if len(self.levels) == 1:
            self.wanted = self.levels[0]
        else:
            turned = compared(self.backward, "=", self.levels[1])
            self.wanted = every([_single(self.levels), turned])

    def edges(self) -> list[Statement]:
        """See `Kind`."""
        draft = self.draft
        # At its end it begins in the other direction where that alone is asked for.
        free = either([Negation(draft.busy), compared(draft.step, "=", number(0))])
        may_begin = every([self.ready, free, _single(self.levels)])
        direction = [Assignment(self.backward, self.levels[1])] if len(self.levels) > 1 else []
        return [
            when(Negation(self.execute), [assigned(self.ready, True)]),
            Assignment(self.edge, may_begin),
            chain([(self.edge, [*direction, *self.converted(), *self.begun()]), self.idle()]),
            Assignment(self.pressed, self.execute),
            *(self._changes() if self.stop else []),
        ]

    def _changes(self) -> list[Statement]:
        """The statements that record whether an input has fallen, or another one has risen beside it."""
        pairs = list(zip(self.levels, self.held, strict=True))
        changed = either([compared(level, "<>", before) for level, before in pairs])
        released = Assignment(self.released, every([_single(self.held), changed]))
        return [released, *(Assignment(before, level) for level, before in pairs)]

    def guards(self) -> list[Branch]:
        """See `Kind`. What begins to move after its end was asked for is ended anew where an input falls again."""
        if not self.stop:
            return super().guards()
        draft = self.draft
        is_sent = compared(draft.step, ">", number(self.stop))
        ends_anew = every([self.released, self.ending_flag, draft.unharmed(), is_sent])
        return [*super().guards(), (ends_anew, [*self.drop, draft.go(self.ending)])]

    def idle(self) -> Branch:
        """See `Edged`. Both inputs at once begin nothing, and end what was shown before."""
        draft = self.draft
        fresh = either([Negation(self.execute), Negation(self.pressed)])
        return every([Negation(draft.busy), fresh]), draft.cleared()

    def ended_well(self) -> list[Statement]:
        """See `Edged`."""
        return [when(Negation(_single(self.levels)), super().ended_well())]

    def over(self, *statements: Statement) -> Statement:
        """See `Edged`."""
        fresh = Assignment(self.ready, Negation(self.execute))
        return super().over(*statements, when(Negation(self.draft.done), [fresh]))


def _single(levels: Sequence[Expression]) -> Expression:
    """Whether exactly one of the inputs is TRUE."""
    return levels[0] if len(levels) == 1 else compared(levels[0], "<>", levels[1])
