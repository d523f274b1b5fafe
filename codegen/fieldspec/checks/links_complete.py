"""A link says how its frames look: the byte order, one body, the code of a request, the check behind all
else.

Why: byte order is stated for each link and never assumed; and a frame whose message cannot be told, or
whose data have no place, cannot be decoded.

Example: a link with two messages whose requests have no part with the role `code`.

Cure: Give the `byte_order`, or the missing part, or put the parts in the order of the wire.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from fieldspec.checks.finding import finding, label
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
        sent = [message for message in device.messages.values() if not message.links or link.name in message.links]
        unnumbered = [message for message in sent if message.number is None or not message.links]
        if len(sent) > 1 and unnumbered and not any(part.role == "code" for part in link.request):
            text = f"the link {link.name} has no code in its requests, but there are {len(sent)} messages"
            yield finding(_CODE, link.place, "request", text, "give the part with the code the role `code`")
        if link.error is not None and not any(part.role == "code" for part in link.response):
            text = f"the link {link.name} marks refusals in the code, but its responses have none"
            yield finding(_CODE, link.place, "error", text, "give the part with the code the role `code`")


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
