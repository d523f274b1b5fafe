"""Another line of versions gets outputs of its own.

Why: generated modules and headers are named after versions, so programs no longer find those that they use.

Example: `builds: true` that moves from the line `firmware` to the line `hardware`.

Cure: Keep the line that is built, or tell users the new names.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named
from fieldspec.changes.nouns import PYTHON, C
from fieldspec.model.device import VersionLine


def building_changed(both: Comparison) -> Iterator[Change]:
    for pair in both.of(VersionLine):
        old, new = pair.old.builds, pair.new.builds
        if old != new:
            text = f"the versions of {named(pair.new)} {'have' if new else 'no longer have'} outputs of their own"
            yield change("building_changed", Effect.SOURCE, pair, "builds", text, old, new, (PYTHON, C))
