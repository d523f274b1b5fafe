"""An enum has lost a member.

Why: the value means nothing any more, or something else, and generated code has no name for it.

Example: a mode that the new firmware has not.

Cure: Where the device still takes the value, keep the member with `unavailable: true`. Where the old spec was
wrong, accept the change with that reason; else give the new version a number of its own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import around, kind, named, path, span
from fieldspec.changes.nouns import ALL
from fieldspec.model.enum import Member


def member_removed(both: Comparison) -> Iterator[Change]:
    for lone in both.removed:
        if isinstance(lone.item, Member):
            old, new = lone.holder
            member = lone.item
            text = f"{named(new)}: {member.name} ({member.value}) is gone"
            yield Change(
                "member_removed",
                Effect.DOCS if member.unavailable else Effect.WIRE,
                kind(member),
                path(member, old),
                text,
                f"{member.value} {member.name}",
                "",
                span(member, "name", old),
                around(new, "members"),
                () if member.unavailable else ALL,
            )
