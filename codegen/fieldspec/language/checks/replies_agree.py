"""A response in an example belongs to the request that it names: it has the same link, message and unit
address, the same echoed fields, and the number of registers or bits that the request names.

Why: the two frames of a sample are one exchange. If the response repeats different values, or has more or fewer
registers, one frame is misprinted or belongs to another sample, or `accesses` names the wrong fields.

Example: a request to station 1 and a response from station 2, or a request for 20 words and a response with 25.

Fix: Correct one of the frames and write an erratum, or name the right example under `reply_to`. Correct the `start`,
`count` and `values` under `accesses` of the message. If the device sends a different number, set `allow:
{replies_agree: <reason>}` on the response.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.foundation.line_text import plural
from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.checks.numbers import body, in_counts
from fieldspec.language.model.device import Device
from fieldspec.language.model.record import Message
from fieldspec.language.model.texts import Example

_HELP = "correct one of the frames, or name the right example"


def replies_agree(device: Device) -> Findings:
    for reply in device.examples.values():
        request = device.examples.get(reply.reply_to)
        if request is None or request.direction != "request" or request.refused:
            continue
        related_label = label(request.place, "id", "the request")
        for key, mine, theirs in (
            ("link", reply.link, request.link),
            ("message", reply.message, request.message),
        ):
            if mine != theirs:
                text = f"{reply.id} has the {key} {mine}, its request {theirs}"
                yield finding(reply.place, key, text, _HELP, related_label)
        for name, request_name in _echoed(device, reply):
            repeated, echoed = reply.values.get(name), request.values.get(request_name)
            if repeated is not None and echoed is not None and repeated != echoed:
                text = f"{name} is {repeated} in {reply.id} and {echoed} in its request"
                yield finding(reply.place, "values", text, _HELP, related_label)
        message = device.messages.get(reply.message)
        if message is not None and request.message == reply.message and not reply.exception_response:
            mismatch = _count_mismatch(device, message, request, reply)
            if mismatch:
                help = f"{_HELP}, or the fields under `accesses` of {message.name}"
                yield finding(reply.place, "values", mismatch, help, related_label)


def _count_mismatch(device: Device, message: Message, request: Example, reply: Example) -> str:
    """The reason why the number of values in a response differs from the requested number, or an empty text."""
    access = message.single_access
    if access is None or access.operation != "read" or reply.direction != "response":
        return ""
    count, values = message.request.named(access.count), message.response.named(access.values)
    elements = reply.values.get(access.values)
    if count is None or count.value is None or values is None or values.value is None or not isinstance(elements, list):
        return ""
    stated = in_counts(device, count.value, request.values.get(count.name))
    want = count.value.const if stated is None else stated
    if want is None:
        return ""
    if device.bit_access(message) is not None:
        size = -(-want // 8)
        if len(elements) == size or values.value.size != 1:
            return ""
        text = f"{request.id} asks for {plural(want, 'bit')}, which take {plural(size, 'byte')}"
        return f"{text}, but {reply.id} has {len(elements)}"
    space = device.space(access.space)
    carried, rest = divmod(len(elements) * values.value.type.size, space.unit_size)
    if rest or carried == want:
        return ""
    return f"{request.id} asks for {plural(want, space.unit)}, but {reply.id} has {carried}"


def _echoed(device: Device, reply: Example) -> Iterator[tuple[str, str]]:
    """The fields of a reply that repeat one of the request, with the name of that one."""
    link = device.links.get(reply.link)
    if link is not None:
        request_addresses = [part.name for part in link.request if part.role == "unit_address"]
        repeated = [part.name for part in link.response if part.role == "unit_address"]
        yield from zip(repeated, request_addresses, strict=False)
        yield from ((part.name, part.same_as) for part in link.response if part.same_as)
    if not reply.exception_response:
        for field in body(device, reply):
            if field.same_as:
                yield field.name, field.same_as
