"""All values between the lowest and the highest member of an enum are members or are declared as `gaps`.

Why: a gap in a list often shows that a row was lost, in the manual or in the transcription. Codes in blocks, for
example alarm codes, are checked if they span at most 64 values. Masks of single bits and lists derived from another
list are not checked.

Example: alarms 0 to 15 and 17.

Fix: Transcribe the missing row, or declare the gap: `gaps: "16: the list goes from 15 to 17"`. Write an erratum if the
manual should have the row. If the numbers are intentionally not consecutive, write `sparse: true` instead.
"""

from __future__ import annotations

import re

from fieldspec.language.checks.finding import Findings, enumeration, finding, interval, label, missing
from fieldspec.language.model.device import Device
from fieldspec.language.model.enums import Enum
from fieldspec.language.model.ranges import Ranges

_WIDEST_BLOCK = 64
_FEWEST_MASKS = 4
_INTERVAL = re.compile(r"(-?(?:0x[0-9A-Fa-f]+|[0-9]+))(?:\.\.(-?(?:0x[0-9A-Fa-f]+|[0-9]+)))?")


def enum_contiguous(device: Device) -> Findings:
    for enum in device.enums.values():
        values = [member.value for member in enum.members]
        if not values or enum.derived:
            continue
        if enum.sparse:
            if enum.gaps:
                text = f"{enum.name} is sparse, so it has no list of gaps"
                yield finding(enum.place, "gaps", text, "remove `gaps`, or `sparse`")
            continue
        declared = _declared(enum)
        if declared is None:
            text = f"`{enum.gaps.partition(':')[0]}` is not a list of values"
            yield finding(enum.place, "gaps", text, "write it like `16, 20..23: the reason`")
            continue
        span = Ranges(((min(values), max(values)),))
        for low, high in declared:
            if low > high or low < span.low or high > span.high or any(low <= value <= high for value in values):
                text = f"the gap {interval(low, high)} of {enum.name} contains a member, or is outside the list"
                yield finding(enum.place, "gaps", text, "name the values that are missing from the list")
                break
        if _are_masks(values):
            continue
        if enum.kind == "enum" or span.high - span.low < _WIDEST_BLOCK or declared:
            yield from _holes(enum, span, values, declared)


def _are_masks(values: list[int]) -> bool:
    """Whether each value but 0 has one bit, and there are enough of them to be no accident."""
    bits = [value for value in values if value]
    return len(bits) >= _FEWEST_MASKS and all(value > 0 and value & (value - 1) == 0 for value in bits)


def _holes(enum: Enum, span: Ranges, values: list[int], declared: tuple[tuple[int, int], ...]) -> Findings:
    left = [hole for hole in missing(span, values) if not _covered(hole, declared)]
    if left:
        next_member = min((m for m in enum.members if m.value > left[0][1]), key=lambda member: member.value)
        yield finding(
            enum.place,
            "gaps" if enum.gaps else "name",
            f"{enum.name} does not list {enumeration([interval(*hole) for hole in left])}",
            "transcribe the missing members, declare the values under `gaps` with a reason, or write `sparse: true`",
            label(next_member.place, "value", f"the next value is {next_member.value}"),
        )


def _covered(hole: tuple[int, int], declared: tuple[tuple[int, int], ...]) -> bool:
    """Whether declared gaps fill a hole; those that touch each other count as one."""
    next_value = hole[0]
    for low, high in sorted(declared):
        if low <= next_value <= high:
            next_value = high + 1
    return next_value > hole[1]


def _declared(enum: Enum) -> tuple[tuple[int, int], ...] | None:
    """The values before the colon of `gaps`, or None where they cannot be read."""
    gaps = []
    for part in enum.gaps.partition(":")[0].split(",") if enum.gaps else ():
        match = _INTERVAL.fullmatch(part.strip())
        if match is None:
            return None
        gaps.append((_parsed_number(match[1]), _parsed_number(match[2] or match[1])))
    return tuple(gaps)


def _parsed_number(text: str) -> int:
    return int(text, 16) if "x" in text else int(text)
