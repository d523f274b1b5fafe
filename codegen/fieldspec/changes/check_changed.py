"""The check of a frame is computed in another way.

Why: each side refuses the frames of the other.

Example: `algorithm: sum8` that becomes `algorithm: lrc`.

Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named, turned
from fieldspec.model.link import Part


def check_changed(both: Comparison) -> Iterator[Change]:
    for pair in both.of(Part):
        old, new = pair.old.algorithm, pair.new.algorithm
        if old != new:
            text = f"{named(pair.new)}: {turned('the algorithm', old, new)}"
            yield change("check_changed", Effect.WIRE, pair, "algorithm", text, old, new)
