"""Rules about enums and their members."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.attributes import ALL, PYTHON
from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparison import Comparison, Pair, ValuePair
from fieldspec.changes.descriptions import around, change, difference_text, kind, named, path, span
from fieldspec.model.device import Device
from fieldspec.model.enums import Bit, Enum, Member


def enum_changed(comparison: Comparison) -> Iterator[Change]:
    """ValuePair are named by another enum, or have names where they had none, or none where they had some.

    Why: where the two enums name a value differently, it means something else. Else the types of generated code change.

    Example: `enum: mode` that becomes `enum: extended_mode`.

    Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
    own.
    """

    for value_pair in comparison.values:
        yield from _compared(comparison, value_pair, value_pair.old.enum, value_pair.new.enum)
    for pair in comparison.of(Bit):
        yield from _compared(comparison, pair, pair.old.enum, pair.new.enum)


def _compared(comparison: Comparison, differing: ValuePair | Pair[Bit], old: str, new: str) -> Iterator[Change]:
    before, after = _names(comparison.old, old), _names(comparison.new, new)
    old = comparison.renamed_to("enums", old)
    if old == new:
        return
    differ = any(after[value] != name for value, name in before.items() if value in after)
    lost = bool(after) and any(value not in after for value in before)
    effect = Effect.WIRE if differ or lost else Effect.SOURCE
    fact = differing.of.new if isinstance(differing, ValuePair) else differing.new
    text = f"{named(fact)}: {difference_text('the enum', old, new)}"
    yield change("enum_changed", effect, differing, "enum", text, old, new, ALL)


def _names(device: Device, name: str) -> dict[int, str]:
    enum = device.enums.get(name)
    return {member.value: member.name for member in enum.members} if enum else {}


def member_added(comparison: Comparison) -> Iterator[Change]:
    """An enum has a further member.

    Why: programs that know all members meet one that they do not know; generated code of the old version refuses it, or
    passes it on as a number where the enum is open.

    Example: an alarm code that the new firmware has.

    Cure: Nothing to do. Where more are to be expected, say `open: true`.
    """

    for unpaired in comparison.added:
        if isinstance(unpaired.item, Member):
            old, new = unpaired.containers
            member = unpaired.item
            text = f"{named(new)}: {member.name} ({member.value}) is new"
            yield Change(
                "member_added",
                Effect.DOCS if member.unavailable else Effect.BEHAVIOUR,
                kind(member),
                path(member, new),
                text,
                "",
                f"{member.value} {member.name}",
                around(old, "members"),
                span(member, "name", new),
            )


def member_removed(comparison: Comparison) -> Iterator[Change]:
    """An enum has lost a member.

    Why: the value means nothing any more, or something else, and generated code has no name for it.

    Example: a mode that the new firmware has not.

    Cure: Where the device still takes the value, keep the member with `unavailable: true`. Where the old spec was
    wrong, accept the change with that reason; else give the new version a number of its own.
    """

    for unpaired in comparison.removed:
        if isinstance(unpaired.item, Member):
            old, new = unpaired.containers
            member = unpaired.item
            text = f"{named(new)}: {member.name} ({member.value}) is gone"
            yield Change(
                "member_removed",
                Effect.DOCS if member.unavailable else Effect.WIRE,
                kind(member),
                path(member, old),
                text,
                f"{member.value} {member.name}",
                "",
                span(member, "name", old),
                around(new, "members"),
                () if member.unavailable else ALL,
            )


def member_renumbered(comparison: Comparison) -> Iterator[Change]:
    """A member of an enum has another value.

    Why: old programs write and understand another member than they mean.

    Example: `{value: 5, name: blue}` that becomes `{value: 6, name: blue}`.

    Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
    own.
    """

    for pair in comparison.of(Member):
        old, new = pair.old.value, pair.new.value
        if old != new:
            text = f"{named(pair.containers[1])}: {named(pair.new)} is {new}, and was {old}"
            yield change("member_renumbered", Effect.WIRE, pair, "value", text, old, new)


def openness_changed(comparison: Comparison) -> Iterator[Change]:
    """An enum takes values that it does not list, or no longer takes them.

    Why: where it opens, generated types admit plain numbers that programs must expect. Where it closes, values that it
    does not list are refused.

    Example: `open: true` at the enum of alarms.

    Cure: Nothing to do where new codes are to be expected.
    """

    for pair in comparison.of(Enum):
        old, new = pair.old.open, pair.new.open
        if old != new:
            text = f"{named(pair.new)} {'passes on' if new else 'refuses'} values that it does not list"
            effect, outputs = (Effect.SOURCE, (PYTHON,)) if new else (Effect.BEHAVIOUR, ())
            yield change("openness_changed", effect, pair, "open", text, old, new, outputs)
