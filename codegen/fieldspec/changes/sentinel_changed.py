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
    old, new = ({(one.value, one.text): one.name for one in value.sentinels} for value in (held.old, held.new))
    for key in sorted(old.keys() | new.keys()):
        count, value = key
        if key not in new:
            text = f"{name}: {value} no longer stands for {old[key]}"
            yield _change(held, Effect.WIRE, text, f"{value} {old[key]}", "")
        elif key not in old:
            effect = Effect.WIRE if _possible(held.old, count) else Effect.BEHAVIOUR
            yield _change(held, effect, f"{name}: {value} stands for {new[key]}", "", f"{value} {new[key]}")
        elif old[key] != new[key]:
            text = f"{name}: {value} is called {new[key]}, and was called {old[key]}"
            yield _change(held, Effect.SOURCE, text, f"{value} {old[key]}", f"{value} {new[key]}", (PYTHON,))


def _possible(value: Value, count: int) -> bool:
    """Whether a count was a quantity."""
    return value.ranges is None or count in value.ranges


def _change(held: Values, effect: Effect, text: str, old: str, new: str, outputs: tuple[str, ...] = ()) -> Change:
    return change("sentinel_changed", effect, held, "sentinels", text, old, new, outputs)
