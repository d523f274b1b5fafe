"""The nodes of an earlier tree in a new one, wherever they differ only in their places.

A text that is parsed again, and a device that is joined with its protocols and signals, consist of new nodes. Whatever
depends on a node alone is found again by the same node.
"""

from __future__ import annotations

from operator import is_

from fieldspec.language.reading.nodes import Mapping, Node, Scalar, Sequence, identity


def with_unchanged(tree: Mapping, earlier: Mapping | None) -> Mapping:
    """A tree with the nodes of an earlier one, if there is one, below its root. They are moved to their new places."""
    if earlier is None:
        return tree
    return Mapping(tree.file, tree.start, tree.end, _values(tree, earlier), tree.keys)


def _values(node: Mapping, earlier: Mapping) -> dict[str, Node]:
    return {key: _unchanged(value, earlier.values.get(key)) for key, value in node.values.items()}


def _unchanged(node: Node, earlier: Node | None) -> Node:
    """The earlier node if it differs only in its place, or else the node with earlier nodes below it."""
    if node is earlier or earlier is None:
        return node
    if isinstance(node, Scalar):
        is_equal = isinstance(earlier, Scalar) and _content(node) == _content(earlier)
        return _moved(earlier, node) if is_equal and _is_movable(earlier, node) else node
    if isinstance(node, Sequence):
        if not isinstance(earlier, Sequence):
            return node
        items = _items(node, earlier)
        if _are_same(items, earlier.items) and _is_movable(earlier, node):
            return _moved(earlier, node)
        return node if _are_same(items, node.items) else Sequence(node.file, node.start, node.end, items)
    if not isinstance(earlier, Mapping):
        return node
    values = _values(node, earlier)
    below = tuple(values.values())
    if (
        values.keys() == earlier.values.keys()
        and _are_same(below, tuple(earlier.values.values()))
        and bool(node.keys) == bool(earlier.keys)
        and _is_movable(earlier, node)
    ):
        earlier.keys = node.keys
        return _moved(earlier, node)
    if _are_same(below, tuple(node.values.values())):
        return node
    return Mapping(node.file, node.start, node.end, values, node.keys)


def _content(scalar: Scalar) -> tuple[object, ...]:
    return scalar.text, scalar.quoted, scalar.value.__class__, scalar.value


def _are_same(left: tuple[Node, ...], right: tuple[Node, ...]) -> bool:
    return len(left) == len(right) and all(map(is_, left, right))


def _items(node: Sequence, earlier: Sequence) -> tuple[Node, ...]:
    """The items of a list, with the earlier ones of the same name, or without names at the same position."""
    if _are_same(node.items, earlier.items):
        return earlier.items
    names = {identity(item): item for item in earlier.items}
    if None in names:
        pairs = zip(node.items, (*earlier.items, *[None] * len(node.items)), strict=False)
        return tuple([_unchanged(item, other) for item, other in pairs])
    return tuple([_unchanged(item, names.get(identity(item))) for item in node.items])


def _is_movable(earlier: Node, node: Node) -> bool:
    """Whether an earlier node is of an earlier text, so that it is in no new tree, or need not be moved."""
    if earlier.file is node.file:
        return (earlier.start, earlier.end) == (node.start, node.end)
    return earlier.file.path == node.file.path


def _moved(earlier: Node, node: Node) -> Node:
    earlier.file, earlier.start, earlier.end = node.file, node.start, node.end
    return earlier
