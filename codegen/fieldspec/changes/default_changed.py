"""A value is another one as long as nobody sets it.

Why: a device that was set up for the old version, and a record that is filled in part, behave in another way. What
is written into reserved fields are other bytes.

Example: `default: 100` that becomes `default: 50`.

Cure: Tell users to set the value where it matters. Where the old spec was wrong, accept the change with that
reason; else give the new version a number of its own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named, turned


def default_changed(both: Comparison) -> Iterator[Change]:
    for held in both.all_values:
        old, new = held.old.default, held.new.default
        if old != new:
            filling = held.reserved and held.new.const is None and (old or 0) != (new or 0)
            effect = Effect.WIRE if filling else Effect.BEHAVIOUR
            text = f"{named(held.of.new)}: {turned('the default', old, new)}"
            yield change("default_changed", effect, held, "default", text, old, new)
