"""The bits of a value are named by another word of flags, or have names where they had none, or none where they had
some.

Why: where the two words name a bit differently, it means something else. Else the types of generated code change.

Example: `flags: status` that becomes `flags: extended_status`.

Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named, turned
from fieldspec.changes.nouns import ALL
from fieldspec.model.device import Device


def flags_changed(both: Comparison) -> Iterator[Change]:
    for held in both.values:
        old, new = both.renamed_to("flags", held.old.flags), held.new.flags
        if old == new:
            continue
        before, after = _names(both.old, held.old.flags), _names(both.new, new)
        lost = bool(before) and bool(after) and not before <= after
        effect = Effect.WIRE if lost else Effect.SOURCE
        text = f"{named(held.of.new)}: {turned('the word of flags', old, new)}"
        yield change("flags_changed", effect, held, "flags", text, old, new, ALL)


def _names(device: Device, name: str) -> set[tuple[int, int, str]]:
    flags = device.flags.get(name)
    return {(bit.first, bit.last, bit.name) for bit in flags.bits if not bit.reserved} if flags else set()
