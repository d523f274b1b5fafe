"""Rules about facts that are added, removed, renamed or described differently."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from fieldspec.language.changes.attributes import ALL, CONSEQUENCES, PYTHON, TEXTS, C
from fieldspec.language.changes.change import Change, Effect
from fieldspec.language.changes.comparison import Comparison, Pair, Unpaired
from fieldspec.language.changes.descriptions import change, changed, kind, named, unpaired_change, within
from fieldspec.language.changes.evidence import enumeration, value_text
from fieldspec.language.model.address_space import AddressSpace
from fieldspec.language.model.device import Device, Version
from fieldspec.language.model.enums import Bit, Member
from fieldspec.language.model.link import Part
from fieldspec.language.model.record import Field
from fieldspec.language.model.registers import Parameter
from fieldspec.language.model.texts import Example


def device_added(device: Device) -> Change:
    """The change that a device is new."""
    text = f"the device {device.id} is new"
    return Change(
        Effect.BEHAVIOUR, "device", device.id, text, "", device.name, None, device.place["id"], rule="fact_added"
    )


def device_removed(device: Device) -> Change:
    """The change that a device is gone, with everything that is generated for it."""
    text = f"the device {device.id} is gone"
    place = device.place["id"]
    return Change(Effect.SOURCE, "device", device.id, text, device.name, "", place, None, ALL, rule="fact_removed")


def fact_added(comparison: Comparison) -> Iterator[Change]:
    """A fact exists only in the new version.

    Why: programs that do not use the fact keep working, as long as no other fact moves. A field that makes a record
    longer, or moves other fields, breaks every program that expects the old length.

    Example: a register at an address that was free.

    Fix: Put new fields in the place of reserved ones. Give the fact a `since`, so that users of the old version are
    warned.
    """

    for unpaired in comparison.added:
        item, container = unpaired.item, unpaired.containers[1]
        if isinstance(item, Member):
            continue
        text = f"the {kind(item)} {named(item)}{within(container)} is new"
        yield unpaired_change(_effect(unpaired), unpaired, True, text, named(item), "name")


def _effect(unpaired: Unpaired) -> Effect:
    if unpaired.fields is not None and not unpaired.fields.offsets_equal:
        return Effect.WIRE
    if getattr(unpaired.item, "reserved", False):
        return Effect.DOCS
    if isinstance(unpaired.item, Version):
        return Effect.BEHAVIOUR if unpaired.containers[1].builds else Effect.DOCS
    return Effect.BEHAVIOUR if unpaired.fields is not None else CONSEQUENCES[type(unpaired.item)].adding


def fact_removed(comparison: Comparison) -> Iterator[Change]:
    """A fact exists only in the old version, without evidence that only its name has changed.

    Why: programs that use the fact access nothing, or different data, and generated code no longer contains its name.

    Example: a register that the new manual does not list.

    Fix: Find out whether the new manual omits it by mistake. If not, give it an `until`, and tell users the
    alternative.
    """

    for unpaired in comparison.removed:
        item, container = unpaired.item, unpaired.containers[0]
        if isinstance(item, Member):
            continue
        effect, outputs = _removal_effect(unpaired)
        text = f"the {kind(item)} {named(item)}{within(container)} is gone"
        yield unpaired_change(effect, unpaired, False, text, named(item), "name", outputs)


def _removal_effect(unpaired: Unpaired) -> tuple[Effect, tuple[str, ...]]:
    consequences = CONSEQUENCES[type(unpaired.item)]
    if isinstance(unpaired.item, Version):
        return (Effect.SOURCE, (PYTHON, C)) if unpaired.containers[0].builds else (Effect.DOCS, ())
    if getattr(unpaired.item, "reserved", False) and (unpaired.fields is None or unpaired.fields.offsets_equal):
        return Effect.DOCS, ()
    return consequences.removing, consequences.outputs


def renamed(comparison: Comparison) -> Iterator[Change]:
    """A fact was renamed. The message names the evidence: the keys that the two facts share with each other and with no
    other added or removed fact.

    Why: generated names follow the names of the spec, so programs with the old names no longer compile or run.

    Example: a register `servo` at 0x2011 that is called `servo_on` now.

    Fix: Keep the old name, unless the new name is worth the work of all users. Labels and printed names can change
    freely.
    """

    for renaming in comparison.renamed:
        old, new = named(renaming.pair.old), named(renaming.pair.new)
        consequences = CONSEQUENCES[type(renaming.pair.new)]
        effect, outputs = consequences.renaming, consequences.outputs
        if _is_unnamed(comparison, renaming.pair.old):
            effect, outputs = Effect.DOCS, ()
        place = within(renaming.pair.containers[1])
        text = f"the {kind(renaming.pair.new)} {old}{place} is called {new}; it has {renaming.evidence}"
        yield change(effect, renaming.pair, "name", text, old, new, outputs)


def _is_unnamed(comparison: Comparison, item: Any) -> bool:
    """Whether no output has the name: the body of a frame, a space where no address needs its name, or a member of an
    enum that is not available.
    """
    if isinstance(item, Member):
        return item.unavailable
    if isinstance(item, AddressSpace):
        return not (comparison.old.several_spaces or comparison.new.several_spaces)
    return isinstance(item, Part) and item.role == "body"


def availability_changed(comparison: Comparison) -> Iterator[Change]:
    """A member of an enum is not available any more, or is available now.

    Why: generated code has no name for a value that is not available, so programs that use the name no longer compile
    or run.

    Example: `unavailable: true` at a mode that the old version had.

    Fix: Tell users the alternative. A member that becomes available needs no action.
    """

    for pair in comparison.of(Member):
        old, new = pair.old.unavailable, pair.new.unavailable
        if old != new:
            effect, outputs = (Effect.SOURCE, ALL) if new else (Effect.BEHAVIOUR, ())
            text = f"{named(pair.new)} ({pair.new.value}) is {'not available any more' if new else 'available now'}"
            yield change(effect, pair, "unavailable", text, not old, not new, outputs)


def applicability_changed(comparison: Comparison) -> Iterator[Change]:
    """A parameter applies to different kinds of motor, axis or model, or has an effect with different messages.

    Why: a program may have to identify the connected device before it sets the parameter.

    Example: `applies_to: [rotary]` that becomes `applies_to: [rotary, linear]`.

    Fix: Nothing to do if the list grows; otherwise, tell users which devices no longer have the parameter.
    """

    for pair in comparison.of(Parameter):
        for key, subject in (("applies_to", "what it exists for"), ("messages", "what it has an effect with")):
            old, new = getattr(pair.old, key), getattr(pair.new, key)
            if key == "messages":
                old = tuple(comparison.renamed_to(key, name) for name in old)
            yield from changed(Effect.BEHAVIOUR, pair, key, subject, old, new)


def documentation_changed(comparison: Comparison) -> Iterator[Change]:
    """The documentation of a fact has changed: printed names, labels, texts, notes, sources, or restated values.

    Why: no program is affected. The texts are in the documentation and in the comments of generated code.

    Example: a `doc` with different text, or a `source` with a different line.

    Fix: No action is needed.
    """

    for model_class, texts in TEXTS.items():
        for pair in comparison.any_of(model_class):
            texts_by_key = [
                (key, *_followed(comparison, pair, key, get(pair.old), get(pair.new))) for key, get in texts.items()
            ]
            differ = [
                (key, old, new)
                for key, old, new in texts_by_key
                if old != new and not _belongs_to_signal(comparison, pair, key)
            ]
            if differ:
                keys = [key for key, _, _ in differ]
                key_text = enumeration([key.replace("_", " ") for key in keys], len(keys))
                text = f"{named(pair.new)}: changed {key_text}"
                old, new = ("; ".join(_key_text(*difference) for difference in side) for side in _old_and_new(differ))
                yield change(Effect.DOCS, pair, keys[0], text, old, new)


_NAMES = {"same_as": "registers", "copy_of": "registers", "signal": "signals"}
_PATHS = ("about", "fact")
_OF_SIGNAL = ("printed_name", "label", "doc", "scale", "sentinels")


def _followed(comparison: Comparison, pair: Pair[Any], key: str, old: Any, new: Any) -> tuple[Any, Any]:
    """The two texts: the old one with new names, and both without what other rules report."""
    if key in _NAMES:
        return comparison.renamed_to(_NAMES[key], old), new
    if key in _PATHS:
        return (comparison.renamed_path(old) if isinstance(old, str) else tuple(map(comparison.renamed_path, old))), new
    if key == "sentinels":
        shared = old.keys() & new.keys()
        return {value: old[value] for value in old if value in shared}, {
            value: new[value] for value in new if value in shared
        }
    if key == "scale" and not _same_scale(pair):
        return "", ""
    return old, new


def _same_scale(pair: Pair[Any]) -> bool:
    if isinstance(pair.old, Bit):
        return bool(pair.old.scale == pair.new.scale)
    old, new = pair.old.value, pair.new.value
    return old is not None and new is not None and old.scale == new.scale


def _belongs_to_signal(comparison: Comparison, pair: Pair[Any], key: str) -> bool:
    """Whether the difference of a field's text is that of its signal."""
    if not isinstance(pair.new, Field) or key not in _OF_SIGNAL:
        return False
    get = TEXTS[Field][key]
    old, new = comparison.old.signals.get(pair.old.signal), comparison.new.signals.get(pair.new.signal)
    return old is not None and new is not None and (get(old), get(new)) == (get(pair.old), get(pair.new))


def _old_and_new(differ: list[tuple[str, Any, Any]]) -> tuple[list[tuple[str, Any]], list[tuple[str, Any]]]:
    """The keys with their old values, and with their new ones."""
    return [(key, old) for key, old, _ in differ], [(key, new) for key, _, new in differ]


def _key_text(key: str, value: Any) -> str:
    return f"{key}: {value_text(value)}"


_KEYS = (
    "link",
    "direction",
    "message",
    "exception_response",
    "refused",
    "reply_to",
    "frame",
    "elided",
    "characters",
    "values",
    "origin",
)
_EXAMPLE_KEYS = {"link": "links", "message": "messages", "reply_to": "examples"}


def example_changed(comparison: Comparison) -> Iterator[Change]:
    """The bytes, the values or the subject of an example have changed.

    Why: an example affects no program, but if its frame has changed and no fact has changed, the frame or the facts are
    wrong.

    Example: a `frame` with a different checksum.

    Fix: Find out whether the manual or the transcription has changed.
    """

    for pair in comparison.of(Example):
        for key in _KEYS:
            old, new = getattr(pair.old, key), getattr(pair.new, key)
            old = comparison.renamed_to(_EXAMPLE_KEYS[key], old) if key in _EXAMPLE_KEYS else old
            subject = f"the {key.replace('_', ' ')}" if isinstance(new, str | bytes) else key
            yield from changed(Effect.DOCS, pair, key, subject, old, new)
