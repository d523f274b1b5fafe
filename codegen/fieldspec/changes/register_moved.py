"""A register lies at another address.

Why: old programs read and write another register than they mean.

Example: `at: 0x2011` that becomes `at: 0x2012`.

Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named
from fieldspec.changes.spelling import hexadecimal
from fieldspec.model.register import Register


def register_moved(both: Comparison) -> Iterator[Change]:
    for pair in both.of(Register):
        if pair.old.address != pair.new.address:
            old, new = hexadecimal(pair.old.address), hexadecimal(pair.new.address)
            text = f"{named(pair.new)} lies at {new}, and lay at {old}"
            yield change("register_moved", Effect.WIRE, pair, "at", text, old, new)
