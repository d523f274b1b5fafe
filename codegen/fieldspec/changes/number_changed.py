"""A parameter, or a set of parameters, has other numbers on the wire.

Why: old programs read and write another parameter than they mean.

Example: `number: 19` that becomes `number: 20`, or another `base` of a set.

Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named, turned
from fieldspec.model.parameter import Parameter, ParameterSet


def number_changed(both: Comparison) -> Iterator[Change]:
    for pair in both.of(Parameter):
        old, new = pair.old.number, pair.new.number
        if old != new:
            effect = Effect.DOCS if pair.old.reserved and pair.new.reserved else Effect.WIRE
            text = f"{named(pair.new)}: {turned('the number', old, new)}"
            yield change("number_changed", effect, pair, "number", text, old, new)
    for held in both.of(ParameterSet):
        space = held.new.name if held.old.space == held.old.name else held.old.space
        for key, what, before, after in (
            ("base", "what is added to its numbers", held.old.base, held.new.base),
            ("space", "the space of its numbers", space, held.new.space),
        ):
            if before != after:
                text = f"{named(held.new)}: {turned(what, before, after)}"
                yield change("number_changed", Effect.WIRE, held, key, text, before, after)
