"""Another address means all stations, or a message can be sent to all stations now, or no longer.

Why: a request that was for one device is carried out by all of them, or by none.

Example: `broadcast: 0` that becomes `broadcast: 255` at the stations of a link.

Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named, turned
from fieldspec.model.link import Link
from fieldspec.model.message import Message


def broadcast_changed(both: Comparison) -> Iterator[Change]:
    for link in both.of(Link):
        old, new = (side.stations.broadcast if side.stations else None for side in (link.old, link.new))
        if old != new:
            text = f"{named(link.new)}: {turned('the address of all stations', old, new)}"
            yield change("broadcast_changed", Effect.WIRE, link, "stations", text, old, new)
    for message in both.of(Message):
        if message.old.broadcast != message.new.broadcast:
            text = "can be sent to all stations" if message.new.broadcast else "can no longer be sent to all stations"
            yield change(
                "broadcast_changed",
                Effect.BEHAVIOUR,
                message,
                "broadcast",
                f"{named(message.new)} {text}",
                message.old.broadcast,
                message.new.broadcast,
            )
