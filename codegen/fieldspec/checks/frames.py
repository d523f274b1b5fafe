"""Which messages a link carries, and what it adds to their data, in bytes."""

from __future__ import annotations

from fieldspec.classes import dataclass
from fieldspec.model.device import Device
from fieldspec.model.link import CHECK_SIZES, Link, Part
from fieldspec.model.message import Message


@dataclass(frozen=True, slots=True)
class Shape:
    """The bytes around the data, before they are written as characters and marked."""

    link: Link
    direction: str
    around: int
    has_length: bool

    def length(self, data: int) -> int:
        """The bytes of a whole frame with so much data, as they are on the line."""
        parts = self.around + data
        coded = 2 * parts if self.link.encoding == "hex_ascii" else parts
        return len(self.link.start) + coded + len(self.link.end)

    def counted(self, part: Part, data: int) -> int:
        """The bytes that a length part counts where there is so much data."""
        parts = self.link.parts(self.direction)
        first, last = self.link.span(self.direction, part) or (0, len(parts) - 1)
        inside = any(one.role == "body" for one in parts[first : last + 1])
        return sum(_size(one) for one in parts[first : last + 1]) + inside * data


def coded(link: Link) -> bool:
    """Whether the requests of a link carry the code of their message."""
    return any(part.role == "code" for part in link.request)


def sent_on(link: Link, message: Message) -> bool:
    """Whether a message is sent on a link."""
    return not message.links or link.name in message.links


def messages_on(device: Device, link: Link) -> list[Message]:
    """The messages that are sent on a link."""
    return [message for message in device.messages.values() if sent_on(link, message)]


def shapes(device: Device, direction: str) -> list[Shape]:
    """The frames in one direction; only those with a length part, where a link has one."""
    found = []
    for link in device.links.values():
        parts = link.parts(direction)
        has_length = any(part.role == "length" for part in parts)
        found.append(Shape(link, direction, sum(_size(part) for part in parts), has_length))
    return [shape for shape in found if shape.has_length] or found


def _size(part: Part) -> int:
    if part.algorithm:
        return CHECK_SIZES.get(part.algorithm, 0)
    return part.value.size if part.value is not None else 0
