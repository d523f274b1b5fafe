"""The lengths of the frames of messages, and the messages that a frame of some length may be."""

from __future__ import annotations

from fieldspec.explain.row import unwrapped
from fieldspec.layout.frame import LinkLayout


def names_of_length(link: LinkLayout, direction: str, frame: bytes) -> list[str]:
    """The messages whose body can be as long as that of the frame."""
    length = len(unwrapped(link.link, direction, frame).data)
    escape = link.frame(direction).escape
    if escape is not None:
        bounds = ((name, lengths(link, direction, name)) for name in link.carried(direction))
        return [name for name, (_, most) in bounds if most is None or length <= escape.most(most)]
    bounds = ((name, lengths(link, direction, name)) for name in link.carried(direction))
    return [name for name, (least, most) in bounds if least <= length and (most is None or length <= most)]


def lengths(link: LinkLayout, direction: str, message: str) -> tuple[int, int | None]:
    """The least and the greatest size of a message's frames without delimiters, in bytes; None is unbounded."""
    shape, body = link.frame(direction), link.messages[message].data(direction)
    around = shape.header_size + shape.trailer_size
    return body.least + around, None if body.most is None else body.most + around
