"""What rules share to say what they have found. Places come from the facts, never from counting."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, TypeAlias

from fieldspec.changes.attributes import MODEL_CLASSES
from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison, Pair, Values
from fieldspec.changes.evidence import quoted, value_text
from fieldspec.model.device import Device, Version, VersionLine
from fieldspec.model.fact import Place
from fieldspec.source import Span

Rule: TypeAlias = Callable[[Comparison], Iterator[Change]]


def change(
    rule: str,
    effect: Effect,
    pair: Pair[Any] | Values,
    key: str,
    message: str,
    old: object = None,
    new: object = None,
    outputs: tuple[str, ...] = (),
) -> Change:
    """A change of what a key of a fact says; `message` goes on from the name of the fact."""
    own = pair.of if isinstance(pair, Values) else pair
    return Change(
        rule,
        effect,
        kind(own.new),
        path(own.new, own.holder[1]),
        message,
        value_text(old),
        value_text(new),
        span(own.old, key, own.holder[0]),
        span(own.new, key, own.holder[1]),
        outputs,
    )


def kind(item: Any) -> str:
    """What users call a thing."""
    return MODEL_CLASSES[type(item)].kind


def named(item: Any) -> str:
    """The name by which users know a thing."""
    return str(MODEL_CLASSES[type(item)].key(item))


def within(holder: Any) -> str:
    """` of status`, or nothing for what the device itself holds."""
    return "" if isinstance(holder, Device) else f" of {named(holder)}"


def path(item: Any, holder: Any) -> str:
    """The path of a thing."""
    if isinstance(item, VersionLine):
        return f"versions/{item.name}"
    if isinstance(item, Version):
        return f"versions/{holder.name}/{item.id}"
    place: Place = item.place
    return place.path.lstrip("/")


def span(item: Any, key: str, holder: Any) -> Span | None:
    """The place of the value of a key; None for what has no place of its own."""
    place = getattr(item, "place", None)
    return _key_span(place, key) if isinstance(place, Place) else None


_SPELT = {"range": "unit_range", "default": "unit_default"}
"""Keys that may be written in two ways."""


def _key_span(place: Place, key: str) -> Span:
    other = _SPELT.get(key, key)
    return place[other] if other in place else place[key]


def around(holder: Any, key: str) -> Span | None:
    """The place of what holds a thing, on the side where the thing is not; None where that is the whole device."""
    return None if isinstance(holder, Device) else span(holder, key, None)


def turned(what: str, old: object, new: object) -> str:
    """`the unit is mm, and was nothing`"""
    return f"{what} is {quoted(new)}, and was {quoted(old)}"
