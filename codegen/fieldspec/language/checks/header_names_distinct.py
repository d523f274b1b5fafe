"""No field in the body of a frame has the name of a part before the body.

Why: examples, the command line and generated code set the values of a frame by name. With one name for both, the part
would be set and the field would have no value.

Example: a link whose frames begin with the part `mode`, and a message with a field `mode`.

Fix: Rename one of them: `{name: link_mode, printed_name: mode, ..}` keeps the name of the manual in the documentation.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from fieldspec.foundation.names import Name
from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.link import Link, Part
from fieldspec.language.model.record import Record
from fieldspec.language.model.sizes import messages_on


def header_names_distinct(device: Device) -> Findings:
    reported: set[int] = set()
    for link in device.links.values():
        for direction in ("request", "response"):
            header = {Name.of(part.name).snake(): part for part in _header(link.parts(direction))}
            for body in _bodies(device, link, direction):
                for field in body.fields:
                    part = header.get(Name.of(field.name).snake())
                    if part is not None and id(field) not in reported:
                        reported.add(id(field))
                        text = f"{field.name} has the name of a part before the body in the {direction}s of {link.name}"
                        related_label = label(part.place, "name", "the part")
                        help = "rename one of them; its `printed_name` keeps the word of the manual"
                        yield finding(field.place, "name", text, help, related_label)


def _header(parts: Sequence[Part]) -> Sequence[Part]:
    """The parts before the body."""
    body = next((number for number, part in enumerate(parts) if part.role == "body"), len(parts))
    return parts[:body]


def _bodies(device: Device, link: Link, direction: str) -> Iterator[Record]:
    """The data of the messages on a link, and the record of its exception responses."""
    for message in messages_on(device, link):
        yield message.request if direction == "request" else message.response
    error = link.exception_response
    if error is not None and direction == "response" and error.record in device.records:
        yield device.records[error.record]
