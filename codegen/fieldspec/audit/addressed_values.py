"""Every value that a device holds at an address: of arrays each element, of tables each field of each element."""

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
    """A value at `address`, which takes `words` there; its bytes begin `skip` bytes behind the first.

    `order` and `swapped` are those of its bytes. What is read of one that is `unread` is not what was written: it can
    only be written, or starts something.
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


def units(layout: DeviceLayout) -> Iterator[AddressedValue]:
    """The values in the spaces of registers."""
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
        placed = list(_flat(table.record, table.table.access))
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


def _flat(
    record: RecordLayout, access: str, before: str = "", at: int = 0
) -> Iterator[tuple[str, FieldLayout, int, str]]:
    """The values in a record with their names, their first bytes and their access, also those of records in it.

    Each of several is there. `access` is that of what the record lies in.
    """
    for field in record.fields:
        allowed = narrowed(access, field.field.access)
        count = field.count or 1
        for number in range(count):
            name = f"{before}{field.name}" + (f"[{number}]" if count > 1 else "")
            byte = at + field.offset + number * field.size
            if field.record is not None:
                yield from _flat(field.record, allowed, f"{name}.", byte)
            elif field.value is not None:
                yield name, field, byte, allowed
