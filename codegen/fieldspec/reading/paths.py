"""Paths of facts: `section/name/...`, each step a key, the name of a list's item, or its number.

In `registers` the groups are skipped: `registers/servo` is the row `servo` of whichever group holds it.
"""

from __future__ import annotations

from collections.abc import Callable

from fieldspec.reading.nodes import Mapping, Node, Sequence, identity

Change = Callable[[Node], Node | None]


def find(node: Node, path: str) -> Node | None:
    """The node at a path, or None."""
    at: Node | None = node
    for step in path.split("/"):
        if at is None:
            return None
        at = _step(at, step)
    return at


def keys(node: Node, path: str) -> list[str | int] | None:
    """The keys and numbers that lead to the node at a path, or None where it leads nowhere."""
    at: Node = node
    found: list[str | int] = []
    for step in path.split("/"):
        steps = _keys(at, step)
        if steps is None:
            return None
        at = node_at(at, steps)
        found += steps
    return found


def _keys(node: Node, step: str) -> list[str | int] | None:
    """The keys of one step; one that skips a group or a list of rows has several."""
    if isinstance(node, Sequence):
        number = _index(node, step)
        if number is None:
            return None
        item = node.items[number]
        if identity(item) != step and isinstance(item, Mapping) and "group" in item.values:
            inner = _keys(item, step)
            return None if inner is None else [number, *inner]
        return [number]
    if isinstance(node, Mapping):
        held = _inner(node, step)
        if held is None:
            return None
        key, below = held
        inner = [] if key == step else _keys(below, step)
        return None if inner is None else [key, *inner]
    return None


def node_at(node: Node, at: list[str | int]) -> Node:
    """The node at some keys."""
    for key in at:
        node = node.items[key] if isinstance(node, Sequence) else node.values[key]  # type: ignore[index, union-attr]
    return node


def schema_path(at: list[str | int]) -> tuple[str, ...]:
    """The keys of the schema that say what stands at some keys of a tree."""
    path: list[str] = []
    for key in at:
        path += ["items"] if isinstance(key, int) else ["properties", key]
    return tuple(path)


def put(node: Node, at: list[str | int], new: Node | None) -> Node:
    """The tree with another node at some keys, or without the item of a list that is there."""
    if not at:
        assert new is not None
        return new
    key, *rest = at
    if isinstance(node, Sequence) and isinstance(key, int):
        if new is None and not rest:
            items = (*node.items[:key], *node.items[key + 1 :])
        else:
            items = (*node.items[:key], put(node.items[key], rest, new), *node.items[key + 1 :])
        return Sequence(node.file, node.start, node.end, items)
    assert isinstance(node, Mapping)
    assert isinstance(key, str)
    if new is None and not rest:
        return node.without(key)
    return node.with_value(key, put(node.values[key], rest, new))


def changed(node: Node, path: str, change: Change) -> Node | None:
    """The tree with the node at a path changed, or None where the path leads nowhere."""
    return _changed(node, path.split("/"), change)


def _inner(mapping: Mapping, step: str) -> tuple[str, Node] | None:
    """The key under which a step finds its node in a mapping, and that node's holder."""
    if step in mapping.values:
        return step, mapping.values[step]
    for key in ("rows", "members", "fields", "bits"):
        held = mapping.values.get(key)
        if isinstance(held, Sequence) and _index(held, step) is not None:
            return key, held
    return None


def _index(sequence: Sequence, step: str) -> int | None:
    """Which item of a list a step means: by name, by the name of a row within it, or by number."""
    for number, item in enumerate(sequence.items):
        if identity(item) == step:
            return number
    for number, item in enumerate(sequence.items):
        if isinstance(item, Mapping) and "group" in item.values and _inner(item, step):
            return number
    if step.isdigit() and int(step) < len(sequence.items):
        return int(step)
    return None


def _step(node: Node, step: str) -> Node | None:
    if isinstance(node, Sequence):
        number = _index(node, step)
        if number is None:
            return None
        item = node.items[number]
        if identity(item) != step and isinstance(item, Mapping) and "group" in item.values:
            return _step(item, step)
        return item
    if isinstance(node, Mapping):
        inner = _inner(node, step)
        if inner is None:
            return None
        key, held = inner
        return held if key == step else _step(held, step)
    return None


def _changed(node: Node, steps: list[str], change: Change) -> Node | None:
    if not steps:
        return change(node)
    step, *rest = steps
    if isinstance(node, Sequence):
        number = _index(node, step)
        if number is None:
            return None
        item = node.items[number]
        grouped = identity(item) != step and isinstance(item, Mapping) and "group" in item.values
        new = _changed(item, steps if grouped else rest, change)
        if new is None:
            return None
        items = (*node.items[:number], new, *node.items[number + 1 :])
        return Sequence(node.file, node.start, node.end, items)
    if isinstance(node, Mapping):
        inner = _inner(node, step)
        if inner is None:
            return None
        key, held = inner
        new = _changed(held, rest if key == step else steps, change)
        return None if new is None else node.with_value(key, new)
    return None
