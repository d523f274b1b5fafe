"""Every member of an enum is within the range and the type of every field that uses the enum.

Why: if a list of values goes beyond the printed range, one of the two was not updated.

Example: a range of 0..13 with a list of modes up to 16.

Fix: Correct the range, and write an erratum. Members that the manual calls not available may be outside the
range.
"""

from __future__ import annotations

from functools import partial

from fieldspec.foundation.line_text import plural
from fieldspec.language.checks.finding import Findings, enumeration, finding, label, range_key
from fieldspec.language.checks.settled import of_values, of_words
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_exact
from fieldspec.language.model.enums import Flags, Member
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.value import Value


def enum_within_range(device: Device) -> Findings:
    yield from of_values(device, partial(_of_value, device))
    yield from of_words(device, partial(_of_word, device))


def _of_word(device: Device, flags: Flags) -> Findings:
    for bit in flags.bits:
        enum = device.enums.get(bit.enum)
        members = enum.members if enum is not None else ()
        if wide := [member for member in members if not 0 <= member.value < 1 << min(bit.width, 64)]:
            yield _finding(bit, "enum", f"{bit.name}, of {plural(bit.width, 'bit')},", wide)
        elif bit.ranges is not None:
            excluded = [member for member in members if not member.unavailable and member.value not in bit.ranges]
            if excluded:
                yield _finding(bit, range_key(bit.place), bit.name, excluded)


def _of_value(device: Device, fact: Fact, value: Value) -> Findings:
    enum = device.enums.get(value.enum)
    if enum is not None and is_exact(value.encoding):
        excluded = [member for member in enum.members if _excluded(value, member)]
        if excluded:
            key = "type" if value.ranges is None else range_key(fact.place)
            yield _finding(fact, key, fact.name, excluded)


def _excluded(value: Value, member: Member) -> bool:
    if not value.low <= member.value <= value.high:
        return True
    if value.ranges is None or member.unavailable or member.value in value.ranges:
        return False
    return value.sentinel(member.value) is None


def _finding(fact: Fact, key: str, subject: str, members: list[Member]) -> Diagnostic:
    text = f"{subject} cannot hold {enumeration([f'{member.name} ({member.value})' for member in members])}"
    related_label = label(members[0].place, "value", "listed here")
    return finding(fact.place, key, text, "correct the range, the type or the list", related_label)
