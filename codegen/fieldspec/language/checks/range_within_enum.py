"""The range of a field is not wider than its closed enum.

Why: a value that is in the range and not in the enum has no meaning. Either a member is missing, or the range
is too wide, or the enum is open.

Example: a range of 0..12 and an enum with the values 0 to 11.

Fix: Transcribe the missing member, correct the range and write an erratum, or set `open: true` on the enum
if values without a name can occur.
"""

from __future__ import annotations

from fieldspec.language.checks.facts import values
from fieldspec.language.checks.finding import Findings, enumeration, finding, interval, label, range_key
from fieldspec.language.model.device import Device
from fieldspec.language.model.ranges import merged, uncovered


def range_within_enum(device: Device) -> Findings:
    for fact, value in values(device):
        enum = device.enums.get(value.enum)
        if enum is None or enum.open or value.ranges is None:
            continue
        members = ((member.value, member.value) for member in enum.members)
        known = merged([*members, *value.special_intervals])
        holes = [hole for low, high in sorted(value.ranges.intervals) for hole in uncovered(low, high, known)]
        if holes:
            yield finding(
                fact.place,
                range_key(fact.place),
                f"{fact.name} can be {enumeration([interval(*hole) for hole in holes])}, without a name in {enum.name}",
                "correct the range or the list, or set `open: true` on the enum",
                label(enum.place, "name", "the list of values"),
            )
