"""Rules about bit fields."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.language.changes.attributes import ALL
from fieldspec.language.changes.change import Change, Effect
from fieldspec.language.changes.comparison import Comparison
from fieldspec.language.changes.descriptions import change, changed, named
from fieldspec.language.changes.evidence import bits
from fieldspec.language.model.device import Device
from fieldspec.language.model.enums import Bit, State


def bit_moved(comparison: Comparison) -> Iterator[Change]:
    """A bit, or a group of bits, has a different position in its word.

    Why: existing programs test and set the wrong bits.

    Example: `bit: 4` that becomes `bit: 5`, or `bits: 4..5` that becomes `bits: 4..6`.

    Fix: If the old spec was wrong, accept the change with that reason; otherwise, assign a new version number.
    """

    for pair in comparison.of(Bit):
        if pair.old.number_text != pair.new.number_text:
            old, new = bits(pair.old), bits(pair.new)
            key = "bit" if pair.new.width == 1 else "bits"
            effect = Effect.DOCS if pair.old.reserved and pair.new.reserved else Effect.WIRE
            yield change(effect, pair, key, f"{named(pair.new)} is {new}, and was {old}", old, new)


def flags_changed(comparison: Comparison) -> Iterator[Change]:
    """The bit field of a value was added, removed or replaced.

    Why: if the two bit fields give a bit different names, its meaning differs. Otherwise, only the types of generated
    code change.

    Example: `flags: status` that becomes `flags: extended_status`.

    Fix: If the old spec was wrong, accept the change with that reason; otherwise, assign a new version number.
    """

    for value_pair in comparison.values:
        old, new = comparison.renamed_to("flags", value_pair.old.flags), value_pair.new.flags
        if old == new:
            continue
        before, after = _names(comparison.old, value_pair.old.flags), _names(comparison.new, new)
        lost = bool(before) and bool(after) and not before <= after
        effect = Effect.WIRE if lost else Effect.SOURCE
        yield from changed(effect, value_pair, "flags", "the word of flags", old, new, ALL)


def _names(device: Device, name: str) -> set[tuple[str, str]]:
    flags = device.flags.get(name)
    return {(bit.number_text, bit.name) for bit in flags.bits if not bit.reserved} if flags else set()


def polarity_changed(comparison: Comparison) -> Iterator[Change]:
    """A bit means the opposite.

    Why: the condition that was true when the bit was 1 is now true when it is 0.

    Example: `active: low` at a bit without it.

    Fix: If the old spec was wrong, accept the change with that reason; otherwise, assign a new version number.
    """

    for pair in comparison.of(Bit):
        old, new = pair.old.active, pair.new.active
        yield from changed(Effect.WIRE, pair, "active", "the active level", old, new)


def state_changed(comparison: Comparison) -> Iterator[Change]:
    """A state of the device is shown by different bits.

    Why: programs mistake one state for another.

    Example: `set: [ready]` of the state `running` that becomes `set: [ready, operating]`.

    Fix: If the old spec was wrong, accept the change with that reason; otherwise, assign a new version number.
    """

    for pair in comparison.of(State):
        word = pair.old.place.path.partition("/states/")[0]
        for key, subject in (("set", "what is 1 in it"), ("clear", "what is 0 in it")):
            old = tuple(comparison.renamed_to(word, name) for name in getattr(pair.old, key))
            new = getattr(pair.new, key)
            if sorted(old) != sorted(new):
                yield from changed(Effect.WIRE, pair, key, subject, old, new)


def edge_changed(comparison: Comparison) -> Iterator[Change]:
    """A bit takes effect by its level instead of its edge, by its edge instead of its level, or by a different edge.

    Why: a program that leaves the bit unchanged starts no action, or repeats the action.

    Example: `edge: rising` at a bit without it.

    Fix: Tell users how to set and clear the bit.
    """

    for pair in comparison.of(Bit):
        old, new = pair.old.edge, pair.new.edge
        yield from changed(Effect.BEHAVIOUR, pair, "edge", "the edge that has the effect", old, new)


def reserved_changed(comparison: Comparison) -> Iterator[Change]:
    """A field, a bit, a parameter or an element of a parameter is reserved now, or is no longer reserved.

    Why: generated code writes reserved values as zero, and ignores them when reading. Bits that have a meaning now were
    written as zero before.

    Example: `reserved: true` at a field that the old version used.

    Fix: Nothing to do if the fact is no longer reserved. If the old spec was wrong, accept the change with that reason;
    otherwise, assign a new version number.
    """

    for pair in comparison.reserved_changes:
        old, new = pair.old.reserved, pair.new.reserved
        effect, outputs = (Effect.WIRE, ALL) if new else (Effect.BEHAVIOUR, ())
        name = named(pair.old if new else pair.new)
        text = f"{name} is reserved now" if new else f"{name} was reserved, and has a meaning now"
        yield change(effect, pair, "reserved", text, old, new, outputs)
