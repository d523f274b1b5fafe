"""A signed range that begins at the least value of its type ends at the greatest, and vice versa.

Why: a manual that prints -2147483648 means all values of 32 bits. If the other end is a different number, a
digit is missing.

Example: -2147483648..214748648.

Fix: Correct the other end, and write an erratum. Ranges that end at -1, 0 or 1 and symmetrical ranges are
permitted.
"""

from __future__ import annotations

from fieldspec.language.checks.facts import values
from fieldspec.language.checks.finding import Findings, finding, range_key
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_count, is_signed


def range_ends_match(device: Device) -> Findings:
    for fact, value in values(device):
        if value.ranges is None or not is_signed(value.encoding) or not is_count(value.encoding):
            continue
        low, high = value.ranges.low, value.ranges.high
        extreme = low == value.type.low or high == value.type.high
        passing = low in (value.type.low, -value.type.high) and high == value.type.high
        if extreme and not passing and not -1 <= low <= 1 and not -1 <= high <= 1:
            text = f"the range of {fact.name} is {value.ranges.text()}; {value.type.name} holds"
            text += f" {value.type.low}..{value.type.high}"
            help = "correct the other end, or allow it with a reason"
            yield finding(fact.place, range_key(fact.place), text, help)
