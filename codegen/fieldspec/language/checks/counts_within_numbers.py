"""A request that names the first of several records, and how many there are, stays within the numbers of the records.

Why: where both ranges allow it, a request reads records after the last one, and the manual does not say what the
device then does. A program that sends it deletes or reads something else than it means to.

Example: `first_point` with the range 1..31 beside `point_count` with the range 1..31: 31 points from 31 on.

Cure: Narrow a range, if the manual says so. Otherwise state under `allow` what is not printed, and write an erratum
with `printed: {allow: ~}`.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.language.checks.finding import finding, label
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.device import Device

_CODE = "counts_within_numbers"


def counts_within_numbers(device: Device) -> Iterator[Diagnostic]:
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
                yield finding(_CODE, count.place, "range", text, help, label(first.place, "range", "the first one"))
