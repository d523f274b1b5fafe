"""Where each part of a frame lies."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.classes import dataclass
from fieldspec.layout.message import MessageLayout
from fieldspec.layout.record import Orders
from fieldspec.model.link import CHECK_SIZES, Link, Part
from fieldspec.model.value import Value


@dataclass(frozen=True, slots=True)
class PartLayout:
    """A part before the body at `offset` bytes from the first part, or the check behind it.

    The offset of the check counts from the end of the frame and is negative.
    """

    part: Part
    name: str
    role: str
    offset: int
    size: int
    value: Value | None
    algorithm: str
    order: str


@dataclass(frozen=True, slots=True)
class FrameLayout:
    """The parts before the body, `head_size` bytes; then the body; then `tail_size` bytes.

    All sizes are those of the parts themselves, before they are written as characters and marked.
    """

    direction: str
    head: tuple[PartLayout, ...]
    head_size: int
    tail: tuple[PartLayout, ...]
    tail_size: int

    def role(self, role: str) -> PartLayout | None:
        """The part with a role."""
        return next((part for part in (*self.head, *self.tail) if part.role == role), None)

    @property
    def check(self) -> PartLayout | None:
        """The check."""
        return self.role("check")


@dataclass(frozen=True, slots=True)
class LinkLayout:
    """The frames of a link in both directions, and the messages that are sent on it."""

    link: Link
    name: str
    request: FrameLayout
    response: FrameLayout
    messages: Mapping[str, MessageLayout]

    def message_with_code(self, code: int) -> MessageLayout | None:
        """The message with a function or command code."""
        return next((laid for laid in self.messages.values() if laid.message.code == code), None)

    def frame(self, direction: str) -> FrameLayout:
        """The frame in one direction."""
        return self.request if direction == "request" else self.response


def link_layout(link: Link, messages: Mapping[str, MessageLayout]) -> LinkLayout:
    """The layout of a link, given all messages of the device."""
    sent = {name: laid for name, laid in messages.items() if not laid.message.links or link.name in laid.message.links}
    return LinkLayout(link, link.name, _frame(link, "request"), _frame(link, "response"), sent)


def _frame(link: Link, direction: str) -> FrameLayout:
    parts = link.parts(direction)
    body = next((number for number, part in enumerate(parts) if part.role == "body"), len(parts))
    orders = Orders(link.byte_order or "big", link.word_order or link.byte_order or "big")
    head, head_size = _laid(parts[:body], orders)
    tail, tail_size = _laid(parts[body + 1 :], orders)
    behind = tuple(
        PartLayout(p.part, p.name, p.role, p.offset - tail_size, p.size, p.value, p.algorithm, p.order) for p in tail
    )
    return FrameLayout(direction, head, head_size, behind, tail_size)


def _laid(parts: tuple[Part, ...], orders: Orders) -> tuple[tuple[PartLayout, ...], int]:
    at = 0
    laid = []
    for part in parts:
        size = CHECK_SIZES[part.algorithm] if part.algorithm else part.value.size if part.value else 0
        order = (part.byte_order or "little") if part.algorithm else orders.of(part.value)[0]
        laid.append(PartLayout(part, part.name, part.role, at, size, part.value, part.algorithm, order))
        at += size
    return tuple(laid), at
