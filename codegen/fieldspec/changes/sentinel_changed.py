"""A value that stands for something else than a quantity has come, has gone, or is another one.

Why: 0xFFFF that meant `ignore` is a distance now, or a distance means `ignore`.

Example: `sentinels: [{value: 0xFFFF, name: ignored}]` that loses its only member.

Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison, Values
from fieldspec.changes.finding import change, named
from fieldspec.changes.nouns import PYTHON
from fieldspec.model.value import Value


def sentinel_changed(both: Comparison) -> Iterator[Change]:
    for held in both.values:
        if held.old.sentinels != held.new.sentinels:
            yield from _compared(held)


def _compared(held: Values) -> Iterator[Change]:
    name = named(held.of.new)
    old, new = ({one.value: one.name for one in value.sentinels} for value in (held.old, held.new))
    for value in sorted(old.keys() | new.keys()):
        if value not in new:
            text = f"{name}: {value} no longer stands for {old[value]}"
            yield _change(held, Effect.WIRE, text, f"{value} {old[value]}", "")
        elif value not in old:
            effect = Effect.WIRE if _possible(held.old, value) else Effect.BEHAVIOUR
            yield _change(held, effect, f"{name}: {value} stands for {new[value]}", "", f"{value} {new[value]}")
        elif old[value] != new[value]:
            text = f"{name}: {value} is called {new[value]}, and was called {old[value]}"
            yield _change(held, Effect.SOURCE, text, f"{value} {old[value]}", f"{value} {new[value]}", (PYTHON,))


def _possible(value: Value, count: int) -> bool:
    """Whether a count was a quantity."""
    return value.ranges is None or count in value.ranges


def _change(held: Values, effect: Effect, text: str, old: str, new: str, outputs: tuple[str, ...] = ()) -> Change:
    return change("sentinel_changed", effect, held, "sentinels", text, old, new, outputs)
