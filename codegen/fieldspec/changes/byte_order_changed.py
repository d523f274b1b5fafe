"""The bytes of a value, or the words of values of several registers, follow each other in another order.

Why: every number of more than one byte is read as another one.

Example: `byte_order: big` at a link that becomes `byte_order: little`.

Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named, turned
from fieldspec.model.device import Device
from fieldspec.model.link import Link, Part
from fieldspec.model.value import Value


def byte_order_changed(both: Comparison) -> Iterator[Change]:
    for link in both.of(Link):
        for key in ("byte_order", "word_order"):
            old, new = getattr(link.old, key) or "big", getattr(link.new, key) or "big"
            if old != new:
                text = f"{named(link.new)}: {turned('the ' + key.replace('_', ' '), old, new)}"
                yield change("byte_order_changed", Effect.WIRE, link, key, text, old, new)
    for part in both.of(Part):
        if part.old.algorithm and part.new.algorithm:
            old, new = part.old.byte_order or "little", part.new.byte_order or "little"
            if old != new:
                text = f"{named(part.new)}: {turned('the byte order of the check', old, new)}"
                yield change("byte_order_changed", Effect.WIRE, part, "byte_order", text, old, new)
    for held in both.values:
        if held.old.byte_order != held.new.byte_order and _ordered(held.old) and _ordered(held.new):
            old, new = _order(held.old, both.old), _order(held.new, both.new)
            if old != new:
                text = f"{named(held.of.new)}: {turned('the byte order', old, new)}"
                yield change("byte_order_changed", Effect.WIRE, held, "byte_order", text, old, new)


def _ordered(value: Value) -> bool:
    return value.type.size > 1


def _order(value: Value, device: Device) -> str:
    return value.byte_order or device.byte_order
