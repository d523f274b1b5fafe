"""Picks the facts of one version from a device's tree."""

from __future__ import annotations

from fieldspec.diagnostics import Diagnostic
from fieldspec.reading.findings import near, quoted
from fieldspec.reading.nodes import Mapping, Node, Scalar, Sequence, children

LONE_VERSION = "1"

_FREE = ("inferred", "printed", "allow", "values")


class Lines:
    """The version lines of a device: which line a version is on, and where in its order."""

    def __init__(self, tree: Mapping) -> None:
        self.place: dict[str, tuple[int, int]] = {}
        self.built: list[str] = []
        self.found: list[Diagnostic] = []
        lines = tree.values.get("versions")
        for number, line in enumerate(lines.items if isinstance(lines, Sequence) else ()):
            if isinstance(line, Mapping):
                self._add(number, line)

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
        builds = line.values.get("builds")
        if isinstance(builds, Scalar) and builds.value is True:
            self.built += [node.text for node in ids]

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

    def unknown(self, node: Node) -> list[Diagnostic]:
        """A finding for every `since`, `until` or `only` that names no declared version."""
        found = []
        if isinstance(node, Mapping):
            for key in ("since", "until", "only"):
                for item in named(node.values.get(key)):
                    if item.text not in self.place:
                        text = f"the device declares no version {quoted(item.text)}"
                        hint = near(item.text, self.place)
                        found.append(Diagnostic("version_unknown", text, item.span, help=hint))
        for step, inner in children(node):
            if step not in _FREE:
                found += self.unknown(inner)
        return found


def named(bound: Node | None) -> list[Scalar]:
    """The versions that a bound names: one, or a list of them."""
    items = bound.items if isinstance(bound, Sequence) else (bound,)
    return [item for item in items if isinstance(item, Scalar)]


def selected(node: Node, versions: tuple[str, ...], lines: Lines) -> Node:
    """The tree without the facts that do not hold for a version, or for several of different lines."""
    if isinstance(node, Sequence):
        items = tuple(
            selected(item, versions, lines)
            for item in node.items
            if not isinstance(item, Mapping) or lines.holds(item, versions)
        )
        return Sequence(node.file, node.start, node.end, items)
    if isinstance(node, Mapping):
        values = {key: selected(value, versions, lines) for key, value in node.values.items()}
        return Mapping(node.file, node.start, node.end, node.keys, values)
    return node
