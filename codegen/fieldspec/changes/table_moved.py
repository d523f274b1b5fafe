"""A table begins at another address.

Why: old programs read and write other records than they mean.

Example: `base: 0x9010` that becomes `base: 0xA010`.

Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named
from fieldspec.changes.spelling import hexadecimal
from fieldspec.model.table import Table


def table_moved(both: Comparison) -> Iterator[Change]:
    for pair in both.of(Table):
        if pair.old.base != pair.new.base:
            old, new = hexadecimal(pair.old.base), hexadecimal(pair.new.base)
            text = f"{named(pair.new)} begins at {new}, and began at {old}"
            yield change("table_moved", Effect.WIRE, pair, "base", text, old, new)
