"""A field, a bit, a parameter or an element of one has lost its meaning, or has got one.

Why: what had a meaning is written as zero and ignored by generated code. What gets one was written as zero so far.

Example: `reserved: true` at a field that the old version used.

Cure: Nothing to do where something gets a meaning. Where the old spec was wrong, accept the change with that
reason; else give the new version a number of its own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named
from fieldspec.changes.nouns import ALL


def reserved_changed(both: Comparison) -> Iterator[Change]:
    for pair in both.turned:
        old, new = pair.old.reserved, pair.new.reserved
        effect, outputs = (Effect.WIRE, ALL) if new else (Effect.BEHAVIOUR, ())
        name = named(pair.old if new else pair.new)
        text = f"{name} is reserved now" if new else f"{name} was reserved, and has a meaning now"
        yield change("reserved_changed", effect, pair, "reserved", text, old, new, outputs)
