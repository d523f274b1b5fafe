"""How blocks start and end, and how they move an axis: what their sources may name. The sources say what they do."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeAlias

from fieldspec.targets.controllers.routines.blocks.ports import (
    ABANDONED,
    ANSWERED,
    ASKED,
    FREE,
    POSTPONED,
    PRESSING,
    URGENT,
    port_members,
)
from fieldspec.targets.controllers.routines.blocks.standard import REASONS, BlockDraft, assigned
from fieldspec.targets.controllers.routines.exchanges import judging_slots
from fieldspec.targets.controllers.routines.named_numbers import named
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.sources.expansion import Expansion, source
from fieldspec.targets.controllers.statements.expressions import INT, UINT, Expression, Whole, either, number
from fieldspec.targets.controllers.statements.routine import Routine, Statement

Branch: TypeAlias = tuple[Expression, Sequence[Statement]]
_HANDSHAKE: dict[str, dict[str, Whole]] = {
    "Reason": {**REASONS, "postponed": named(POSTPONED, UINT, "error", "postponed")},
    "Port": {
        name: named(state, INT, "port", name)
        for name, state in {"free": FREE, "asked": ASKED, "answered": ANSWERED, "abandoned": ABANDONED}.items()
    },
    "Urgency": {
        name: named(urgency, INT, "urgency", name) for name, urgency in {"pressing": PRESSING, "urgent": URGENT}.items()
    },
}
TRIES = 3
"""How often a failed read of the end of a motion is repeated."""


def handshake_slots(world: World) -> dict[str, Any]:
    """The names for sources of blocks that send requests through ports, and of blocks that serve them."""
    return {**judging_slots(world), **_HANDSHAKE}


def port_constants() -> list[Whole]:
    """All constants of ports: the states, the errors, and what goes before others."""
    return [constant for constants in _HANDSHAKE.values() for constant in constants.values()]


class Kind:
    """How a block starts and ends. `sources` say what it does, `comment` says so in the output.

    `fresh` is done where it starts; `late` is whether its time is over.
    """

    sources: tuple[str, ...]
    comment = (
        "Only a rising edge of Execute starts it, the first scan included; one while Busy restarts it with its "
        "inputs. Done, CommandAborted, Error stay until Execute is FALSE, at least one scan. Call it in each scan."
    )

    def __init__(self, draft: BlockDraft, **slots: Any) -> None:
        self.draft = draft
        self.fresh: list[Statement] = []
        self.late: Expression | None = None
        lists = {"fresh": self.fresh, "at_start": draft.at_start}
        slots = {**handshake_slots(draft.world), **draft.slots, **lists, **slots}
        sources = source(*self.sources, draft.carrier)
        draft.expand(Expansion(sources, draft, slots, port_members(draft.world)))

    def known(self) -> dict[str, Any]:
        """The names for sources once the steps of the block are known."""
        draft = self.draft
        return {
            "converts": bool(draft.at_start),
            "late": False if self.late is None else self.late,
            "has_end": False,
            "timers": draft.timers(),
            "settling": draft.settling_timer(),
            "asks": draft.branches(asks=True),
            "takes": draft.branches(asks=False),
        }

    def block(self, **slots: Any) -> Routine:
        """The block. `slots` is what its carrier knows."""
        self.draft.expansion.scope |= {**self.known(), **slots}
        return self.draft.finished()

    def limit(self) -> None:
        """Ends the block with an error, or its motion, when its time is over."""
        running = self.draft.expansion.property("Limited")
        self.late = self.draft.timer("fbLimit", running, "TimeLimit", "T#60s", "the longest time until Done")

    def forget_first(self, flag: Expression) -> None:
        """Adds the reset of a flag to what the block does where it starts."""
        if assigned(flag, False) not in self.fresh:
            self.fresh.append(assigned(flag, False))


class Executed(Kind):
    """A block that carries out its steps once; its input Abort, if it has one, ends it."""

    sources = ("executed",)

    def __init__(self, draft: BlockDraft, abort: bool) -> None:
        super().__init__(draft, is_abortable=abort, has_axis=False)


class Reading(Kind):
    """A block that reads while Enable is TRUE. It continues after an error, and recovers by itself."""

    sources = ("reading",)
    comment = "Reads again and again while Enable is TRUE, after an error too. Call it in each scan."


class Stopping(Kind):
    """A block that stops the axis, and locks it while Execute is TRUE. `stop` is the last step that asks for it."""

    sources = ("judged", "stopping")
    comment = (
        "While it is Busy or Execute is TRUE, the axis is locked: no motion starts. It asks for the stop until it is "
        "answered, and is Busy until the device stands."
    )

    def __init__(self, draft: BlockDraft) -> None:
        self.stop = 0
        super().__init__(draft, is_abortable=False, has_axis=True)

    def known(self) -> dict[str, Any]:
        """See `Kind`."""
        return {**super().known(), "stops": self.draft.between(1, self.stop)}


class Moving(Kind):
    """A block that moves the axis, or halts it.

    `commands` are the steps whose requests begin the motion, `look` is the one after its acceptance. `ending` is the
    first step of what ends the motion, and `stop` the last one that asks for its end, both 0 where nothing does.
    `at_once` is done where it begins, `restart` where its end begins, `tries` is how often that is tried. A motion that
    `lasts` continues while Execute is TRUE. One that `halts` is sent before all starts, and has failed only where none
    of its tries succeeds. Where the device does not show that it takes the command, it is `hidden`: no other may be
    under way then. Where it `remembers`, an edge that comes while the motion is being ended begins afterwards.
    """

    sources: tuple[str, ...] = ("edged", "judged", "moving")
    remembers = True

    def __init__(self, draft: BlockDraft, halts: bool = False, **slots: Any) -> None:
        self.halts = halts
        super().__init__(draft, is_abortable=True, has_axis=True, halts=halts, remembers=self.remembers, **slots)
        draft.refusal = draft.variable("uiRefusal")
        self.look = self.ending = self.stop = 0
        self.commands: list[int] = []
        self.restart: Sequence[Statement] = ()
        self.at_once: Sequence[Statement] = ()
        self.lowered: Sequence[Statement] = ()
        self.lowered_unless_done: Sequence[Statement] = ()
        self.tries = TRIES
        self.lasts = self.hidden = False

    def known(self) -> dict[str, Any]:
        """See `Kind`."""
        draft = self.draft
        return {
            **super().known(),
            **{name: number(getattr(self, name)) for name in ("look", "ending", "stop", "tries")},
            **{name: getattr(self, name) for name in ("restart", "at_once", "lowered", "lowered_unless_done", "lasts")},
            "is_hidden": self.hidden,
            "is_repeated": self.tries > 1,
            "has_end": self.ending > 0,
            "has_stop": self.stop > 0,
            "stops": draft.between(self.ending, self.stop),
            "looks": bool(self.commands) and self.look > max(self.commands) + 1,
            "at_command": either([draft.step.compared("=", step) for step in self.commands])
            if self.commands
            else False,
            "lowers_unless_done": bool(self.lowered_unless_done),
        }

    def alarmed(self, tests: Sequence[Expression]) -> list[Statement]:
        """The statements that record an alarm as the reason, while the motion is being ended."""
        return [statement for test in tests for statement in self.draft.action("SeeAlarm", is_there=test)]

    def unready(self, moves: Expression) -> Branch:
        """The branch for an axis that has to stand: the block's own motion is ended, then it begins again."""
        self.hidden = True
        moves = either([moves, self.draft.expansion.property("StillEarlier")])
        return moves, self.draft.action("AskForStandstill")


class Jogging(Moving):
    """A block that moves the axis in a direction while the input of that direction alone is TRUE."""

    sources = ("levels", "judged", "moving", "jogging")
    comment = (
        "It moves while one of its inputs is TRUE; with both TRUE, or none, it stops, and is Busy until the device "
        "stands. Nothing starts in the first scan, and after an error or CommandAborted not before both inputs were "
        "FALSE. These outputs stay while an input is TRUE, and at least one scan. Call it in each scan."
    )
    remembers = False

    def __init__(self, draft: BlockDraft, forward: bool, backward: bool) -> None:
        super().__init__(draft, has_forward=forward, has_backward=backward)
