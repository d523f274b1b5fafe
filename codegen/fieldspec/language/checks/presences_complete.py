"""The field that says whether another one is sent comes before it in its record. It is one unsigned binary number of at
most four bytes that programs set: not a constant, reserved, optional, computed or a parameter. It has the bit, or the
enum with the members. Nothing measures an optional field. The data of exception responses, and of messages that access
registers, have none.

Why: a decoder reads the deciding field first, and then knows whether the bytes of the other field follow.

Example: `present_if: {by: flags, bit: 9}` for a field `flags` of the type `u8`.

Fix: List the fields in the order of the wire, name a deciding field that has the bit or the enum, or state a message
for each case.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.language.checks.facts import layers, nested_fields
from fieldspec.language.checks.finding import finding, label
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import Whole, is_signed
from fieldspec.language.model.raw_numbers import orders_of
from fieldspec.language.model.record import Field, Presence, Record

_CODE = "presences_complete"
_KEY = "present_if"
_MOST_BYTES = 4


def presences_complete(device: Device) -> Iterator[Diagnostic]:
    refusing = {link.exception_response.record for link in device.links.values() if link.exception_response is not None}
    for layer in layers(device):
        for field in layer.fields:
            if field.presence is not None and layer.name in refusing and device.records.get(layer.name) is layer:
                text = f"{layer.name} is the data of exceptions, and {field.name} is optional"
                yield finding(_CODE, field.place, _KEY, text, "remove `present_if`, or leave the field out")
            if field.presence is not None:
                yield from _decided(device, layer, field, field.presence)
                yield from _measured(layer, field)
    for message in device.messages.values():
        bodies = (message.request, message.response) if message.accesses else ()
        optional = next(
            (field for body in bodies for field in nested_fields(device, body.fields) if field.presence), None
        )
        if optional is not None:
            text = f"{message.name} reads or writes registers, and {optional.name} is optional"
            help = "remove `accesses`, or state a message for each case"
            yield finding(_CODE, message.place, "accesses", text, help, label(optional.place, _KEY, optional.name))


def _decided(device: Device, layer: Record, field: Field, presence: Presence) -> Iterator[Diagnostic]:
    """The findings of the field that decides on another one."""
    names = [other.name for other in layer.fields]
    decider = layer.named(presence.by)
    if decider is None:
        return
    if names.index(decider.name) >= names.index(field.name):
        text = f"{decider.name} decides whether {field.name} is sent, but does not come before it"
        help = "list the fields in the order of the wire"
        yield finding(_CODE, field.place, _KEY, text, help, label(decider.place, "name", decider.name))
    objection = _objection(device, decider, presence)
    if objection:
        text = f"{decider.name} cannot decide whether {field.name} is sent: {objection}"
        help = "name one unsigned number with the bit or the enum"
        yield finding(_CODE, field.place, _KEY, text, help, label(decider.place, "name", decider.name))


def _objection(device: Device, decider: Field, presence: Presence) -> str:
    """The reason why a field cannot decide another one, or an empty text."""
    value = decider.value
    if value is None or decider.is_list:
        return "it is not a single value"
    if not isinstance(value.encoding, Whole) or is_signed(value.encoding) or value.size > _MOST_BYTES:
        return f"it is {value.type.name}"
    if decider.reserved or value.const is not None or decider.measures is not None or value.parameter is not None:
        return "programs do not set it"
    if presence.bit is not None and presence.bit >= 8 * value.size:
        return f"it has no bit {presence.bit}"
    if presence.bit is None and not value.enum:
        return "it has no enum"
    is_swapped = orders_of(value, device.byte_order, device.word_order)[1]
    return "its word order differs from its byte order" if is_swapped else ""


def _measured(layer: Record, field: Field) -> Iterator[Diagnostic]:
    """The findings of fields that measure an optional one."""
    for other in layer.fields:
        if other.measures is not None and other.measures.field == field.name:
            text = f"{other.name} measures {field.name}, which is optional"
            help = "remove `measures`, or `present_if`: the number of bytes or elements says it already"
            yield finding(_CODE, other.place, "measures", text, help)
