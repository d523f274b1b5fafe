"""A bit shows the opposite.

Why: what was so when the bit was 1 is so when it is 0.

Example: `active: low` at a bit that had none.

Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named, turned
from fieldspec.model.flags import Bit


def polarity_changed(both: Comparison) -> Iterator[Change]:
    for pair in both.of(Bit):
        old, new = pair.old.active, pair.new.active
        if old != new:
            text = f"{named(pair.new)}: {turned('the active level', old, new)}"
            yield change("polarity_changed", Effect.WIRE, pair, "active", text, old, new)
