"""A bit acts by its level where it acted by its edge, or by another edge.

Why: a program that leaves the bit as it is starts nothing, or starts it again and again.

Example: `edge: rising` at a bit that had none.

Cure: Tell users how the bit has to be set and cleared.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named, turned
from fieldspec.model.flags import Bit


def edge_changed(both: Comparison) -> Iterator[Change]:
    for pair in both.of(Bit):
        old, new = pair.old.edge, pair.new.edge
        if old != new:
            text = f"{named(pair.new)}: {turned('the edge that has the effect', old, new)}"
            yield change("edge_changed", Effect.BEHAVIOUR, pair, "edge", text, old, new)
