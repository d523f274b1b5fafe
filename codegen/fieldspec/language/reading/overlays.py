"""Applies a version overlay to the tree that it is based on."""

from __future__ import annotations

import json

from fieldspec.foundation.classes import dataclass
from fieldspec.language.diagnostics import Diagnostic, Label
from fieldspec.language.reading.findings import near, quoted
from fieldspec.language.reading.nodes import (
    LISTS,
    Mapping,
    Node,
    Scalar,
    Sequence,
    exact,
    identity,
    keys,
    mappings,
    node_at,
    put,
    schema_path,
)
from fieldspec.language.reading.references import Reference, references
from fieldspec.language.reading.removals import RemovedFact, removal_findings, removed_changes
from fieldspec.language.reading.renamed_paths import RenamedPaths, with_text
from fieldspec.language.reading.scalars import part_at, typed_at
from fieldspec.language.schema import schema

OVERLAY_PARTS = ("changes", "removes", "adds", "renames")
"""The lists of an overlay, in the order in which they are applied."""

# The keys by which the rows of lists are in order.
_ORDERED_BY = ("at", "number", "value", "bit", "base")
_OF_ALL_VERSIONS = frozenset(("accepts", "audit", "reviews", "uses", "versions"))
"""Sections that are not of one version, so that no overlay changes them."""
_JUDGING = frozenset(("accepts", "audit", "reviews"))
"""Sections whose names other versions share."""


def applied(tree: Mapping, overlay: Mapping) -> tuple[Mapping, list[Diagnostic]]:
    """The tree of a version, from the tree of its base and its overlay, and the findings where these do not fit.

    All paths are of the base: names change last, all at once.
    """
    work = _Application(tree)
    for part, apply in zip(OVERLAY_PARTS, (work.change, work.remove, work.add, work.rename), strict=True):
        for entry in mappings(overlay.values.get(part)):
            apply(entry)
    work.refer()
    work.findings += [*removed_changes(tree, overlay), *removal_findings(work.tree, work.removed)]
    return _stating(_accepting(work.tree, overlay), overlay), work.findings


def _accepting(tree: Mapping, overlay: Mapping) -> Mapping:
    """The tree with the changes that an overlay accepts; they come with its version."""
    own = overlay.values.get("accepts")
    head = overlay.values["overlay"]
    if not isinstance(own, Sequence) or not isinstance(head, Mapping):
        return tree
    entries = tuple(entry.with_value("since", head.values["id"]) for entry in mappings(own))
    existing = tree.values.get("accepts")
    before = existing.items if isinstance(existing, Sequence) else ()
    return tree.with_value("accepts", Sequence(own.file, own.start, own.end, (*before, *entries)))


def _stating(tree: Mapping, overlay: Mapping) -> Mapping:
    """The tree with the entries of an overlay, in one list after the entries of the versions that it is based on."""
    before = tree.values.get("changes")
    entries = [*before.items] if isinstance(before, Sequence) else []
    for part in OVERLAY_PARTS:
        for entry in mappings(overlay.values.get(part)):
            kind = Scalar(entry.file, entry.start, entry.end, part, False, part)
            entries.append(entry.with_value("kind", kind))
    return tree.with_value("changes", Sequence(overlay.file, overlay.start, overlay.end, tuple(entries)))


class _Application:
    """A tree while the entries of an overlay are applied to it, one after the other."""

    def __init__(self, tree: Mapping) -> None:
        self.tree = tree
        self.new_names: dict[tuple[str | int, ...], _NewName] = {}
        self.findings: list[Diagnostic] = []
        self.removed: list[RemovedFact] = []

    def _refuse(self, code: str, text: str, node: Node, help: str, *labels: Label) -> None:
        self.findings.append(Diagnostic(code, text, node.span, labels, help))

    def _keys_and_fact(self, entry: Mapping, key: str = "fact") -> tuple[list[str | int], Node] | None:
        """The keys of the fact that an entry is about, and the fact. A missing fact is a finding."""
        path = entry.values[key]
        assert isinstance(path, Scalar)
        section = path.text.partition("/")[0]
        if section in _OF_ALL_VERSIONS:
            text = f"`{section}` is that of the device, not of a version"
            self._refuse("overlay_fact_missing", text, path, "change it in the files of the device")
            return None
        node_keys = keys(self.tree, path.text)
        if node_keys is None:
            self._refuse(
                "overlay_fact_missing",
                f"there is no fact {quoted(path.text)} in the base version",
                path,
                _near_path(self.tree, path.text),
            )
            return None
        return node_keys, node_at(self.tree, node_keys)

    def _put(self, node_keys: list[str | int], new: Node | None) -> None:
        tree = put(self.tree, node_keys, new)
        assert isinstance(tree, Mapping)
        self.tree = tree

    def change(self, entry: Mapping) -> None:
        """Sets keys of a fact, if they have the values that the entry expects."""
        place = self._keys_and_fact(entry)
        if place is None:
            return
        node_keys, fact = place
        if not isinstance(fact, Mapping):
            self._refuse("overlay_fact_missing", "this is not a fact", entry.values["fact"], "name a fact, not a list")
            return
        keys_set = entry.values["set"]
        assert isinstance(keys_set, Mapping)
        if node_keys == ["device"] and "id" in keys_set.values:
            text = "all versions have the id of the device"
            self._refuse("id_matches_path", text, keys_set.values["id"], "remove `id`")
            return
        new, sound = fact, True
        for key, pair in keys_set.values.items():
            assert isinstance(pair, Mapping)
            was, now = pair.values["was"], pair.values["is"]
            old = fact.values.get(key)
            if not self._was(key, was, old, fact, node_keys):
                sound = False
            elif _is_same_node(was, now):
                text = f"`{key}` does not change"
                self._refuse("overlay_changes_nothing", text, pair, "state another value, or remove the entry")
                sound = False
            elif _absent(now):
                new = new.without(key)
            else:
                new = new.with_entry(key, now, keys_set)
        if sound:
            self._typed(node_keys, new)

    def _was(self, key: str, was: Node, old: Node | None, fact: Node, node_keys: list[str | int]) -> bool:
        """Whether a key had the value that an entry expects; if not, a finding shows both places."""
        if _absent(was) and old is None:
            return True
        part = schema_path(node_keys)
        known = key in part_at(part).get("properties", {})
        if not known:
            return True  # the schema says that there is no such key
        if old is not None and not _absent(was) and exact(typed_at(was, (*part, "properties", key))[0]) == exact(old):
            return True
        state = f"is {quoted(_node_text(old))}" if old is not None else "is absent"
        text = f"`{key}` {state} in the base version, but `was` is {quoted(_node_text(was))}"
        label = Label((old or fact).span, "the value in the base version" if old is not None else "the fact")
        right = quoted(f"was: {_node_text(old) if old is not None else '~'}")
        help = f"write {right}; if the base has changed since, decide which value is right now"
        self._refuse("overlay_base_differs", text, was, help, label)
        return False

    def _typed(self, node_keys: list[str | int], new: Mapping) -> None:
        """Puts a mapping at some keys, typed by the schema."""
        node, findings = typed_at(new, schema_path(node_keys))
        self.findings += findings
        if not findings:
            self._put(node_keys, node)

    def remove(self, entry: Mapping) -> None:
        """Takes a fact out of its list."""
        place = self._keys_and_fact(entry)
        if place is None:
            return
        if not isinstance(place[0][-1], int):
            self._refuse("overlay_fact_missing", "this is not a fact", entry.values["fact"], "name an item of a list")
            return
        node_keys, fact = place
        holder = node_at(self.tree, node_keys[:2])
        self._put(node_keys, None)
        path = entry.values["fact"]
        assert isinstance(path, Scalar)
        self.removed.append(RemovedFact(path, fact, holder))

    def rename(self, entry: Mapping) -> None:
        """Gives a fact another name, wherever the spec refers to it."""
        place = self._keys_and_fact(entry)
        if place is None:
            return
        node_keys, fact = place
        to, path = entry.values["to"], entry.values["fact"]
        assert isinstance(to, Scalar)
        assert isinstance(path, Scalar)
        if not isinstance(fact, Mapping) or "name" not in fact.values:
            self._refuse("overlay_fact_missing", "this fact has no name", path, "name a fact that has one")
            return
        if to.text == identity(fact) or tuple(node_keys) in self.new_names:
            self._refuse("overlay_changes_nothing", f"{quoted(to.text)} is not a new name", to, "state one other name")
            return
        self.new_names[tuple(node_keys)] = _NewName(path.text, to)

    def refer(self) -> None:
        """Gives facts their new names, wherever the spec refers to them."""
        self._drop_taken_names()
        if not self.new_names:
            return
        for node_keys in sorted(self.new_names, key=len, reverse=True):
            fact = node_at(self.tree, [*node_keys])
            assert isinstance(fact, Mapping)
            self._put([*node_keys], fact.with_value("name", fact.values["name"]))  # it is no longer that of an alias
        targets = {id(node_at(self.tree, [*node_keys])): new.name for node_keys, new in self.new_names.items()}
        pairs = [
            (reference, targets[id(reference.target)].text)
            for reference in references(self.tree)
            if id(reference.target) in targets
            and reference.keys
            and reference.keys[0] not in _JUDGING
            and reference.scalar.text[reference.start : reference.end] == identity(reference.target)
            and "/" not in reference.scalar.text
        ]
        paths = RenamedPaths(self.tree, {new.path: new.name.text for new in self.new_names.values()})
        # What follows in a text, and what is below a key, has its place by what comes before it.
        for reference, name in sorted(pairs, key=lambda pair: _place_of(pair[0]), reverse=True):
            self._refer_by(reference, name)
        sections = {name: paths.renamed(node, name == "behaviour") for name, node in self.tree.values.items()}
        self.tree = Mapping(self.tree.file, self.tree.start, self.tree.end, sections, self.tree.keys)
        for node_keys, new in self.new_names.items():
            self._put([*node_keys, "name"], new.name)

    def _refer_by(self, reference: Reference, name: str) -> None:
        """Puts a new name where a reference has the old one."""
        *holder_keys, key = reference.keys
        node = node_at(self.tree, [*reference.keys])
        if not reference.is_key:
            text = node.text if isinstance(node, Scalar) else ""
            self._put([*reference.keys], with_text(node, f"{text[: reference.start]}{name}{text[reference.end :]}"))
            return
        holder = node_at(self.tree, holder_keys)
        assert isinstance(holder, Mapping)
        values = {name if own == key else own: value for own, value in holder.values.items()}
        self._put(holder_keys, Mapping(holder.file, holder.start, holder.end, values, holder.keys))

    def _drop_taken_names(self) -> None:
        """Refuses new names that something else in the same list has, or is to have."""
        for node_keys, new in [*self.new_names.items()]:
            *list_keys, own = node_keys
            for number, item in enumerate(mappings(node_at(self.tree, list_keys))):
                other = self.new_names.get((*list_keys, number))
                if number != own and new.name.text == (other.name.text if other is not None else identity(item)):
                    text, label = f"{quoted(new.name.text)} already exists", Label(item.span, "this one")
                    self._refuse("overlay_name_taken", text, new.name, "use another name", label)
                    self.new_names.pop(node_keys, None)

    def add(self, entry: Mapping) -> None:
        """Puts a new fact into a list."""
        path, item = entry.values["in"], entry.values["item"]
        assert isinstance(path, Scalar)
        assert isinstance(item, Mapping)
        if "source" in entry.values and "source" not in item.values:
            item = item.with_value("source", entry.values["source"])
        node_keys = keys(self.tree, path.text) if path.text.partition("/")[0] not in _OF_ALL_VERSIONS else None
        if node_keys is None and "/" not in path.text and path.text in _LISTS - _OF_ALL_VERSIONS:
            empty = Sequence(path.file, path.start, path.end, ())
            self.tree = self.tree.with_value(path.text, empty)
            node_keys = [path.text]
        if node_keys is None:
            self._keys_and_fact(entry, "in")
            return
        node = node_at(self.tree, node_keys)
        if isinstance(node, Mapping):
            inner = next((key for key in LISTS if key in node.values), None)
            if inner is None:
                self._refuse("overlay_fact_missing", "this is not a list of facts", path, "name a list of facts")
                return
            node_keys, node = [*node_keys, inner], node.values[inner]
        assert isinstance(node, Sequence)
        name = identity(item)
        existing = next((item for item in node.items if name is not None and identity(item) == name), None)
        if existing is not None:
            label = Label(existing.span, "this one")
            help = "change it under `changes`, or use another name"
            self._refuse("overlay_name_taken", f"{quoted(name or '')} already exists", item, help, label)
            return
        new, findings = typed_at(item, (*schema_path(node_keys), "items"))
        self.findings += findings
        place = self._index_of_new(entry, node, new)
        if not findings and place is not None:
            self._put(
                node_keys, Sequence(node.file, node.start, node.end, (*node.items[:place], new, *node.items[place:]))
            )

    def _index_of_new(self, entry: Mapping, siblings: Sequence, new: Node) -> int | None:
        """The index of a new item in its list."""
        after = entry.values.get("after")
        if isinstance(after, Scalar):
            names = [identity(item) for item in siblings.items]
            list_path = entry.values["in"]
            assert isinstance(list_path, Scalar)
            row = (
                keys(self.tree, f"{list_path.text.removesuffix('/rows')}/rows/{after.text}")
                if "=" in after.text
                else None
            )
            if row is not None and isinstance(row[-1], int):
                return row[-1] + 1
            if after.text not in names:
                text = f"there is no {quoted(after.text)} in this list"
                hint = near(after.text, [name for name in names if name])
                self._refuse("overlay_fact_missing", text, after, hint)
                return None
            return names.index(after.text) + 1
        for key in _ORDERED_BY:
            own = _scalar_number(new, key)
            if own is not None:
                later = (n for n, item in enumerate(siblings.items) if (_scalar_number(item, key) or 0) > own)
                return next(later, len(siblings.items))
        return len(siblings.items)


_LISTS = frozenset(key for key, part in schema()["properties"].items() if part["type"] == "array")


def _place_of(reference: Reference) -> tuple[int, bool, int]:
    """Later replacements have a lower place: nearer to the root, a key, nearer to its start."""
    return len(reference.keys), not reference.is_key, reference.start


@dataclass(frozen=True, slots=True)
class _NewName:
    """The new name of the fact at a path of the base."""

    path: str
    name: Scalar


_MOST_NAMES = 5
"""The names that the help for an unknown path lists."""


def _near_path(tree: Mapping, path: str) -> str:
    """The help for the path of a fact that is not there: the name that its first unknown step may mean."""
    steps = path.split("/")
    known = next(n for n in range(len(steps) - 1, -1, -1) if not n or keys(tree, "/".join(steps[:n])) is not None)
    before = "/".join(steps[:known])
    holder: Node = node_at(tree, keys(tree, before) or []) if before else tree
    close = near(steps[known], _names_below(holder, 2))
    if not close.startswith("did you mean"):
        names = [name for name in _names_below(holder, 1) if name not in ("group", "section", "rows")][:_MOST_NAMES]
        place = f"`{before}`" if before else "the base version"
        return f"correct the path; {place} contains {', '.join(names)}" if names else f"{place} contains no facts"
    name = close.partition("`")[2].partition("`")[0]
    return f"did you mean `{'/'.join([*steps[:known], name, *steps[known + 1 :]])}`?"


def _names_below(node: Node, levels: int) -> list[str]:
    """The names of the entries of a list, of the rows of its groups, or of what is listed in an entry."""
    if isinstance(node, Sequence):
        inner = [item for item in node.items if isinstance(item, Mapping) and ("group" in item.values)]
        rows = [name for item in inner for name in _names_below(item, 1)]
        return [*rows, *(name for item in node.items if (name := identity(item)))]
    if not isinstance(node, Mapping):
        return []
    lists = [child for child in node.values.values() if isinstance(child, Sequence) and levels]
    return [*node.values, *(name for child in lists for name in _names_below(child, levels - 1))]


def _scalar_number(node: Node, key: str) -> int | None:
    scalar = node.values.get(key) if isinstance(node, Mapping) else None
    return scalar.value if isinstance(scalar, Scalar) and isinstance(scalar.value, int) else None


def _absent(node: Node) -> bool:
    return isinstance(node, Scalar) and node.value is None


def _is_same_node(was: Node, now: Node) -> bool:
    return exact(was) == exact(now)


def _node_text(node: Node) -> str:
    """A value as it can be written in one line."""
    if isinstance(node, Scalar):
        return json.dumps(node.text, ensure_ascii=False) if node.quoted else node.text
    if isinstance(node, Sequence):
        return f"[{', '.join(map(_node_text, node.items))}]"
    return f"{{{', '.join(f'{key}: {_node_text(value)}' for key, value in node.values.items())}}}"
