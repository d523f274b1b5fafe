"""Every value with an address: each element of an array, and each field of each element of a record table."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.classes import TYPE_CHECKING, dataclass
from fieldspec.layout.device import DeviceLayout, TableLayout
from fieldspec.layout.record import FieldLayout, RecordLayout
from fieldspec.model.access import narrowed
from fieldspec.model.fact import Fact
from fieldspec.model.value import Value

if TYPE_CHECKING:
    from typing import TypeAlias


Address: TypeAlias = tuple[str, int]
"""The name of a space, and an address in it."""


@dataclass(frozen=True, slots=True)
class AddressedValue:
    """A value of `words` words at `address`; its own bytes begin after `skip` bytes.

    `order` and `swapped` are the order of its bytes. A value is `unread` where a read does not give what was written:
    it can only be written, or a write starts an action.
    """

    space: str
    name: str
    fact: Fact
    address: int
    words: int
    skip: int
    value: Value
    order: str
    swapped: bool
    unread: bool
    reserved: bool

    @property
    def addresses(self) -> list[Address]:
        """The addresses of its words."""
        return [(self.space, address) for address in range(self.address, self.address + self.words)]


def addressed_values(layout: DeviceLayout) -> Iterator[AddressedValue]:
    """The values in the spaces of registers, in the order of the spec."""
    device = layout.device
    for register_layout in layout.registers:
        register = register_layout.register
        for number in range(register_layout.count):
            name = (
                f"{register_layout.name}[{register.index_from + number}]"
                if register_layout.count > 1
                else register_layout.name
            )
            address = register_layout.address + number * register_layout.stride
            yield AddressedValue(
                device.space_name(register.space),
                name,
                register,
                address,
                max(1, register_layout.words),
                0,
                register.value,
                register_layout.order,
                register_layout.swapped,
                register.trigger or register.access == "wo",
                register.reserved,
            )
    for table in layout.tables.values():
        if table.table.base_by:
            continue
        placed = list(values_of_record(table.record, table.table.access))
        for index in table.table.indexes:
            for name, field, byte, access in placed:
                yield _field(device.space_name(table.table.space), table, index, name, field, byte, access)


def _field(
    space: str, table: TableLayout, index: int, name: str, field: FieldLayout, byte: int, access: str
) -> AddressedValue:
    assert field.value is not None
    return AddressedValue(
        space,
        f"{table.name}[{index}].{name}",
        field.field,
        table.table.address(index) + byte // 2,
        (byte % 2 + field.size + 1) // 2,
        byte % 2,
        field.value,
        field.order,
        field.swapped,
        access == "wo",
        field.field.reserved,
    )


def values_of_record(
    record: RecordLayout, access: str, before: str = "", offset: int = 0
) -> Iterator[tuple[str, FieldLayout, int, str]]:
    """The values of a record, also of nested records: name, field, first byte and access of each element.

    `access` is the access of the table or field that contains the record.
    """
    for field in record.fields:
        allowed = narrowed(access, field.field.access)
        count = field.count or 1
        for number in range(count):
            name = f"{before}{field.name}" + (f"[{number}]" if count > 1 else "")
            byte = offset + field.offset + number * field.size
            if field.record is not None:
                yield from values_of_record(field.record, allowed, f"{name}.", byte)
            elif field.value is not None:
                yield name, field, byte, allowed
