"""No record contains itself, and records are nested at most 64 deep.

Why: a record that contains itself has no end and no layout.

Example: a record point with a field `record: zone`, and a record zone with a field `record: point`.

Fix: Remove the field from one of them, or name the intended record.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, finding
from fieldspec.language.model.device import Device
from fieldspec.language.model.sizes import MOST_LEVELS, RecordSizes


def records_finite(device: Device) -> Findings:
    endless = RecordSizes(device).endless
    for name in endless:
        record = device.records[name]
        for field in record.fields:
            if field.record in endless:
                text = f"{name} contains itself, or is nested more than {MOST_LEVELS} deep, through {field.record}"
                help = "remove the field, or name the intended record"
                yield finding(field.place, "record", text, help)
