"""A field of a table in the register space has no constant, unless it is reserved.

Why: what a device answers when it is asked is read, whatever it is; a constant binds what lies in a frame. A record is
read as a whole, and a register that holds another value than its constant would make all of it unreadable.

Example: a record of a table with a field `{name: version, type: u16, const: 3}`.

Cure: Give the field a `range` of that one value, and a `default`: both bind what is written only.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.finding import finding, label
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device
from fieldspec.model.record import Record
from fieldspec.model.registers import Table

_MOST_LEVELS = 8


def table_fields_readable(device: Device) -> Iterator[Diagnostic]:
    done: set[str] = set()
    for table in device.tables.values():
        record = device.records.get(table.record)
        if record is not None:
            yield from _of_record(device, table, record, done, _MOST_LEVELS)


def _of_record(device: Device, table: Table, record: Record, done: set[str], levels: int) -> Iterator[Diagnostic]:
    if record.name in done or not levels:
        return
    done.add(record.name)
    for field in record.fields:
        if field.value is not None and field.value.const is not None and not field.reserved:
            text = f"{field.name} is a constant in a table, but {table.name} can answer anything"
            help = f"write `range: {field.value.const}` instead, which binds what is written only"
            there = label(table.place, "record", "the table")
            yield finding("table_fields_readable", field.place, "const", text, help, there)
        inner = device.records.get(field.record)
        if inner is not None:
            yield from _of_record(device, table, inner, done, levels - 1)
