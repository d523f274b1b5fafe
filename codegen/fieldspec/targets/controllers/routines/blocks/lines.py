"""Blocks that ask through a port: one request at a time, and an answer that comes some scans later."""

from __future__ import annotations

from collections.abc import Iterable

from fieldspec.targets.controllers.routines.blocks.kinds import Executed, Kind
from fieldspec.targets.controllers.routines.blocks.ports import AXIS, member
from fieldspec.targets.controllers.routines.blocks.standard import BlockDraft, assigned
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.statements.expressions import Member, Variable
from fieldspec.targets.controllers.statements.routine import Routine, Statement


class LineDraft(BlockDraft):
    """A block that asks through the port with a key. `kind` says how it starts and ends."""

    carrier = "line"
    kind: Kind

    def __init__(self, world: World, name: str, group: str, port: str) -> None:
        super().__init__(world, name, group)
        self.key = port
        port_name = "Axis" if port.startswith("axis") else "Frames"
        self.port = self.struct(port_name, port, "call the block that serves it in each scan")
        self.slots = {"stPort": self.port, "is_asked_for": True}

    @classmethod
    def executed(cls, world: World, name: str, group: str, port: str) -> LineDraft:
        """A block that carries out its steps once, within a time limit, and may be aborted."""
        draft = cls(world, name, group, port)
        draft.kind = Executed(draft, abort=True)
        return draft

    def lend_axis(self) -> Variable:
        """See `BlockDraft`."""
        axis = self.port if self.key == AXIS else self.struct("Axis", AXIS, "the same for all blocks of the device")
        self.slots["Axis"] = axis
        return axis

    def limit(self) -> None:
        """Ends the block with an error when its time is over."""
        self.kind.limit()

    def of_port(self, name: str) -> Member:
        """A member of the port."""
        return member(self.world, self.key, name, self.port)

    def request(self, fill: Iterable[Statement], take: Iterable[Statement], remark: str = "") -> int:
        """Adds a step that sends a request unless `fill` fails, and takes its response."""
        return self.add(fill, take, remark)

    def ask(self, *fields: Statement) -> list[Statement]:
        """The statements that send a request through the port."""
        return [*fields, assigned(self.variable("xAsked"), True)]

    def block(self) -> Routine:
        """The block: the statements of each scan, with requests and responses in two CASEs."""
        return self.kind.block()
