"""There are more, or fewer, elements of a register, a table, a field or a parameter.

Why: fewer elements leave programs with addresses that mean nothing; a field with more or fewer moves all that
follows it.

Example: `count: 127` of a table that becomes `count: 255`.

Cure: Nothing to do where registers, tables and parameters grow. Where the old spec was wrong, accept the change
with that reason; else give the new version a number of its own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison, Pair
from fieldspec.changes.finding import change, named, turned
from fieldspec.changes.nouns import PYTHON
from fieldspec.model.parameter import Parameter
from fieldspec.model.record import Field
from fieldspec.model.register import Register
from fieldspec.model.table import Table


def count_changed(both: Comparison) -> Iterator[Change]:
    for pair in both.any_of(Register, Table, Parameter):
        yield from _grown(pair, "count", pair.old.count, pair.new.count)
    for parameter in both.of(Parameter):
        yield from _grown(parameter, "elements", parameter.old.elements or 1, parameter.new.elements or 1)
    for field in both.of(Field):
        yield from _in_frame(field)


def _grown(pair: Pair[Register] | Pair[Table] | Pair[Parameter], key: str, old: int, new: int) -> Iterator[Change]:
    if old != new:
        effect = Effect.BEHAVIOUR if new > old else Effect.WIRE
        text = f"{named(pair.new)}: {turned('the number of elements', old, new)}"
        yield change("count_changed", effect, pair, key, text, old, new)


def _in_frame(pair: Pair[Field]) -> Iterator[Change]:
    if (pair.old.repeat is None) != (pair.new.repeat is None):
        goes_on = pair.new.repeat is not None
        text = "goes on to the end of the data" if goes_on else "no longer goes on to the end of the data"
        yield change(
            "count_changed",
            Effect.WIRE,
            pair,
            "repeat",
            f"{named(pair.new)} {text}",
            pair.old.repeat,
            pair.new.repeat,
        )
    elif pair.old.count != pair.new.count:
        same = (pair.old.count or 1) == (pair.new.count or 1)
        effect, outputs = (Effect.SOURCE, (PYTHON,)) if same else (Effect.WIRE, ())
        text = f"{named(pair.new)}: {turned('the number of elements', pair.old.count, pair.new.count)}"
        yield change("count_changed", effect, pair, "count", text, pair.old.count, pair.new.count, outputs)
