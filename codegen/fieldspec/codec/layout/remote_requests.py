"""Remote requests of CAN buses: their codes have four bytes, with a bit that tells them from others."""

from __future__ import annotations

from fieldspec.foundation.classes import replace
from fieldspec.language.model.link import Link, Part
from fieldspec.language.model.primitives import PRIMITIVES

_CODE = PRIMITIVES["u32"]


def with_remote_codes(link: Link) -> Link:
    """The link, whose codes have room for the bit of remote requests. All parts of requests are in the identifier."""
    assert link.escape is not None
    place = next(number for number, part in enumerate(link.request) if part.role == "code")
    _, order, first, width = link.escape.fields[place]
    fields = (*link.escape.fields[:place], (_CODE.size, order, first, width), *link.escape.fields[place + 1 :])
    return replace(
        link,
        request=tuple(map(_wide, link.request)),
        response=tuple(map(_wide, link.response)),
        escape=replace(link.escape, fields=fields, remote=place),
    )


def _wide(part: Part) -> Part:
    if part.role != "code" or part.value is None:
        return part
    return replace(part, value=replace(part.value, type=_CODE, size=_CODE.size))
