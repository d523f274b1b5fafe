"""Process data: the functions that pack and unpack telegrams."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.targets.controllers.routines.drafts import Draft
from fieldspec.targets.controllers.routines.holders import Bytes, Holder, Words
from fieldspec.targets.controllers.routines.records import members_of, read_fields, write_fields
from fieldspec.targets.controllers.routines.values import order_remark
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.routines.wrapping import framed
from fieldspec.targets.controllers.statements.expressions import BYTE, WORD, number, sequence
from fieldspec.targets.controllers.statements.routine import Routine


def telegrams(layout: DeviceLayout) -> list[MessageLayout]:
    """The messages whose data are sent without header and trailer: process data."""
    links = [link for link in layout.links.values() if not framed(link)]
    messages = {message.name: message for link in links for message in link.messages.values()}
    return list(messages.values())


def telegram_routines(world: World) -> Iterator[Routine]:
    """The functions of all telegrams, for each direction in which they have a fixed size."""
    for message in telegrams(world.layout):
        for data in message.bodies:
            if not data.size:
                continue
            for unit in ("bytes", "words") if data.size % 2 == 0 else ("bytes",):
                yield _packed(world, message, data, unit)
                yield _unpacked(world, message, data, unit)


def _holder(draft: Draft, data: RecordLayout, unit: str, remark: str) -> Holder:
    if unit == "bytes":
        return Bytes(draft.declare("aBytes", sequence(data.size or 0, BYTE), "in_out", remark), number(0))
    array = draft.declare("aWords", sequence((data.size or 0) // 2, WORD), "in_out", remark)
    return Words(array, number(0), draft.world.layout.device.byte_order)


def _draft(world: World, message: MessageLayout, data: RecordLayout, unit: str, verb: str, title: str) -> Draft:
    size = f"{data.size} bytes" if unit == "bytes" else f"{(data.size or 0) // 2} words"
    name = message.message.title or message.name.replace("_", " ")
    remark = f"{name}, {size}. {order_remark(world.layout, unit)} {world.comment(message.message, None)}".strip()
    return Draft(world, world.routine(verb, data.name, unit), f"telegram {message.name}", f"{title}: {remark}")


def _packed(world: World, message: MessageLayout, data: RecordLayout, unit: str) -> Routine:
    draft = _draft(world, message, data, unit, "pack", "Struct to process data")
    struct = draft.declare("stData", world.struct(data.name), "in_out", "is read only")
    holder = _holder(draft, data, unit, "receives the process data")
    draft.add(write_fields(draft, data, holder, members_of(world, data, struct)))
    return draft.finished()


def _unpacked(world: World, message: MessageLayout, data: RecordLayout, unit: str) -> Routine:
    draft = _draft(world, message, data, unit, "unpack", "Process data to struct")
    holder = _holder(draft, data, unit, "is read only")
    struct = draft.declare("stData", world.struct(data.name), "in_out", "receives the values")
    draft.add(read_fields(draft, data, holder, members_of(world, data, struct)))
    return draft.finished()
