"""A message is sent on other links, or beside other messages.

Why: on a link that it has lost, a message is not understood; beside another one it may not be allowed.

Example: `links: [rtu, ascii]` that becomes `links: [rtu]`.

Cure: Nothing to do where links or companions are added. Where the old spec was wrong, accept the change with that
reason; else give the new version a number of its own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named, turned
from fieldspec.model.device import Device
from fieldspec.model.message import Message


def sending_changed(both: Comparison) -> Iterator[Change]:
    for pair in both.of(Message):
        links = tuple(both.renamed_to("links", name) for name in _links(both.old, pair.old))
        beside = tuple(both.renamed_to("messages", name) for name in pair.old.supplements)
        for key, what, old, new, kept in (
            ("links", "where it is sent", links, _links(both.new, pair.new), pair.new.links),
            ("supplements", "what it is sent beside", beside, pair.new.supplements, pair.new.supplements),
        ):
            stated = getattr(pair.old, key) or kept
            if stated and sorted(old) != sorted(new):
                lost = key == "links" and bool(set(old) - set(new))
                text = f"{named(pair.new)}: {turned(what, old, new)}"
                yield change("sending_changed", Effect.WIRE if lost else Effect.BEHAVIOUR, pair, key, text, old, new)


def _links(device: Device, message: Message) -> tuple[str, ...]:
    return message.links or tuple(device.links)
