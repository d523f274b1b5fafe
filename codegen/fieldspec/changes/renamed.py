"""Something has another name. It is the same thing by the evidence that the message names: nothing else that has
come or gone shares it.

Why: generated names follow the names of the spec, so programs that use the old ones no longer compile or run.

Example: a register `servo` at 0x2011 that is called `servo_on` now.

Cure: Keep the old name, unless the new one is worth the trouble of all users; labels and printed names may change
freely.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, kind, named, within
from fieldspec.changes.nouns import NOUNS


def renamed(both: Comparison) -> Iterator[Change]:
    for found in both.renamed:
        old, new = named(found.pair.old), named(found.pair.new)
        noun = NOUNS[type(found.pair.new)]
        text = (
            f"the {kind(found.pair.new)} {old}{within(found.pair.holder[1])} is called {new}; it has {found.evidence}"
        )
        yield change("renamed", noun.renaming, found.pair, "name", text, old, new, noun.outputs)
