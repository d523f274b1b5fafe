"""The tree of a YAML file. Every value keeps its place; keys are looked up in the text when their place is asked for.

Nobody changes a node that is built. They are not frozen, because frozen ones take five times as long to build, and
most of a short run is reading.
"""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal
from typing import TypeAlias

from fieldspec.classes import dataclass, field
from fieldspec.source import SourceFile, Span

Plain: TypeAlias = bool | int | Decimal | str | None


@dataclass(slots=True)
class Scalar:
    """A scalar: its text, whether it was quoted, and its value once the schema has typed it."""

    file: SourceFile
    start: int
    end: int
    text: str
    quoted: bool
    value: Plain = None

    @property
    def span(self) -> Span:
        """Where it stands."""
        return Span(self.file, self.start, self.end)


@dataclass(slots=True)
class Sequence:
    """A list of nodes."""

    file: SourceFile
    start: int
    end: int
    items: tuple[Node, ...]

    @property
    def span(self) -> Span:
        """Where it stands."""
        return Span(self.file, self.start, self.end)


@dataclass(slots=True)
class Mapping:
    """Nodes by key, in the order of the file. The keys stand in the text of the mapping, but for those of `keys`.

    `keys` has, by key, the mapping in whose text it stands, or the place that stands for it.
    """

    file: SourceFile
    start: int
    end: int
    values: dict[str, Node]
    keys: dict[str, Scalar | Mapping] = field(default_factory=lambda: ALL_THERE)

    @property
    def span(self) -> Span:
        """Where it stands."""
        return Span(self.file, self.start, self.end)

    def holder(self, key: str) -> Scalar | Mapping:
        """The mapping in whose text a key stands, or the place that stands for it."""
        return self.keys.get(key, self)

    def with_value(self, key: str, value: Node) -> Mapping:
        """The same mapping with one value set."""
        keys = self.keys
        if key not in self.values:
            keys = {**keys, key: Scalar(value.file, value.start, value.end, key, False, key)}
        return Mapping(self.file, self.start, self.end, {**self.values, key: value}, keys)

    def with_entry(self, key: str, value: Node, holder: Mapping) -> Mapping:
        """The same mapping with the key and the value of another one."""
        keys = {**self.keys, key: holder.holder(key)}
        return Mapping(self.file, self.start, self.end, {**self.values, key: value}, keys)

    def without(self, key: str) -> Mapping:
        """The same mapping without one key."""
        values = {k: v for k, v in self.values.items() if k != key}
        return Mapping(self.file, self.start, self.end, values, self.keys)


ALL_THERE: dict[str, Scalar | Mapping] = {}
"""The `keys` of a mapping whose keys all stand in its text, which is nearly every one."""

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
            held = node.values.get(key)
            if isinstance(held, Scalar):
                return held.text
    return None


def mappings(node: Node | None) -> Iterator[Mapping]:
    """The mappings of a list."""
    for item in node.items if isinstance(node, Sequence) else ():
        if isinstance(item, Mapping):
            yield item


def copied(node: Node) -> Node:
    """The same node once more, so that it can be typed in another way."""
    if isinstance(node, Scalar):
        return Scalar(node.file, node.start, node.end, node.text, node.quoted, node.value)
    if isinstance(node, Sequence):
        return Sequence(node.file, node.start, node.end, tuple([copied(item) for item in node.items]))
    values = {key: copied(value) for key, value in node.values.items()}
    return Mapping(node.file, node.start, node.end, values, node.keys)


def plain(node: Node) -> object:
    """The node as plain Python data; decimals become floats, for validation only."""
    if isinstance(node, Scalar):
        return float(node.value) if isinstance(node.value, Decimal) else node.value
    if isinstance(node, Sequence):
        return [plain(item) for item in node.items]
    return {key: plain(value) for key, value in node.values.items()}


def exact(node: Node) -> object:
    """The node as plain Python data with exact decimals."""
    if isinstance(node, Scalar):
        return node.value
    if isinstance(node, Sequence):
        return [exact(item) for item in node.items]
    return {key: exact(value) for key, value in node.values.items()}
