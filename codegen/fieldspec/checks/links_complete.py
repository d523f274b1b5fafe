"""A link says how its frames look: the byte order, one body, the code of a request, the check behind all
else.

Why: byte order is stated for each link and never assumed; and a frame whose message cannot be told, or
whose data have no place, cannot be decoded.

Example: a link with two messages whose requests have no part with the role `code`.

Cure: Give the `byte_order`, or the missing part, or put the parts in the order of the wire. Where frames
really carry no code, name the link under the `links` of each of its messages, which then have none either:
whoever decodes says which message it is.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from fieldspec.checks.finding import finding, label
from fieldspec.checks.frames import coded, messages_on
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device
from fieldspec.model.link import Link, Part
from fieldspec.model.primitive import Kind

_CODE = "links_complete"
_NUMBERS = ("station", "code", "length")


def links_complete(device: Device) -> Iterator[Diagnostic]:
    for link in device.links.values():
        if not link.byte_order:
            text = f"the link {link.name} has no byte order"
            yield finding(_CODE, link.place, "byte_order", text, "give `byte_order: big` or `little`")
        for direction in ("request", "response"):
            yield from _of_parts(link, direction, link.parts(direction))
        yield from _told_apart(device, link)
        if link.error is not None and not any(part.role == "code" for part in link.response):
            text = f"the link {link.name} marks refusals in the code, but its responses have none"
            yield finding(_CODE, link.place, "error", text, "give the part with the code the role `code`")


def _told_apart(device: Device, link: Link) -> Iterator[Diagnostic]:
    """A link without codes carries one message, or messages that are known to have none."""
    sent = messages_on(device, link)
    odd = next((message for message in sent if message.code is not None or not message.links), None)
    if len(sent) > 1 and odd is not None and not coded(link):
        text = f"the link {link.name} has no code in its requests, but there are {len(sent)} messages"
        what = "has a code" if odd.code is not None else "does not say on which links it is sent"
        there = label(odd.place, "code" if odd.code is not None else "name", f"{odd.name} {what}")
        help = "give the part with the code the role `code`, or the messages their `links` and no code"
        yield finding(_CODE, link.place, "request", text, help, there)


def _of_parts(link: Link, direction: str, parts: tuple[Part, ...]) -> Iterator[Diagnostic]:
    roles = Counter(part.role for part in parts)
    for role in (*_NUMBERS, "body", "check"):
        if roles[role] > 1 or (role == "body" and not roles[role]):
            text = f"the {direction} of {link.name} has {roles[role]} parts with the role {role}"
            help = "each role comes once, and `body` must be there"
            yield finding(_CODE, link.place, direction, text, help)
    for part in parts:
        if part.role in _NUMBERS and part.value is not None and part.value.type.kind is not Kind.INTEGER:
            text = f"the {part.role} {part.name} is {part.value.type.name}, which is no number"
            yield finding(_CODE, part.place, "type", text, "give it an integer type")
        if part.role == "check" and part is not parts[-1]:
            text = f"{parts[-1].name} stands behind the check {part.name}"
            help = "a check is over all before it, so it is the last part"
            yield finding(_CODE, parts[-1].place, "name", text, help, label(part.place, "name", "the check"))
    roles_in_order = [part.role for part in parts]
    for role in _NUMBERS:
        if role in roles_in_order and "body" in roles_in_order[: roles_in_order.index(role)]:
            part = parts[roles_in_order.index(role)]
            text = f"the {role} {part.name} stands behind the body"
            yield finding(_CODE, part.place, "name", text, "what says how to read the body stands before it")
