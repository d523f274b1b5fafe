"""A record, the data of a message, or what stands around the data in a frame, has another length.

Why: who waits for the old number of bytes cuts a frame off, or waits for ever; generated code refuses frames of
another length.

Example: a response of 10 bytes that has 12.

Cure: Put new fields where reserved ones were. Where the old spec was wrong, accept the change with that reason; else
give the new version a number of its own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import kind, named, path, span, turned
from fieldspec.model.link import Link


def length_changed(both: Comparison) -> Iterator[Change]:
    for fields in both.fields:
        before, after = fields.sizes
        if before != after:
            old, new = fields.holder
            what = " ".join(word for word in ("the length of the", fields.direction or kind(new), _of(new)) if word)
            text = f"{named(new)}: {turned(what, _said(before), _said(after))}"
            key = fields.direction or "fields"
            where = f"{path(new, None)}/{fields.direction}".rstrip("/")
            places = span(old, key, None), span(new, key, None)
            yield Change("length_changed", Effect.WIRE, kind(new), where, text, _said(before), _said(after), *places)


def _of(holder: object) -> str:
    return "without its data" if isinstance(holder, Link) else ""


def _said(size: tuple[int, bool]) -> str:
    """`10 bytes`, or `2 bytes or more`"""
    number, goes_on = size
    return f"{number} byte{'' if number == 1 else 's'}" + (" or more" if goes_on else "")
