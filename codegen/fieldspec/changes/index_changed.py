"""The elements of a register, a table or a parameter are counted in another way.

Why: element 5 is another one than before, with another address.

Example: `index_from: 0` that becomes `index_from: 1`.

Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named, turned
from fieldspec.model.parameter import Subindex
from fieldspec.model.register import Register
from fieldspec.model.table import Table


def index_changed(both: Comparison) -> Iterator[Change]:
    for pair in both.any_of(Register, Table):
        old, new = pair.old.index_from, pair.new.index_from
        if old != new:
            text = f"{named(pair.new)}: {turned('the number of the first element', old, new)}"
            yield change("index_changed", Effect.WIRE, pair, "index_from", text, old, new)
    for inner in both.of(Subindex):
        if inner.old.indices != inner.new.indices:
            text = f"{named(inner.new)}: {turned('the sub-index', inner.old.indices, inner.new.indices)}"
            effect = Effect.DOCS if inner.old.reserved and inner.new.reserved else Effect.WIRE
            yield change("index_changed", effect, inner, "index", text, inner.old.indices, inner.new.indices)
