"""A state of the device is shown by other bits.

Why: programs take one state for another.

Example: `set: [ready]` of the state `running` that becomes `set: [ready, operating]`.

Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named, turned
from fieldspec.model.flags import State


def state_changed(both: Comparison) -> Iterator[Change]:
    for pair in both.of(State):
        word = pair.old.place.path.partition("/states/")[0]
        for key, what in (("set", "what is 1 in it"), ("clear", "what is 0 in it")):
            old = tuple(both.renamed_to(word, name) for name in getattr(pair.old, key))
            new = getattr(pair.new, key)
            if sorted(old) != sorted(new):
                text = f"{named(pair.new)}: {turned(what, old, new)}"
                yield change("state_changed", Effect.WIRE, pair, key, text, old, new)
