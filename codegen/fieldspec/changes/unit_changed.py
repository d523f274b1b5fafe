"""A quantity is in another unit.

Why: the same number is millimetres where it was pulses.

Example: `unit: pulse` that becomes `unit: mm`.

Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named, turned
from fieldspec.changes.nouns import PYTHON


def unit_changed(both: Comparison) -> Iterator[Change]:
    for held in both.values:
        old, new = held.old.unit, held.new.unit
        if old != new:
            text = f"{named(held.of.new)}: {turned('the unit', old, new)}"
            yield change("unit_changed", Effect.WIRE, held, "unit", text, old, new, (PYTHON,))
