"""The old version has something that the new one has not, and nothing shows that it only has another name.

Why: programs that use it read or write nothing, or something else, and generated code has no name for it any more.

Example: a register that the new manual does not list.

Cure: Look whether the new manual has left it out by mistake. Else give it an `until`, and tell users what to use
instead.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison, Lone
from fieldspec.changes.finding import around, kind, named, path, span, within
from fieldspec.changes.nouns import NOUNS, PYTHON, C
from fieldspec.model.device import Version
from fieldspec.model.enum import Member


def fact_removed(both: Comparison) -> Iterator[Change]:
    for lone in both.removed:
        item, holder = lone.item, lone.holder[0]
        if isinstance(item, Member):
            continue
        effect, outputs = _effect(lone)
        text = f"the {kind(item)} {named(item)}{within(holder)} is gone"
        before, after = span(item, "name", holder), around(lone.holder[1], "name")
        yield Change(
            "fact_removed", effect, kind(item), path(item, holder), text, named(item), "", before, after, outputs
        )


def _effect(lone: Lone) -> tuple[Effect, tuple[str, ...]]:
    noun = NOUNS[type(lone.item)]
    if isinstance(lone.item, Version):
        return (Effect.SOURCE, (PYTHON, C)) if lone.holder[0].builds else (Effect.DOCS, ())
    if getattr(lone.item, "reserved", False) and (lone.fields is None or lone.fields.kept):
        return Effect.DOCS, ()
    return noun.removing, noun.outputs
