"""No two members of an enum have the same value.

Why: if a value has two names, its meaning is unknown.

Example: 3 for homing and 3 for preset_position.

Fix: Correct one of the values, and write an erratum if the manual prints it that way. If the value has two names, keep
the member with the preferred name, and list the other name under its `aliases`.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.enums import Member


def enum_values_unique(device: Device) -> Findings:
    for enum in device.enums.values():
        first: dict[int, Member] = {}
        for member in enum.members:
            other = first.setdefault(member.value, member)
            if other is not member:
                yield finding(
                    member.place,
                    "value",
                    f"{enum.name} has the value {member.value} twice, as {other.name} and as {member.name}",
                    "correct one of the values, or list the second name under `aliases` of the first member",
                    label(other.place, "value", f"{other.name}"),
                )
