"""A value may be fewer numbers than before, a text may be shorter, or fewer records may follow each other.

Why: what was accepted is refused, by the device or by generated code.

Example: `range: 0..100` that becomes `range: 1..100`.

Cure: Tell users of the lost values.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change
from fieldspec.changes.intervals import bounded, text, without


def range_narrowed(both: Comparison) -> Iterator[Change]:
    for held in bounded(both):
        lost = without(held.old, held.new)
        if lost.intervals:
            said = f"{held.name}: {held.what} is {text(held.new)}; {text(lost)} is not allowed any more"
            yield change("range_narrowed", Effect.BEHAVIOUR, held.pair, held.key, said, text(held.old), text(held.new))
