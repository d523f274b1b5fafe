"""Rules about addresses of registers and tables, and numbers of parameters."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.evidence import hexadecimal
from fieldspec.changes.finding import change, named, turned
from fieldspec.model.registers import Parameter, ParameterSet, Register, Subindex, Table


def register_moved(both: Comparison) -> Iterator[Change]:
    """A register lies at another address.

    Why: old programs read and write another register than they mean.

    Example: `at: 0x2011` that becomes `at: 0x2012`.

    Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
    own.
    """

    for pair in both.of(Register):
        if pair.old.address != pair.new.address:
            old, new = hexadecimal(pair.old.address), hexadecimal(pair.new.address)
            text = f"{named(pair.new)} lies at {new}, and lay at {old}"
            yield change("register_moved", Effect.WIRE, pair, "at", text, old, new)


def table_moved(both: Comparison) -> Iterator[Change]:
    """A table begins at another address.

    Why: old programs read and write other records than they mean.

    Example: `base: 0x9010` that becomes `base: 0xA010`.

    Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
    own.
    """

    for pair in both.of(Table):
        if pair.old.base != pair.new.base:
            old, new = hexadecimal(pair.old.base), hexadecimal(pair.new.base)
            text = f"{named(pair.new)} begins at {new}, and began at {old}"
            yield change("table_moved", Effect.WIRE, pair, "base", text, old, new)


def stride_changed(both: Comparison) -> Iterator[Change]:
    """The elements of a register or a table lie at other distances.

    Why: all elements but the first lie at other addresses.

    Example: `stride: 0x10` that becomes `stride: 0x20`.

    Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
    own.
    """

    for pair in both.any_of(Register, Table):
        old, new = pair.old.stride, pair.new.stride
        if old != new and min(pair.old.count, pair.new.count) > 1:
            text = f"{named(pair.new)}: {turned('the distance of its elements in words', old, new)}"
            yield change("stride_changed", Effect.WIRE, pair, "stride", text, old, new)


def index_changed(both: Comparison) -> Iterator[Change]:
    """The elements of a register, a table or a parameter are counted in another way.

    Why: element 5 is another one than before, with another address.

    Example: `index_from: 0` that becomes `index_from: 1`.

    Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
    own.
    """

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


def number_changed(both: Comparison) -> Iterator[Change]:
    """A parameter, or a set of parameters, has other numbers on the wire.

    Why: old programs read and write another parameter than they mean.

    Example: `number: 19` that becomes `number: 20`, or another `base` of a set.

    Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
    own.
    """

    for pair in both.of(Parameter):
        old, new = pair.old.number, pair.new.number
        if old != new:
            effect = Effect.DOCS if pair.old.reserved and pair.new.reserved else Effect.WIRE
            text = f"{named(pair.new)}: {turned('the number', old, new)}"
            yield change("number_changed", effect, pair, "number", text, old, new)
    for held in both.of(ParameterSet):
        space = held.new.name if held.old.space == held.old.name else held.old.space
        for key, what, before, after in (
            ("base", "what is added to its numbers", held.old.base, held.new.base),
            ("space", "the space of its numbers", space, held.new.space),
        ):
            if before != after:
                text = f"{named(held.new)}: {turned(what, before, after)}"
                yield change("number_changed", Effect.WIRE, held, key, text, before, after)
