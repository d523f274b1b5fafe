"""Rules about enums and their members."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.language.changes.attributes import ALL, PYTHON, C
from fieldspec.language.changes.change import Change, Effect
from fieldspec.language.changes.comparison import Comparison, Pair, Unpaired, ValuePair
from fieldspec.language.changes.descriptions import change, difference, difference_text, named, unpaired_change
from fieldspec.language.model.device import Device
from fieldspec.language.model.enums import Bit, Enum, Member


def enum_changed(comparison: Comparison) -> Iterator[Change]:
    """The enum of a value was added, removed or replaced.

    Why: if the two enums give a number different names, its meaning differs. Otherwise, only the types of generated
    code change.

    Example: `enum: mode` that becomes `enum: extended_mode`.

    Fix: If the old spec was wrong, accept the change with that reason; otherwise, assign a new version number.
    """

    for value_pair in comparison.values:
        yield from _compare_members(comparison, value_pair, value_pair.old.enum, value_pair.new.enum)
    for pair in comparison.of(Bit):
        yield from _compare_members(comparison, pair, pair.old.enum, pair.new.enum)


def _compare_members(comparison: Comparison, differing: ValuePair | Pair[Bit], old: str, new: str) -> Iterator[Change]:
    before, after = _names(comparison.old, old), _names(comparison.new, new)
    old = comparison.renamed_to("enums", old)
    if old == new:
        return
    differ = any(after[value] != name for value, name in before.items() if value in after)
    lost = bool(after) and any(value not in after for value in before)
    effect = Effect.WIRE if differ or lost else Effect.SOURCE
    yield difference(effect, differing, "enum", "the enum", old, new, ALL)


def _names(device: Device, name: str) -> dict[int, str]:
    enum = device.enums.get(name)
    return {member.value: member.name for member in enum.members} if enum else {}


def member_added(comparison: Comparison) -> Iterator[Change]:
    """An enum has a new member.

    Why: programs receive an unknown value. Generated code of the old version rejects it, or passes it on as a number if
    the enum is open.

    Example: an alarm code that the new firmware has.

    Fix: Nothing to do. If the manual announces more members, write `open: true`.
    """

    for unpaired in comparison.added:
        if isinstance(unpaired.item, Member):
            effect = Effect.DOCS if unpaired.item.unavailable else Effect.BEHAVIOUR
            yield unpaired_change(effect, unpaired, True, *_texts(unpaired, True), "members")


def _texts(unpaired: Unpaired, is_new: bool) -> tuple[str, str]:
    """The message about a member that only one device has, and its value."""
    member, state = unpaired.item, "new" if is_new else "gone"
    text = f"{named(unpaired.containers[is_new])}: {member.name} ({member.value}) is {state}"
    return text, f"{member.value} {member.name}"


def member_removed(comparison: Comparison) -> Iterator[Change]:
    """An enum has lost a member.

    Why: the value has no meaning or a different meaning, and generated code has no name for it.

    Example: a mode that the new firmware does not have.

    Fix: If the device still accepts the value, keep the member with `unavailable: true`. If the old spec was wrong,
    accept the change with that reason; otherwise, assign a new version number.
    """

    for unpaired in comparison.removed:
        if isinstance(unpaired.item, Member):
            effect, outputs = (Effect.DOCS, ()) if unpaired.item.unavailable else (Effect.WIRE, ALL)
            yield unpaired_change(effect, unpaired, False, *_texts(unpaired, False), "members", outputs)


def member_renumbered(comparison: Comparison) -> Iterator[Change]:
    """The value of an enum member has changed.

    Why: existing programs write the wrong member, and misread the members that they receive.

    Example: `{value: 5, name: blue}` that becomes `{value: 6, name: blue}`.

    Fix: If the old spec was wrong, accept the change with that reason; otherwise, assign a new version number.
    """

    for pair in comparison.of(Member):
        old, new = pair.old.value, pair.new.value
        if old != new:
            text = f"{named(pair.containers[1])}: {named(pair.new)} is {new}, and was {old}"
            effect = Effect.DOCS if pair.old.unavailable and pair.new.unavailable else Effect.WIRE
            yield change(effect, pair, "value", text, old, new)


def aliases_changed(comparison: Comparison) -> Iterator[Change]:
    """The aliases of an enum member have changed.

    Why: programs that use a removed name no longer compile. A new alias changes nothing for them.

    Example: `aliases: [red]` that a member loses.

    Fix: Keep the alias, or tell users the name to write.
    """

    for pair in comparison.of(Member):
        old, new = ", ".join(pair.old.aliases), ", ".join(pair.new.aliases)
        if old != new:
            lost = not (pair.old.unavailable or set(pair.old.aliases) <= {pair.new.name, *pair.new.aliases})
            effect = Effect.SOURCE if lost else Effect.DOCS
            subject = f"{named(pair.containers[1])}: {named(pair.new)}"
            text = f"{subject}: {difference_text('what else it is called', old or None, new or None)}"
            yield change(effect, pair, "aliases", text, old, new, (PYTHON, C) if lost else ())


def openness_changed(comparison: Comparison) -> Iterator[Change]:
    """An enum admits values that it does not list, or no longer admits them.

    Why: the type of an open enum also admits numbers, which programs must expect. With a closed enum, generated code
    rejects unlisted values.

    Example: `open: true` at the enum of alarms.

    Fix: Nothing to do if the manual announces more codes.
    """

    for pair in comparison.of(Enum):
        old, new = pair.old.open, pair.new.open
        if old != new:
            text = f"{named(pair.new)} {'passes on' if new else 'refuses'} values that it does not list"
            effect, outputs = (Effect.SOURCE, (PYTHON,)) if new else (Effect.BEHAVIOUR, ())
            yield change(effect, pair, "open", text, old, new, outputs)
