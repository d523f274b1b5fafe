"""The range of a field is not wider than its closed enum.

Why: a value that is in the range and not in the enum has no meaning. Either a member is missing, or the range
is too wide, or the enum is open.

Example: a range of 0..12 and an enum with the values 0 to 11.

Cure: Transcribe the missing member, correct the range and write an erratum, or set `open: true` on the enum
if values without a name can occur.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.facts import values
from fieldspec.checks.finding import enumeration, finding, interval, label, missing, range_key
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device


def range_within_enum(device: Device) -> Iterator[Diagnostic]:
    for fact, value in values(device):
        enum = device.enums.get(value.enum)
        if enum is None or enum.open or value.ranges is None:
            continue
        named_numbers = [
            *(member.value for member in enum.members),
            *(sentinel.value for sentinel in value.sentinels),
        ]
        holes = missing(value.ranges, named_numbers)
        if holes:
            yield finding(
                "range_within_enum",
                fact.place,
                range_key(fact.place),
                f"{fact.name} can be {enumeration([interval(*hole) for hole in holes])}, without a name in {enum.name}",
                "correct the range or the list, or set `open: true` on the enum",
                label(enum.place, "name", "the list of values"),
            )
