"""Picks the facts of one version from a device's tree."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from operator import is_

from fieldspec.diagnostics import Diagnostic
from fieldspec.reading.findings import near, quoted
from fieldspec.reading.nodes import Mapping, Node, Scalar, Sequence, identity, mappings

LONE_VERSION = "1"

BOUNDS = frozenset(("since", "until", "only"))
_FREE = frozenset(("inferred", "printed", "allow", "values"))


class Lines:
    """The version lines of a device: which line a version is on, and where in its order."""

    def __init__(self, tree: Mapping) -> None:
        self.place: dict[str, tuple[int, int]] = {}
        self.built: list[str] = []
        self.alike: dict[str, Scalar] = {}
        """By version, the line with outputs that its own line is like."""
        self.found: list[Diagnostic] = []
        self._unbounded: dict[int, Node] = {}
        lines = tree.values.get("versions")
        for number, line in enumerate(lines.items if isinstance(lines, Sequence) else ()):
            if isinstance(line, Mapping):
                self._add(number, line)
        built = [identity(line) or "" for line in mappings(lines) if _true(line, "builds")]
        for named in {id(one): one for one in self.alike.values()}.values():
            if named.text not in built:
                text = f"the device has no line of versions with outputs that is called {quoted(named.text)}"
                self.found.append(Diagnostic("version_unknown", text, named.span, help=near(named.text, built)))

    def _add(self, number: int, line: Mapping) -> None:
        members = line.values.get("members")
        ids = [
            node
            for item in (members.items if isinstance(members, Sequence) else ())
            if isinstance(item, Mapping) and isinstance(node := item.values.get("id"), Scalar)
        ]
        for order, node in enumerate(ids):
            if node.text in self.place:
                text = f"the version `{node.text}` is declared twice"
                self.found.append(Diagnostic("version_twice", text, node.span, help="give it an identifier of its own"))
            self.place[node.text] = (number, order)
        like = line.values.get("like")
        if _true(line, "builds"):
            self.built += [node.text for node in ids]
        elif isinstance(like, Scalar):
            self.alike |= {node.text: like for node in ids}

    def versions(self) -> list[str]:
        """The versions that outputs are written for, the oldest first."""
        return self.built or [LONE_VERSION]

    def holds(self, node: Mapping, versions: tuple[str, ...]) -> bool:
        """Whether a fact holds for a version, or for several of different lines. Other lines decide nothing here."""
        return all(self._holds(node, version) for version in versions)

    def _holds(self, node: Mapping, version: str) -> bool:
        if version not in self.place:
            return True
        line, order = self.place[version]
        for key, wrong in (("since", 1), ("until", -1)):
            for bound in named(node.values.get(key)):
                other, at = self.place.get(bound.text, (None, 0))
                if other == line and (at - order) * wrong > 0:
                    return False
        listed = [bound.text for bound in named(node.values.get("only"))]
        same = [other for other in listed if self.place.get(other, (None, 0))[0] == line]
        return not same or version in same

    def selected(self, node: Node, versions: tuple[str, ...]) -> Node:
        """The tree without the facts that do not hold for a version, or for several of different lines."""
        return self._picked(node, lambda fact: self.holds(fact, versions))

    def reached(self, tree: Node, base: str, version: str) -> Node:
        """The tree of a version that another one on its line is made of: without what holds for neither of them."""
        lines = {self.place.get(one, (None,))[0] for one in (base, version)}
        if len(lines) > 1:
            return tree
        return self._picked(tree, lambda fact: self._holds(fact, base) or self._holds(fact, version))

    def _picked(self, node: Node, holds: Callable[[Mapping], bool]) -> Node:
        """The tree without some facts. A part without bounds is the same for all versions; it is seen through once."""
        if isinstance(node, Scalar) or id(node) in self._unbounded:
            return node
        below = tuple(node.values.values()) if isinstance(node, Mapping) else node.items
        kept = below
        if isinstance(node, Sequence):
            kept = tuple([item for item in below if not isinstance(item, Mapping) or holds(item)])
        made = tuple([self._picked(item, holds) for item in kept])
        if self._free(node, below):
            self._unbounded[id(node)] = node  # keeping the node keeps its id from being given to another one
        if len(made) == len(below) and all(map(is_, made, below)):
            return node
        if isinstance(node, Sequence):
            return Sequence(node.file, node.start, node.end, made)
        return Mapping(node.file, node.start, node.end, dict(zip(node.values, made, strict=True)), node.keys)

    def _free(self, node: Mapping | Sequence, below: tuple[Node, ...]) -> bool:
        if isinstance(node, Mapping) and not BOUNDS.isdisjoint(node.values):
            return False
        return all(isinstance(item, Scalar) or id(item) in self._unbounded for item in below)

    def unknown(self, node: Node) -> list[Diagnostic]:
        """A finding for every `since`, `until` or `only` that names no declared version."""
        found: list[Diagnostic] = []
        if not isinstance(node, Scalar):
            self._search(node, found)
        return found

    def _search(self, node: Mapping | Sequence, found: list[Diagnostic]) -> bool:
        """Adds the findings of a part of a tree, and notes whether it has no bounds, which versions then need not."""
        free = True
        values: Iterable[Node]
        if isinstance(node, Mapping):
            values = node.values.values()
            if not BOUNDS.isdisjoint(node.values):
                free = False
                found += self._misnamed(node)
            if not _FREE.isdisjoint(node.values):
                free = False  # what stands there is not looked at here
                values = [value for key, value in node.values.items() if key not in _FREE]
        else:
            values = node.items
        for item in values:
            if not isinstance(item, Scalar) and not self._search(item, found):
                free = False
        if free:
            self._unbounded[id(node)] = node  # keeping the node keeps its id from being given to another one
        return free

    def _misnamed(self, node: Mapping) -> Iterator[Diagnostic]:
        for key in ("since", "until", "only"):
            for item in named(node.values.get(key)):
                if item.text not in self.place:
                    text = f"the device declares no version {quoted(item.text)}"
                    hint = near(item.text, self.place)
                    yield Diagnostic("version_unknown", text, item.span, help=hint)


def _true(line: Mapping, key: str) -> bool:
    held = line.values.get(key)
    return isinstance(held, Scalar) and held.value is True


def named(bound: Node | None) -> list[Scalar]:
    """The versions that a bound names: one, or a list of them."""
    items = bound.items if isinstance(bound, Sequence) else (bound,)
    return [item for item in items if isinstance(item, Scalar)]


def selected(node: Node, versions: tuple[str, ...], lines: Lines) -> Node:
    """The tree without the facts that do not hold for a version, or for several of different lines."""
    return lines.selected(node, versions)
