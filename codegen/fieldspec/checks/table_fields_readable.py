"""A field of a register table has no `const`, unless it is reserved.

Why: a constant restricts frames, but a device may return any value of a register. A record is read as a
whole, so one register with another value than its constant would make the whole record unreadable.

Example: a record of a table with a field `{name: version, type: u16, const: 3}`.

Cure: Use a `range` with only that value and a `default`: both apply only to writing.
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
            text = f"{field.name} is a constant, but {table.name} can return any value"
            help = f"write `range: {field.value.const}` instead, which restricts only writing"
            there = label(table.place, "record", "the table")
            yield finding("table_fields_readable", field.place, "const", text, help, there)
        inner = device.records.get(field.record)
        if inner is not None:
            yield from _of_record(device, table, inner, done, levels - 1)
