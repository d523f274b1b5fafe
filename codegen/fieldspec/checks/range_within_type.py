"""A range, a sentinel and a printed range of stations fit the type that holds them.

Why: a bound that the type cannot hold cannot be sent. Either the type is too narrow, or its sign is
wrong, or a digit of the bound is.

Example: a range of -1..127 on a `u16`.

Cure: Put the type or the bound right; give a signed type where the manual prints negative values.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.finding import finding, outside, range_key
from fieldspec.checks.walking import values
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device
from fieldspec.model.fact import Fact
from fieldspec.model.link import Link
from fieldspec.model.primitive import Kind, Primitive
from fieldspec.model.ranges import Ranges
from fieldspec.model.value import Value

_HELP = "put the type or the bound right"
_WHOLE = (Kind.INTEGER, Kind.BOOLEAN)


def range_within_type(device: Device) -> Iterator[Diagnostic]:
    for fact, value in values(device):
        if value.type.kind in _WHOLE:
            yield from _of_value(fact, value)
    for flags in device.flags.values():
        if flags.type.kind in _WHOLE and outside(flags.ranges, flags.type.low, flags.type.high):
            text = f"{flags.name} cannot be {_text(flags.ranges)} as {_held(flags.type)}"
            yield finding("range_within_type", flags.place, "range", text, _HELP)
    for link in device.links.values():
        yield from _of_stations(link)


def _of_value(fact: Fact, value: Value) -> Iterator[Diagnostic]:
    if outside(value.ranges, value.type.low, value.type.high):
        text = f"{fact.name} cannot be {_text(value.ranges)} as {_held(value.type)}"
        yield finding("range_within_type", fact.place, range_key(fact.place), text, _HELP)
    for sentinel in value.sentinels:
        if not value.type.low <= sentinel.value <= value.type.high:
            text = f"{fact.name} cannot be {sentinel.value} ({sentinel.name}) as {_held(value.type)}"
            yield finding("range_within_type", fact.place, "sentinels", text, _HELP)


def _of_stations(link: Link) -> Iterator[Diagnostic]:
    part = next((p for p in link.request if p.role == "station" and p.value is not None), None)
    if link.stations is None or part is None or part.value is None or part.value.type.kind not in _WHOLE:
        return
    held = part.value.type
    if outside(link.stations.ranges, held.low, held.high):
        text = f"{part.name} cannot be {_text(link.stations.ranges)} as {_held(held)}"
        yield finding("range_within_type", link.stations.place, "range", text, _HELP)


def _held(primitive: Primitive) -> str:
    return f"{primitive.name}, which holds {primitive.low}..{primitive.high}"


def _text(ranges: Ranges | None) -> str:
    return ranges.text() if ranges else ""
