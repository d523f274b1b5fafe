"""The one value that a field may have is another one.

Why: frames with the old value are refused, and so are those of the old side.

Example: `const: 0x44` that becomes `const: 0x45`.

Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named, turned


def const_changed(both: Comparison) -> Iterator[Change]:
    for held in both.all_values:
        old, new = held.old.const, held.new.const
        if old != new:
            text = f"{named(held.of.new)}: {turned('the constant', old, new)}"
            yield change("const_changed", Effect.WIRE, held, "const", text, old, new)
