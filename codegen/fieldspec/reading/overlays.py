"""Versions that are written as changes of others, a file each, and the places that they take on their lines."""

from __future__ import annotations

from collections.abc import Mapping as Table

from fieldspec.classes import dataclass, field
from fieldspec.diagnostics import Diagnostic, Label
from fieldspec.reading.findings import near, quoted
from fieldspec.reading.nodes import Mapping, Scalar, Sequence, identity, mappings
from fieldspec.reading.paths import keys, node_at, put
from fieldspec.reading.yaml_reader import key_span
from fieldspec.source import Span

PARTS = ("adds", "changes", "removes", "renames")
# What a section `overlay` says beyond what a line says of its members.
_ITS_OWN = ("line", "based_on", "after")


@dataclass(slots=True)
class Overlays:
    """The overlays of a device by version, in an order in which each stands behind the one that it is based on.

    `heads` are their sections `overlay`, `bases` the versions that they are based on. `found` is what is wrong with
    how they refer to each other.
    """

    trees: dict[str, Mapping] = field(default_factory=dict)
    heads: dict[str, Mapping] = field(default_factory=dict)
    bases: dict[str, str] = field(default_factory=dict)
    found: list[Diagnostic] = field(default_factory=list)


def overlays(files: Table[str, Mapping], base: Mapping) -> tuple[Overlays, Mapping]:
    """The overlays of a device, given the files of its folder `versions` by name, and the base with their versions."""
    result = Overlays()
    for name, tree in files.items():
        head = tree.values.get("overlay")
        if not isinstance(head, Mapping):
            text = "the key `overlay` is missing"
            result.found.append(
                Diagnostic("missing_key", text, Span(tree.file, 0, 1), help="say which version the file is about")
            )
            continue
        own = _text(head, "id")
        if own != name:
            text = f"the id is {quoted(own)}, the file is `{name}`"
            result.found.append(Diagnostic("id_matches_path", text, head.values["id"].span, help="rename one of them"))
            continue
        for key in tree.values:
            if key not in (*PARTS, "overlay", "accepts"):
                text = f"there is no key `{key}` here"
                help = "a file of the folder `versions` says what a version changes; write new facts under `adds`"
                result.found.append(Diagnostic("unknown_key", text, key_span(tree, key), help=help))
        result.heads[own], result.trees[own] = head, tree
    declared = _declared(base)
    for version, head in result.heads.items():
        if version in declared:
            text = f"the version `{version}` is declared twice"
            label = Label(declared[version].span, "the first one")
            help = "remove it from the list of versions, or remove the file"
            result.found.append(Diagnostic("version_twice", text, head.values["id"].span, (label,), help))
    return _ordered(result, base, declared)


def _declared(base: Mapping) -> dict[str, Scalar]:
    """The ids of the versions that the device lists."""
    found = {}
    for line in mappings(base.values.get("versions")):
        for member in mappings(line.values.get("members")):
            held = member.values.get("id")
            if isinstance(held, Scalar):
                found[held.text] = held
    return found


def _ordered(overlays: Overlays, base: Mapping, declared: Table[str, Scalar]) -> tuple[Overlays, Mapping]:
    """The overlays in order, and the base with their versions in the places that they take on their lines."""
    waiting = {version: head for version, head in overlays.heads.items() if version not in declared}
    known = set(declared)
    ordered: dict[str, Mapping] = {}
    while ready := [v for v, head in waiting.items() if {_text(head, "based_on"), _follows(head)} <= known]:
        for version in ready:
            base, found = _listed(base, waiting.pop(version), ordered)
            overlays.found += found
            known.add(version)
            ordered[version] = overlays.trees[version]
    for version, head in waiting.items():
        for key in ("based_on", "after"):
            named = head.values.get(key)
            if isinstance(named, Scalar) and named.text not in known | waiting.keys():
                text = f"the device has no version {quoted(named.text)}"
                hint = near(named.text, known | waiting.keys())
                overlays.found.append(Diagnostic("version_unknown", text, named.span, help=hint))
                break
        else:
            text = f"the version `{version}` is based on itself, by way of others"
            if _text(head, "based_on") == version:
                text = f"the version `{version}` is based on itself"
            span = head.values["based_on"].span
            overlays.found.append(
                Diagnostic("overlay_cycle", text, span, help="base it on a version that does not need it")
            )
    bases = {version: _text(overlays.heads[version], "based_on") for version in ordered}
    return Overlays(ordered, overlays.heads, bases, overlays.found), base


def _follows(head: Mapping) -> str:
    return _text(head, "after") or _text(head, "based_on")


def _listed(base: Mapping, head: Mapping, others: Table[str, Mapping]) -> tuple[Mapping, list[Diagnostic]]:
    """The base with a version on its line, behind the one that it follows."""
    line = head.values["line"]
    assert isinstance(line, Scalar)
    at = keys(base, f"versions/{line.text}/members")
    if at is None:
        known = [identity(held) or "" for held in mappings(base.values.get("versions"))]
        text = f"the device has no line of versions {quoted(line.text)}"
        return base, [Diagnostic("version_unknown", text, line.span, help=near(line.text, known))]
    members = node_at(base, at)
    assert isinstance(members, Sequence)
    ids = [identity(item) for item in members.items]
    follows = _follows(head)
    if follows not in ids:
        text = f"the line `{line.text}` has no version `{follows}` behind which this one could stand"
        help = "name the version of its own line that it follows, under `after`"
        return base, [Diagnostic("version_unknown", text, head.values["id"].span, help=help)]
    behind = ids.index(follows) + 1
    found = []
    if behind < len(ids) and ids[behind] in others:
        text = f"two versions of the line `{line.text}` follow `{follows}`"
        label = Label(members.items[behind].span, "the other one")
        help = "say under `after` which of them comes first"
        found = [Diagnostic("version_twice", text, head.values["id"].span, (label,), help)]
    for key in _ITS_OWN:
        head = head.without(key)
    items = (*members.items[:behind], head, *members.items[behind:])
    made = put(base, at, Sequence(members.file, members.start, members.end, items))
    assert isinstance(made, Mapping)
    return made, found


def _text(mapping: Mapping, key: str) -> str:
    held = mapping.values.get(key)
    return held.text if isinstance(held, Scalar) else ""
