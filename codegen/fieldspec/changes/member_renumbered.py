"""A member of an enum has another value.

Why: old programs write and understand another member than they mean.

Example: `{value: 5, name: blue}` that becomes `{value: 6, name: blue}`.

Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named
from fieldspec.model.enum import Member


def member_renumbered(both: Comparison) -> Iterator[Change]:
    for pair in both.of(Member):
        old, new = pair.old.value, pair.new.value
        if old != new:
            text = f"{named(pair.holder[1])}: {named(pair.new)} is {new}, and was {old}"
            yield change("member_renumbered", Effect.WIRE, pair, "value", text, old, new)
