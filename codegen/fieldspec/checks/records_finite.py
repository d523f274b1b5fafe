"""No record lies in itself, and records are nested at most 64 deep.

Why: a record that holds itself has no end, and no layout.

Example: a record point with a field `record: zone`, and a record zone with a field `record: point`.

Cure: Take the field out of one of them, or name the record that was meant.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.finding import finding
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device
from fieldspec.model.sizes import MOST_LEVELS, RecordSizes


def records_finite(device: Device) -> Iterator[Diagnostic]:
    endless = RecordSizes(device).endless
    for name in endless:
        record = device.records[name]
        for field in record.fields:
            if field.record in endless:
                text = f"{name} lies in itself, or is nested more than {MOST_LEVELS} deep, through {field.record}"
                help = "take the field out, or name the record that was meant"
                yield finding("records_finite", field.place, "record", text, help)
