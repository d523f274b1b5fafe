"""A record has fields, unless it is the record of exception responses only.

Why: an exception response can consist of its mark, without data. A field or an element of a table without bytes has no
meaning.

Example: a table whose record has `fields: []`.

Fix: Add the fields.
"""

from __future__ import annotations

from fieldspec.language.checks.facts import layers
from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device

_HELP = "add its fields; only exception responses may have none"


def records_filled(device: Device) -> Findings:
    empty = {name: record for name, record in device.records.items() if not record.fields}
    if not empty:
        return
    excepted = {link.exception_response.record for link in device.links.values() if link.exception_response is not None}
    users = {table.record: (table.place, table.name) for table in device.tables.values()}
    users |= {field.record: (field.place, field.name) for layer in layers(device) for field in layer.fields}
    for name, record in empty.items():
        if name in users:
            place, user = users[name]
            related_label = label(record.place, "fields", name)
            yield finding(place, "record", f"{user} has no bytes, because {name} has no fields", _HELP, related_label)
        elif name not in excepted:
            yield finding(record.place, "fields", f"{name} has no fields", _HELP)
