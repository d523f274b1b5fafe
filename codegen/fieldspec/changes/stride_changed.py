"""The elements of a register or a table lie at other distances.

Why: all elements but the first lie at other addresses.

Example: `stride: 0x10` that becomes `stride: 0x20`.

Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named, turned
from fieldspec.model.register import Register
from fieldspec.model.table import Table


def stride_changed(both: Comparison) -> Iterator[Change]:
    for pair in both.any_of(Register, Table):
        old, new = pair.old.stride, pair.new.stride
        if old != new and min(pair.old.count, pair.new.count) > 1:
            text = f"{named(pair.new)}: {turned('the distance of its elements in words', old, new)}"
            yield change("stride_changed", Effect.WIRE, pair, "stride", text, old, new)
