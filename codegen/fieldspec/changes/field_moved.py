"""Fields of a record or a message, or parts of a frame, lie elsewhere among the others.

Why: bytes that were one field are another one.

Example: a field that is put before all others, or two that change places.

Cure: Put new fields behind the others, or where reserved ones were. Where the old spec was wrong, accept the change
with that reason; else give the new version a number of its own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import kind, named, path, span
from fieldspec.changes.spelling import listed


def field_moved(both: Comparison) -> Iterator[Change]:
    for fields in both.fields:
        if fields.moved:
            first, now, before, after = fields.moved[0]
            names = listed([named(new) for _, new, _, _ in fields.moved])
            holder = fields.holder[1]
            text = f"{named(now)} lies at offset {after}, and lay at {before}"
            if len(fields.moved) > 1:
                text = f"{names} lie elsewhere; {text}"
            text = f"{named(holder)}: {text}"
            yield Change(
                "field_moved",
                Effect.WIRE,
                kind(now),
                path(now, holder),
                text,
                f"offset {before}",
                f"offset {after}",
                span(first, "name", fields.holder[0]),
                span(now, "name", holder),
            )
