"""The layout of a whole device at one version."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from fieldspec.codec.layout.bit_counts import with_bit_count
from fieldspec.codec.layout.frame import LinkLayout, link_layout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.record import FieldLayout, Orders, RecordLayout, RegisterLayout
from fieldspec.codec.layout.record_building import record_layout
from fieldspec.foundation.caches import ByIdentity
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.access import narrowed
from fieldspec.language.model.choice import BlockChoice
from fieldspec.language.model.device import Device
from fieldspec.language.model.record import Field, Record
from fieldspec.language.model.registers import Register, Table


@dataclass(frozen=True, slots=True)
class TableLayout:
    """A table of records in the register space. `words` is the size of one record."""

    table: Table
    name: str
    record: RecordLayout
    words: int

    def access(self, field: Field) -> str:
        """The access to a field of an element: what both the field and the table allow."""
        return narrowed(self.table.access, field.access)

    @property
    def read_only(self) -> tuple[str, ...]:
        """The fields that cannot be written, in a table with others that can."""
        if self.table.access == "ro":
            return ()
        return tuple(field.name for field in self.record.fields if self._read_only(field))

    @property
    def writable(self) -> bool:
        """Whether an element can be written as a whole: all of its fields can be written."""
        return self.table.access != "ro" and not self.read_only

    def word_runs(self) -> Iterator[tuple[int, int, tuple[FieldLayout, ...]]]:
        """The first word, the number of words, and the fields in them; fields that share a word are together."""
        words = [self._in_word(word) for word in range(self.words)]
        first = 0
        for index in range(1, len(words) + 1):
            if index == len(words) or words[index] != words[first]:
                if words[first]:
                    yield first, index - first, words[first]
                first = index

    def _in_word(self, word: int) -> tuple[FieldLayout, ...]:
        def end(field: FieldLayout) -> int:
            return field.end if field.end is not None else field.offset + field.size

        return tuple(field for field in self.record.fields if field.offset < 2 * word + 2 and end(field) > 2 * word)

    def _read_only(self, field: FieldLayout) -> bool:
        inner = field.record.fields if field.record is not None else ()
        return field.field.access == "ro" or any(map(self._read_only, inner))


@dataclass(frozen=True, slots=True)
class DeviceLayout:
    """All numbers of a device at one version. Two layouts with the same `identity` are alike for programs.

    `equal_versions` are the versions of other lines that have no outputs of their own and use the outputs of this one.
    `blocks` are those that controllers have, None for all.
    """

    device: Device
    identity: str
    records: Mapping[str, RecordLayout]
    links: Mapping[str, LinkLayout]
    messages: Mapping[str, MessageLayout]
    registers: tuple[RegisterLayout, ...]
    tables: Mapping[str, TableLayout]
    equal_versions: tuple[str, ...] = ()
    blocks: BlockChoice | None = None


LAYOUT_ATTRIBUTES = ("links", "messages", "records", "enums", "flags", "spaces", "groups", "tables")
"""The attributes of a device from which its layout follows, but for the identity."""


def device_layout(device: Device) -> DeviceLayout:
    """The layout of a device without findings. For any other device, it may raise any exception."""
    orders = Orders(device.byte_order, device.word_order)
    records: dict[str, RecordLayout] = {}
    bodies = [body for message in device.messages.values() for body in (message.request, message.response)]
    parts = frozenset(field.record for record in (*device.records.values(), *bodies) for field in record.fields)
    for record in device.records.values():
        _add_record(record, device, records, orders, parts)
    messages = {
        message.name: MessageLayout(
            message,
            message.name,
            with_bit_count(device, message, record_layout(message.request, records, orders, device, is_part=False)),
            record_layout(message.response, records, orders, device, is_part=False),
        )
        for message in device.messages.values()
    }
    registers = tuple(_register(register, orders) for register in device.registers())
    tables = {
        table.name: TableLayout(table, table.name, records[table.record], (records[table.record].size or 0) // 2)
        for table in device.tables.values()
    }
    from fieldspec.codec.layout.identity import (
        identity,  # this imports OpenSSL, which a layout read from a cache does not need
    )

    links = {link.name: link_layout(link, messages, records) for link in device.links.values()}
    return DeviceLayout(
        device, identity(device, records, links, messages, registers), records, links, messages, registers, tables
    )


def _add_record(
    record: Record, device: Device, records: dict[str, RecordLayout], orders: Orders, parts: frozenset[str]
) -> None:
    """Adds the layout of a record, after the layouts of the records in it. `parts` are the records in others."""
    if record.name in records:
        return
    for field in record.fields:
        if field.record:
            _add_record(device.records[field.record], device, records, orders, parts)
    records[record.name] = record_layout(record, records, orders, device, record.name in parts)


_REGISTERS: ByIdentity[Register, tuple[Orders, RegisterLayout]] = ByIdentity(limit=20_000)
"""The layouts of registers, which versions share, and mostly the next build too."""


def _register(register: Register, orders: Orders) -> RegisterLayout:
    if register not in _REGISTERS or _REGISTERS[register][0] != orders:
        row = (register, register.name, register.address, register.width, register.count, register.stride)
        _REGISTERS[register] = orders, RegisterLayout(*row, *orders.of(register.value))
    return _REGISTERS[register][1]
