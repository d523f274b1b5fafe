"""Numbers that are sent as digits, which functions for programmable controllers do not convert."""

from __future__ import annotations

from fieldspec.classes import replace
from fieldspec.layout.device import DeviceLayout, TableLayout
from fieldspec.layout.frame import LinkLayout, MessageLayout
from fieldspec.layout.record import RecordLayout
from fieldspec.model.value import PRIMITIVES, Value


def without_digits(layout: DeviceLayout) -> DeviceLayout:
    """The layout with bytes in place of digits, of which nothing is written: other findings are looked for in it."""
    records: dict[str, RecordLayout] = {}
    for name, record in layout.records.items():
        records[name] = _record(record, records)
    messages = {
        name: MessageLayout(
            message.message, name, _record(message.request, records), _record(message.response, records)
        )
        for name, message in layout.messages.items()
    }
    links = {
        name: LinkLayout(
            link.link, name, link.request, link.response, {other: messages[other] for other in link.messages}
        )
        for name, link in layout.links.items()
    }
    tables = {
        name: TableLayout(table.table, name, records[table.record.name], table.words)
        for name, table in layout.tables.items()
    }
    registers = tuple(
        replace(register, register=replace(register.register, value=_bytes(register.register.value)))
        for register in layout.registers
    )
    groups = tuple(
        replace(group, registers=tuple(replace(register, value=_bytes(register.value)) for register in group.registers))
        for group in layout.device.groups
    )
    signals = {name: replace(signal, value=_bytes(signal.value)) for name, signal in layout.device.signals.items()}
    device = replace(layout.device, groups=groups, signals=signals)
    return replace(
        layout, device=device, records=records, messages=messages, links=links, registers=registers, tables=tables
    )


def _record(record: RecordLayout, records: dict[str, RecordLayout]) -> RecordLayout:
    fields = tuple(
        replace(
            field,
            value=None if field.value is None else _bytes(field.value),
            record=None if field.record is None else records[field.record.name],
        )
        for field in record.fields
    )
    return replace(record, fields=fields)


def _bytes(value: Value) -> Value:
    if not value.digits:
        return value
    kind = PRIMITIVES["bytes"]
    scale, offset = type(value.scale)(1), type(value.offset)(0)
    bare = replace(value, type=kind, digits="", places=0, has_blanks=False, scale=scale, scale_text="", offset=offset)
    return replace(bare, enum="", flags="", sentinels=(), unit="", default=None, ranges=None, write_ranges=None)
