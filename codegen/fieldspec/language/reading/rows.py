"""The order of rows that a device states next to the rows of its protocols."""

from __future__ import annotations

from fieldspec.language.reading.nodes import Node, Sequence, identity


def rows_in_order(merged: Node, base: Sequence, override: Sequence) -> Node:
    """Merged rows with each row that `base` does not have after the row of `base` that it follows in `override`."""
    assert isinstance(merged, Sequence)
    if any(identity(item) is None for item in (*base.items, *override.items)):
        return merged
    known = {identity(item) for item in base.items}
    following: dict[str, list[Node]] = {}
    last: str | None = None
    for item in override.items:
        name = identity(item)
        if name in known:
            last = name
        elif last is not None:
            following.setdefault(last, []).append(item)
    moved = {identity(item) for items in following.values() for item in items}
    rows: list[Node] = []
    for item in merged.items:
        if identity(item) not in moved:
            rows += [item, *following.get(identity(item) or "", ())]
    return Sequence(merged.file, merged.start, merged.end, tuple(rows))
