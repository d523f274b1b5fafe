"""Paths that lead to facts, under the new names of facts on them."""

from __future__ import annotations

from fieldspec.language.reading.nodes import Mapping, Node, Scalar, Sequence, keys, node_at

_STEPS = ("write", "set", "clear", "pulse", "send", "read", "wait", "timeout")
_PATHS = ("fact", "about", "references", "saved_by", "opposite_of", "sum_of", "within", "limit", *_STEPS)
_WORDS = ("flags", "enum", "record")
"""The keys that name the fact in which a path continues after a register or a field."""


class RenamedPaths:
    """Paths of the base under new names, which are stated by the paths of the base."""

    def __init__(self, tree: Mapping, names: dict[str, str]) -> None:
        self._tree, self._names = tree, names

    def renamed(self, node: Node, everywhere: bool, key: str = "") -> Node:
        """A part of the tree with its paths under the new names: those in keys too where they stand `everywhere`."""
        if isinstance(node, Sequence):
            items = tuple([self.renamed(item, everywhere, key) for item in node.items])
            same = all(new is old for new, old in zip(items, node.items, strict=True))
            return node if same else Sequence(node.file, node.start, node.end, items)
        if isinstance(node, Mapping):
            values = {
                self._path(name) if everywhere else name: self.renamed(value, everywhere, name)
                for name, value in node.values.items()
            }
            same = all(values.get(name) is value for name, value in node.values.items())
            return node if same else Mapping(node.file, node.start, node.end, values, node.keys)
        return with_text(node, self._path(node.text)) if everywhere or key in _PATHS else node

    def _path(self, text: str) -> str:
        """A path under the new names. An element of a list has its number after its name."""
        old, new = "", []
        for step in text.split("/"):
            name, mark, index = step.partition("[")
            known = self._names.get(f"{old}/{name}") or self._names.get(f"{self._word(old)}/{name}", name)
            new.append(f"{known}{mark}{index}")
            old = f"{old}/{name}" if old else name
        return "/".join(new) if old.partition("/")[0] in self._tree.values else text

    def _word(self, path: str) -> str:
        """The path of the word of flags, the enum or the record of what is at a path; empty where it has none."""
        node_keys = keys(self._tree, path) if "/" in path else None
        node = node_at(self._tree, node_keys) if node_keys is not None else None
        stated = [(key, node.values[key]) for key in _WORDS if key in node.values] if isinstance(node, Mapping) else []
        return next((f"{key.removesuffix('s')}s/{name.text}" for key, name in stated if isinstance(name, Scalar)), "")


def with_text(node: Node, text: str) -> Node:
    """A scalar with another text."""
    if not isinstance(node, Scalar) or node.text == text:
        return node
    return Scalar(node.file, node.start, node.end, text, node.quoted, text)
