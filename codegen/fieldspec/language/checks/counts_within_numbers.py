"""A request with the number of a first record and a count of records stays within the numbers of the records.

Why: if both ranges permit it, a request reaches beyond the last record, and the manual does not say how the device
responds. A program that sends it deletes or reads the wrong data.

Example: `first_point` and `point_count`, each with the range 1..31: 31 points from 31 on.

Fix: Narrow a range, if the manual says so. Otherwise state under `allow` what the manual leaves open, and write an
erratum with `printed: {allow: ~}`.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device


def counts_within_numbers(device: Device) -> Findings:
    for message in device.messages.values():
        fields = {field.name: field for field in message.request.fields}
        for name, first in fields.items():
            count = fields.get(f"{name.removeprefix('first_')}_count") if name.startswith("first_") else None
            if count is None or first.value is None or count.value is None:
                continue
            starts, counts = first.value.ranges, count.value.ranges
            if starts is not None and counts is not None and starts.high + counts.high - 1 > starts.high:
                last = starts.high + counts.high - 1
                text = f"{first.name} and {count.name} of {message.name} reach {last}, "
                text += f"but the last number is {starts.high}"
                help = "narrow a range, or allow it with what the manual leaves open, and write an erratum"
                yield finding(count.place, "range", text, help, label(first.place, "range", "the first one"))
