"""YAML text -> nodes with places. A slip is a finding, never an exception.

Built on PyYAML's parser events, of which only plain data is taken: no tags, no merge keys. An alias is
the node it names; how many values and levels a file may have, with its aliases written out, is bounded.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

import yaml
from yaml.events import CollectionStartEvent

from fieldspec.diagnostics import Diagnostic, Label
from fieldspec.reading.findings import quoted
from fieldspec.reading.nodes import Mapping, Node, Scalar, Sequence
from fieldspec.source import SourceFile, Span

LARGEST_FILE = 8 * 1024 * 1024
LARGEST_TREE = 2_000_000
DEEPEST_TREE = 64

_CONTROL = re.compile("[^\\t\\n\\r -~\\x85\\xa0-\\ufffd\\U00010000-\\U0010ffff]")
_HALF = re.compile("[\ud800-\udfff]")
_TAG = re.compile(r"!(<[^>]*>|[^\s,\[\]{}]*)")

# libyaml's parser, which PyYAML has only where it was built with it; the other one gives the same events.
_Parser = yaml._yaml.CParser if yaml.__with_libyaml__ else yaml.Loader


def decoded(path: str, data: bytes) -> tuple[SourceFile, list[Diagnostic]]:
    """The text of a file, which must be UTF-8 and not larger than `LARGEST_FILE` bytes."""
    if len(data) > LARGEST_FILE:
        file = SourceFile(path, "")
        text = f"the file has {len(data)} bytes; a spec file may have {LARGEST_FILE}"
        return file, [Diagnostic("file_too_large", text, Span(file, 0, 0), help="split it over several files")]
    if data.startswith(b"\xef\xbb\xbf"):
        data = data[3:]
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError as error:
        file = SourceFile(path, data.decode("utf-8", "replace"))
        at = len(data[: error.start].decode("utf-8", "replace"))
        message = f"byte {data[error.start]:#04x} is not UTF-8"
        return file, [Diagnostic("not_utf8", message, Span(file, at, at + 1), help="save the file as UTF-8")]
    file = SourceFile(path, text)
    bad = _CONTROL.search(text)
    if bad is not None:
        message = f"control character {ord(bad[0]):#04x}"
        return file, [Diagnostic("yaml_syntax", message, Span(file, *bad.span()), help="remove it")]
    return file, []


def parsed(file: SourceFile) -> tuple[Node | None, list[Diagnostic]]:
    """The node tree of a file, or None, and what is wrong with its YAML."""
    tab = _indenting_tab(file)
    if tab is not None:
        help = "indent with blanks"
        return None, [Diagnostic("tab_indent", "a tab indents this line", Span(file, tab, tab + 1), help=help)]
    builder = _Builder(file)
    try:
        return builder.document(_Parser(file.text))
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        at = min(mark.index if mark else 0, max(0, len(file.text) - 1))
        labels: tuple[Label, ...] = ()
        if error.context and error.context_mark and error.context_mark.index != at:
            start = error.context_mark.index
            labels = (Label(Span(file, start, start + 1), error.context),)
        found = Diagnostic("yaml_syntax", error.problem or "not YAML", Span(file, at, at + 1), labels)
    except yaml.reader.ReaderError as error:
        at = min(error.position, max(0, len(file.text) - 1))
        found = Diagnostic("yaml_syntax", error.reason, Span(file, at, at + 1))
    except (ValueError, OverflowError) as error:  # PyYAML's own, for an escape that names no character
        found = Diagnostic("yaml_syntax", f"not YAML: {error}", Span(file, 0, 1))
    except _Refused as refused:
        found = refused.args[0]
    return None, [*builder.found, found]


def _indenting_tab(file: SourceFile) -> int | None:
    """Where a line is indented with a tab: most parsers then say something that helps nobody."""
    if "\t" not in file.text:
        return None
    at = 0
    for line in file.text.split("\n"):
        indent = line[: len(line) - len(line.lstrip(" \t"))]
        if "\t" in indent and line.strip():
            return at + indent.index("\t")
        at += len(line) + 1
    return None


class _Refused(Exception):
    """Carries the finding that ends the reading of a file."""


class _Size(NamedTuple):
    """What a node counts, with its aliases written out: its values, and the levels below it."""

    values: int
    levels: int


class _Builder:
    """Builds nodes from parser events."""

    def __init__(self, file: SourceFile) -> None:
        self.file = file
        self.found: list[Diagnostic] = []
        self.anchors: dict[str, Node | None] = {}
        self.sizes: dict[int, _Size] = {}
        self.total = 0
        self.deepest = 0

    def document(self, parser: object) -> tuple[Node | None, list[Diagnostic]]:
        """The first document; a second one is a finding."""
        root: Node | None = None
        seen = 0
        events = _events(parser)
        for event in events:
            if isinstance(event, yaml.DocumentStartEvent):
                seen += 1
                if seen > 1:
                    span = self._span(event)
                    text = "a second document starts here; a spec file is one document"
                    self.found.append(Diagnostic("several_documents", text, span, help="use a file of its own"))
                    return None, self.found
                root = self._node(next(events), events, 0)
        return root, self.found

    def _span(self, event: yaml.Event) -> Span:
        return Span(self.file, *_bounds(event))

    def _tag(self, event: yaml.Event) -> Span:
        """Where the tag of a node stands: before it, perhaps behind an anchor."""
        found = _TAG.search(self.file.text, _bounds(event)[0])
        return Span(self.file, *found.span()) if found else self._span(event)

    def _refuse(self, code: str, message: str, event: yaml.Event, help: str) -> None:
        raise _Refused(Diagnostic(code, message, self._span(event), help=help))

    def _node(self, event: yaml.Event, events: Iterator[yaml.Event], depth: int) -> Node:
        if isinstance(event, yaml.ScalarEvent) and event.tag is None and not event.anchor and event.style != '"':
            # Nine of ten nodes are such scalars, of which there is nothing more to be found out.
            self._grow(event, 1, depth)
            return Scalar(self.file, *_bounds(event), event.value, not event.implicit[0])
        if isinstance(event, yaml.AliasEvent):
            return self._alias(event, depth)
        self._grow(event, 1, depth)
        assert isinstance(event, (yaml.ScalarEvent, CollectionStartEvent))
        if event.tag is not None and not (isinstance(event, yaml.ScalarEvent) and event.tag == "!"):
            text = f"the tag {quoted(event.tag)}: a spec holds plain data"
            raise _Refused(Diagnostic("tag_used", text, self._tag(event), help="remove the tag"))
        if event.anchor:
            self.anchors[event.anchor] = None
        before, outer, self.deepest = self.total - 1, self.deepest, depth
        node: Node
        if isinstance(event, yaml.ScalarEvent):
            if event.style == '"' and _HALF.search(event.value):
                self._refuse("yaml_syntax", "an escape names half a character", event, "write the character itself")
            node = Scalar(self.file, *_bounds(event), event.value, not event.implicit[0])
        elif isinstance(event, yaml.SequenceStartEvent):
            node = self._sequence(event, events, depth)
        else:
            node = self._mapping(event, events, depth)
        if event.anchor:
            self.anchors[event.anchor] = node
            self.sizes[id(node)] = _Size(self.total - before, self.deepest - depth)
        self.deepest = max(outer, self.deepest)
        return node

    def _grow(self, event: yaml.Event, values: int, depth: int) -> None:
        """Counts the values of a node, whose deepest one stands at a depth."""
        self.total += values
        if depth > self.deepest:
            self.deepest = depth
        if depth > DEEPEST_TREE:
            self._refuse("too_deep", f"nested more than {DEEPEST_TREE} levels deep", event, "use fewer levels")
        if self.total > LARGEST_TREE and isinstance(event, yaml.AliasEvent):
            text = f"aliases make this file grow beyond {LARGEST_TREE} values"
            self._refuse("aliases_grow", text, event, "write the data out")
        if self.total > LARGEST_TREE:
            text = f"the file has more than {LARGEST_TREE} values"
            self._refuse("file_too_large", text, event, "split it over several files")

    def _alias(self, event: yaml.AliasEvent, depth: int) -> Node:
        name = event.anchor or ""
        node = self.anchors.get(name)
        if node is None:
            known = name in self.anchors
            text = f"the alias {quoted(name)} " + ("lies within what it names" if known else "names no anchor")
            self._refuse("alias_unknown", text, event, "write the data out")
            raise AssertionError
        size = self.sizes[id(node)]
        self._grow(event, size.values, depth + size.levels)
        return node

    def _sequence(self, event: yaml.Event, events: Iterator[yaml.Event], depth: int) -> Sequence:
        items: list[Node] = []
        for inner in events:
            if isinstance(inner, yaml.SequenceEndEvent):
                return Sequence(self.file, _bounds(event)[0], _bounds(inner)[1], tuple(items))
            items.append(self._node(inner, events, depth + 1))
        raise AssertionError("the parser ends every sequence")

    def _mapping(self, event: yaml.Event, events: Iterator[yaml.Event], depth: int) -> Mapping:
        keys: dict[str, Scalar] = {}
        values: dict[str, Node] = {}
        for inner in events:
            if isinstance(inner, yaml.MappingEndEvent):
                return Mapping(self.file, _bounds(event)[0], _bounds(inner)[1], keys, values)
            key = self._node(inner, events, depth + 1)
            value = self._node(next(events), events, depth + 1)
            if not isinstance(key, Scalar):
                self.found.append(
                    Diagnostic("key_not_text", "a key must be a word", key.span, help="write a plain word")
                )
            elif key.text in keys:
                first = Label(keys[key.text].span, "the first one")
                text = f"the key {quoted(key.text)} stands here twice"
                self.found.append(Diagnostic("duplicate_key", text, key.span, (first,), "remove one of them"))
            else:
                keys[key.text], values[key.text] = key, value
        raise AssertionError("the parser ends every mapping")


def _bounds(event: yaml.Event) -> tuple[int, int]:
    """The offsets of an event's first character and of the one behind its last."""
    assert event.start_mark is not None
    assert event.end_mark is not None
    return event.start_mark.index, event.end_mark.index


def _events(parser: object) -> Iterator[yaml.Event]:
    while True:
        event = parser.get_event()  # type: ignore[attr-defined]
        if event is None or isinstance(event, yaml.StreamEndEvent):
            return
        yield event
