"""Examples that read or write registers use existing addresses, in agreement with their access, and values
within their range.

Why: a sample frame prints an address and a value independently of the register table. If it does not fit the register
table, one of the two is misprinted.

Example: a sample that writes 13 to a register with the range 0..12, or writes to an address that is in no
table.

Fix: Correct the frame or the register, and write an erratum.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, finding, hexadecimal, label, range_key
from fieldspec.language.checks.numbers import Legal, in_counts
from fieldspec.language.checks.occupants import Addressed, Addresses
from fieldspec.language.model.device import Device
from fieldspec.language.model.digits import digits_text
from fieldspec.language.model.raw_numbers import orders_of
from fieldspec.language.model.record import Field, Message, RegisterAccess
from fieldspec.language.model.registers import Register
from fieldspec.language.model.texts import Example

_MOST_WORDS = 0x10000
_REFUSED = {"read": "wo", "write": "ro"}


def examples_fit_registers(device: Device) -> Findings:
    addresses = Addresses(device)
    legal = Legal(device)
    refused = {reply.reply_to for reply in device.examples.values() if reply.exception_response}
    for example in device.examples.values():
        message = device.messages.get(example.message)
        bits = device.bit_access(message) if message is not None else None
        access = bits or (device.register_access(message) if message is not None else None)
        if message is None or access is None or example.exception_response or example.refused:
            continue
        if example.id in refused:
            continue
        request = example if example.direction == "request" else device.examples.get(example.reply_to)
        start = _request_count(device, message, access.start, request) if request is not None else None
        if start is None:
            continue
        if example.direction == "request":
            yield from _accessed(device, addresses, access, start, message, example)
        writes = access.operation == "write"
        data = _data(device, message, example) if bits is None else _bits(device, message, bits, example, request)
        for address, occupant, number in addresses.numbers(access.space, start, data, writes):
            yield from _valued(occupant, address, number, legal, writes, example)


def _accessed(
    device: Device, addresses: Addresses, access: RegisterAccess, start: int, message: Message, example: Example
) -> Findings:
    """The fault of the words that a request addresses: nothing begins there, or its access forbids it."""
    if not addresses.at(access.space, start):
        text = f"no register or field begins at {hexadecimal(start)}, which {example.id} addresses"
        yield finding(example.place, "values", text, "correct the frame or the register table")
    carried = len(_data(device, message, example)) // device.space(access.space).unit_size
    count = carried or _request_count(device, message, access.count, example) or 1
    for occupant in addresses.within(access.space, start, min(count, _MOST_WORDS)):
        if occupant.access == _REFUSED[access.operation]:
            deed = "reads" if access.operation == "read" else "writes"
            text = f"{example.id} {deed} {occupant.fact.name}, whose access is {occupant.access}"
            related_label = label(occupant.holder.place, "access", "the access")
            yield finding(example.place, "values", text, "correct the frame or the access", related_label)


def _valued(
    occupant: Addressed, address: int, number: int | float | None, legal: Legal, writes: bool, example: Example
) -> Findings:
    """The fault of a number at an address, as it is read; a trigger may be read as any number."""
    value = occupant.value
    if value is None or (isinstance(occupant.fact, Register) and occupant.fact.trigger and not writes):
        return
    name = f"{occupant.fact.name} at {hexadecimal(address)}"
    if number is None:
        text = f"{name} is not {digits_text(value)} in {example.id}"
        related_label = label(occupant.fact.place, "digits", "its digits")
        yield finding(example.place, "values", text, "correct the frame or the digits", related_label)
        return
    if writes and value.const is not None and number != value.const:
        text = f"{name} is {number} in {example.id}, but can only be written with {value.const}"
        related_label = label(occupant.fact.place, "const", "its constant")
        yield finding(example.place, "values", text, "correct the frame or the constant", related_label)
        return
    reason = legal.objection(value, number, writes)
    if reason:
        text = f"{name} is {number} in {example.id}, which {reason}"
        key = "write_range" if writes and "write_range" in occupant.fact.place else range_key(occupant.fact.place)
        related_label = label(occupant.fact.place, key, "its permitted values")
        yield finding(example.place, "values", text, "correct the frame or the range", related_label)


def _request_count(device: Device, message: Message, name: str, example: Example) -> int | None:
    """The count of a field of the request."""
    field = next((field for field in message.request.fields if field.name == name), None)
    return in_counts(device, field.value, example.values.get(name)) if field is not None and field.value else None


def _bits(device: Device, message: Message, access: RegisterAccess, example: Example, request: Example | None) -> bytes:
    """The bits that an example carries, a byte for each; none if it carries none, or if they cannot be read."""
    if (access.operation == "read") != (example.direction == "response"):
        return b""
    value = example.values.get(access.values)
    if access.set is not None:
        return bytes([{access.set: 1, access.clear: 0}[value]]) if value in (access.set, access.clear) else b""
    count = _request_count(device, message, access.count, request) if request is not None else None
    if not isinstance(value, list) or not all(isinstance(byte, int) and 0 <= byte <= 0xFF for byte in value):
        return b""
    return bytes(byte >> place & 1 for byte in value for place in range(8))[:count]


def _data(device: Device, message: Message, example: Example) -> bytes:
    """The bytes of the words that an example carries; none if it carries none, or if they cannot be read."""
    if message.single_access is None:
        return b""
    reads = message.single_access.operation == "read"
    if reads != (example.direction == "response"):
        return b""
    layer = message.response if reads else message.request
    field: Field | None = next((f for f in layer.fields if f.name == message.single_access.values), None)
    value = example.values.get(message.single_access.values)
    if field is None or field.value is None or field.value.digits:
        return b""
    size = field.value.size
    if size != device.space(message.single_access.space).unit_size:
        return b""
    items = value if isinstance(value, list) else [value]
    counts = [count for item in items if (count := in_counts(device, field.value, item)) is not None]
    if len(counts) != len(items):
        return b""
    order, _ = orders_of(field.value, device.byte_order, "")
    limit = 1 << 8 * size
    return b"".join((count % limit).to_bytes(size, "big" if order == "big" else "little") for count in counts)
