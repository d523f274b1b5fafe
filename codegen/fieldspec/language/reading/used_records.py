"""The records of a protocol that a device takes along with the messages that it has chosen."""

from __future__ import annotations

from collections.abc import Iterable

from fieldspec.language.reading.nodes import Mapping, Node, Scalar, Sequence, identity


def used_records(protocol: Mapping, records: Sequence, messages: Sequence, device: Mapping) -> Sequence:
    """The records without those that only other messages of the protocol have.

    `messages` are the chosen ones. A record stays if the device has an entry of it, or names it.
    """
    all_messages = protocol.values.get("messages")
    chosen = {identity(message) for message in messages.items}
    other_messages = [message for message in _items(all_messages) if identity(message) not in chosen]
    by_name = {identity(record): record for record in records.items}
    sections = (own for key, own in protocol.values.items() if key not in ("messages", "records"))
    entries = {identity(record) for record in _items(device.values.get("records"))}
    needed_names = _with_inner({*_names((*sections, *messages.items, device)), *entries}, by_name)
    unneeded = _with_inner(_names(other_messages), by_name) - needed_names
    items = tuple(record for record in records.items if identity(record) not in unneeded)
    return Sequence(records.file, records.start, records.end, items)


def _items(node: Node | None) -> tuple[Node, ...]:
    return node.items if isinstance(node, Sequence) else ()


def _with_inner(names: set[str | None], records: dict[str | None, Node]) -> set[str | None]:
    """Names of records and of the records in them."""
    reached: set[str | None] = set()
    waiting = names
    while waiting:
        reached |= waiting
        waiting = _names(records[name] for name in waiting if name in records) - reached
    return reached


def _names(nodes: Iterable[Node]) -> set[str | None]:
    """The names under `record` anywhere in some nodes."""
    names: set[str | None] = set()
    waiting = [*nodes]
    while waiting:
        node = waiting.pop()
        if isinstance(node, Mapping):
            name = node.values.get("record")
            if isinstance(name, Scalar):
                names.add(name.text)
            waiting += node.values.values()
        elif isinstance(node, Sequence):
            waiting += node.items
    return names
