"""A parameter exists for other kinds of motor, axis or model, or has an effect with other messages.

Why: a program that sets it may have to ask first what it is connected to.

Example: `applies_to: [rotary]` that becomes `applies_to: [rotary, linear]`.

Cure: Nothing to do where the list grows; else tell users which devices no longer have the parameter.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named, turned
from fieldspec.model.parameter import Parameter


def applicability_changed(both: Comparison) -> Iterator[Change]:
    for pair in both.of(Parameter):
        for key, what in (("applies_to", "what it exists for"), ("messages", "what it has an effect with")):
            old, new = getattr(pair.old, key), getattr(pair.new, key)
            if key == "messages":
                old = tuple(both.renamed_to(key, name) for name in old)
            if old != new:
                text = f"{named(pair.new)}: {turned(what, old, new)}"
                yield change("applicability_changed", Effect.BEHAVIOUR, pair, key, text, old, new)
