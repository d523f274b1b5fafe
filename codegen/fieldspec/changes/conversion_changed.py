"""A count stands for another share of its reference.

Why: the same count is another speed, torque or distance.

Example: `full_scale: 0x4000` that becomes `full_scale: 0x40000000`.

Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named, turned
from fieldspec.model.signal import Conversion


def conversion_changed(both: Comparison) -> Iterator[Change]:
    for pair in both.of(Conversion):
        paths = tuple(map(both.renamed_path, pair.old.references))
        renamed = tuple(both.renamed_to("signals", name) for name in pair.old.signals)
        for key, what, old, new in (
            ("full_scale", "the full scale", pair.old.full_scale, pair.new.full_scale),
            ("complement", "taking away from the reference", pair.old.complement, pair.new.complement),
            ("type", "the type of the count", pair.old.type.name, pair.new.type.name),
            ("signals", "what it holds for", renamed, pair.new.signals),
            ("references", "what holds the reference", paths, pair.new.references),
        ):
            if old != new:
                text = f"{named(pair.new)}: {turned(what, old, new)}"
                yield change("conversion_changed", Effect.WIRE, pair, key, text, old, new)
