"""Rules about addresses of registers and tables, address spaces, and numbers of parameters."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from fieldspec.language.changes.change import Change, Effect
from fieldspec.language.changes.comparison import Comparison, Pair
from fieldspec.language.changes.descriptions import change, changed, difference_text, named
from fieldspec.language.changes.evidence import hexadecimal
from fieldspec.language.model.address_space import AddressSpace
from fieldspec.language.model.record import Message
from fieldspec.language.model.registers import Parameter, ParameterSet, Register, Subindex, Table


def register_moved(comparison: Comparison) -> Iterator[Change]:
    """The address of a register has changed.

    Why: existing programs read and write the wrong register.

    Example: `at: 0x2011` that becomes `at: 0x2012`.

    Fix: If the old spec was wrong, accept the change with that reason; otherwise, assign a new version number.
    """

    for pair in comparison.of(Register):
        if pair.old.address != pair.new.address:
            old, new = hexadecimal(pair.old.address), hexadecimal(pair.new.address)
            text = f"{named(pair.new)} is at {new}, and was at {old}"
            yield change(Effect.WIRE, pair, "at", text, old, new)


def table_moved(comparison: Comparison) -> Iterator[Change]:
    """The base address of a table, or the register that contains it, has changed.

    Why: existing programs read and write the wrong records.

    Example: `base: 0x9010` that becomes `base: 0xA010`.

    Fix: If the old spec was wrong, accept the change with that reason; otherwise, assign a new version number.
    """

    for pair in comparison.of(Table):
        if pair.old.base != pair.new.base:
            old, new = hexadecimal(pair.old.base), hexadecimal(pair.new.base)
            text = f"{named(pair.new)} begins at {new}, and began at {old}"
            yield change(Effect.WIRE, pair, "base", text, old, new)
        old = comparison.renamed_to("registers", pair.old.base_by) if pair.old.base_by else ""
        yield from changed(Effect.WIRE, pair, "base_by", "the register of its address", old, pair.new.base_by)


def stride_changed(comparison: Comparison) -> Iterator[Change]:
    """The distance between the elements of a register or a table has changed.

    Why: all elements after the first have different addresses.

    Example: `stride: 0x10` that becomes `stride: 0x20`.

    Fix: If the old spec was wrong, accept the change with that reason; otherwise, assign a new version number.
    """

    for pair in comparison.any_of(Register, Table):
        old, new = pair.old.stride, pair.new.stride
        if old != new and min(pair.old.count, pair.new.count) > 1:
            yield from changed(Effect.WIRE, pair, "stride", "the distance of its elements in words", old, new)


def index_changed(comparison: Comparison) -> Iterator[Change]:
    """The numbers of the elements of a register, a table or a parameter have changed.

    Why: element 5 is a different element at a different address.

    Example: `index_from: 0` that becomes `index_from: 1`.

    Fix: If the old spec was wrong, accept the change with that reason; otherwise, assign a new version number.
    """

    for pair in comparison.any_of(Register, Table):
        old, new = pair.old.index_from, pair.new.index_from
        yield from changed(Effect.WIRE, pair, "index_from", "the number of the first element", old, new)
    for inner in comparison.of(Subindex):
        if inner.old.indices != inner.new.indices:
            text = f"{named(inner.new)}: {difference_text('the sub-index', inner.old.indices, inner.new.indices)}"
            effect = Effect.DOCS if inner.old.reserved and inner.new.reserved else Effect.WIRE
            yield change(effect, inner, "index", text, inner.old.indices, inner.new.indices)


def number_changed(comparison: Comparison) -> Iterator[Change]:
    """The numbers of a parameter, or of a set of parameters, on the wire have changed.

    Why: existing programs read and write the wrong parameter.

    Example: `number: 19` that becomes `number: 20`, or a different `base` of a set.

    Fix: If the old spec was wrong, accept the change with that reason; otherwise, assign a new version number.
    """

    for pair in comparison.of(Parameter):
        effect = Effect.DOCS if pair.old.reserved and pair.new.reserved else Effect.WIRE
        yield from changed(effect, pair, "number", "the number", pair.old.number, pair.new.number)
    for set_pair in comparison.of(ParameterSet):
        space = set_pair.new.name if set_pair.old.space == set_pair.old.name else set_pair.old.space
        for key, subject, before, after in (
            ("base", "what is added to its numbers", set_pair.old.base, set_pair.new.base),
            ("space", "the space of its numbers", space, set_pair.new.space),
        ):
            yield from changed(Effect.WIRE, set_pair, key, subject, before, after)


_OF_SPACE = (
    ("unit", "the unit of its addresses", Effect.WIRE),
    ("bounds", "the range of its addresses", Effect.BEHAVIOUR),
    ("first_number", "the number of its first address", Effect.DOCS),
)


def space_changed(comparison: Comparison) -> Iterator[Change]:
    """A register, a table or a message belongs to another address space, or the address space itself has changed.

    Why: the same address in a different space is a different register, and needs different messages.

    Example: a group of registers with `space: holding_registers` that becomes `space: input_registers`.

    Fix: If the old spec was wrong, accept the change with that reason; otherwise, assign a new version number.
    """

    for pair in comparison.any_of(Register, Table):
        yield from _moved(comparison, pair, pair.old.space, pair.new.space, "space")
    for message in comparison.of(Message):
        if message.old.single_access is not None and message.new.single_access is not None:
            yield from _moved(
                comparison, message, message.old.single_access.space, message.new.single_access.space, "accesses"
            )
    for space in comparison.of(AddressSpace):
        for key, subject, effect in _OF_SPACE:
            old, new = _space_value(space.old, key), _space_value(space.new, key)
            yield from changed(effect, space, key, subject, old, new)


def _space_value(space: AddressSpace, key: str) -> object:
    value = getattr(space, key)
    return value.text() if key == "bounds" else value


def _moved(comparison: Comparison, pair: Pair[Any], before: str, after: str, key: str) -> Iterator[Change]:
    old = comparison.renamed_to("spaces", comparison.old.space_name(before))
    new = comparison.new.space_name(after)
    yield from changed(Effect.WIRE, pair, key, "the address space", old, new)
