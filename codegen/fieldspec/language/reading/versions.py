"""Versions of a device: overlays in files of their own, and the facts of one version."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from collections.abc import Mapping as Table
from operator import is_

from fieldspec.foundation.caches import ByIdentity
from fieldspec.foundation.classes import dataclass, field
from fieldspec.foundation.names import folded
from fieldspec.foundation.reserved import file_name_fault
from fieldspec.foundation.source import Span
from fieldspec.language.diagnostics import Diagnostic, Label
from fieldspec.language.reading.findings import near, quoted
from fieldspec.language.reading.nodes import Mapping, Node, Scalar, Sequence, identity, keys, mappings, node_at, put
from fieldspec.language.reading.yaml_reader import key_span

PARTS = ("adds", "changes", "removes", "renames")
# What a section `overlay` says beyond what a line says of its members.
_VERSION_KEYS = ("line", "based_on", "after")


@dataclass(slots=True)
class Overlays:
    """The overlays of a device by version, each after the one that it is based on.

    `heads` are their sections `overlay`, `bases` the versions that they are based on. `findings` is what is wrong with
    how they refer to each other.
    """

    trees: dict[str, Mapping] = field(default_factory=dict)
    heads: dict[str, Mapping] = field(default_factory=dict)
    bases: dict[str, str] = field(default_factory=dict)
    findings: list[Diagnostic] = field(default_factory=list)


def overlays(files: Table[str, Mapping], base: Mapping) -> tuple[Overlays, Mapping]:
    """The overlays of a device, given the files of its folder `versions` by name, and the base with their versions."""
    result = Overlays()
    for name, tree in files.items():
        head = tree.values.get("overlay")
        if not isinstance(head, Mapping):
            text = "the key `overlay` is missing"
            result.findings.append(
                Diagnostic("missing_key", text, Span(tree.file, 0, 1), help="state which version the file describes")
            )
            continue
        own = _scalar_text(head, "id")
        if own != name:
            text = f"the id is {quoted(own)}, the file is `{name}`"
            result.findings.append(
                Diagnostic("id_matches_path", text, head.values["id"].span, help="rename one of them")
            )
            continue
        for key in tree.values:
            if key not in (*PARTS, "overlay", "accepts"):
                text = f"there is no key `{key}` here"
                help = "a file in the folder `versions` states the changes of a version; write new facts under `adds`"
                result.findings.append(Diagnostic("unknown_key", text, key_span(tree, key), help=help))
        result.heads[own], result.trees[own] = head, tree
    declared = _declared(base)
    for version, head in result.heads.items():
        if version in declared:
            text = f"the version `{version}` is declared twice"
            label = Label(declared[version].span, "the first one")
            help = "remove it from the list of versions, or remove the file"
            result.findings.append(Diagnostic("version_twice", text, head.values["id"].span, (label,), help))
    return _ordered(result, base, declared)


def unportable(base: Mapping, versions: Iterable[str]) -> Iterator[Diagnostic]:
    """Finds versions for which outputs are written, but whose files some file systems cannot have."""
    folded_ids: dict[str, str] = {}
    for version, node in ((version, node) for version, node in _declared(base).items() if version in versions):
        fault = file_name_fault(version)
        other = folded_ids.setdefault(folded(version), version)
        if other != version:
            fault = f"differs from `{other}` in capital letters alone: Windows and macOS have one file for both"
        if fault:
            text = f"the version {quoted(version)} {fault}"
            yield Diagnostic("file_name_portable", text, node.span, help="choose another name")


def _declared(base: Mapping) -> dict[str, Scalar]:
    """The ids of the versions that the device lists."""
    identifiers = {}
    for line in mappings(base.values.get("versions")):
        for member in mappings(line.values.get("members")):
            identifier = member.values.get("id")
            if isinstance(identifier, Scalar):
                identifiers[identifier.text] = identifier
    return identifiers


def _ordered(overlays: Overlays, base: Mapping, declared: Table[str, Scalar]) -> tuple[Overlays, Mapping]:
    """The overlays in order, and the base with their versions in the places that they take on their lines."""
    waiting = {version: head for version, head in overlays.heads.items() if version not in declared}
    known = set(declared)
    ordered: dict[str, Mapping] = {}
    while ready := [v for v, head in waiting.items() if {_scalar_text(head, "based_on"), _follows(head)} <= known]:
        for version in ready:
            base, findings = _with_version(base, waiting.pop(version), ordered)
            overlays.findings += findings
            known.add(version)
            ordered[version] = overlays.trees[version]
    for version, head in waiting.items():
        for key in ("based_on", "after"):
            reference = head.values.get(key)
            if isinstance(reference, Scalar) and reference.text not in known | waiting.keys():
                text = f"the device has no version {quoted(reference.text)}"
                hint = near(reference.text, known | waiting.keys())
                overlays.findings.append(Diagnostic("version_unknown", text, reference.span, help=hint))
                break
        else:
            text = f"the version `{version}` is based on itself, through others"
            if _scalar_text(head, "based_on") == version:
                text = f"the version `{version}` is based on itself"
            span = head.values["based_on"].span
            overlays.findings.append(
                Diagnostic("overlay_cycle", text, span, help="base it on a version that does not depend on it")
            )
    bases = {version: _scalar_text(overlays.heads[version], "based_on") for version in ordered}
    return Overlays(ordered, overlays.heads, bases, overlays.findings), base


def _follows(head: Mapping) -> str:
    return _scalar_text(head, "after") or _scalar_text(head, "based_on")


def _with_version(base: Mapping, head: Mapping, earlier_heads: Table[str, Mapping]) -> tuple[Mapping, list[Diagnostic]]:
    """The base with a version on its line, after the one that it follows."""
    line = head.values["line"]
    assert isinstance(line, Scalar)
    members_keys = keys(base, f"versions/{line.text}/members")
    if members_keys is None:
        known = [identity(version_node) or "" for version_node in mappings(base.values.get("versions"))]
        text = f"the device has no version line {quoted(line.text)}"
        return base, [Diagnostic("version_unknown", text, line.span, help=near(line.text, known))]
    members = node_at(base, members_keys)
    assert isinstance(members, Sequence)
    ids = [identity(item) for item in members.items]
    follows = _follows(head)
    if follows not in ids:
        text = f"the line `{line.text}` has no version `{follows}` for this version to follow"
        help = "name the version of its own line that it follows, under `after`"
        return base, [Diagnostic("version_unknown", text, head.values["id"].span, help=help)]
    position = ids.index(follows) + 1
    findings = []
    if position < len(ids) and ids[position] in earlier_heads:
        text = f"two versions of the line `{line.text}` follow `{follows}`"
        label = Label(members.items[position].span, "the other one")
        help = "state under `after` which of them comes first"
        findings = [Diagnostic("version_twice", text, head.values["id"].span, (label,), help)]
    for key in _VERSION_KEYS:
        head = head.without(key)
    items = (*members.items[:position], head, *members.items[position:])
    result = put(base, members_keys, Sequence(members.file, members.start, members.end, items))
    assert isinstance(result, Mapping)
    return result, findings


def _scalar_text(mapping: Mapping, key: str) -> str:
    scalar = mapping.values.get(key)
    return scalar.text if isinstance(scalar, Scalar) else ""


LONE_VERSION = "1"

BOUNDS = frozenset(("since", "until", "only"))
_FREE = frozenset(("inferred", "printed", "allow", "values"))


class Lines:
    """The version lines of a device: the line of a version, and its position there."""

    def __init__(self, tree: Mapping) -> None:
        self.place: dict[str, tuple[int, int]] = {}
        self.built: list[str] = []
        self.alike: dict[str, Scalar] = {}
        """By version, the line with outputs that its own line is like."""
        self.findings: list[Diagnostic] = []
        self._unbounded: ByIdentity[Node, bool] = ByIdentity()
        lines = tree.values.get("versions")
        for number, line in enumerate(lines.items if isinstance(lines, Sequence) else ()):
            if isinstance(line, Mapping):
                self._add(number, line)
        built = [identity(line) or "" for line in mappings(lines) if _true(line, "builds")]
        for line_name in {id(scalar): scalar for scalar in self.alike.values()}.values():
            if line_name.text not in built:
                text = f"no version line with outputs has the name {quoted(line_name.text)}"
                self.findings.append(
                    Diagnostic("version_unknown", text, line_name.span, help=near(line_name.text, built))
                )

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
                self.findings.append(Diagnostic("version_twice", text, node.span, help="use a different identifier"))
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
        """Whether a fact applies to a version, or to several of different lines. Bounds on other lines do not count."""
        return all(self._holds(node, version) for version in versions)

    def _holds(self, node: Mapping, version: str) -> bool:
        if version not in self.place:
            return True
        line, order = self.place[version]
        for key, wrong in (("since", 1), ("until", -1)):
            for bound in named(node.values.get(key)):
                other, bound_order = self.place.get(bound.text, (None, 0))
                if other == line and (bound_order - order) * wrong > 0:
                    return False
        only = [bound.text for bound in named(node.values.get("only"))]
        same = [other for other in only if self.place.get(other, (None, 0))[0] == line]
        return not same or version in same

    def selected(self, node: Node, versions: tuple[str, ...]) -> Node:
        """The tree with only the facts that apply to a version, or to several of different lines."""
        return self._picked(node, lambda fact: self.holds(fact, versions))

    def reached(self, tree: Node, base: str, version: str) -> Node:
        """The tree of a version as the base of another one on its line: without the facts that apply to neither."""
        lines = {self.place.get(identifier, (None,))[0] for identifier in (base, version)}
        if len(lines) > 1:
            return tree
        return self._picked(tree, lambda fact: self._holds(fact, base) or self._holds(fact, version))

    def _picked(self, node: Node, holds: Callable[[Mapping], bool]) -> Node:
        """The tree without some facts. A part without bounds is the same for all versions, and searched once."""
        if isinstance(node, Scalar) or node in self._unbounded:
            return node
        below = tuple(node.values.values()) if isinstance(node, Mapping) else node.items
        remaining = below
        if isinstance(node, Sequence):
            remaining = tuple([i for i in below if not isinstance(i, Mapping) or i in self._unbounded or holds(i)])
        picked = tuple([self._picked(item, holds) for item in remaining])
        if self._free(node, below):
            self._unbounded[node] = True
        if len(picked) == len(below) and all(map(is_, picked, below)):
            return node
        if isinstance(node, Sequence):
            return Sequence(node.file, node.start, node.end, picked)
        return Mapping(node.file, node.start, node.end, dict(zip(node.values, picked, strict=True)), node.keys)

    def _free(self, node: Mapping | Sequence, below: tuple[Node, ...]) -> bool:
        if isinstance(node, Mapping) and not BOUNDS.isdisjoint(node.values):
            return False
        return all(isinstance(item, Scalar) or item in self._unbounded for item in below)

    def unknown(self, node: Node) -> list[Diagnostic]:
        """A finding for every `since`, `until` or `only` that names no declared version."""
        findings: list[Diagnostic] = []
        if not isinstance(node, Scalar):
            self._search(node, findings)
        return findings

    def _search(self, node: Mapping | Sequence, findings: list[Diagnostic], holders: tuple[Mapping, ...] = ()) -> bool:
        """Adds the findings of a part of a tree, and notes whether it has no bounds, which versions then need not.

        `holders` are the facts with bounds that hold it.
        """
        free = True
        values: Iterable[Node]
        if isinstance(node, Mapping):
            values = node.values.values()
            if not BOUNDS.isdisjoint(node.values):
                free = False
                findings += self._misnamed(node)
                findings += self._never(node, holders)
                holders = (*holders, node)
            if not _FREE.isdisjoint(node.values):
                free = False  # bounds in there are not searched here
                values = [value for key, value in node.values.items() if key not in _FREE]
        else:
            values = node.items
        for item in values:
            if not isinstance(item, Scalar) and not self._search(item, findings, holders):
                free = False
        if free:
            self._unbounded[node] = True
        return free

    def _never(self, node: Mapping, holders: tuple[Mapping, ...]) -> Iterator[Diagnostic]:
        """A finding where no version of a line that a fact names is within its bounds and the bounds of its parents."""
        bounds = [key for key in ("since", "until", "only") if key in node.values]
        if len(bounds) + len(holders) < 2:
            return
        own = {self.place.get(bound.text, (None,))[0] for key in bounds for bound in named(node.values[key])}
        for line in own - {None}:
            versions = [version for version, (other, _) in self.place.items() if other == line]
            outer = [version for version in versions if self._all_hold(holders, version)]
            if outer and not any(self._holds(node, version) for version in outer):
                text = f"no version is within {' and '.join(f'`{key}`' for key in bounds)}"
                if any(self._holds(node, version) for version in versions):
                    text += " and the bounds of what holds this"
                help = "correct the bounds, or remove the entry"
                yield Diagnostic("version_never", text, node.values[bounds[0]].span, help=help)
                return

    def _all_hold(self, facts: tuple[Mapping, ...], version: str) -> bool:
        return all(self._holds(fact, version) for fact in facts)

    def unreached(self, overlay: Mapping, version: str, bases: Table[str, str]) -> list[Diagnostic]:
        """A finding for each fact that an overlay adds, and that neither its version nor one based on it has."""
        reached = {version}
        while further := {other for other, base in bases.items() if base in reached} - reached:
            reached |= further
        findings = []
        for entry in mappings(overlay.values.get("adds")):
            item = entry.values.get("item")
            if isinstance(item, Mapping) and not any(self._holds(item, other) for other in reached):
                key = next(key for key in ("since", "until", "only") if key in item.values)
                text = f"`{key}` leaves {quoted(identity(item) or '')} out of the version `{version}`, which adds it"
                help = f"remove `{key}`, or add the fact in the file of another version"
                findings.append(Diagnostic("overlay_changes_nothing", text, item.values[key].span, help=help))
        return findings

    def _misnamed(self, node: Mapping) -> Iterator[Diagnostic]:
        for key in ("since", "until", "only"):
            for item in named(node.values.get(key)):
                if item.text not in self.place:
                    text = f"the device declares no version {quoted(item.text)}"
                    hint = near(item.text, self.place)
                    yield Diagnostic("version_unknown", text, item.span, help=hint)


def _true(line: Mapping, key: str) -> bool:
    scalar = line.values.get(key)
    return isinstance(scalar, Scalar) and scalar.value is True


def named(bound: Node | None) -> list[Scalar]:
    """The versions that a bound names: one, or a list of them."""
    items = bound.items if isinstance(bound, Sequence) else (bound,)
    return [item for item in items if isinstance(item, Scalar)]


def selected(node: Node, versions: tuple[str, ...], lines: Lines) -> Node:
    """The tree with only the facts that apply to a version, or to several of different lines."""
    return lines.selected(node, versions)
