"""If enum members have a second number and nearly all are sorted by it, then all must be sorted, and no number may
occur twice.

Why: a misprint shows in a table that is sorted by one of its columns.

Example: internal codes 42, 34, 44: the middle one is out of order.

Fix: Correct the number, and write an erratum if the manual prints it that way.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, finding, label, longest_ascent
from fieldspec.language.model.device import Device
from fieldspec.language.model.enums import Enum, Member

_SMALL = 8


def member_numbers_ascending(device: Device) -> Findings:
    for enum in device.enums.values():
        yield from _of_enum(enum, [(member.number, member) for member in enum.members if member.number is not None])


def _of_enum(enum: Enum, rows: list[tuple[int, Member]]) -> Findings:
    first: dict[int, Member] = {}
    for number, member in rows:
        other = first.setdefault(number, member)
        if other is not member:
            text = f"{enum.name} has the number {number} twice, as {other.name} and as {member.name}"
            related_label = label(other.place, "number", other.name)
            yield finding(member.place, "number", text, "correct one of the numbers", related_label)
    ascent = longest_ascent([number for number, _ in rows])
    if (len(rows) - len(ascent)) * _SMALL > len(rows):
        return
    for index, (number, member) in enumerate(rows):
        if index not in ascent:
            last, other = rows[index - 1] if index else rows[1]
            relation = "after" if index else "before"
            text = f"{member.name} has the number {number}, which breaks the order of {enum.name}"
            related_label = label(other.place, "number", f"it is listed {relation} {other.name}, {last}")
            yield finding(member.place, "number", text, "correct the number", related_label)
