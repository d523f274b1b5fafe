"""The new version has something that the old one has not.

Why: nobody who does without it is hurt, as long as it takes no place from anything. A field that makes a record
longer, or moves others, breaks every program that knows the old length.

Example: a register at an address that was free.

Cure: Put new fields where reserved ones were. Give the fact a `since`, so that users of the old version know.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison, Lone
from fieldspec.changes.finding import around, kind, named, path, span, within
from fieldspec.changes.nouns import NOUNS
from fieldspec.model.device import Version
from fieldspec.model.enum import Member


def fact_added(both: Comparison) -> Iterator[Change]:
    for lone in both.added:
        item, holder = lone.item, lone.holder[1]
        if isinstance(item, Member):
            continue
        text = f"the {kind(item)} {named(item)}{within(holder)} is new"
        before, after = around(lone.holder[0], "name"), span(item, "name", holder)
        yield Change("fact_added", _effect(lone), kind(item), path(item, holder), text, "", named(item), before, after)


def _effect(lone: Lone) -> Effect:
    if lone.fields is not None and not lone.fields.kept:
        return Effect.WIRE
    if getattr(lone.item, "reserved", False):
        return Effect.DOCS
    if isinstance(lone.item, Version):
        return Effect.BEHAVIOUR if lone.holder[1].builds else Effect.DOCS
    return Effect.BEHAVIOUR if lone.fields is not None else NOUNS[type(lone.item)].adding
