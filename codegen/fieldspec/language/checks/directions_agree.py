"""If requests and responses of a link have the same parts, a length or a checksum is computed in the same way in both.

Why: the frames of both directions are mostly the same. A `role` or a `covers` that is missing in one direction is
usually a mistake in the spec: clients then reject valid responses, or accept invalid ones.

Example: `{name: size, role: length, type: u8}` in requests and `{name: size, type: u8}` in responses, which have the
same parts otherwise.

Fix: Correct the part in one direction. If the manual prints it that way, set `allow: {directions_agree: <reason>}` in
the part of the response.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.diagnostics import Severity
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_count
from fieldspec.language.model.link import Link, Part
from fieldspec.language.model.sizes import messages_on, part_size

_COMPUTED = ("length", "checksum")
_HELP = "correct one of them, or allow this with a reason"


def directions_agree(device: Device) -> Findings:
    for link in device.links.values():
        parts = link.request, link.response
        names = [[(part.name, part_size(part)) for part in own] for own in parts]
        has_exchange = any(
            message.is_requested and message.is_answered_on(link.name) for message in messages_on(device, link)
        )
        if not has_exchange or names[0] != names[1]:
            continue
        differing = [pair for pair in zip(*parts, strict=True) if pair[0].role != pair[1].role]
        if not differing:
            for request, response in zip(*parts, strict=True):
                yield from _computed(link, request, response)
        elif len(differing) == 1:
            yield from _roles(link, *differing[0])


def _roles(link: Link, request: Part, response: Part) -> Findings:
    """The finding of a part that is computed in one direction, and a number that users state in the other one."""
    for own, other, direction in ((request, response, "request"), (response, request, "response")):
        if own.role in _COMPUTED and _is_stated(other):
            text = f"{own.name} is a {own.role} only in each {direction} on {link.name}; "
            text += "users state it in the other direction"
            related_label = label(own.place, "role", f"the role in each {direction}")
            yield finding(other.place, "name", text, _HELP, related_label, severity=Severity.WARNING)


def _is_stated(part: Part) -> bool:
    """Whether a part is a number that users state, and nothing else says what it is."""
    value = part.value
    if part.role != "plain" or part.reserved or part.same_as or value is None or not is_count(value.encoding):
        return False
    return value.const is None and not value.enum and not value.flags and not value.scaled and not value.unit


def _computed(link: Link, request: Part, response: Part) -> Findings:
    """The finding of a part that is computed in two ways, which differ in one key."""
    if request.role not in _COMPUTED:
        return
    own, other = _keys(request), _keys(response)
    differing = [key for key in own if own[key] != other[key]]
    if len(differing) == 1:
        key = differing[0]
        text = f"{request.name} of requests and of responses on {link.name} differ in `{key}`"
        related_label = label(request.place, key if key in request.place else "name", "the part of requests")
        response_key = key if key in response.place else "name"
        yield finding(response.place, response_key, text, _HELP, related_label, severity=Severity.WARNING)


def _keys(part: Part) -> dict[str, object]:
    """How a part is computed, by the keys that say it; bytes before or after often name the direction."""
    span = part.span, part.unit_size, part.plus
    if part.role == "length":
        return {"measures": span, "byte_order": part.value.byte_order if part.value is not None else ""}
    return {
        "covers": span,
        "algorithm": part.stated_algorithm,
        "byte_order": part.byte_order if "byte_order" in part.place else "",
        "digits": part.digits,
    }
