"""How blocks move an axis: who is responsible for it, how a motion ends, what a stop locks.

A block takes the axis over when the device has accepted its command, and the block before it ends then. A block that
fails while its command may be on its way ends the motion before it says so.
"""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.targets.controllers.routines.blocks.kinds import Branch, Edged
from fieldspec.targets.controllers.routines.blocks.ports import increment
from fieldspec.targets.controllers.routines.blocks.standard import ERRORS, BlockDraft, assigned, chain
from fieldspec.targets.controllers.statements.expressions import (
    INT,
    UDINT,
    UINT,
    Expression,
    Member,
    Negation,
    Operation,
    Variable,
    Whole,
    compared,
    either,
    every,
    number,
    plus,
)
from fieldspec.targets.controllers.statements.routine import Assignment, Statement, when

TRIES = 3
"""How often the end of a motion is asked for, where it fails."""
_NONE = Whole(0, UINT)


class AxisPort:
    """The members of a port that say which block has the axis."""

    MEMBERS = ("motion", "claims", "stops", "active", "unseen", "exclusive")

    def __init__(self, *members: Member) -> None:
        self.motion, self.claims, self.stops, self.active, self.unseen, self.exclusive = members

    @property
    def locked(self) -> Expression:
        """Whether a stop has the axis."""
        return compared(self.stops, ">", Whole(0, UDINT))


def between(draft: BlockDraft, first: int, last: int) -> Expression:
    """Whether the step of the block lies between two steps, both included."""
    if first == last:
        return compared(draft.step, "=", number(first))
    return every([compared(draft.step, ">=", number(first)), compared(draft.step, "<=", number(last))])


class Moving(Edged):
    """A block that moves the axis, or halts it.

    `commands` are the steps whose requests begin the motion, `look` is the one behind its acceptance. `ending` is the
    first step of what ends the motion, and `stop` the last one that asks for its end, both 0 where nothing does.
    `at_once` is done where it begins, `restart` where its end begins, `tries` is how often that is tried. `wanted` is
    None, or what must hold for the motion to go on. One that `halts` is sent before all starts, and has failed only
    where none of its tries succeeds.
    """

    def __init__(self, draft: BlockDraft, axis: AxisPort, halts: bool = False) -> None:
        self.halts = halts
        self.wanted: Expression | None = None
        super().__init__(draft, aborted=True)
        self.axis = axis
        draft.refusal = draft.declare("uiRefusal", UINT, "local", "why the inputs of the last edge are refused")
        self.pending = draft.flag("xPending", "an edge that has not begun yet") if self.remembers else None
        self.earlier = draft.flag("xEarlier", "a command of before may be moving the axis")
        self.sent = draft.flag("xSent", "the command may be on its way")
        self.taken = draft.flag("xTaken", "the device has accepted the command: the block has the axis")
        self.accepts = draft.flag("xAccepted", "the device has accepted the command in this scan")
        self.ending_flag = draft.flag("xEnding", "the motion is being ended")
        self.counted = draft.flag("xActive", "the port counts the command of this block as one that is under way")
        self.alone = draft.flag("xAlone", "nothing else was under way when the command went out")
        self.owner = draft.declare("udiOwner", UDINT, "local", "the count of motions when the block had the axis last")
        self.claim = draft.declare("udiClaim", UDINT, "local", "the count of starts with the one of this block")
        self.first_reason = draft.declare("uiFirstReason", UINT, "local", "why the motion is being ended")
        self.tries_left = draft.declare("iTry", INT, "local")
        self.look = self.ending = self.stop = 0
        self.commands: list[int] = []
        self.restart: Sequence[Statement] = ()
        self.at_once: Sequence[Statement] = ()
        self.tries = TRIES
        self.lowered: Sequence[Statement] = ()
        self.lowered_unless_done: Sequence[Statement] = ()

    late: Expression | None = None
    hidden = False
    """Whether the device does not show that it takes the command: no other may be under way then."""
    remembers = True
    """Whether an edge that comes while the motion is being ended begins afterwards."""

    def limit(self) -> None:
        """Adds the time limit after which the motion is ended."""
        running = every([self.draft.busy, Negation(self.ending_flag)])
        self.late = self.draft.timer("fbLimit", running, "tLimit", "T#60s", "the longest time until Done")

    def on_ask(self) -> list[Statement]:
        """See `Kind`. They record that the command may be on its way."""
        steps = [compared(self.draft.step, "=", number(step)) for step in self.commands]
        return [when(either(steps), self.goes_out())] if steps else []

    def goes_out(self) -> list[Statement]:
        """The statements that record that the command is on its way: acceptances from now on come after it."""
        earlier = Assignment(self.earlier, self.still_earlier())
        unseen: list[Statement] = []
        if not self.halts:
            alone = compared(self.axis.active, "=", Whole(0, UDINT))
            unseen = [assigned(self.axis.unseen, True), Assignment(self.alone, alone)]
        return [earlier, assigned(self.sent, True), Assignment(self.owner, self.axis.motion), *unseen]

    def still_earlier(self) -> Expression:
        """Whether an earlier command may be moving the axis, and no other has been accepted since."""
        return every([self.earlier, compared(self.owner, "=", self.axis.motion)])

    def take_over(self) -> list[Statement]:
        """The statements that give the axis to the block, whose command is accepted."""
        return [assigned(self.accepts, True)]

    def accepted(self) -> list[Statement]:
        """See `Kind`."""
        motion = self.axis.motion
        takeover = [increment(motion), Assignment(self.owner, motion), assigned(self.taken, True)]
        return [when(self.accepts, [*takeover, assigned(self.accepts, False)])]

    def edges(self) -> list[Statement]:
        """See `Kind`."""
        assert self.pending is not None
        return [
            *self.find_edge(),
            chain([(self.edge, [*self.converted(), assigned(self.pending, True)]), self.idle()]),
            # A halt that is asked for anew is sent anew; what moves begins when the motion before has ended.
            when(self.pending if self.halts else every([self.pending, Negation(self.ending_flag)]), self.begun()),
        ]

    def converted(self) -> list[Statement]:
        """The statements that convert the inputs."""
        draft = self.draft
        return [Assignment(draft.refusal, _NONE), *draft.at_start] if draft.at_start else []

    def begun(self) -> list[Statement]:
        """See `Edged`."""
        draft, axis = self.draft, self.axis
        reason = draft.refusal if draft.at_start else _NONE
        claims = [increment(axis.claims), Assignment(self.claim, axis.claims)]
        unlocked = [] if reason == _NONE else [draft.unharmed()]
        start = [when(self._clashes(), [draft.fail("unready")], [*claims, *self.at_once])]
        same = compared(self.owner, "=", axis.motion)
        return [
            *([assigned(self.pending, False)] if self.pending is not None else []),
            *super().begun(),
            Assignment(self.earlier, every([either([self.earlier, self.sent, self.taken]), same])),
            Assignment(self.owner, axis.motion),
            *(assigned(flag, False) for flag in (self.sent, self.taken)),
            *([assigned(self.ending_flag, False)] if self.halts else []),
            Assignment(self.first_reason, _NONE),
            Assignment(draft.reason, reason),
            when(every([*unlocked, Negation(axis.locked)]), [*claims, *self.at_once] if self.halts else start),
        ]

    def guards(self) -> list[Branch]:
        """See `Kind`."""
        draft, axis = self.draft, self.axis
        assert draft.aborted is not None
        displaced = compared(self.owner, "<>", axis.motion)
        superseded = compared(self.claim, "<>", axis.claims)
        # A motion that was being ended because another one was to begin was not too short.
        short = compared(self.first_reason, "=", Whole(ERRORS["short"][0], UINT))
        ended: list[Statement] = [draft.forgotten()]
        if not self.halts:
            ended.append(when(Negation(every([superseded, short])), [Assignment(draft.reason, self.first_reason)]))
        ended.append(Assignment(draft.aborted, draft.unharmed()))
        if self.pending is not None:
            # An edge in this very scan begins in the next one, and nothing is told of the motion before.
            ended = [Assignment(self.pending, self.edge), draft.forgotten(), when(Negation(self.edge), ended[1:])]
        ended += [assigned(flag, False) for flag in self._flags()]
        waits = [Negation(self.taken), Negation(self.ending_flag)]
        locked = [assigned(self.earlier, False), when(draft.unharmed(), [draft.fail("locked")])]
        goes_on = [*self.drop, *self.take_over(), draft.go(self.look)]
        # What is asked for over a line is answered before another start goes out, so that its own answer decides.
        unsent = [Negation(self.sent)] if self.stop else []
        lost: list[Branch] = [(self.still_earlier(), [draft.fail("short")])]
        if not self.stop:
            lost.insert(0, (self.sent, goes_on))
        left = chain(lost, [assigned(draft.aborted, True)])
        branches: list[Branch] = [
            (every([either([self.sent, self.taken, self.ending_flag]), displaced]), ended),
            (every([axis.locked, *waits]), [when(self.sent, self.drop or goes_on, locked)]),
        ]
        if self.wanted is not None:
            withdrawn = [Negation(self.wanted), draft.unharmed(), Negation(self.ending_flag)]
            branches.append((every(withdrawn), self._withdrawn()))
        if not self.halts:
            branches.append((every([superseded, draft.unharmed(), *waits, *unsent]), [left]))
        if self.late is not None:
            branches.append((every([self.late, Negation(self.ending_flag)]), [draft.fail("late")]))
        return branches

    def _withdrawn(self) -> list[Statement]:
        """The statements for a motion whose input is no longer TRUE."""
        draft = self.draft
        moving = either([self.sent, self.taken, self.still_earlier()])
        return [when(moving, self._end_begun(), [draft.forgotten(), draft.end()])]

    def _flags(self) -> tuple[Variable, ...]:
        return self.sent, self.taken, self.earlier, self.ending_flag

    def _end_begun(self) -> list[Statement]:
        """The statements that begin to end the motion and record the reason."""
        draft = self.draft
        return [
            *self.drop,
            when(Negation(self.taken), [Assignment(self.owner, self.axis.motion)]),
            Assignment(self.first_reason, draft.reason),
            draft.forgotten(),
            assigned(self.ending_flag, True),
            *([Assignment(self.tries_left, number(self.tries))] if self.tries > 1 else []),
            *self.restart,
            draft.go(self.ending),
        ]

    def seen_to_move(self) -> Statement:
        """The statement that records motion, unless another command was under way when this one was sent."""
        return when(self.alone, [assigned(self.axis.unseen, False)])

    def alarmed(self, tests: Sequence[Expression]) -> list[Statement]:
        """The statements that record an alarm as the reason, while the motion is being ended."""
        reason = Assignment(self.first_reason, Whole(ERRORS["alarm"][0], UINT))
        return [when(test, [reason]) for test in tests]

    def urgent(self) -> Expression | None:
        """See `Kind`."""
        if not self.stop:
            return None
        return between(self.draft, self.ending, self.stop)

    def pressing(self) -> Expression | None:
        """See `Kind`. Whether its command is accepted is looked at before another start goes out."""
        if not self.commands or self.look <= max(self.commands) + 1:
            return None
        return every([self.sent, Negation(self.taken), Negation(self.ending_flag)])

    def tail(self) -> list[Statement]:
        """See `Kind`."""
        draft = self.draft
        branches: list[Branch] = []
        if self.ending:
            remark = "the longest time until it stands, where its motion is being ended"
            late = draft.timer("fbEnding", self.ending_flag, "tEnding", "T#5s", remark)
            branches.append((self.ending_flag, self._ending(late)))
            at_command = either([compared(draft.step, "=", number(step)) for step in self.commands])
            refused = every([compared(draft.reason, "=", Whole(ERRORS["exception"][0], UINT)), at_command])
            maybe = every([self.sent, Negation(refused)]) if self.commands else self.sent
            may_move = either([self.taken, self.still_earlier(), maybe])
            branches.append((every([draft.failed(), may_move]), self._end_begun()))
        branches += [(draft.failed(), draft.erroneous()), self.done()]
        flags = [assigned(flag, False) for flag in self._flags() if self.ending or flag is not self.ending_flag]
        lowered = [*self.lowered]
        if self.lowered_unless_done:
            lowered.append(when(Negation(draft.done), self.lowered_unless_done))
        return [chain(branches), self.over(*flags, *lowered), self._count()]

    def _count(self) -> Statement:
        """The statement that counts the block's command in the port until the block has ended."""
        active = self.axis.active
        less = Assignment(active, Operation("-", (active, Whole(1, UDINT)), UDINT))
        lost = when(compared(active, ">", Whole(0, UDINT)), [less])
        changes = compared(self.counted, "<>", either([self.sent, self.taken, self.ending_flag, self.still_earlier()]))
        counts = when(self.counted, [lost], [increment(active)])
        alone = [Assignment(self.axis.exclusive, self.counted)] if self.hidden else []
        return when(changes, [counts, Assignment(self.counted, Negation(self.counted)), *alone])

    def _clashes(self) -> Expression:
        """Whether the device could not show which of two commands it carries out, this one or another block's."""
        if not self.hidden:
            return self.axis.exclusive
        active, own = self.axis.active, Whole(1, UDINT)
        return either([compared(active, ">", own), every([compared(active, "=", own), Negation(self.counted)])])

    def _ending(self, late: Expression) -> list[Statement]:
        """The statements while the motion is being ended: further tries, and the end."""
        draft = self.draft
        once_more: list[Branch] = []
        if self.tries > 1:
            is_retried = every([draft.failed(), compared(self.tries_left, ">", number(1))])
            minus = Assignment(self.tries_left, plus(self.tries_left, -1))
            once_more.append((is_retried, [*self.drop, draft.forgotten(), minus, draft.go(self.ending)]))
        finished = compared(draft.step, "=", number(0))
        flags = [assigned(flag, False) for flag in (self.ending_flag, self.sent, self.taken)]
        outcome = when(draft.failed(), draft.erroneous(), self.ended_well())
        tells = [compared(self.first_reason, "<>", _NONE), *([draft.failed()] if self.halts else [])]
        ended: list[Statement] = [
            *flags,
            *([] if self.pending is None else [Assignment(self.earlier, draft.failed())]),
            when(every(tells), [Assignment(draft.reason, self.first_reason)]),
            outcome if self.pending is None else when(Negation(self.pending), [outcome]),
        ]
        return [
            when(every([late, draft.unharmed(), compared(draft.step, ">", number(self.stop))]), [draft.fail("late")]),
            chain([*once_more, (either([draft.failed(), finished]), ended)]),
        ]


def unready(kind: Moving, draft: BlockDraft, moves: Expression) -> Branch:
    """The branch for an axis that has to stand: the block's own motion is ended, then it begins again."""
    kind.hidden = True
    remember_edge = [Assignment(kind.pending, kind.still_earlier())] if kind.pending is not None else []
    return either([moves, kind.still_earlier()]), [*remember_edge, draft.fail("unready")]
