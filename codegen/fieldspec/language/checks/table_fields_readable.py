"""A field of a register table has no `const`, unless it is reserved.

Why: a constant restricts frames, but a device may return any value of a register. A record is read as a
whole, so one register whose value differs from its constant would make the whole record unreadable.

Example: a record of a table with a field `{name: version, type: u16, const: 3}`.

Fix: Use a `range` with only that value and a `default`: both apply only to writing.
"""

from __future__ import annotations

from fieldspec.language.checks.facts import nested_fields
from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device


def table_fields_readable(device: Device) -> Findings:
    done: set[int] = set()
    for table in device.tables.values():
        record = device.records.get(table.record)
        for field in nested_fields(device, record.fields if record is not None else ()):
            if field.value is None or field.value.const is None or field.reserved or id(field) in done:
                continue
            done.add(id(field))
            text = f"{field.name} is a constant, but {table.name} can return any value"
            help = f"write `range: {field.value.const}` instead, which restricts only writing"
            related_label = label(table.place, "record", "the table")
            yield finding(field.place, "const", text, help, related_label)
