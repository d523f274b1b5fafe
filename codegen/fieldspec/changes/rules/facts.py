"""Rules about facts that are added, removed, renamed or described differently."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from fieldspec.changes.attributes import ALL, MODEL_CLASSES, PYTHON, TEXTS, C
from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison, Lone, Pair
from fieldspec.changes.evidence import enumeration, value_text
from fieldspec.changes.finding import around, change, kind, named, path, span, turned, within
from fieldspec.model.device import Device, Version
from fieldspec.model.enums import Member
from fieldspec.model.record import Field
from fieldspec.model.registers import Parameter
from fieldspec.model.texts import Example


def device_added(device: Device) -> Change:
    """That a device is new."""
    text = f"the device {device.id} is new"
    return Change("fact_added", Effect.BEHAVIOUR, "device", device.id, text, "", device.name, None, device.place["id"])


def device_removed(device: Device) -> Change:
    """That a device is gone, and with it everything that is generated for it."""
    text = f"the device {device.id} is gone"
    return Change(
        "fact_removed", Effect.SOURCE, "device", device.id, text, device.name, "", device.place["id"], None, ALL
    )


def fact_added(both: Comparison) -> Iterator[Change]:
    """The new version has something that the old one has not.

    Why: nobody who does without it is hurt, as long as it takes no place from anything. A field that makes a record
    longer, or moves others, breaks every program that knows the old length.

    Example: a register at an address that was free.

    Cure: Put new fields where reserved ones were. Give the fact a `since`, so that users of the old version know.
    """

    for lone in both.added:
        item, holder = lone.item, lone.holder[1]
        if isinstance(item, Member):
            continue
        text = f"the {kind(item)} {named(item)}{within(holder)} is new"
        before, after = around(lone.holder[0], "name"), span(item, "name", holder)
        yield Change("fact_added", _effect(lone), kind(item), path(item, holder), text, "", named(item), before, after)


def _effect(lone: Lone) -> Effect:
    if lone.fields is not None and not lone.fields.offsets_equal:
        return Effect.WIRE
    if getattr(lone.item, "reserved", False):
        return Effect.DOCS
    if isinstance(lone.item, Version):
        return Effect.BEHAVIOUR if lone.holder[1].builds else Effect.DOCS
    return Effect.BEHAVIOUR if lone.fields is not None else MODEL_CLASSES[type(lone.item)].adding


def fact_removed(both: Comparison) -> Iterator[Change]:
    """The old version has something that the new one has not, and nothing shows that it only has another name.

    Why: programs that use it read or write nothing, or something else, and generated code has no name for it any more.

    Example: a register that the new manual does not list.

    Cure: Look whether the new manual has left it out by mistake. Else give it an `until`, and tell users what to use
    instead.
    """

    for lone in both.removed:
        item, holder = lone.item, lone.holder[0]
        if isinstance(item, Member):
            continue
        effect, outputs = _removal_effect(lone)
        text = f"the {kind(item)} {named(item)}{within(holder)} is gone"
        before, after = span(item, "name", holder), around(lone.holder[1], "name")
        yield Change(
            "fact_removed", effect, kind(item), path(item, holder), text, named(item), "", before, after, outputs
        )


def _removal_effect(lone: Lone) -> tuple[Effect, tuple[str, ...]]:
    noun = MODEL_CLASSES[type(lone.item)]
    if isinstance(lone.item, Version):
        return (Effect.SOURCE, (PYTHON, C)) if lone.holder[0].builds else (Effect.DOCS, ())
    if getattr(lone.item, "reserved", False) and (lone.fields is None or lone.fields.offsets_equal):
        return Effect.DOCS, ()
    return noun.removing, noun.outputs


def renamed(both: Comparison) -> Iterator[Change]:
    """Something has another name. It is the same thing by the evidence that the message names: nothing else that has
    come or gone shares it.

    Why: generated names follow the names of the spec, so programs that use the old ones no longer compile or run.

    Example: a register `servo` at 0x2011 that is called `servo_on` now.

    Cure: Keep the old name, unless the new one is worth the trouble of all users; labels and printed names may change
    freely.
    """

    for found in both.renamed:
        old, new = named(found.pair.old), named(found.pair.new)
        noun = MODEL_CLASSES[type(found.pair.new)]
        text = (
            f"the {kind(found.pair.new)} {old}{within(found.pair.holder[1])} is called {new}; it has {found.evidence}"
        )
        yield change("renamed", noun.renaming, found.pair, "name", text, old, new, noun.outputs)


def availability_changed(both: Comparison) -> Iterator[Change]:
    """A member of an enum has become not available, or available.

    Why: generated code has no name for a value that is not available, so programs that use the name no longer compile
    or run.

    Example: `unavailable: true` at a mode that the old version had.

    Cure: Tell users what to use instead. A member that becomes available hurts nobody.
    """

    for pair in both.of(Member):
        old, new = pair.old.unavailable, pair.new.unavailable
        if old != new:
            effect, outputs = (Effect.SOURCE, ALL) if new else (Effect.BEHAVIOUR, ())
            text = f"{named(pair.new)} ({pair.new.value}) is {'not available any more' if new else 'available now'}"
            yield change("availability_changed", effect, pair, "unavailable", text, not old, not new, outputs)


def applicability_changed(both: Comparison) -> Iterator[Change]:
    """A parameter exists for other kinds of motor, axis or model, or has an effect with other messages.

    Why: a program that sets it may have to ask first what it is connected to.

    Example: `applies_to: [rotary]` that becomes `applies_to: [rotary, linear]`.

    Cure: Nothing to do where the list grows; else tell users which devices no longer have the parameter.
    """

    for pair in both.of(Parameter):
        for key, what in (("applies_to", "what it exists for"), ("messages", "what it has an effect with")):
            old, new = getattr(pair.old, key), getattr(pair.new, key)
            if key == "messages":
                old = tuple(both.renamed_to(key, name) for name in old)
            if old != new:
                text = f"{named(pair.new)}: {turned(what, old, new)}"
                yield change("applicability_changed", Effect.BEHAVIOUR, pair, key, text, old, new)


def documentation_changed(both: Comparison) -> Iterator[Change]:
    """What is read by people has changed: names as printed, labels, texts, notes, sources, and what the manual prints
    twice.

    Why: nobody is hurt. Texts stand in the documentation and in the comments of generated code.

    Example: a `doc` in other words, or a `source` with another line.

    Cure: None is needed.
    """

    for noun, texts in TEXTS.items():
        for pair in both.any_of(noun):
            held = [(key, *_followed(both, pair, key, get(pair.old), get(pair.new))) for key, get in texts.items()]
            differ = [
                (key, old, new) for key, old, new in held if old != new and not _is_told_by_signal(both, pair, key)
            ]
            if differ:
                keys = [key for key, _, _ in differ]
                text = (
                    f"{named(pair.new)} has another {enumeration([key.replace('_', ' ') for key in keys], len(keys))}"
                )
                old, new = ("; ".join(_key_text(*each) for each in side) for side in _old_and_new(differ))
                yield change("documentation_changed", Effect.DOCS, pair, keys[0], text, old, new)


_NAMES = {"same_as": "registers", "copy_of": "registers", "signal": "signals"}
_PATHS = ("about", "fact")
_OF_SIGNAL = ("printed_name", "label", "doc", "scale", "sentinels")


def _followed(both: Comparison, pair: Pair[Any], key: str, old: Any, new: Any) -> tuple[Any, Any]:
    """Two texts: the old one by new names, and both without what other rules tell."""
    if key in _NAMES:
        return both.renamed_to(_NAMES[key], old), new
    if key in _PATHS:
        return (both.renamed_path(old) if isinstance(old, str) else tuple(map(both.renamed_path, old))), new
    if key == "sentinels":
        shared = old.keys() & new.keys()
        return {one: old[one] for one in old if one in shared}, {one: new[one] for one in new if one in shared}
    if key == "scale" and not _same_scale(pair):
        return "", ""
    return old, new


def _same_scale(pair: Pair[Any]) -> bool:
    old, new = pair.old.value, pair.new.value
    return old is not None and new is not None and old.scale == new.scale


def _is_told_by_signal(both: Comparison, pair: Pair[Any], key: str) -> bool:
    """Whether a signal tells what has changed at a field that takes its texts from there."""
    if not isinstance(pair.new, Field) or key not in _OF_SIGNAL:
        return False
    get = TEXTS[Field][key]
    old, new = both.old.signals.get(pair.old.signal), both.new.signals.get(pair.new.signal)
    return old is not None and new is not None and (get(old), get(new)) == (get(pair.old), get(pair.new))


def _old_and_new(differ: list[tuple[str, Any, Any]]) -> tuple[list[tuple[str, Any]], list[tuple[str, Any]]]:
    """The keys with their old values, and with their new ones."""
    return [(key, old) for key, old, _ in differ], [(key, new) for key, _, new in differ]


def _key_text(key: str, held: Any) -> str:
    return f"{key}: {value_text(held)}"


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


def example_changed(both: Comparison) -> Iterator[Change]:
    """An example has other bytes, or other values, or stands for something else.

    Why: nobody is hurt by an example. But where its frame has changed and no fact has, one of the two is wrong.

    Example: a `frame` with another checksum.

    Cure: Look whether the manual or the transcription has changed.
    """

    for pair in both.of(Example):
        for key in _KEYS:
            old, new = getattr(pair.old, key), getattr(pair.new, key)
            old = both.renamed_to(_EXAMPLE_KEYS[key], old) if key in _EXAMPLE_KEYS else old
            if old != new:
                what = f"the {key.replace('_', ' ')}" if isinstance(new, str | bytes) else key
                text = f"{named(pair.new)}: {turned(what, old, new)}"
                yield change("example_changed", Effect.DOCS, pair, key, text, old, new)
