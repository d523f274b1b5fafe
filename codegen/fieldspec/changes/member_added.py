"""An enum has a further member.

Why: programs that know all members meet one that they do not know; generated code of the old version refuses it, or
passes it on as a number where the enum is open.

Example: an alarm code that the new firmware has.

Cure: Nothing to do. Where more are to be expected, say `open: true`.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import around, kind, named, path, span
from fieldspec.model.enum import Member


def member_added(both: Comparison) -> Iterator[Change]:
    for lone in both.added:
        if isinstance(lone.item, Member):
            old, new = lone.holder
            member = lone.item
            text = f"{named(new)}: {member.name} ({member.value}) is new"
            yield Change(
                "member_added",
                Effect.DOCS if member.unavailable else Effect.BEHAVIOUR,
                kind(member),
                path(member, new),
                text,
                "",
                f"{member.value} {member.name}",
                around(old, "members"),
                span(member, "name", new),
            )
