"""On links with codes, every message has a unique code, or differs from every message with the same code in a constant
or in the range of a byte in its data. On links without codes, a message has a unique number or no number. A message is
answered only on links on which it is sent.

Why: a decoder identifies a message by its code, and people identify it by its number.

Example: two commands with the code 0x44 on one link, or two telegrams with the number 111.

Fix: Add the code, or correct a code or a number, and write an erratum if the manual prints it that way. If commands
share a code and have subcodes, give each request the field with its subcode as a `const`, at the same offset, or a byte
with a `range` of its own numbers. Responses need no subcode: without it, the request determines the expected response.
A message that is sent only on links without codes names these links under `links`. A message that reads has a response
on every link on which it is sent. An unrequested message has a code that no response has, or differs from every
response with its code in a constant at one common offset.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.link import Link
from fieldspec.language.model.record import Message, Record
from fieldspec.language.model.sizes import RecordSizes, coded, messages_on, sent_on
from fieldspec.language.model.subcodes import Numbers, Place, distinct_place, numbers_at


def messages_complete(device: Device) -> Findings:
    for link in device.links.values():
        yield from _coded(device, link) if coded(link) else _numbered(device, link)
    for message in device.messages.values():
        yield from _check_supplements(device, message)
        yield from _check_answers(device, message)
        yield from _check_response_code(device, message)


def _coded(device: Device, link: Link) -> Findings:
    by_code: dict[int, list[Message]] = {}
    for message in messages_on(device, link):
        code = message.code_of("request")
        if code is None:
            text = f"{message.name} has no code"
            help = "state its `code`, or name the links without codes on which it is sent"
            yield finding(message.place, "code", text, help)
            continue
        by_code.setdefault(code, []).append(message)
    sizes = RecordSizes(device)
    for messages in by_code.values():
        yield from _shared(device, sizes, [message for message in messages if message.is_requested])
    yield from _unrequested(device, sizes, link)


def _shared(device: Device, sizes: RecordSizes, messages: list[Message]) -> Findings:
    """Several messages have a code: the numbers of a field in their requests tell them apart."""
    places = [_places(device, sizes, message.request) for message in messages]
    if len(messages) < 2 or distinct_place(places) is not None:
        return
    # Where each two of them differ, but not all of them at one place, the first one stands for all others.
    pairs = ((later, earlier) for later in range(len(messages)) for earlier in range(later))
    alike = (pair for pair in pairs if distinct_place([places[number] for number in pair]) is None)
    later, earlier = next(alike, (len(messages) - 1, 0))
    message, other = messages[later], messages[earlier]
    text = f"{message.name} and {other.name} have the code {message.code:#04x}"
    help = "correct one of the codes, or give each message its subcode: a field of up to eight bytes with its own"
    help += " `const` at the same place"
    if any(map(distinct_place, ([numbers] for numbers in places))):
        text += ", and no constant at the same place of each request tells them apart"
        help = "give each of them a number of up to eight bytes with its own `const` at the same place, all"
        help += " of one size, or a byte with a `range` of its own"
    if bool(message.request.fields) != bool(other.request.fields):
        help += "; if only their sizes differ, state one message, and these fields as a record with `repeat: 0..1`"
    yield finding(message.place, "code", text, help, label(other.place, "code", other.name))


def _unrequested(device: Device, sizes: RecordSizes, link: Link) -> Findings:
    """Unrequested messages are identified without a request."""
    answered_messages = [message for message in messages_on(device, link) if message.is_answered_on(link.name)]
    is_coded = any(part.role == "code" for part in link.response)
    for message in (message for message in answered_messages if not message.is_requested):
        if not is_coded:
            text = f"no code or constant identifies {message.name} on {link.name}, which only the device sends"
            help = "give a part of `response` the role `code`, or name under `links` only links without codes"
            yield finding(message.place, "requested", text, help)
            continue
        code = message.code_of("response")
        same = [other for other in answered_messages if other is not message and other.code_of("response") == code]
        places = [_places(device, sizes, other.response) for other in (message, *same)]
        if same and distinct_place(places) is None:
            text = f"{message.name} is unrequested, and looks like the response to {same[0].name}"
            help = "correct one of the codes, or give each of them a field with a `const` at the same place"
            related_label = label(same[0].place, "code", same[0].name)
            yield finding(message.place, "requested", text, help, related_label)


def _places(device: Device, sizes: RecordSizes, record: Record) -> dict[Place, Numbers]:
    orders = device.byte_order, device.word_order
    places = (numbers_at(field, offset, *orders) for field, offset in sizes.offsets(record))
    return dict(place_and_numbers for place_and_numbers in places if place_and_numbers is not None)


def _numbered(device: Device, link: Link) -> Findings:
    first: dict[int, Message] = {}
    for message in messages_on(device, link):
        other = first.setdefault(message.number, message) if message.number is not None else message
        if other is not message:
            text = f"{message.name} and {other.name} have the number {message.number}"
            related_label = label(other.place, "number", other.name)
            yield finding(message.place, "number", text, "correct one of the numbers", related_label)


def _check_answers(device: Device, message: Message) -> Findings:
    """A message is answered only where it is sent, and one that reads is answered wherever it is sent."""
    if message.answered_on is None:
        return
    for name in message.answered_on:
        link = device.links.get(name)
        if link is not None and not sent_on(link, message):
            text = f"{message.name} is answered on {name}, but not sent there"
            yield finding(message.place, "answered_on", text, "leave the link out, or add it to `links`")
    link_names = [link.name for link in device.links.values() if sent_on(link, message)]
    silent = [name for name in link_names if not message.is_answered_on(name)]
    if not silent:
        return
    if any(access.operation == "read" for access in message.accesses):
        text = f"{message.name} reads, but is not answered on {', '.join(silent)}"
        yield finding(message.place, "answered_on", text, "remove `accesses`, or `answered_on`")
    if message.number is not None and message.code is None:
        text = f"{message.name} has no code: its request and its response are sent without each other"
        help = "remove `answered_on`, and add `response: []` if there is none"
        yield finding(message.place, "answered_on", text, help)
    printed = ("frame_length", message.response_length), ("data_words", message.response_words)
    for key, stated in printed:
        if stated is not None and not message.is_answered:
            text = f"{message.name} is never answered, but `{key}` has a response"
            yield finding(message.place, key, text, "remove the response there, or `answered_on`")


def _check_response_code(device: Device, message: Message) -> Findings:
    """Some response has a code in which the response code can be."""
    if message.response_code is None:
        return
    links = [link for link in device.links.values() if sent_on(link, message) and message.is_answered_on(link.name)]
    if links and not any(part.role == "code" for link in links for part in link.response):
        names = ", ".join(link.name for link in links)
        text = f"{message.name} has a `response_code`, but responses on {names} have no code"
        help = "remove it, or add the part with the role `code` to `response` of the link"
        yield finding(message.place, "response_code", text, help)


def _check_supplements(device: Device, message: Message) -> Findings:
    """A message that supplements others is not supplemented itself, and shares a link with each of them."""
    for name in message.supplements:
        other = device.messages.get(name)
        if other is None:
            continue
        apart = not any(sent_on(link, message) and sent_on(link, other) for link in device.links.values())
        if apart or other.supplements:
            reason = "no link carries both" if apart else "that message is never sent alone either"
            text = f"{message.name} is sent beside {name}, but {reason}"
            related_label = label(other.place, "supplements" if other.supplements else "name", name)
            help = "name messages of the same link that are sent alone"
            yield finding(message.place, "supplements", text, help, related_label)
