"""A value may be more numbers than before, a text may be longer, or more records may follow each other.

Why: values come that an old program does not expect, and generated code of the old version refuses them.

Example: `range: 0..100` that becomes `range: 0..200`.

Cure: None is needed.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change
from fieldspec.changes.intervals import bounded, text, without


def range_widened(both: Comparison) -> Iterator[Change]:
    for held in bounded(both):
        gained = without(held.new, held.old)
        if gained.intervals:
            said = f"{held.name}: {held.what} is {text(held.new)}; {text(gained)} is allowed now"
            yield change("range_widened", Effect.BEHAVIOUR, held.pair, held.key, said, text(held.old), text(held.new))
