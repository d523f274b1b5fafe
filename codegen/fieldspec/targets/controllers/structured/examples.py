"""How to use the functions of a device: calls in the order in which a program makes them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.language.model.device import Device
from fieldspec.targets.controllers.dialects import Spelling
from fieldspec.targets.controllers.routines.printer import call_lines
from fieldspec.targets.controllers.routines.records import is_user_field
from fieldspec.targets.controllers.routines.telegrams import telegrams
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.routines.wrapping import framed, link_words
from fieldspec.targets.controllers.statements.expressions import Expression, number
from fieldspec.targets.controllers.statements.routine import Routine

_STEP = "    "


def examples(world: World, routines: Sequence[Routine], spelling: Spelling) -> list[str]:
    """The lines of a comment: one use of each kind that the device has; none where a project chooses blocks."""
    if world.layout.blocks is not None:
        return []
    uses = _Uses(world, {routine.name: routine for routine in routines}, spelling)
    lines: list[str] = []
    for title, steps in uses.all():
        lines += ["", title, *(f"{_STEP}{line}" for line in steps)]
    return lines


class _Uses:
    """The uses of a device, each with its title and its lines."""

    def __init__(self, world: World, by_name: dict[str, Routine], spelling: Spelling) -> None:
        self.world, self.by_name, self.spelling = world, by_name, spelling

    def all(self) -> Iterator[tuple[str, list[str]]]:
        """The titles and lines of all uses."""
        link = next((link for link in self.world.layout.links.values() if framed(link)), None)
        if link is not None:
            yield from self._registers(link)
            other = _telling(link)
            if other is not None:
                yield f"To send {other.name} on {link.name}:", self._exchange(link, other)
        yield from self._cyclic()

    def _registers(self, link: LinkLayout) -> Iterator[tuple[str, list[str]]]:
        """The calls that read registers and unpack their values."""
        unpack, space = self._unpacking()
        message = _reading(self.world.layout.device, link, space)
        if message is None or unpack is None:
            return
        parse = self._function("parse", link, message)
        lists = [
            declared.variable for declared in parse.of_role("in_out") if declared.variable.type == self.world.words
        ]
        counts = [declared.variable for declared in parse.of_role("output") if declared.variable.name.endswith("Count")]
        if not lists or not counts:
            return
        known: dict[str, Expression] = {"aWords": lists[0], "iCount": counts[0], "iFirst": number(0)}
        parameters = {declared.variable.name for declared in unpack.declared}
        arguments = {name: value for name, value in known.items() if name in parameters}
        lines = [*self._exchange(link, message), *call_lines(unpack, self.spelling, **arguments)]
        yield f"To read registers on {link.name}, and take the values out of them:", lines

    def _function(self, deed: str, link: LinkLayout, message: MessageLayout) -> Routine:
        return self.by_name[self.world.routine(deed, *link_words(self.world, link), message.name)]

    def _exchange(self, link: LinkLayout, message: MessageLayout) -> list[str]:
        built = call_lines(self._function("build", link, message), self.spelling)
        if message.name not in link.exchanged:
            return [*built, "// send the first iLength bytes of aFrame; the device does not answer"]
        return [
            *built,
            "// send the first iLength bytes of aFrame, receive the answer into it, and set iLength to its bytes",
            *call_lines(self._function("parse", link, message), self.spelling),
        ]

    def _unpacking(self) -> tuple[Routine | None, str]:
        """The first function that takes values out of registers: of a record in a table, or of a group; its space."""
        start = self.world.routine("unpack")
        matching = [
            routine
            for name, routine in self.by_name.items()
            if name.startswith(start) and any(declared.variable.name == "aWords" for declared in routine.declared)
        ]
        ordered = [
            routine for kind in ("record ", "registers ") for routine in matching if routine.group.startswith(kind)
        ]
        first = next(iter(ordered), None)
        device = self.world.layout.device
        spaces = {f"record {table.record}": table.space for table in reversed(list(device.tables.values()))}
        spaces |= {f"registers {group.name}": group.space for group in device.groups}
        return first, spaces.get(first.group, "") if first is not None else ""

    def _cyclic(self) -> Iterator[tuple[str, list[str]]]:
        """The exchange of the longest telegram."""
        cyclic = [message for message in telegrams(self.world.layout) if message.request.size and message.response.size]
        if not cyclic:
            return
        longest = max(cyclic, key=lambda message: (message.request.size or 0) + (message.response.size or 0))
        unpack = self.by_name.get(self.world.routine("unpack", longest.response.name, "words"))
        pack = self.by_name.get(self.world.routine("pack", longest.request.name, "words"))
        if unpack is not None and pack is not None:
            remark = "// decide what to do, and set the members of the struct that is sent"
            lines = [*call_lines(unpack, self.spelling), remark, *call_lines(pack, self.spelling)]
            yield f"In each cycle, with {longest.name}; aWords is what the fieldbus gives and takes:", lines


def _reading(device: Device, link: LinkLayout, space: str) -> MessageLayout | None:
    """The message that reads the registers of a space."""
    for message in link.messages.values():
        access = device.word_access(message.message)
        if access is None or access.operation != "read":
            continue
        if device.space_name(access.space) == device.space_name(space):
            return message
    return None


def _telling(link: LinkLayout) -> MessageLayout | None:
    """The message with the most fields in its request, among messages with only single values."""
    best: MessageLayout | None = None
    greatest_count = 0
    for message in link.carried("request").values():
        fields = [field for field in message.request.fields if is_user_field(field)]
        single = all(field.value is not None and not field.is_list for field in fields)
        if single and message.message.single_access is None and len(fields) > greatest_count:
            best, greatest_count = message, len(fields)
    return best
