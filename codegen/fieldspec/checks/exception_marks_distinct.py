"""Where frames carry no code, a constant in the data marks exception responses: a `field` of their record, at a
fixed place. No other response on the link has this number there.

Why: a decoder that cannot tell the two apart reads the reason of a refusal as the answer, or the reverse.

Example: `exception_response: {field: command, record: abort}` where `command` has the `const` 0x80, and a message
whose response begins with any byte.

Cure: Give the field of the record a `const`. Give the fields of other responses at its place another `const`, an enum
that is not open, or a range without this number. Where responses carry a code, state `flag`, `code` or `part` instead.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.finding import finding, label, near
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device
from fieldspec.model.link import Link
from fieldspec.model.record import Field, Message
from fieldspec.model.sizes import RecordSizes, messages_on
from fieldspec.model.subcodes import Place, constant_at

_CODE = "exception_marks_distinct"


def exception_marks_distinct(device: Device) -> Iterator[Diagnostic]:
    sizes = RecordSizes(device)
    for link in device.links.values():
        error = link.exception_response
        record = device.records.get(error.record) if error is not None else None
        if error is None or not error.field or record is None:
            continue
        if any(part.role == "code" for part in link.response):
            text = f"responses on {link.name} carry a code, so that no field of {error.record} marks exceptions"
            yield finding(_CODE, link.place, "exception_response", text, "state `flag`, `code` or `part` instead")
            continue
        field = record.named(error.field)
        if field is None:
            text = f"{record.name} has no field {error.field}"
            help = near(error.field, [other.name for other in record.fields])
            yield finding(_CODE, link.place, "exception_response", text, help, label(record.place, "name", record.name))
            continue
        offset = next((at for other, at in sizes.offsets(record) if other is field), None)
        constant = constant_at(field, offset, device.byte_order) if offset is not None else None
        if constant is None:
            text = f"{record.name}/{field.name} marks exception responses, but it is no constant at a fixed place"
            help = "give it a whole number of one or two bytes as `const`, with fields of fixed size before it"
            yield finding(_CODE, field.place, "name", text, help, label(link.place, "exception_response", link.name))
            continue
        for message in messages_on(device, link):
            if message.is_answered_on(link.name):
                yield from _apart(device, sizes, link, message, *constant)


def _apart(
    device: Device, sizes: RecordSizes, link: Link, message: Message, place: Place, number: int
) -> Iterator[Diagnostic]:
    """Whether the response of a message never has the number at a place."""
    offset, size, _ = place
    for field, at in sizes.offsets(message.response):
        bounds = sizes.field(field)
        if bounds is not None and at + bounds[1] <= offset:
            continue
        if at >= offset + size or _is_another(device, field, at, place, number):
            return
        text = f"{message.name} may have {number:#x} in {field.name}, which marks exception responses on {link.name}"
        help = "give the field another `const`, an enum that is not open, or a range without this number"
        there = label(link.place, "exception_response", "exception responses")
        yield finding(_CODE, field.place, "name", text, help, there)
        return


def _is_another(device: Device, field: Field, at: int, place: Place, number: int) -> bool:
    """Whether a field is one number at the very place, and never this one."""
    constant = constant_at(field, at, device.byte_order)
    if constant is not None:
        return constant[0] == place and constant[1] != number
    value = field.value
    if value is None or (at, value.size) != place[:2] or field.count is not None or field.repeat is not None:
        return False
    if field.reserved or value.type.signed or (value.size > 1 and (value.byte_order or device.byte_order) != place[2]):
        return False
    enum = device.enums.get(value.enum)
    if enum is not None and not enum.open:
        return enum.member(number) is None
    return value.ranges is not None and number not in value.ranges and value.sentinel(number) is None
