"""Where frames carry a code, every message has one of its own.

Why: the code is how a decoder knows which message it has.

Example: two commands with the code 0x44.

Cure: Give the code, or put one of them right and write an erratum if it is printed so.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.finding import finding, label
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device
from fieldspec.model.link import Link
from fieldspec.model.message import Message

_CODE = "messages_complete"


def messages_complete(device: Device) -> Iterator[Diagnostic]:
    for link in device.links.values():
        if any(part.role == "code" for part in link.request):
            yield from _on(link, [one for one in device.messages.values() if not one.links or link.name in one.links])


def _on(link: Link, messages: list[Message]) -> Iterator[Diagnostic]:
    first: dict[int, Message] = {}
    for message in messages:
        if message.code is None:
            text = f"{message.name} has no code"
            yield finding(_CODE, message.place, "code", text, "give it as `code`")
            continue
        other = first.setdefault(message.code, message)
        if other is not message:
            text = f"{message.name} and {other.name} have the code {message.code:#04x}"
            there = label(other.place, "code", other.name)
            yield finding(_CODE, message.place, "code", text, "put one of the codes right", there)
