"""A register has to be read or written in another way: in one request or not, as a trigger or not.

Why: a program that reads a value in two requests gets halves of two values; one that reads back a trigger gets
nothing.

Example: `atomic: true` at a register that did not have it.

Cure: Tell users how to access the register.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named
from fieldspec.model.register import Register

_SAID = {
    ("atomic", True): "must be accessed in one request",
    ("atomic", False): "may be accessed in several requests",
    ("trigger", True): "starts an action when it is written",
    ("trigger", False): "no longer starts an action when it is written",
}


def handling_changed(both: Comparison) -> Iterator[Change]:
    for pair in both.of(Register):
        for key in ("atomic", "trigger"):
            old, new = getattr(pair.old, key), getattr(pair.new, key)
            if old != new:
                text = f"{named(pair.new)} {_SAID[key, new]}"
                yield change("handling_changed", Effect.BEHAVIOUR, pair, key, text, old, new)
