"""An enum takes values that it does not list, or no longer takes them.

Why: where it opens, generated types admit plain numbers that programs must expect. Where it closes, values that it
does not list are refused.

Example: `open: true` at the enum of alarms.

Cure: Nothing to do where new codes are to be expected.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named
from fieldspec.changes.nouns import PYTHON
from fieldspec.model.enum import Enum


def openness_changed(both: Comparison) -> Iterator[Change]:
    for pair in both.of(Enum):
        old, new = pair.old.open, pair.new.open
        if old != new:
            text = f"{named(pair.new)} {'passes on' if new else 'refuses'} values that it does not list"
            effect, outputs = (Effect.SOURCE, (PYTHON,)) if new else (Effect.BEHAVIOUR, ())
            yield change("openness_changed", effect, pair, "open", text, old, new, outputs)
