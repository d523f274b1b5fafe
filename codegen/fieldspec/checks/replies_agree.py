"""A response in an example belongs to the request that it names: it has the same link, message and unit
address, and the same echoed fields.

Why: the two frames of a sample are one exchange. If the response repeats different values, one frame is
misprinted or belongs to another sample.

Example: a request to station 1 and a response from station 2.

Cure: Correct one of the frames and write an erratum, or name the right example under `reply_to`.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.finding import finding, label
from fieldspec.checks.numbers import body
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device
from fieldspec.model.texts import Example

_CODE = "replies_agree"
_HELP = "correct one of the frames, or name the right example"


def replies_agree(device: Device) -> Iterator[Diagnostic]:
    for reply in device.examples.values():
        request = device.examples.get(reply.reply_to)
        if request is None or request.direction != "request" or request.refused:
            continue
        there = label(request.place, "id", "the request")
        for key, mine, theirs in (
            ("link", reply.link, request.link),
            ("message", reply.message, request.message),
        ):
            if mine != theirs:
                text = f"{reply.id} has the {key} {mine}, its request {theirs}"
                yield finding(_CODE, reply.place, key, text, _HELP, there)
        for name, asked in _echoed(device, reply):
            repeated, echoed = reply.values.get(name), request.values.get(asked)
            if repeated is not None and echoed is not None and repeated != echoed:
                text = f"{name} is {repeated} in {reply.id} and {echoed} in its request"
                yield finding(_CODE, reply.place, "values", text, _HELP, there)


def _echoed(device: Device, reply: Example) -> Iterator[tuple[str, str]]:
    """The fields of a reply that repeat one of the request, with the name of that one."""
    link = device.links.get(reply.link)
    if link is not None:
        asked = [part.name for part in link.request if part.role == "unit_address"]
        repeated = [part.name for part in link.response if part.role == "unit_address"]
        yield from zip(repeated, asked, strict=False)
        yield from ((part.name, part.same_as) for part in link.response if part.same_as)
    if not reply.exception_response:
        for field in body(device, reply):
            if field.same_as:
                yield field.name, field.same_as
