"""The part with the unit address has its role in requests and in responses, if both have such a part.

Why: without the role in responses, clients accept the response of another device. Without it in requests, the sender
has to state the address as an ordinary number. A part of the same name without the role is an error; a number of the
same size could be an address, and is a warning.

Example: `{name: station, role: unit_address, type: u8}` in requests, and `{name: station, type: u8}` in responses.

Fix: Add `role: unit_address` to the other part. If it is not an address, give it a different name, and set `allow:
{unit_addresses_match: <reason>}` in the part with the address.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.diagnostics import Severity
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_count
from fieldspec.language.model.link import Link, Part
from fieldspec.language.model.sizes import messages_on

_DIRECTIONS = ("request", "response")


def unit_addresses_match(device: Device) -> Findings:
    for link in device.links.values():
        if any(message.is_requested for message in messages_on(device, link)):
            yield from _of_link(link)


def _of_link(link: Link) -> Findings:
    addresses = {direction: _address(link.parts(direction)) for direction in _DIRECTIONS}
    for direction, other in (_DIRECTIONS, _DIRECTIONS[::-1]):
        own = addresses[direction]
        if own is None or addresses[other] is not None:
            continue
        mark = link.exception_response.part if link.exception_response is not None and other == "response" else ""
        parts = [part for part in _before_body(link.parts(other)) if part.name != mark]
        numbers = [part for part in parts if _may_be_address(part)]
        namesake = next((part for part in numbers if part.name == own.name), None)
        part = namesake or next((part for part in numbers if _size(part) == _size(own)), None)
        if part is None:
            continue
        severity = Severity.ERROR if namesake is not None else Severity.WARNING
        text = f"only each {direction} on {link.name} has a unit address, {own.name}"
        likeness = "a part of the same name, without the role" if namesake is not None else "a number of the same size"
        help = f"add `role: unit_address` to {part.name} of the {other}, or allow this if it is not an address"
        related_label = label(part.place, "name", f"the {other} has {likeness}")
        yield finding(own.place, "role", text, help, related_label, severity=severity)


def _address(parts: tuple[Part, ...]) -> Part | None:
    return next((part for part in parts if part.role == "unit_address"), None)


def _before_body(parts: tuple[Part, ...]) -> tuple[Part, ...]:
    body = next((index for index, part in enumerate(parts) if part.role == "body"), len(parts))
    return parts[:body]


def _may_be_address(part: Part) -> bool:
    """Whether a part is a number that users give, and nothing else says what it is."""
    value = part.value
    if part.role != "plain" or part.reserved or part.same_as or value is None or not is_count(value.encoding):
        return False
    return value.const is None and not value.enum and not value.flags and not value.scaled and not value.unit


def _size(part: Part) -> int:
    """The bits of a part of an identifier, or of its bytes."""
    if part.bits is not None:
        return part.bits[1] - part.bits[0] + 1
    return 8 * part.value.size if part.value is not None else 0
