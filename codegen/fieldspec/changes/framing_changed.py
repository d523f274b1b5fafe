"""Frames have other marks at their ends, or are written in another way.

Why: neither side finds the frames of the other.

Example: `end: 0D` that becomes `end: 0D 0A`, or `encoding: binary` that becomes `encoding: hex_ascii`.

Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named, turned
from fieldspec.model.link import Link

_KEYS = {"encoding": "the encoding", "start": "the mark at the start", "end": "the mark at the end"}


def framing_changed(both: Comparison) -> Iterator[Change]:
    for pair in both.of(Link):
        for key, what in _KEYS.items():
            old, new = getattr(pair.old, key), getattr(pair.new, key)
            if old != new:
                text = f"{named(pair.new)}: {turned(what, old, new)}"
                yield change("framing_changed", Effect.WIRE, pair, key, text, old, new)
