"""A request that reads or writes registers contains only the address, the count and the values that `accesses` names,
and computed or constant fields. The address and the count of several registers are not constant.

Why: clients, simulators and `live` use the message for every register of the address space. They have no value for a
further field, so they could not send the message, and the registers would be inaccessible. With a constant address they
would reach only one register; with a constant count they would read values that the user did not request.

Example: a message that reads registers by `{name: address, type: u16}`, `{name: word_count, type: u16}` and
`{name: area, type: u8}`, whose area is not stated.

Fix: State `const` for a further field; if the field has several values, state a message and an address space for each
value. Or remove `accesses`: users then send the message with all its fields.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.record import Field, Message, RegisterAccess


def accesses_complete(device: Device) -> Findings:
    for message in device.messages.values():
        access = message.single_access
        if access is None:
            continue
        field_names = [access.start, access.count, access.values if access.operation == "write" else ""]
        stated = [name for name in field_names if name]
        if len(set(stated)) < len(stated) or not all(message.request.named(name) for name in stated):
            continue  # other rules say which field is meant
        for field in message.request.fields:
            if field.name not in field_names and not _is_filled(field):
                text = f"{field.name} of {message.name} is neither stated nor computed, so no client can "
                text += f"{access.operation} registers by the message"
                help = "state its `const`, or remove `accesses` from the message"
                related_label = label(message.place, "accesses", "the fields that clients fill")
                yield finding(field.place, "name", text, help, related_label)
        yield from _constants(message, access, packed=device.bit_access(message) is not None)


def _constants(message: Message, access: RegisterAccess, packed: bool) -> Findings:
    """The findings of an address or a number that clients cannot choose. `packed`: several bits are in one value."""
    start, count = message.request.named(access.start), message.request.named(access.count)
    holder = message.response if access.operation == "read" else message.request
    values = holder.named(access.values)
    has_several_values = values is not None and values.repeat is not None and (packed or values.repeat.high > 1)
    for field, noun, is_wrong in ((start, "address", True), (count, "number", has_several_values)):
        if field is None or not is_wrong or not _is_filled(field) or (field is count and field.measures is not None):
            continue
        key = "reserved" if field.reserved else "const" if field.measures is None else "measures"
        text = (
            f"{field.name} is the {noun} in {message.name}, but `{key}` says what is sent, whatever register is meant"
        )
        help = f"remove `{key}`, or remove `accesses`: users then send the message as any other"
        yield finding(field.place, key, text, help)


def _is_filled(field: Field) -> bool:
    """Whether encoders know the value of a field."""
    return field.reserved or field.measures is not None or (field.value is not None and field.value.const is not None)
