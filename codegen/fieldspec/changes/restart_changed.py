"""A change of a value takes effect after a restart, or no longer needs one.

Why: a program that sets the value and goes on works with the old one.

Example: `restart: true` at a parameter that took effect at once.

Cure: Tell users when to restart the device.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named, turned
from fieldspec.model.parameter import Parameter
from fieldspec.model.record import Field
from fieldspec.model.register import Register


def restart_changed(both: Comparison) -> Iterator[Change]:
    for pair in both.any_of(Register, Field, Parameter):
        old, new = pair.old.restart, pair.new.restart
        if old != new:
            text = f"{named(pair.new)}: {turned('whether a restart is needed', old, new)}"
            yield change("restart_changed", Effect.BEHAVIOUR, pair, "restart", text, old, new)
