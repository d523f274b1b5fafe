"""The node tree of a YAML file, and paths to its facts."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from decimal import Decimal
from typing import TypeAlias

from fieldspec.foundation.classes import dataclass, field
from fieldspec.foundation.source import SourceFile, Span
from fieldspec.language.model.fact import ScalarValue

# Nobody changes a node that is built. They are not frozen, because frozen ones take five times as long to build, and
# most of a short run is reading.


@dataclass(slots=True)
class Scalar:
    """A scalar: its text, whether it was quoted, and its value once the schema has typed it."""

    file: SourceFile
    start: int
    end: int
    text: str
    quoted: bool
    value: ScalarValue = None

    @property
    def span(self) -> Span:
        """The place of the node."""
        return Span(self.file, self.start, self.end)


@dataclass(slots=True)
class Sequence:
    """A list of nodes with its place in a file."""

    file: SourceFile
    start: int
    end: int
    items: tuple[Node, ...]

    @property
    def span(self) -> Span:
        """The place of the node."""
        return Span(self.file, self.start, self.end)


@dataclass(slots=True)
class Mapping:
    """Nodes by key, in the order of the file. Its text has all keys but those in `keys`.

    `keys` maps a key to the mapping whose text has it, or to a place to report in its stead.
    """

    file: SourceFile
    start: int
    end: int
    values: dict[str, Node]
    keys: dict[str, Scalar | Mapping] = field(default_factory=lambda: ALL_THERE)

    @property
    def span(self) -> Span:
        """The place of the node."""
        return Span(self.file, self.start, self.end)

    def holder(self, key: str) -> Scalar | Mapping:
        """The mapping whose text has a key, or the place to report in its stead."""
        return self.keys.get(key, self)

    def with_value(self, key: str, value: Node) -> Mapping:
        """The same mapping with one value set."""
        keys = self.keys
        if key not in self.values:
            keys = {**keys, key: Scalar(value.file, value.start, value.end, key, False, key)}
        return Mapping(self.file, self.start, self.end, {**self.values, key: value}, keys)

    def with_entry(self, key: str, value: Node, holder: Mapping) -> Mapping:
        """The same mapping with the key and the value of the mapping `holder`."""
        keys = {**self.keys, key: holder.holder(key)}
        return Mapping(self.file, self.start, self.end, {**self.values, key: value}, keys)

    def without(self, key: str) -> Mapping:
        """The same mapping without one key."""
        values = {k: v for k, v in self.values.items() if k != key}
        return Mapping(self.file, self.start, self.end, values, self.keys)


ALL_THERE: dict[str, Scalar | Mapping] = {}
"""The `keys` of a mapping whose text has all of its keys, as nearly every mapping."""

CHECKED = "checked"
"""The key of the numbers that follow from the rest of a fact. Errata, reasons and paths leave it out."""

LISTS = ("rows", "members", "fields", "bits")
"""The keys of lists that paths leave out."""

Node: TypeAlias = Scalar | Sequence | Mapping


def children(node: Node) -> Iterator[tuple[str | int, Node]]:
    """The nodes directly below a node, with their keys or numbers."""
    if isinstance(node, Mapping):
        yield from node.values.items()
    elif isinstance(node, Sequence):
        yield from enumerate(node.items)


def identity(node: Node) -> str | None:
    """The name by which a path knows an item of a list."""
    if isinstance(node, Mapping):
        for key in ("name", "id", "group", "line", "protocol"):
            scalar = node.values.get(key)
            if isinstance(scalar, Scalar):
                return scalar.text
    return None


def with_checked_keys(fact: Mapping) -> Mapping:
    """A fact with the keys under its `checked` as keys of its own."""
    checked = fact.values.get(CHECKED)
    if not isinstance(checked, Mapping):
        return fact
    values = {key: value for key, value in fact.values.items() if key != CHECKED} | checked.values
    return Mapping(fact.file, fact.start, fact.end, values, {**fact.keys, **dict.fromkeys(checked.values, checked)})


def mappings(node: Node | None) -> Iterator[Mapping]:
    """The mappings of a list."""
    for item in node.items if isinstance(node, Sequence) else ():
        if isinstance(item, Mapping):
            yield item


def copied(node: Node) -> Node:
    """A copy of a node, so that it can be typed by another part of the schema."""
    if isinstance(node, Scalar):
        return Scalar(node.file, node.start, node.end, node.text, node.quoted, node.value)
    if isinstance(node, Sequence):
        return Sequence(node.file, node.start, node.end, tuple([copied(item) for item in node.items]))
    values = {key: copied(value) for key, value in node.values.items()}
    return Mapping(node.file, node.start, node.end, values, node.keys)


def json_data(node: Node) -> object:
    """The node as data of JSON, for validation only: decimals become floats."""
    if isinstance(node, Scalar):
        return float(node.value) if isinstance(node.value, Decimal) else node.value
    if isinstance(node, Sequence):
        return [json_data(item) for item in node.items]
    return {key: json_data(value) for key, value in node.values.items()}


def exact(node: Node) -> object:
    """The node as Python data with exact decimals."""
    if isinstance(node, Scalar):
        return node.value
    if isinstance(node, Sequence):
        return [exact(item) for item in node.items]
    return {key: exact(value) for key, value in node.values.items()}


# In `registers` the groups are skipped: `registers/servo` is the row `servo` of whichever group contains it.

Change = Callable[[Node], Node | None]


def find(node: Node, path: str) -> Node | None:
    """The node at a path, None if there is none."""
    path_keys = _path_keys(node, path)
    return None if path_keys is None else node_at(node, path_keys)


def keys(node: Node, path: str) -> list[str | int] | None:
    """The keys and numbers that lead to the node at a path, or None if there is no node.

    A path of a table to look up may end with a row by a cell, `lookups/pins/rows/pin=3`, if no other row has the cell.
    """
    return _path_keys(node, with_number_of_row(node, path))


def _path_keys(node: Node, path: str) -> list[str | int] | None:
    path_keys: list[str | int] = []
    for step in path.split("/"):
        steps = _keys(node, step)
        if steps is None:
            return None
        path_keys += steps
        node = node_at(node, steps)
    return path_keys


def with_number_of_row(tree: Node, path: str) -> str:
    """A path to a row of a table by its number, where a cell names it."""
    table_path, mark, row_name = path.partition("/rows/")
    column, sign, cell = row_name.partition("=")
    table = find(tree, table_path) if mark and sign else None
    if not isinstance(table, Mapping):
        return path
    names = [identity(item) for item in mappings(table.values.get("columns"))]
    rows = [
        number
        for number, row in enumerate(mappings(table.values.get("rows")))
        if isinstance(cells := row.values.get("cells"), Sequence)
        and (column, cell) in zip(names, [getattr(inner, "text", "") for inner in cells.items], strict=False)
    ]
    return f"{table_path}/rows/{rows[0]}" if len(rows) == 1 else path


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
        pair = _inner(node, step)
        if pair is None:
            return None
        key, value = pair
        below = [] if key == step else _keys(value, step)
        return None if below is None else [key, *below]
    return None


def node_at(node: Node, node_keys: list[str | int]) -> Node:
    """The node at some keys."""
    for key in node_keys:
        node = node.items[key] if isinstance(node, Sequence) else node.values[key]  # type: ignore[index, union-attr]
    return node


def schema_path(node_keys: list[str | int]) -> tuple[str, ...]:
    """The keys of the part of the schema that describes the node at some keys of a tree."""
    path: list[str] = []
    for key in node_keys:
        path += ["items"] if isinstance(key, int) else ["properties", key]
    return tuple(path)


def put(node: Node, node_keys: list[str | int], new: Node | None) -> Node:
    """The tree with another node at some keys, or without the item of a list that is there."""
    if not node_keys:
        assert new is not None
        return new
    key, *rest = node_keys
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
    """The tree with the node at a path changed, or None if there is no node."""
    path_keys = _path_keys(node, path)
    new = change(node_at(node, path_keys)) if path_keys is not None else None
    return put(node, path_keys, new) if path_keys is not None and new is not None else None


def _inner(mapping: Mapping, step: str) -> tuple[str, Node] | None:
    """The key under which a step finds its node in a mapping, and that node's holder."""
    if step in mapping.values:
        return step, mapping.values[step]
    checked = mapping.values.get(CHECKED)
    if isinstance(checked, Mapping) and step in checked.values:
        return CHECKED, checked
    for key in LISTS:
        value = mapping.values.get(key)
        if isinstance(value, Sequence) and _index(value, step) is not None:
            return key, value
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
