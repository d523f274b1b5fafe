"""Numbers that are sent as digits, which functions for programmable controllers do not convert."""

from __future__ import annotations

from fieldspec.classes import replace
from fieldspec.diagnostics import Diagnostic
from fieldspec.layout.device import DeviceLayout, TableLayout
from fieldspec.layout.frame import LinkLayout, MessageLayout
from fieldspec.layout.record import RecordLayout
from fieldspec.model.value import PRIMITIVES, Value
from fieldspec.plc.absent import stated_values
from fieldspec.plc.dialects import Dialect

_HELP = "leave this output out for the device: name the others after --to"


def digits_findings(layout: DeviceLayout, dialect: Dialect) -> list[Diagnostic]:
    """A finding for each value that is sent as digits."""
    facts = {id(fact): fact for fact, value in stated_values(layout) if value.digits}
    return [
        Diagnostic(
            "plc_numbers_binary",
            f"{fact.name} is sent as digits, which {dialect.title} does not convert",
            fact.place["digits"],
            help=_HELP,
        )
        for fact in facts.values()
    ]


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
    device = replace(layout.device, groups=groups)
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
    bare = replace(value, type=kind, digits="", places=0, enum="", flags="", sentinels=(), unit="", default=None)
    return replace(bare, scale=scale, scale_text="", offset=offset, ranges=None, write_ranges=None)
