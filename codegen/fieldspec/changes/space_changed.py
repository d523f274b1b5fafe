"""A register, a table or a message belongs to another address space, or a space is another one.

Why: the same address in another space is another register; programs read and write it with the wrong message.

Example: a group of registers with `space: holding_registers` that becomes `space: input_registers`.

Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
own.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison, Pair
from fieldspec.changes.finding import change, named, turned
from fieldspec.model.address_space import AddressSpace
from fieldspec.model.record import Message
from fieldspec.model.registers import Register, Table

_OF_SPACE = (
    ("unit", "what an address holds", Effect.WIRE),
    ("bounds", "the range of its addresses", Effect.BEHAVIOUR),
    ("first_number", "the number of its first address", Effect.DOCS),
)


def space_changed(both: Comparison) -> Iterator[Change]:
    for pair in both.any_of(Register, Table):
        yield from _moved(both, pair, pair.old.space, pair.new.space, "space")
    for message in both.of(Message):
        if message.old.accesses is not None and message.new.accesses is not None:
            yield from _moved(both, message, message.old.accesses.space, message.new.accesses.space, "accesses")
    for space in both.of(AddressSpace):
        for key, what, effect in _OF_SPACE:
            old, new = _space_value(space.old, key), _space_value(space.new, key)
            if old != new:
                text = f"{named(space.new)}: {turned(what, old, new)}"
                yield change("space_changed", effect, space, key, text, old, new)


def _space_value(space: AddressSpace, key: str) -> object:
    value = getattr(space, key)
    return value.text() if key == "bounds" else value


def _moved(both: Comparison, pair: Pair[Any], before: str, after: str, key: str) -> Iterator[Change]:
    old = both.renamed_to("spaces", both.old.space_name(before))
    new = both.new.space_name(after)
    if old != new:
        text = f"{named(pair.new)}: {turned('the address space', old, new)}"
        yield change("space_changed", Effect.WIRE, pair, key, text, old, new)
