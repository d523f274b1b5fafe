"""A timing, a maximum, a supply is another one.

Why: a machine that was built for the old number may be too fast, too slow or too weak.

Example: `value: 5` of a reply time in ms that becomes `value: 20`.

Cure: Tell users of the old number.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named, turned
from fieldspec.model.limit import Limit

_KEYS = {
    "kind": ("kind", "the kind"),
    "value": ("value", "the value"),
    "low": ("min", "the least"),
    "high": ("max", "the most"),
    "text": ("text", "the text"),
    "unit": ("unit", "the unit"),
}


def limit_changed(both: Comparison) -> Iterator[Change]:
    for pair in both.of(Limit):
        for attribute, (key, what) in _KEYS.items():
            old, new = getattr(pair.old, attribute), getattr(pair.new, attribute)
            if old != new:
                effect = Effect.DOCS if attribute == "kind" else Effect.BEHAVIOUR
                text = f"{named(pair.new)}: {turned(what, old, new)}"
                yield change("limit_changed", effect, pair, key, text, old, new)
