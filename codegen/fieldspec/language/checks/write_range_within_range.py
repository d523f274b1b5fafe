"""The `write_range` of a value is part of its `range` and contains its sentinels.

Why: a device returns the written value. A value that can be written but never read is a misprint. A sentinel that
cannot be written contradicts the `write_range`: state a value that is only read as a member of an enum.

Example: a parameter with `range: 0..2, 4` and `write_range: 0..3`.

Fix: Correct one of the ranges, or make the value a member of an enum.
"""

from __future__ import annotations

from fieldspec.language.checks.facts import values
from fieldspec.language.checks.finding import Findings, finding, label, range_key
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_count
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.ranges import Ranges, merged, uncovered
from fieldspec.language.model.value import Value

_HELP = "correct one of them"


def write_range_within_range(device: Device) -> Findings:
    for fact, value in values(device):
        if value.write_ranges is not None and is_count(value.encoding):
            yield from _compare_ranges(fact, value, value.write_ranges)


def _compare_ranges(fact: Fact, value: Value, writable: Ranges) -> Findings:
    read = value.ranges.intervals if value.ranges is not None else ((value.type.low, value.type.high),)
    excess = _beyond(writable, [*read, *value.special_intervals])
    if excess is not None:
        text = f"{excess} can be written to {fact.name}, but is not in its range"
        key = "type" if value.ranges is None else range_key(fact.place)
        yield finding(fact.place, "write_range", text, _HELP, label(fact.place, key, "its permitted values"))
    for sentinel in value.sentinels:
        if uncovered(*sentinel.interval, merged(writable.intervals)):
            text = f"the special value {sentinel.name}, {sentinel.text}, cannot be written to {fact.name}"
            help = "add it to `write_range`, or make it a member of an enum if it is only read"
            yield finding(fact.place, "write_range", text, help, label(fact.place, "sentinels", "the special value"))


def _beyond(writable: Ranges, read: list[tuple[int, int]]) -> int | None:
    """The first number that lies in none of some intervals; None where there is none."""
    known = merged(read)
    return next((holes[0][0] for low, high in writable.intervals if (holes := uncovered(low, high, known))), None)
