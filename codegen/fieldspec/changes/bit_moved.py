"""A bit, or a field of bits, lies elsewhere in its word.

Why: old programs test and set other bits than they mean.

Example: `bit: 4` that becomes `bit: 5`, or `bits: 4..5` that becomes `bits: 4..6`.

Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.evidence import bits
from fieldspec.changes.finding import change, named
from fieldspec.model.flags import Bit


def bit_moved(both: Comparison) -> Iterator[Change]:
    for pair in both.of(Bit):
        if (pair.old.first, pair.old.last) != (pair.new.first, pair.new.last):
            old, new = bits(pair.old), bits(pair.new)
            key = "bit" if pair.new.width == 1 else "bits"
            effect = Effect.DOCS if pair.old.reserved and pair.new.reserved else Effect.WIRE
            yield change("bit_moved", effect, pair, key, f"{named(pair.new)} is {new}, and was {old}", old, new)
