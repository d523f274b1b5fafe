"""Blocks that ask through a port: one request at a time, and an answer that comes some scans later."""

from __future__ import annotations

from collections.abc import Iterable

from fieldspec.plc.routines.blocks.kinds import Executed, Kind, Reading
from fieldspec.plc.routines.blocks.motion import AxisPort
from fieldspec.plc.routines.blocks.ports import (
    ABANDONED,
    ANSWERED,
    ASKED,
    AXIS,
    FREE,
    POSTPONED,
    PRESSING,
    URGENT,
    increment,
    member,
)
from fieldspec.plc.routines.blocks.standard import BlockDraft, assigned, chain
from fieldspec.plc.routines.blocks.stopping import Stopping
from fieldspec.plc.routines.expressions import (
    BOOL,
    UDINT,
    UINT,
    Expression,
    Member,
    Negation,
    Whole,
    compared,
    either,
    every,
    number,
)
from fieldspec.plc.routines.routine import Assignment, Routine, Statement, when
from fieldspec.plc.routines.world import World


class LineDraft(BlockDraft):
    """A block that asks through the port with a key. `kind` says how it starts and ends."""

    kind: Kind

    def __init__(self, world: World, name: str, group: str, port: str) -> None:
        super().__init__(world, name, group)
        self.key = port
        port_name = "axis" if port.startswith("axis") else "frames"
        self.port = self.struct(port_name, port, "call the block that serves it in each scan")

    @classmethod
    def executed(cls, world: World, name: str, group: str, port: str, abort: bool = True) -> LineDraft:
        """A block that carries out its steps once, within a time limit."""
        draft = cls(world, name, group, port)
        kind = Executed(draft, abort)
        draft.connect(kind)
        return draft

    @classmethod
    def reading(cls, world: World, name: str, group: str, port: str) -> LineDraft:
        """A block that reads while Enable is TRUE."""
        draft = cls(world, name, group, port)
        draft.connect(Reading(draft))
        return draft

    def connect(self, kind: Kind) -> None:
        """Connects the block to the kind of its start and end, which may give up its requests."""
        self.kind = kind
        self.asked = self.declare("xAsked", BOOL, "local", "a request of this block is on its way")
        state = self.of_port("state")
        release = when(
            compared(state, "=", number(ANSWERED)),
            [Assignment(state, number(FREE))],
            [Assignment(state, number(ABANDONED))],
        )
        kind.release = [when(self.asked, [release, assigned(self.asked, False)])]
        self.dropped = self.declare("xDrop", BOOL, "local", "what it has asked for is given up in this scan")
        kind.drop = [assigned(self.dropped, True)]

    def axis_port(self) -> AxisPort:
        """The members that say who moves the axis."""
        axis = self.port if self.key == AXIS else self.struct("axis", AXIS, "the same for all blocks of the device")
        return AxisPort(*(member(self.world, AXIS, name, axis) for name in AxisPort.MEMBERS))

    def limit(self) -> None:
        """Ends the block with an error when its time is over."""
        assert isinstance(self.kind, Executed)
        self.kind.limit()

    def of_port(self, name: str) -> Member:
        """A member of the port."""
        return member(self.world, self.key, name, self.port)

    def request(self, fill: Iterable[Statement], take: Iterable[Statement], remark: str = "") -> int:
        """Adds a step that sends a request unless `fill` fails, and takes its response."""
        return self.add(fill, take, remark)

    def ask(self, *fields: Statement) -> list[Statement]:
        """The statements that send a request through the port."""
        return [*fields, assigned(self.asked, True)]

    def block(self) -> Routine:
        """The block: the statements of each scan, with requests and responses in two CASEs."""
        kind = self.kind
        state, error, urgent = (self.of_port(name) for name in ("state", "error", "urgent"))
        number_asked, request = self.declare("udiRequest", UDINT, "local"), self.of_port("request")
        is_answered = every([self.asked, compared(state, "=", number(ANSWERED))])
        first, second = kind.urgent(), kind.pressing()
        allowed: list[Expression] = [compared(urgent, "=", number(0))]
        claims: list[Statement] = []
        if second is not None:
            allowed.append(every([second, compared(urgent, "<=", number(PRESSING))]))
            presses = every([second, compared(urgent, "<", number(PRESSING))])
            claims.append(when(presses, [Assignment(urgent, number(PRESSING))]))
        if first is not None:
            allowed.append(first)
            claims.append(when(first, [Assignment(urgent, number(URGENT))]))
        may_ask = [*kind.may_ask(), self.unharmed(), Negation(self.asked), compared(state, "=", number(FREE))]
        may_ask.append(either(allowed))
        judged = chain(
            [
                (compared(self.of_port("answered"), "<>", number_asked), [self.fail("other")]),
                (compared(error, "<>", Whole(0, UINT)), [Assignment(self.reason, error)]),
            ],
            self.selected(asks=False),
        )
        take: list[Statement] = [
            assigned(self.asked, False),
            Assignment(state, number(FREE)),
            when(compared(error, "<>", Whole(POSTPONED, UINT)), [judged]),
        ]
        asking = [increment(request), Assignment(number_asked, request), Assignment(state, number(ASKED))]
        if first is not None:
            asking.append(when(first, [Assignment(self.of_port("first"), request)]))
        ask = [*self.selected(asks=True), when(self.asked, [*asking, *kind.on_ask()])]
        working = chain([*kind.guards(), (is_answered, take), (every(may_ask), ask)])
        drops = when(self.dropped, [*kind.release, assigned(self.dropped, False)])
        always = [kind.unlock()] if isinstance(kind, Stopping) else []
        tail = kind.tail()
        edges = kind.edges()
        return self.finished(
            [*self.timers(), *edges, when(kind.active(), [working, *kind.accepted(), *tail, drops, *claims]), *always]
        )
