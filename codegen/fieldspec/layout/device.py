"""The layout of a whole device at one version."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass

from fieldspec.layout.frame import LinkLayout, link_layout
from fieldspec.layout.message import MessageLayout
from fieldspec.layout.record import FieldLayout, Orders, RecordLayout, record_layout
from fieldspec.model.device import Device
from fieldspec.model.record import Record
from fieldspec.model.register import Register
from fieldspec.model.table import Table


@dataclass(frozen=True, slots=True)
class RegisterLayout:
    """A register: addresses and words; `order` and `swapped` as in a field."""

    register: Register
    name: str
    address: int
    words: int
    count: int
    stride: int
    order: str
    swapped: bool


@dataclass(frozen=True, slots=True)
class TableLayout:
    """A table of records in the register space."""

    table: Table
    name: str
    record: RecordLayout
    words: int


@dataclass(frozen=True, slots=True)
class DeviceLayout:
    """All numbers of a device at one version. `identity` is equal if and only if what is on the wire is."""

    device: Device
    identity: str
    records: Mapping[str, RecordLayout]
    links: Mapping[str, LinkLayout]
    messages: Mapping[str, MessageLayout]
    registers: tuple[RegisterLayout, ...]
    tables: Mapping[str, TableLayout]


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
    links = {link.name: link_layout(link, messages) for link in device.links.values()}
    return DeviceLayout(
        device, _identity(device, records, links, messages, registers), records, links, messages, registers, tables
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


def _identity(
    device: Device,
    records: Mapping[str, RecordLayout],
    links: Mapping[str, LinkLayout],
    messages: Mapping[str, MessageLayout],
    registers: tuple[RegisterLayout, ...],
) -> str:
    """A hash over everything that decides what bytes mean, and over nothing else."""
    digest = hashlib.sha256()

    def add(*words: object) -> None:
        digest.update("\x1f".join(str(word) for word in words).encode() + b"\n")

    def add_field(field: FieldLayout) -> None:
        value = field.value
        inner = field.record.name if field.record else ""
        add("field", field.name, field.offset, field.size, field.count, inner, field.order, field.swapped)
        add(field.field.measures, field.field.reserved, field.field.repeat)
        for case in field.cases:
            add("case", sorted(case.numbers), case.value.type.name, case.order, case.swapped)
        if value:
            add(value.type.name, value.scale, value.offset, value.unit, value.ranges, value.const)
            add(value.enum, value.flags, [(s.value, s.name) for s in value.sentinels])

    for link in links.values():
        add("link", link.name, link.link.encoding, link.link.start.hex(), link.link.end.hex(), link.link.error)
        for frame in (link.request, link.response):
            for part in (*frame.head, *frame.tail):
                add(part.name, part.role, part.offset, part.size, part.algorithm, part.order)
    for record in records.values():
        add("record", record.name)
        for field in record.fields:
            add_field(field)
    for message in messages.values():
        add("message", message.name, message.message.code, message.message.number, message.message.links)
        for data in (message.request, message.response):
            for field in data.fields:
                add_field(field)
    for laid in registers:
        value, register = laid.register.value, laid.register
        add("register", laid.name, laid.address, laid.words, laid.count, laid.stride, laid.order, laid.swapped)
        add(value.type.name, value.scale, value.offset, value.unit, value.ranges, value.enum, value.flags)
        add(register.access, register.trigger, register.atomic, value.const)
    for table in device.tables.values():
        add("table", table.name, table.base, table.stride, table.count, table.index_from, table.record)
    for words in device.parameters.values():
        add("parameters", words.name, words.space, words.base, words.numbers)
        for parameter in words.parameters:
            value = parameter.value
            add("parameter", words.name, parameter.number, parameter.name, value.type.name, value.scale, value.unit)
            add(value.ranges, value.enum, value.flags, parameter.access, parameter.count, parameter.elements)
            for inner in parameter.subindices:
                add("subindex", inner.name, inner.indices, inner.value.type.name, inner.value.scale, inner.value.unit)
    for conversion in device.conversions.values():
        add("conversion", conversion.name, conversion.type.name, conversion.full_scale, conversion.complement)
    for enum in device.enums.values():
        add("enum", enum.name, enum.open, [(m.name, m.value, m.unavailable) for m in enum.members])
    for flags in device.flags.values():
        add("flags", flags.name, flags.type.name, [(b.name, b.first, b.last, b.enum) for b in flags.bits])
    return digest.hexdigest()[:16]
