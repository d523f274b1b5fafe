"""The field with the first address can contain the address of every register that its message accesses.

Why: outputs put the address of a register into that field. An address that does not fit the field is rejected when a
program first requests the register, or loses its high bits.

Example: a register at 0x1200 in an address space whose reading message has `{name: address, type: u8}`.

Fix: Correct the type or the range of the field, or the address or the address space of the register.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.language.checks.addresses import table_words
from fieldspec.language.checks.finding import Findings, finding, hexadecimal, label
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_count
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.record import Field, Message
from fieldspec.language.model.sizes import RecordSizes
from fieldspec.language.model.value import Value

_REFUSED = {"read": "wo", "write": "ro"}
_HELP = "correct the type or the range of the field, or the address"


def addresses_fit_messages(device: Device) -> Findings:
    for message in device.messages.values():
        access = message.single_access
        field = message.request.named(access.start) if access is not None else None
        if access is None or field is None or field.value is None or not is_count(field.value.encoding):
            continue
        space = device.space_name(access.space)
        for fact, key, first, last in _addressed(device, space, _REFUSED[access.operation]):
            if not _contains(field.value, first, last):
                yield _finding(message, field, fact, key, first if first == last else last)
                break


def _addressed(device: Device, space: str, refused: str) -> Iterator[tuple[Fact, str, int, int]]:
    """The part of a space that a message can access: registers with the first addresses of their elements, whole
    tables.
    """
    for register in device.registers():
        if device.space_name(register.space) == space and register.access != refused:
            yield register, "at", register.address, register.address + (register.count - 1) * register.stride
    sizes = RecordSizes(device)
    for table in device.tables.values():
        if device.space_name(table.space) == space and table.access != refused and not table.base_by:
            last = table.base + (table.count - 1) * table.stride + table_words(table, sizes) - 1
            yield table, "base", table.base, last


def _contains(value: Value, first: int, last: int) -> bool:
    """Whether all numbers from one to another are values of a field."""
    if first < value.low or last > value.high:
        return False
    ranges = value.writable_ranges
    return ranges is None or any(low <= first and last <= high for low, high in ranges.intervals)


def _finding(message: Message, field: Field, fact: Fact, key: str, address: int) -> Diagnostic:
    text = f"{fact.name} has the address {hexadecimal(address)}, which {field.name} of {message.name} cannot contain"
    related_label = label(field.place, "range" if "range" in field.place else "type", "the field with the address")
    return finding(fact.place, key, text, _HELP, related_label)
