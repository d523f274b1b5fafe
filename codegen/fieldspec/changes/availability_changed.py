"""A member of an enum has become not available, or available.

Why: generated code has no name for a value that is not available, so programs that use the name no longer compile
or run.

Example: `unavailable: true` at a mode that the old version had.

Cure: Tell users what to use instead. A member that becomes available hurts nobody.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named
from fieldspec.changes.nouns import ALL
from fieldspec.model.enum import Member


def availability_changed(both: Comparison) -> Iterator[Change]:
    for pair in both.of(Member):
        old, new = pair.old.unavailable, pair.new.unavailable
        if old != new:
            effect, outputs = (Effect.SOURCE, ALL) if new else (Effect.BEHAVIOUR, ())
            text = f"{named(pair.new)} ({pair.new.value}) is {'not available any more' if new else 'available now'}"
            yield change("availability_changed", effect, pair, "unavailable", text, not old, not new, outputs)
