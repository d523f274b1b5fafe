"""An example has other bytes, or other values, or stands for something else.

Why: nobody is hurt by an example. But where its frame has changed and no fact has, one of the two is wrong.

Example: a `frame` with another check.

Cure: Look whether the manual or the transcription has changed.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named, turned
from fieldspec.model.example import Example

_KEYS = (
    "link",
    "direction",
    "message",
    "error",
    "refused",
    "reply_to",
    "frame",
    "elided",
    "characters",
    "values",
    "origin",
)
_NAMES = {"link": "links", "message": "messages", "reply_to": "examples"}


def example_changed(both: Comparison) -> Iterator[Change]:
    for pair in both.of(Example):
        for key in _KEYS:
            old, new = getattr(pair.old, key), getattr(pair.new, key)
            old = both.renamed_to(_NAMES[key], old) if key in _NAMES else old
            if old != new:
                what = f"the {key.replace('_', ' ')}" if isinstance(new, str | bytes) else key
                text = f"{named(pair.new)}: {turned(what, old, new)}"
                yield change("example_changed", Effect.DOCS, pair, key, text, old, new)
