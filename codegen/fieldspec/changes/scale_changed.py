"""One count is worth something else.

Why: the same number on the wire is ten times the distance, or a tenth of it.

Example: `scale: 0.01` that becomes `scale: 0.001`.

Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named, turned


def scale_changed(both: Comparison) -> Iterator[Change]:
    for held in both.values:
        for key, old, new in (
            ("scale", held.old.scale, held.new.scale),
            ("offset", held.old.offset, held.new.offset),
        ):
            if old != new:
                text = f"{named(held.of.new)}: {turned('the ' + key, old, new)}"
                yield change("scale_changed", Effect.WIRE, held, key, text, old, new)
