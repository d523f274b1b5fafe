"""The first parts of a frame on a CAN bus are all bits of its identifier, the same in requests and responses, and the
data have at most eight bytes; if they have several lists, each has room for all its elements beside the least of the
others. Numbers fit into their bits. Only a CAN bus has remote requests. A remote request has all its parts in the
identifier, and a code among them.

Why: the value of a bit without a part would be undefined, and a frame with more data cannot be sent.

Example: an identifier of 11 bits with `bits: 7..10` and `bits: 0..5`, which leaves out bit 6.

Fix: Give every bit of the identifier to one part, as `const` or `reserved` if the manual says so. State longer data as
several messages. A CAN bus has no delimiters, escapes, serial settings or ports. Only parts of the data can be counted
by a length or covered by a checksum.
"""

from __future__ import annotations

from fieldspec.foundation.line_text import plural
from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_signed
from fieldspec.language.model.escape import CAN_DATA
from fieldspec.language.model.fact import Place
from fieldspec.language.model.link import Link, Part
from fieldspec.language.model.record import Message, Record
from fieldspec.language.model.sizes import RecordSizes, messages_on, messages_sent, part_size, sent_on

_FOREIGN = ("start", "end", "transmission", "escape", "serial", "network", "silence")
_MOST_PARTS = 7
"""The bytes of the parts of an identifier: packed, they never need more room than unpacked."""
_REMOTE_CODE = 4
"""The bytes of a code on a bus with remote requests."""


def can_frames_complete(device: Device) -> Findings:
    for link in device.links.values():
        if not link.is_can:
            continue
        yield from _without_foreign_keys(link)
        own = [_identifier(link.parts(direction)) for direction in ("request", "response")]
        if own[0] != own[1]:
            text = f"requests and responses on {link.name} divide the identifier differently"
            help = "give the parts before the data the same types and bits in both directions"
            yield finding(link.place, "can", text, help)
        for direction in ("request", "response"):
            yield from _of_parts(device, link, direction)
        yield from _data(device, link)
        yield from _numbers(device, link)
    for message in device.messages.values():
        if message.remote is not None:
            yield from _remote_request(device, message)


def _identifier(parts: tuple[Part, ...]) -> list[tuple[object, ...]]:
    return [
        (part.bits, part.value.type.name, part.value.byte_order)
        for part in parts
        if part.bits is not None and part.value is not None
    ]


def _without_foreign_keys(link: Link) -> Findings:
    for key in _FOREIGN:
        if key in link.place:
            yield finding(link.place, key, f"`{key}` has no effect on a CAN bus", f"remove `{key}`")


def _of_parts(device: Device, link: Link, direction: str) -> Findings:
    assert link.escape is not None
    parts = link.parts(direction)
    identifier_end = next((index for index, part in enumerate(parts) if part.bits is None), len(parts))
    for part in parts[identifier_end:]:
        if part.bits is not None:
            text = f"{part.name} is a part of the identifier, but comes after {parts[identifier_end].name}"
            yield finding(part.place, "bits", text, "list the parts of the identifier first")
        if part.role in ("length", "checksum"):
            yield from _of_span(link, direction, part, identifier_end)
    free = set(range(link.escape.bits))
    for part in parts[:identifier_end]:
        first, last = part.bits or (0, 0)
        wrong = [bit for bit in range(first, last + 1) if bit not in free]
        if wrong:
            objection = "the identifier does not have" if wrong[0] >= link.escape.bits else "another part has"
            text = f"{part.name} has bit {wrong[0]}, which {objection}"
            yield finding(part.place, "bits", text, "correct the bits")
        free -= set(range(first, last + 1))
        if part.value is not None and last - first >= 8 * part.value.size:
            text = f"{part.name} has {plural(last - first + 1, 'bit')}, but is {part.value.type.name}"
            related_label = label(part.place, "type", "its type")
            yield finding(part.place, "bits", text, "use a wider type", related_label)
        if part.value is not None and is_signed(part.value.encoding):
            text = f"{part.name} is {part.value.type.name}, but the bits of an identifier have no sign"
            yield finding(part.place, "type", text, "use an unsigned type")
    if free:
        text = f"no part of a {direction} on {link.name} has bit {max(free)} of the identifier"
        help = "give every bit to a part; one without a meaning is `reserved`"
        yield finding(link.place, direction, text, help)
    is_remote = any(message.remote is not None for message in messages_on(device, link))
    sizes = [_REMOTE_CODE if is_remote and part.role == "code" else part_size(part) for part in parts[:identifier_end]]
    if sum(sizes) > _MOST_PARTS:
        text = f"the parts of the identifier on {link.name} have more than {_MOST_PARTS} bytes"
        yield finding(link.place, direction, text, "use narrower types, or join neighbouring parts")


def _of_span(link: Link, direction: str, part: Part, identifier_end: int) -> Findings:
    """A length or a checksum in the data says nothing of the identifier; the bus has a length and a checksum of it."""
    span = link.span(direction, part)
    if span is None or span[0] >= identifier_end:
        return
    verb, key = ("counts", "measures") if part.role == "length" else ("covers", "covers")
    parts = link.parts(direction)
    own = [other.name for other in parts[identifier_end:] if other is not part or part.role == "length"]
    text = f"{part.name} {verb} {parts[span[0]].name}, whose bits are in the identifier"
    help = f"begin with a part of the data, such as `{key}: {{from: {own[0] if own else part.name}}}`"
    help += f"; remove {part.name} if it is the {part.role} that the bus itself has"
    yield finding(part.place, key, text, help)


def _data(device: Device, link: Link) -> Findings:
    """The data of every message, and of an exception response, fit into a frame."""
    for direction in ("request", "response"):
        for message in messages_sent(device, link, direction):
            record = message.request if direction == "request" else message.response
            subject = f"the {direction} of {message.name}"
            help = "divide it into several messages"
            yield from _of_record(device, link, direction, record, subject, (message.place, direction, help))
    error = link.exception_response
    if error is not None and error.record in device.records:
        subject, record = f"an exception response on {link.name}", device.records[error.record]
        owner = link.place, "exception_response", "shorten the record"
        yield from _of_record(device, link, "response", record, subject, owner)


def _of_record(
    device: Device, link: Link, direction: str, record: Record, subject: str, owner: tuple[Place, str, str]
) -> Findings:
    """Data that are too long: `owner` says where, and what to do, if no list can be shorter.

    Lists may fill a frame together, such as data and padding; encoders reject more.
    """
    sizes = RecordSizes(device)
    bounds = [(field, pair) for field in record.fields if (pair := sizes.field(field)) is not None]
    if len(bounds) < len(record.fields):
        return
    minimum = sum(part_size(part) for part in link.parts(direction) if part.bits is None)
    minimum += sum(low for _, (low, _) in bounds)
    if minimum > CAN_DATA:
        place, key, help = owner
        yield finding(place, key, f"{subject} has {minimum} bytes, and a CAN frame {CAN_DATA}", help)
        return
    for field, (low, high) in bounds:
        size = minimum + high - low
        if size > CAN_DATA:
            text = f"with {field.name} at its longest, {subject} has {size} bytes, and a CAN frame {CAN_DATA}"
            help = f"lower the limit of {field.name}, or {owner[2]}"
            yield finding(field.place, "length" if field.repeat is None else "repeat", text, help)


def _remote_request(device: Device, message: Message) -> Findings:
    """A remote request has no data, so its code and all other parts are in the identifier."""
    for link in device.links.values():
        if not sent_on(link, message):
            continue
        data_parts = [part for part in link.request if part.bits is None and part.role != "body"]
        if not link.is_can:
            text = f"{message.name} is a remote request, but {link.name} is not a CAN bus"
            help = "name the CAN buses on which it is sent under `links`, or state its `request`"
        elif data_parts:
            text = f"{message.name} is a remote request, which has no room for {data_parts[0].name} of {link.name}"
            help = "name the links whose requests have all their parts in the identifier under `links`"
        elif not any(part.role == "code" for part in link.request):
            text = f"{message.name} is a remote request, but no part of the identifier on {link.name} has its code"
            help = "give the part of the identifier that tells the messages apart the role `code`"
        else:
            continue
        yield finding(message.place, "remote", text, help)


def _numbers(device: Device, link: Link) -> Findings:
    """Constants, ranges, unit addresses and codes have no more bits than their parts."""
    for part in (*link.request, *link.response):
        if part.bits is None or part.value is None:
            continue
        highest = (1 << part.bits[1] - part.bits[0] + 1) - 1
        ranges, addresses = part.value.ranges, link.unit_addresses
        numbers = [("const", part.value.const), ("range", ranges.high if ranges is not None else None)]
        for key, number in numbers:
            if number is not None and number > highest and key in part.place:
                text = f"{part.name} can be {number}, but its bits hold at most {highest}"
                yield finding(part.place, key, text, "correct the number or the bits")
        if part.role == "unit_address" and addresses is not None:
            greatest = max((addresses.ranges.high if addresses.ranges else 0), addresses.broadcast or 0)
            if greatest > highest:
                text = f"a unit address can be {greatest}, but the bits of {part.name} hold at most {highest}"
                yield finding(link.place, "unit_addresses", text, "correct the addresses or the bits")
        for message in messages_on(device, link) if part.role == "code" else ():
            for key, code in message.codes:
                if code > highest:
                    text = f"the code {code:#x} does not fit the bits of {part.name}, which hold at most {highest}"
                    yield finding(message.place, key, text, "correct the code or the bits")
        error = link.exception_response
        if part.role == "code" and error is not None and max(error.flag, error.code or 0) > highest:
            text = f"the bits of {part.name} do not hold the mark of exception responses"
            yield finding(link.place, "exception_response", text, "correct the mark or the bits")
