"""Frames are separated by another silence.

Why: a program that waits for too short a time sends two frames that the device takes for one.

Example: `silence: {characters: 3.5}` that becomes `silence: {milliseconds: 50}`.

Cure: Tell users how long to wait.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named, turned
from fieldspec.model.link import Link


def timing_changed(both: Comparison) -> Iterator[Change]:
    for pair in both.of(Link):
        for key, unit in (("silence_characters", "characters"), ("silence_milliseconds", "milliseconds")):
            old, new = getattr(pair.old, key), getattr(pair.new, key)
            if old != new:
                text = f"{named(pair.new)}: {turned('the silence between frames in ' + unit, old, new)}"
                yield change("timing_changed", Effect.BEHAVIOUR, pair, "silence", text, old, new)
