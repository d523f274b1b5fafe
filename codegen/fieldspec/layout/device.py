"""The layout of a whole device at one version."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.classes import dataclass
from fieldspec.layout.frame import LinkLayout, MessageLayout, link_layout
from fieldspec.layout.record import FieldLayout, Orders, RecordLayout, RegisterLayout, record_layout
from fieldspec.model.access import narrowed
from fieldspec.model.device import Device
from fieldspec.model.record import Field, Record
from fieldspec.model.registers import Register, Table


@dataclass(frozen=True, slots=True)
class TableLayout:
    """A table of records in the register space."""

    table: Table
    name: str
    record: RecordLayout
    words: int

    def access(self, field: Field) -> str:
        """What may be done with a field of an element: what the field and the table both allow."""
        return narrowed(self.table.access, field.access)

    @property
    def read_only(self) -> tuple[str, ...]:
        """The fields that cannot be written, in a table that does not say so of all of them."""
        if self.table.access == "ro":
            return ()
        return tuple(field.name for field in self.record.fields if self._read_only(field))

    @property
    def writable(self) -> bool:
        """Whether an element may be written as a whole: nothing in it can only be read."""
        return self.table.access != "ro" and not self.read_only

    def _read_only(self, field: FieldLayout) -> bool:
        inner = field.record.fields if field.record is not None else ()
        return field.field.access == "ro" or any(map(self._read_only, inner))


@dataclass(frozen=True, slots=True)
class DeviceLayout:
    """All numbers of a device at one version. `identity` is equal if and only if what is on the wire is.

    `twins` are the versions of other lines that have no outputs of their own, and share those of this one.
    """

    device: Device
    identity: str
    records: Mapping[str, RecordLayout]
    links: Mapping[str, LinkLayout]
    messages: Mapping[str, MessageLayout]
    registers: tuple[RegisterLayout, ...]
    tables: Mapping[str, TableLayout]
    equal_versions: tuple[str, ...] = ()


def device_layout(device: Device) -> DeviceLayout:
    """The layout of a device that has passed the checks."""
    orders = Orders(device.byte_order, device.word_order)
    records: dict[str, RecordLayout] = {}
    for record in device.records.values():
        _lay(record, device, records, orders)
    messages = {
        message.name: MessageLayout(
            message,
            message.name,
            record_layout(message.request, records, orders, device.enums),
            record_layout(message.response, records, orders, device.enums),
        )
        for message in device.messages.values()
    }
    registers = tuple(_register(register, orders) for register in device.registers())
    tables = {
        table.name: TableLayout(table, table.name, records[table.record], (records[table.record].size or 0) // 2)
        for table in device.tables.values()
    }
    from fieldspec.layout.identity import identity  # with OpenSSL, for which one that is laid out has no use

    links = {link.name: link_layout(link, messages) for link in device.links.values()}
    return DeviceLayout(
        device, identity(device, records, links, messages, registers), records, links, messages, registers, tables
    )


def _lay(record: Record, device: Device, records: dict[str, RecordLayout], orders: Orders) -> None:
    """Lays out a record behind the records that lie in it."""
    if record.name in records:
        return
    for field in record.fields:
        if field.record:
            _lay(device.records[field.record], device, records, orders)
    records[record.name] = record_layout(record, records, orders, device.enums)


def _register(register: Register, orders: Orders) -> RegisterLayout:
    order, swapped = orders.of(register.value)
    return RegisterLayout(
        register, register.name, register.address, register.width, register.count, register.stride, order, swapped
    )
