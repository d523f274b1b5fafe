"""Values are named by another enum, or have names where they had none, or none where they had some.

Why: where the two enums name a value differently, it means something else. Else the types of generated code change.

Example: `enum: mode` that becomes `enum: extended_mode`.

Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison, Pair, Values
from fieldspec.changes.finding import change, named, turned
from fieldspec.changes.nouns import ALL
from fieldspec.model.device import Device
from fieldspec.model.flags import Bit


def enum_changed(both: Comparison) -> Iterator[Change]:
    for held in both.values:
        yield from _compared(both, held, held.old.enum, held.new.enum)
    for pair in both.of(Bit):
        yield from _compared(both, pair, pair.old.enum, pair.new.enum)


def _compared(both: Comparison, held: Values | Pair[Bit], old: str, new: str) -> Iterator[Change]:
    before, after = _names(both.old, old), _names(both.new, new)
    old = both.renamed_to("enums", old)
    if old == new:
        return
    differ = any(after[value] != name for value, name in before.items() if value in after)
    lost = bool(after) and any(value not in after for value in before)
    effect = Effect.WIRE if differ or lost else Effect.SOURCE
    fact = held.of.new if isinstance(held, Values) else held.new
    text = f"{named(fact)}: {turned('the enum', old, new)}"
    yield change("enum_changed", effect, held, "enum", text, old, new, ALL)


def _names(device: Device, name: str) -> dict[int, str]:
    enum = device.enums.get(name)
    return {member.value: member.name for member in enum.members} if enum else {}
