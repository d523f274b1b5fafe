"""A limit has a number or a text. Its minimum is not greater than its maximum, and its value is between them.

Why: no time is both at least 400 ms and at most 200 ms. Two columns are swapped, or a digit is wrong. A limit without
a number and a text limits nothing.

Example: `{min: 400, max: 200, unit: ms}`, or `{name: timeout, unit: ms}`.

Fix: Correct one of them, or state the number, and write an erratum if the manual prints it that way.
"""

from __future__ import annotations

from decimal import Decimal
from itertools import pairwise

from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device


def limits_ordered(device: Device) -> Findings:
    for limit in device.limits:
        rising = [
            (key, number) for key, number in _limit_text(limit.low, limit.value, limit.high) if number is not None
        ]
        if not rising and not limit.text:
            text = f"{limit.name} has neither a number nor a text"
            yield finding(limit.place, "name", text, "state `value`, `min`, `max` or `text`")
        for (before, less), (next_key, next_number) in pairwise(rising):
            if less > next_number:
                text = f"{limit.name} has the {before} {less} and the {next_key} {next_number}"
                related_label = label(limit.place, before, f"the {before}")
                yield finding(limit.place, next_key, text, "correct one of them", related_label)


def _limit_text(
    low: Decimal | None, value: Decimal | None, high: Decimal | None
) -> tuple[tuple[str, Decimal | None], ...]:
    return ("min", low), ("value", value), ("max", high)
