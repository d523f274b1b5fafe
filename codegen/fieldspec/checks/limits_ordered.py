"""The least of a limit is not more than the most, and its value lies between them.

Why: a time of at least 400 ms and at most 200 ms cannot be kept; two columns were exchanged, or a digit
is wrong.

Example: `{min: 400, max: 200, unit: ms}`.

Cure: Put one of them right, and write an erratum if it is printed so.
"""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal
from itertools import pairwise

from fieldspec.checks.finding import finding, label
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device


def limits_ordered(device: Device) -> Iterator[Diagnostic]:
    for limit in device.limits:
        rising = [
            (key, number) for key, number in _limit_text(limit.low, limit.value, limit.high) if number is not None
        ]
        for (before, less), (behind, more) in pairwise(rising):
            if less > more:
                text = f"{limit.name} has the {before} {less} and the {behind} {more}"
                there = label(limit.place, before, f"the {before}")
                yield finding("limits_ordered", limit.place, behind, text, "put one of them right", there)


def _limit_text(
    low: Decimal | None, value: Decimal | None, high: Decimal | None
) -> tuple[tuple[str, Decimal | None], ...]:
    return ("min", low), ("value", value), ("max", high)
