"""The parts of a response by which it belongs to one of several open requests."""

from __future__ import annotations

from fieldspec.layout.frame import LinkLayout
from fieldspec.layout.part import PartLayout


def repeated_parts(link: LinkLayout) -> list[tuple[PartLayout, PartLayout]]:
    """The parts of requests on a link that responses repeat, the unit address among them, each with its repetition.

    A device has one open request for each of their values: the next frame with the same values answers it, or shows
    that its answer is lost.
    """
    pairs = [(link.request.role("unit_address"), link.response.role("unit_address"))]
    asked = {part.name: part for part in link.request.header}
    pairs += [(asked.get(part.part.same_as), part) for part in link.response.header if part.role == "plain"]
    return [(own, other) for own, other in pairs if own is not None and other is not None]
