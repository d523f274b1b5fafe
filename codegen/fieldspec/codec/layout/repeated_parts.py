"""The parts of its request that a response repeats, which assign it to one of several open requests."""

from __future__ import annotations

from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.open_parts import open_parts
from fieldspec.codec.layout.part import PartLayout
from fieldspec.codec.layout.record import FieldLayout


def repeated_parts(link: LinkLayout) -> list[tuple[PartLayout, PartLayout]]:
    """The parts of requests on a link that responses repeat, the unit address among them, each with its repetition.

    A device has one open request for each of their values: the next frame with the same values answers it, or shows
    that its answer is lost.
    """
    pairs = [(link.request.role("unit_address"), link.response.role("unit_address"))]
    request_parts = {part.name: part for part in link.request.header}
    repeated = {part.repeated.name: part.part for part in open_parts(link) if part.repeated is not None}
    pairs += [
        (repeated.get(part.name) or request_parts.get(part.part.same_as), part)
        for part in link.response.header
        if part.role == "plain"
    ]
    return [(own, other) for own, other in pairs if own is not None and other is not None]


def repeated_fields(message: MessageLayout) -> list[tuple[FieldLayout, FieldLayout]]:
    """The fields of a request that its response repeats, each with its repetition.

    The response to an access to registers repeats what has the same name, which no spec has to say.
    """
    by_name = message.message.single_access is not None
    candidates = [(field.field.same_as or (field.name if by_name else ""), field) for field in message.response.fields]
    pairs = [(message.request.named(name), field) for name, field in candidates if name]
    return [(own, other) for own, other in pairs if own is not None and not own.field.reserved]
