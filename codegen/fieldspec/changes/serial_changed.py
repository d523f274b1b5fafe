"""A serial line has other settings, or another one of them at first.

Why: two sides with different settings do not hear each other.

Example: `default_baud: 9600` that becomes `default_baud: 19200`.

Cure: Tell users what to set their side to.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named, turned
from fieldspec.model.link import Link, Serial

_NONE = Serial((), None, (), (), (), None, ())
_KEYS = ("baud", "default_baud", "data_bits", "parity", "stop_bits", "start_bits")


def serial_changed(both: Comparison) -> Iterator[Change]:
    for pair in both.of(Link):
        before, after = pair.old.serial or _NONE, pair.new.serial or _NONE
        for key in _KEYS:
            old, new = getattr(before, key), getattr(after, key)
            if old != new:
                text = f"{named(pair.new)}: {turned(key.replace('_', ' '), old, new)}"
                yield change("serial_changed", Effect.BEHAVIOUR, pair, "serial", text, old, new)
