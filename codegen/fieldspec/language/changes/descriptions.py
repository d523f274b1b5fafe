"""Changes as the rules describe them: their kinds, names, paths and places, which the facts know themselves."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, TypeAlias

from fieldspec.foundation.source import Span
from fieldspec.language.changes.change import Change, Effect
from fieldspec.language.changes.comparison import Comparison, Pair, Unpaired, ValuePair
from fieldspec.language.changes.evidence import quoted, value_text
from fieldspec.language.model.attributes import MODEL_CLASSES
from fieldspec.language.model.device import Device, Version, VersionLine
from fieldspec.language.model.fact import Place

Rule: TypeAlias = Callable[[Comparison], Iterator[Change]]


def change(
    effect: Effect,
    pair: Pair[Any] | ValuePair,
    key: str,
    message: str,
    old: object = None,
    new: object = None,
    outputs: tuple[str, ...] = (),
) -> Change:
    """A change of the value that a key of a fact has. `message` follows the name of the fact."""
    own = pair.of if isinstance(pair, ValuePair) else pair
    return Change(
        effect,
        kind(own.new),
        path(own.new, own.containers[1]),
        message,
        value_text(old),
        value_text(new),
        span(own.old, key, own.containers[0]),
        span(own.new, key, own.containers[1]),
        outputs,
    )


def difference(
    effect: Effect,
    pair: Pair[Any] | ValuePair,
    key: str,
    subject: str,
    old: object,
    new: object,
    outputs: tuple[str, ...] = (),
) -> Change:
    """The change of a value, in the words of `difference_text`."""
    own = pair.of if isinstance(pair, ValuePair) else pair
    message = f"{named(own.new)}: {difference_text(subject, old, new)}"
    return change(effect, pair, key, message, old, new, outputs)


def changed(
    effect: Effect,
    pair: Pair[Any] | ValuePair,
    key: str,
    subject: str,
    old: object,
    new: object,
    outputs: tuple[str, ...] = (),
) -> Iterator[Change]:
    """The change of a value, if it differs."""
    if old != new:
        yield difference(effect, pair, key, subject, old, new, outputs)


def unpaired_change(
    effect: Effect, unpaired: Unpaired, is_new: bool, message: str, value: str, key: str, outputs: tuple[str, ...] = ()
) -> Change:
    """The change that only one device has an object. `key` is that of its container in the other one."""
    item, own, other = unpaired.item, unpaired.containers[is_new], unpaired.containers[not is_new]
    values_and_places = [(value, span(item, "name", own)), ("", around(other, key))]
    (old, before), (new, after) = reversed(values_and_places) if is_new else values_and_places
    return Change(effect, kind(item), path(item, own), message, old, new, before, after, outputs)


def kind(item: Any) -> str:
    """The word of users for the class of an object."""
    return MODEL_CLASSES[type(item)].title


def named(item: Any) -> str:
    """The name by which users know an object."""
    return str(MODEL_CLASSES[type(item)].key(item))


def within(container: Any) -> str:
    """The container after a name: ` of status`, or nothing for the device itself."""
    return "" if isinstance(container, Device) else f" of {named(container)}"


def path(item: Any, container: Any) -> str:
    """The path of an object."""
    if isinstance(item, VersionLine):
        return f"versions/{item.name}"
    if isinstance(item, Version):
        return f"versions/{container.name}/{item.id}"
    place: Place = item.place
    return place.path.lstrip("/")


def span(item: Any, key: str, container: Any) -> Span | None:
    """The place of the value of a key; None for an object without a place."""
    place = getattr(item, "place", None)
    return _key_span(place, key) if isinstance(place, Place) else None


_IN_UNIT = {"range": "unit_range", "default": "unit_default"}
"""Keys with another key that states the same in the unit of the value."""


def _key_span(place: Place, key: str) -> Span:
    other = _IN_UNIT.get(key, key)
    return place[other] if other in place else place[key]


def around(container: Any, key: str) -> Span | None:
    """The place of the container in the device that lacks an object; None if that is the whole device."""
    return None if isinstance(container, Device) else span(container, key, None)


def difference_text(subject: str, old: object, new: object) -> str:
    """`the unit is mm, and was nothing`"""
    return f"{subject} is {quoted(new)}, and was {quoted(old)}"
