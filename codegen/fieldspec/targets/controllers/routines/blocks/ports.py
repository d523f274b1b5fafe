"""What stands between the blocks of a device and its line: structs that several blocks and one transport share.

Blocks use a port one after another. A block asks while the port is free, the transport answers, and the block that has
asked takes the answer and frees the port. Each request has a number, which its answer bears.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.record import Message
from fieldspec.targets.controllers.routines.telegrams import telegrams
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.routines.wrapping import framed
from fieldspec.targets.controllers.sources.lookups import Members
from fieldspec.targets.controllers.statements.expressions import (
    BOOL,
    INT,
    UDINT,
    UINT,
    Expression,
    Member,
    StructType,
    Type,
)
from fieldspec.targets.controllers.structs import fixed

FREE, ASKED, ANSWERED, ABANDONED = range(4)
"""The states of a port. A transport frees a port that is abandoned once it can send again."""

AXIS, FRAMES = "axis of the device", "frames of the device"
"""The keys of the ports that belong to no telegram. No fact has a name with spaces."""
PRESSING, URGENT = 3, 6
"""The priority that a block writes in each scan while it stops, or checks whether its command is accepted.

Whoever serves the port counts it down: twice between two calls of a block, where the order of the calls changes.
"""
POSTPONED = 65535
"""The error of a request that was not sent because a stop has priority: the block repeats the request."""
STATE_REMARK = "0 free, 1 asked, 2 answered, 3 abandoned"
_HANDSHAKE: tuple[tuple[str, Type, str], ...] = (
    ("state", INT, STATE_REMARK),
    ("error", UINT, "0, or why there is no answer: an ErrorID"),
    ("request", UDINT, "the number of the request, counted up by its sender"),
    ("answered", UDINT, "the number of the request that was answered"),
    ("first", UDINT, "the number of the last request of a stop"),
    ("urgent", INT, "while it is not 0, only urgent requests are sent; the server counts it down in each scan"),
)
"""What ports have through which blocks ask. An answer with another number is that to a request which was given up."""


@dataclass(frozen=True, slots=True)
class Port:
    """A struct that blocks share. `members` are name, type and remark; World knows it and its members by `key`."""

    key: str
    name: str
    title: str
    members: tuple[tuple[str, Type, str], ...]


def ports(world: World) -> Iterator[Port]:
    """The ports of a device, as far as the structs in them are declared."""
    layout = world.layout
    mover = (
        ("motion", UDINT, "counts the commands that were accepted: the block of the last one has the axis"),
        ("claims", UDINT, "counts the commands that were begun: only the last one is sent"),
        ("stops", UDINT, "how many stops lock the axis"),
        ("active", UDINT, "how many blocks have a command under way"),
        ("unseen", BOOL, "the last command was not seen to move the axis: it may still begin, a stop notwithstanding"),
        ("exclusive", BOOL, "one of them does not see whether the device takes it: no other begins meanwhile"),
    )
    if layout.registers:
        access = (
            ("write", BOOL, "whether the words are to be written"),
            ("address", UINT, "of the first register"),
            ("count", INT, "how many words"),
            ("words", world.words, "what is written, or was read"),
        )
        yield Port(AXIS, "axis", "A device, and the access to its registers", (*_HANDSHAKE, *access, *mover))
    elif sends(layout):
        yield Port(AXIS, "axis", "A device, and who moves it", mover)
    if own_links(layout):
        frame = (
            ("send", INT, "how many bytes of the frame are to be sent"),
            ("received", INT, "how many bytes of it were received"),
            ("frame", world.frame, "what is sent, and then what was received"),
        )
        yield Port(FRAMES, "frames", "A line that carries frames", (*_HANDSHAKE, *frame))
    for message in cyclic(layout):
        yield Port(
            axis_key(message),
            f"{message.name}_axis",
            f"The process data of {message.name.replace('_', ' ')}, and who moves",
            (
                ("valid", BOOL, "whether the response has come in this cycle"),
                ("request", StructType(world.names.structs[message.request.name]), ""),
                ("response", StructType(world.names.structs[message.response.name]), ""),
                *mover,
            ),
        )


def own_links(layout: DeviceLayout) -> list[LinkLayout]:
    """The links whose frames have more than a body, which the controller builds itself."""
    return [link for link in layout.links.values() if framed(link)]


def sends(layout: DeviceLayout) -> bool:
    """Whether a task sends messages."""
    return bool(own_links(layout)) and any(step.action == "send" for task in layout.device.tasks for step in task.steps)


def cyclic(layout: DeviceLayout) -> list[MessageLayout]:
    """The telegrams of fixed size that tasks use."""
    names = {name for task in layout.device.tasks if task.steps for name in task.messages}
    return [
        message
        for message in telegrams(layout)
        if message.name in names and all(data.size and fixed(data) for data in (message.request, message.response))
    ]


def axis_key(message: MessageLayout | Message) -> str:
    """The key of the port for a telegram."""
    return f"axis of {message.name}"


def port_members(world: World) -> Members:
    """The members of all ports, by the name of the struct and their key."""
    if not world.port_members:
        world.port_members.update(
            {
                world.names.structs[port.key]: {
                    key: (world.names.members[port.key][key], kind) for key, kind, _ in port.members
                }
                for port in ports(world)
            }
        )
    return world.port_members


def member(world: World, port: str, name: str, struct: Expression) -> Member:
    """A member of a port."""
    return Member(struct, *port_members(world)[world.names.structs[port]][name])
