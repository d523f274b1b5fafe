"""Which facts of a tree refer to which: by names under keys that name facts of one section, by paths, within a fact, by
roles, as keys of values, and as values that have names."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TypeAlias

from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.source import Span
from fieldspec.language.model.task import ACTIONS
from fieldspec.language.reading.meanings import VALUED, VALUES, Meanings, value_of
from fieldspec.language.reading.nodes import LISTS, Mapping, Node, Scalar, Sequence, identity, mappings
from fieldspec.language.reading.yaml_reader import key_spans

REFERENCES = {
    "enums": ("enum",),
    "flags": ("flags",),
    "records": ("record",),
    "signals": ("signal", "signals"),
    "messages": ("message", "messages", "supplements"),
    "links": ("link", "links", "answered_on"),
    "spaces": ("space",),
    "registers": ("same_as", "copy_of", "of", "scale_by", "count_by", "base_by"),
    "parameters": ("set",),
    "examples": ("reply_to",),
    "versions": ("since", "until", "only", "based_on", "after"),
}
"""The keys under which facts of each section are named, besides paths."""

INNER = frozenset(
    (
        *("same_as", "scale_by", "by", "number", "start", "count", "values", "and_mask", "or_mask", "counter", "data"),
        *("field", "bytes", "items", "from", "to", "part", "set", "clear", "aliases", "last", "size", "unsized"),
    )
)
"""The keys under which parts of the same fact are named: fields of a message, parts of a link, bits, members."""
HOLDERS = frozenset(("enums", "flags", "links", "messages", "records", "tables"))
"""The sections of facts that have such parts."""
ASKED = ("frame", "request", "fields", "bits", "members", "response")
"""Their lists, in the order of the search for a name: a response repeats values of the request."""

Keys: TypeAlias = tuple[str | int, ...]
"""The keys and numbers that lead to a node of a tree."""

PlaceInFile: TypeAlias = tuple[str, int, int]
"""A file and the offsets of a node in it, which is the same fact at all versions, under whatever name."""


def place_in_file(node: Node) -> PlaceInFile:
    """The place of a node."""
    return node.file.path, node.start, node.end


@dataclass(frozen=True, slots=True)
class Reference:
    """A name of the fact `target`, or of a state of a machine, under a `key` of the fact at the path `holder`.

    The name is the text `start` to `end` of the scalar: all of it, a step of a path, of which each step is one, or a
    member beside its bit. It may have a role of the target in place of its name. It is at some `keys` of the tree, or
    `is_key`: these lead to the value of that key.
    """

    scalar: Scalar
    start: int
    end: int
    key: str
    holder: str
    target: Node
    keys: Keys = ()
    is_key: bool = False

    @property
    def span(self) -> Span:
        """The place of the name."""
        whole = unquoted(self.scalar)
        return Span(whole.file, whole.start + self.start, whole.start + self.end)


def unquoted(scalar: Scalar) -> Span:
    """The place of the text of a scalar, after its anchor and within its quotation marks."""
    start = unanchored(scalar)
    mark = int(scalar.file.text[start : start + 1] in ("'", '"'))
    return Span(scalar.file, start + mark, scalar.end - mark)


def unanchored(node: Node) -> int:
    """Where a node begins after its anchor."""
    anchor = _ANCHOR.match(node.file.text, node.start, node.end)
    return anchor.end() if anchor is not None else node.start


_ANCHOR = re.compile(r"&\S+\s+")


def references(tree: Mapping, overlay: Mapping | None = None) -> Iterator[Reference]:
    """All references in the tree of a version, in its order; or those in the `overlay` of the next version."""
    names = {section: named_facts(node) for section, node in tree.values.items()}
    names["state"] = names.get("behaviour", {})
    meanings = Meanings(tree)
    for section, node in (overlay or tree).values.items():
        yield from _Search(names, meanings, section).below(node, section, section, "", None, (section,))


def used_by(tree: Mapping) -> dict[str, list[str]]:
    """The paths of the facts that refer to each fact, by its path. What errata and notes are about is theirs to say."""
    paths: dict[PlaceInFile, str] = {}
    for section in tree.values:
        for path, node in _facts(tree.values[section], section):
            paths.setdefault(place_in_file(node), path)
    users: dict[str, list[str]] = {}
    last: dict[tuple[int, str], Reference] = {}
    for reference in references(tree):
        last[id(reference.scalar), reference.holder] = reference  # a path is about what its last step names
    for reference in last.values():
        path = paths.get(place_in_file(reference.target), "")
        section = reference.holder.partition("/")[0]
        holders = users.setdefault(path, [])
        if section not in _SAYING and reference.holder not in (path, *holders):
            holders.append(reference.holder)
    users.pop("", None)
    return {path: holders for path, holders in users.items() if holders}


_SAYING = frozenset(("accepts", "audit", "changes", "errata", "notes", "reviews"))


def _facts(node: Node, section: str) -> Iterator[tuple[str, Mapping]]:
    """The facts of a section with their paths: items of its list, and rows of its groups."""
    for item in mappings(node):
        yield f"{section}/{identity(item)}", item
        for key in _ROWS:
            if key in item.values:
                yield from ((f"{section}/{identity(row)}", row) for row in _rows(item, key))


def named_facts(node: Node) -> dict[str, Mapping]:
    """The facts of a section by name; a group gives way to a row."""
    groups = {name: item for item in mappings(node) if (name := identity(item)) is not None}
    rows = (row for item in mappings(node) for key in _ROWS if key in item.values for row in _rows(item, key))
    return {**groups, **{name: row for row in rows if (name := identity(row)) is not None}}


_ROWS = {"group": "rows", "line": "members"}
"""The lists of groups of registers, and of lines of versions, whose items are named as if they were in the section."""


def _rows(item: Mapping, key: str) -> Iterator[Mapping]:
    yield from mappings(item.values.get(_ROWS[key]))


_ACTING = ("tasks", "behaviour")
"""The sections whose steps and actions name facts by roles."""
_WITH_ROLES = frozenset(
    (
        *ACTIONS,
        *(
            "show",
            "initial",
            "record",
            "rises",
            "falls",
            "if",
            "receive",
            "to",
            "value",
            "speed",
            "acceleration",
            "deceleration",
            "product",
            "over",
            "or",
            "of",
            "answer",
        ),
    )
)
"""The keys under which they do."""
IN_USE = "message/"
"""Begins the path of a part of the cyclic message in use, which may be any message."""


_STATE = "state/"
"""Begins the path of the state of a machine in a condition."""
_OF_PARTS = ("enter", "append", "insert", "remove", "load", "from")
"""The keys under which actions name machines and collections, which are parts of the behaviour."""
_PARTS = frozenset(("machine", "collection"))


def _keys(mapping: Mapping) -> Iterator[Scalar]:
    """The keys of a mapping as scalars with the places that they have in its text."""
    for key, span in key_spans(mapping):
        if key in mapping.values:
            yield Scalar(span.file, span.start, span.end, key, False)


class _Search:
    """Looks for references in one section of a tree."""

    def __init__(self, names: dict[str, dict[str, Mapping]], meanings: Meanings, section: str) -> None:
        self.names, self.meanings, self.section = names, meanings, section

    def below(
        self, node: Node, path: str, holder: str, key: str, fact: Mapping | None, keys: Keys
    ) -> Iterator[Reference]:
        """The references in a node. `holder` is the path of the fact that has it, `fact` the item of the section."""
        if isinstance(node, Scalar):
            for start, end, target in self._targets(node.text, key, holder, fact):
                yield Reference(node, start, end, key, holder, target, keys)
            return
        if isinstance(node, Sequence):
            for number, item in enumerate(node.items):
                if isinstance(item, Mapping):
                    own = f"{path}/{identity(item) or number}"
                    rows = self.section if "group" in item.values and path == self.section else own
                    holder_path = own if identity(item) is not None or path == self.section else holder
                    yield from self._within(item, rows, holder_path, fact or item, (*keys, number))
                else:
                    yield from self.below(item, path, holder, key, fact, (*keys, number))
            return
        yield from self._within(node, path, holder, fact, keys)

    def _within(self, node: Mapping, path: str, holder: str, fact: Mapping | None, keys: Keys) -> Iterator[Reference]:
        name = node.values.get("name")
        for key, child in node.values.items():
            if child is not name:
                inner = path if key in LISTS else f"{path}/{key}"
                yield from self.below(child, inner, holder, key, fact, (*keys, key))
            if isinstance(child, Mapping):
                yield from self._by_keys(node, key, child, holder, (*keys, key))
            if key == "segments" and isinstance(child, Mapping) and fact is not None:
                yield from self._of_segments(child, holder, fact, (*keys, key))
        yield from self._of_cases(node, holder, fact, keys)
        yield from self._of_elements(node, holder, keys)
        for key, value_key in VALUED.items() if self.section in _ACTING else ():
            signal, value = node.values.get(key), node.values.get(value_key)
            if isinstance(signal, Scalar) and value is not None:
                facts = self.meanings.facts(signal.text)
                yield from self._of_values(value, value_key, facts, holder, (*keys, value_key))
        machine, state = node.values.get("enter"), node.values.get("state")
        if self.section == "behaviour" and isinstance(machine, Scalar) and state is not None:
            yield from self._of_states(state, "state", machine.text, holder)

    def _of_cases(self, node: Mapping, holder: str, fact: Mapping | None, keys: Keys) -> Iterator[Reference]:
        """The members that select a case, or with which a field is sent, of the field that a node names as deciding."""
        selector, cases, members = (node.values.get(key) for key in ("by", "cases", "when"))
        decider = _part(fact, selector.text, holder.split("/")[2:3]) if fact and isinstance(selector, Scalar) else None
        if decider is not None and members is not None:
            yield from self._of_values(members, "when", [decider], holder, (*keys, "when"))
        for number, case in enumerate(cases.items if decider is not None and isinstance(cases, Sequence) else ()):
            members = value_of(case, "when")
            if members is not None and decider is not None:
                yield from self._of_values(members, "when", [decider], holder, (*keys, "cases", number, "when"))

    def _of_elements(self, node: Mapping, holder: str, keys: Keys) -> Iterator[Reference]:
        """The field of the elements of a list that says whether another one follows, and the members that say so."""
        continuation, record = node.values.get("more_if"), value_of(node, "record")
        name, members = value_of(continuation, "in"), value_of(continuation, "when")
        element = self.names["records"].get(record.text) if isinstance(record, Scalar) else node
        if isinstance(name, Scalar) and element is not None:
            element = _part(element, name.text, [])
            if element is not None:
                yield Reference(name, 0, len(name.text), "in", holder, element, (*keys, "more_if", "in"))
        if members is not None and element is not None:
            yield from self._of_values(members, "when", [element], holder, (*keys, "more_if", "when"))

    def _of_segments(self, segments: Mapping, holder: str, fact: Mapping, keys: Keys) -> Iterator[Reference]:
        """The members that say how a value is sent in pieces, and why a transfer is aborted."""
        parts = [value_of(field, "parameter") for field in mappings(fact.values.get("response"))]
        names = [value_of(value_of(part, "sizes"), "by") for part in parts]
        deciders = [_part(fact, name.text, ["response"]) for name in names if isinstance(name, Scalar)]
        for key in ("when", "unsized"):
            if key in segments.values:
                stated_deciders = [decider for decider in deciders if decider is not None]
                yield from self._of_values(segments.values[key], key, stated_deciders, holder, (*keys, key))
        abort = segments.values.get("abort")
        message, reason = value_of(abort, "message"), value_of(abort, "reason")
        abort_message = self.names["messages"].get(message.text) if isinstance(message, Scalar) else None
        field = (
            _part(abort_message, reason.text, []) if abort_message is not None and isinstance(reason, Scalar) else None
        )
        for key in ("counter", "size"):
            node = value_of(abort, key)
            if node is not None and field is not None:
                yield from self._of_values(node, key, [field], holder, (*keys, "abort", key))

    def _by_keys(self, node: Mapping, key: str, child: Mapping, holder: str, keys: Keys) -> Iterator[Reference]:
        """The references in the keys of a mapping under a `key` of a node, and in what these have."""
        if key in VALUES:
            yield from self._of_fields(child, key, [*self.meanings.fields(node, None)], holder, keys)
        elif key == "printed":
            for inner, values in child.values.items():
                if inner in VALUES:
                    fields = [*self.meanings.fields(child, node)]
                    yield from self._of_fields(values, inner, fields, holder, (*keys, inner))
        elif key == "if":
            for signal in _keys(child):
                for start, end, target in self._targets(signal.text, key, holder, None):
                    yield Reference(signal, start, end, key, holder, target)
                value, machine = child.values[signal.text], signal.text.removeprefix(_STATE)
                if machine != signal.text:
                    yield from self._of_states(value, key, machine, holder)
                yield from self._of_values(value, key, self.meanings.facts(signal.text), holder, (*keys, signal.text))

    def _of_states(self, value: Node, key: str, machine: str, holder: str) -> Iterator[Reference]:
        """The states of a machine that a value means, or each of several."""
        for scalar in value.items if isinstance(value, Sequence) else (value,):
            for state in self.meanings.states(machine):
                if isinstance(scalar, Scalar) and scalar.text == state.text:
                    yield Reference(scalar, 0, len(state.text), key, holder, state)

    def _of_fields(self, values: Node, key: str, fields: list[Mapping], holder: str, keys: Keys) -> Iterator[Reference]:
        """The fields that values are given for, and what the values mean."""
        for name in _keys(values) if isinstance(values, Mapping) else ():
            field = next((field for field in fields if identity(field) == name.text), None)
            if field is not None and isinstance(values, Mapping):
                own_keys = (*keys, name.text)
                yield Reference(name, 0, len(name.text), key, holder, field, own_keys, is_key=True)
                value = values.values[name.text]
                yield from self._of_values(value, key, [field], holder, own_keys)
                yield from self._of_fields(value, key, [*self.meanings.parts(field)], holder, own_keys)

    def _of_values(self, value: Node, key: str, facts: list[Mapping], holder: str, keys: Keys) -> Iterator[Reference]:
        """The members, bits, states and special values that a value means, or each of several: also a `BIT=MEMBER`."""
        items = enumerate(value.items) if isinstance(value, Sequence) else ()
        nodes = [((*keys, number), item) for number, item in items] or [(keys, value)]
        for own_keys, scalar in ((own_keys, node) for own_keys, node in nodes if isinstance(node, Scalar)):
            start, known = 0, facts
            for name in scalar.text.split("="):
                known = [item for fact in known for item, _ in self.meanings.values(fact) if identity(item) == name]
                stop = start + len(name)
                yield from (Reference(scalar, start, stop, key, holder, item, own_keys) for item in known)
                start += len(name) + 1

    def _targets(self, text: str, key: str, holder: str, fact: Mapping | None) -> Iterator[tuple[int, int, Mapping]]:
        """The facts that a text names, each with the part of the text that is its name."""
        path = text.partition("[")[0]  # an element of a list has its number after its path
        if path.startswith(IN_USE):
            for message in self.names.get("messages", {}):
                shift = len(f"messages/{message}/") - len(IN_USE)
                for start, end, fact_there in self._on_path(f"messages/{message}/{path.removeprefix(IN_USE)}"):
                    if start >= shift + len(IN_USE):
                        yield start - shift, end - shift, fact_there
        elif "/" in path:
            yield from self._on_path(path)
        elif (target := self._named(text, key, holder, fact)) is not None:
            yield 0, len(text), target
        elif self.section in _ACTING and key in _WITH_ROLES:
            yield from ((0, len(path), known) for known in self.meanings.with_role(path))

    def _named(self, text: str, key: str, holder: str, fact: Mapping | None) -> Mapping | None:
        if key in INNER and fact is not None and self.section in HOLDERS and holder.count("/"):
            whole = key == "same_as" and self.section == "records" and holder.count("/") == 1
            inner = None if whole else _part(fact, text, [] if key == "same_as" else holder.split("/")[2:3])
            if inner is not None or key == "same_as":
                return self.names["records"].get(text) if whole else inner
        if self.section == "behaviour" and key in _OF_PARTS:
            known_part = self.names["state"].get(text)
            return known_part if known_part is not None and not _PARTS.isdisjoint(known_part.values) else None
        sections = (section for section, keys in REFERENCES.items() if key in keys)
        known = (self.names.get(section, {}).get(text) for section in sections)
        return next((target for target in known if target is not None), None)

    def _on_path(self, path: str) -> Iterator[tuple[int, int, Mapping]]:
        """The facts on a path, if it leads to one."""
        section, *steps = path.split("/")
        node: Node | None = self.names.get(section, {}).get(steps[0])
        start = len(section) + 1
        facts = []
        for number, step in enumerate(steps):
            node = self.meanings.step(node, step) if number else node
            if isinstance(node, Mapping) and identity(node) == step:
                facts.append((start, start + len(step), node))
            start += len(step) + 1
        if node is not None:
            yield from facts


def _part(fact: Mapping, name: str, direction: list[str]) -> Mapping | None:
    """The part of a fact with a name: a field, a part of a frame, a bit, a member; first one in the same direction."""
    for key in (*direction, *ASKED):
        for item in mappings(fact.values.get(key)):
            if identity(item) == name:
                return item
    return None
