"""Blocks that ask through a port: one request at a time, and an answer that comes some scans later."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from fieldspec.plc.routines.blocks.ports import ABANDONED, ANSWERED, ASKED, FREE, increment, member
from fieldspec.plc.routines.blocks.standard import BlockDraft, chain
from fieldspec.plc.routines.expressions import (
    BOOL,
    INT,
    UDINT,
    UINT,
    Expression,
    Member,
    Negation,
    Truth,
    Variable,
    Whole,
    compared,
    either,
    every,
    number,
    plus,
)
from fieldspec.plc.routines.routine import Assignment, Routine, Statement, when
from fieldspec.plc.routines.world import World

_TRIES = 3
"""How often the end of what was started is asked for, where it fails."""


class LineDraft(BlockDraft):
    """A block that asks through the port with a key."""

    def __init__(self, world: World, name: str, group: str, port: str, levelled: bool = False) -> None:
        super().__init__(world, name, group, levelled)
        self.key = port
        self.port = self.struct(_port_name(port), port, "call the block that serves it in each scan")
        self.asked = self.declare("xAsked", BOOL, "local")
        self.hold = False
        self.first, self.ending = 0, (0, 0)

    def of_port(self, name: str) -> Member:
        """A member of the port."""
        return member(self.world, self.key, name, self.port)

    def request(self, fill: Iterable[Statement], take: Iterable[Statement]) -> int:
        """Adds a step that asks, once what `fill` computes is good, and takes the answer."""
        return self.add(fill, take)

    def ask(self, *fields: Statement) -> list[Statement]:
        """The statements that ask."""
        return [*fields, Assignment(self.asked, Truth(True))]

    def ends_by(self, begin: int, first: int, last: int) -> None:
        """Says that the steps from `first` to `last` end what the step `begin` has started, whatever happens."""
        self.first, self.ending = begin, (first, last)

    def block(self) -> Routine:
        """The block."""
        begin = self.begins()
        state = self.of_port("state")
        answered = every([self.asked, compared(state, "=", number(ANSWERED))])
        free = every([Negation(self.asked), compared(state, "=", number(FREE))])
        error = self.of_port("error")
        number_asked, request = self.declare("udiRequest", UDINT, "local"), self.of_port("request")
        takes = self.selected([step.take for step in self.steps])
        asks = self.selected([step.ask for step in self.steps])
        asking = [increment(request), Assignment(number_asked, request), Assignment(state, number(ASKED))]
        working = chain(
            [
                (Negation(self.busy), begin),
                (
                    answered,
                    [
                        Assignment(self.asked, Truth(False)),
                        Assignment(state, number(FREE)),
                        chain(
                            [
                                (compared(self.of_port("answered"), "<>", number_asked), [self.fail("other")]),
                                (compared(error, "<>", Whole(0, UINT)), [Assignment(self.reason, error)]),
                            ],
                            takes,
                        ),
                    ],
                ),
                (free, [*asks, when(self.asked, asking)]),
            ]
        )
        tail = [self.again(self._dropped())] if self.levelled else self._tail()
        return self.finished([*self.timers(), *self.edges, working, when(self.busy, tail)])

    def _dropped(self) -> Statement:
        """What gives up a request; its answer belongs to nobody."""
        state = self.of_port("state")
        release = when(
            compared(state, "=", number(ANSWERED)),
            [Assignment(state, number(FREE))],
            [Assignment(state, number(ABANDONED))],
        )
        return when(self.asked, [release, Assignment(self.asked, Truth(False))])

    def _tail(self) -> list[Statement]:
        if self.ending == (0, 0):
            late = [when(self.late, [self.fail("late")])] if self.late is not None else []
            return [*late, self.outcome(), self.over(self._dropped())]
        ending = self.declare("xEnding", BOOL, "local")
        self.at_start.append(Assignment(ending, Truth(False)))
        late = [when(every([self.late, Negation(ending)]), [self.fail("late")])] if self.late is not None else []
        return [*late, self.outcome(self._ending(ending)), self.over(self._dropped())]

    def _ending(self, ending: Variable) -> list[tuple[Expression, Sequence[Statement]]]:
        """What ends a motion that was started, when the block fails or is aborted, or is no longer to go on."""
        assert self.abort is not None
        assert self.aborted is not None
        aborting = self.declare("xAborting", BOOL, "local")
        tries = self.declare("iTry", INT, "local")
        why = self.declare("uiFirstReason", UINT, "local", "why it ends before its time")
        first, last = self.ending
        stops: list[Expression] = [self.failed(), self.abort]
        aborts: list[Expression] = [self.abort]
        if self.hold:
            stops.append(Negation(self.start))
        elif self.displaced is not None:
            stops.append(self.displaced)
            aborts.append(self.displaced)
        bounds = [
            compared(self.step, ">=", number(self.first)),
            compared(self.step, "<=", number(last)),
        ]
        none = Whole(0, UINT)
        no_reason = Assignment(self.reason, none)
        begin: list[Statement] = [
            *(self._dropped(), Assignment(ending, Truth(True)), Assignment(aborting, either(aborts))),
            *(Assignment(why, self.reason), no_reason, Assignment(tries, number(1)), self.go(first)),
        ]
        wrong = [Assignment(self.error_id, self.reason), Assignment(self.error, Truth(True))]
        failed_again = when(
            compared(tries, "<", number(_TRIES)),
            [Assignment(tries, plus(tries, 1)), no_reason, self.go(first)],
            [when(compared(why, "<>", none), [Assignment(self.reason, why)]), *wrong],
        )
        ended = chain(
            [
                (compared(why, "<>", none), [Assignment(self.error_id, why), Assignment(self.error, Truth(True))]),
                (aborting, [Assignment(self.aborted, Truth(True))]),
            ],
            [Assignment(self.done, Truth(True))],
        )
        behind = compared(self.step, ">", number(last))
        over = chain([(self.failed(), [failed_again]), (behind, [ended])])
        # The end of a jog would end the motion of the block that has taken over.
        displaced = self.displaced if self.hold else None
        taken = [(displaced, [Assignment(self.aborted, Truth(True))])] if displaced is not None else []
        return [*taken, (ending, [over]), (every([either(stops), *bounds]), begin)]


def _port_name(key: str) -> str:
    return "axis" if key.startswith("axis") else "frames"
