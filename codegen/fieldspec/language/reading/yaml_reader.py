"""YAML text -> nodes with places. A mistake is a finding, never an exception.

Built on PyYAML's parser events, of which only plain data is taken: no tags, no merge keys. An alias is
the node it names; how many values and levels a file may have, with its aliases written out, is bounded.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Callable, Iterator
from typing import Any, TypeAlias

import yaml
from yaml.events import (
    AliasEvent,
    CollectionEndEvent,
    CollectionStartEvent,
    DocumentStartEvent,
    Event,
    MappingEndEvent,
    MappingStartEvent,
    ScalarEvent,
    SequenceEndEvent,
    SequenceStartEvent,
    StreamEndEvent,
)

from fieldspec.foundation.source import Refused, SourceFile, Span
from fieldspec.language.diagnostics import Diagnostic, Label
from fieldspec.language.reading.findings import LARGEST_FILE, quoted
from fieldspec.language.reading.help_on_syntax import syntax_help
from fieldspec.language.reading.nodes import ALL_THERE, Mapping, Node, Scalar, Sequence, copied

LARGEST_TREE = 2_000_000
DEEPEST_TREE = 64

# The code points that Unicode keeps from being characters: neither HTML nor XML may have them.
_NO_CHARACTERS = "\\ufdd0-\\ufdef" + "".join(chr(plane << 16 | low) for plane in range(17) for low in (0xFFFE, 0xFFFF))
_NO_CHARACTER = re.compile(f"[{_NO_CHARACTERS}]")
# With them, all that YAML does not print, of what UTF-8 can encode.
_CONTROL = re.compile(f"[\\x00-\\x08\\x0b\\x0c\\x0e-\\x1f\\x7f-\\x84\\x86-\\x9f{_NO_CHARACTERS}]")
_PRINTABLE_BYTES = b"\t\n\r" + bytes(range(0x20, 0x7F))
"""Bytes that are printed wherever they are; texts have hardly others."""
_HALF = re.compile("[\ud800-\udfff]")
_TAG = re.compile(r"!(<[^>]*>|[^\s,\[\]{}]*)")

_BREAK = "\n\r\x85\u2028\u2029"

Size: TypeAlias = tuple[int, int]
"""The counts of a node: its values, including all below it, and the levels below it."""

# Classes of events, as plain values: there are no types to be narrowed where every instruction counts.
_SCALAR: Any = ScalarEvent
_END: Any = MappingEndEvent

# libyaml's parser, which PyYAML has only where it was built with it; the other one gives the same events.
_Parser = yaml._yaml.CParser if yaml.__with_libyaml__ else yaml.Loader


def decoded(path: str, data: bytes) -> tuple[SourceFile, list[Diagnostic]]:
    """The text of a file, which must be UTF-8 with at most `LARGEST_FILE` bytes; one that was refused has none."""
    if isinstance(data, Refused):
        file = SourceFile(path, "")
        return file, [Diagnostic(data.code, data.decode(), Span(file, 0, 0), help=data.help)]
    if len(data) > LARGEST_FILE:
        file = SourceFile(path, "")
        text = f"the file has {len(data)} bytes; the limit is {LARGEST_FILE}"
        return file, [Diagnostic("file_too_large", text, Span(file, 0, 0), help="split it into several files")]
    if data.startswith(b"\xef\xbb\xbf"):
        data = data[3:]
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError as error:
        file = SourceFile(path, data.decode("utf-8", "replace"))
        offset = len(data[: error.start].decode("utf-8", "replace"))
        message = f"byte {data[error.start]:#04x} is not UTF-8"
        return file, [Diagnostic("not_utf8", message, Span(file, offset, offset + 1), help="save the file as UTF-8")]
    file = SourceFile(path, text)
    bad = _CONTROL.search(text) if data.translate(None, _PRINTABLE_BYTES) else None
    if bad is not None:
        message = f"{_kind(bad[0])} {ord(bad[0]):#04x}"
        return file, [Diagnostic("yaml_syntax", message, Span(file, *bad.span()), help="remove it")]
    return file, []


def _kind(sign: str) -> str:
    """The kind of a code point that texts must not contain."""
    return "control character" if ord(sign) < 0xA0 else "code point that is not a character,"


def parsed(file: SourceFile) -> tuple[Node | None, list[Diagnostic]]:
    """The node tree of a file, or None, and what is wrong with its YAML."""
    tab = _indenting_tab(file)
    if tab is not None:
        help = "indent with spaces"
        return None, [Diagnostic("tab_indent", "a tab indents this line", Span(file, tab, tab + 1), help=help)]
    builder = _Builder(file, _Parser(file.text))
    try:
        return builder.document()
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        offset = min(mark.index if mark else 0, max(0, len(file.text) - 1))
        labels: tuple[Label, ...] = ()
        if error.context and error.context_mark and error.context_mark.index != offset:
            start = error.context_mark.index
            labels = (Label(Span(file, start, start + 1), error.context),)
        problem = error.problem or "not YAML"
        help = syntax_help(problem, file.text, offset)
        finding = Diagnostic("yaml_syntax", problem, Span(file, offset, offset + 1), labels, help)
    except yaml.reader.ReaderError as error:
        offset = min(error.position, max(0, len(file.text) - 1))
        finding = Diagnostic("yaml_syntax", error.reason, Span(file, offset, offset + 1))
    except (ValueError, OverflowError) as error:  # PyYAML's own, for an escape that names no character
        finding = Diagnostic("yaml_syntax", f"not YAML: {error}", Span(file, 0, 1))
    except _Refused as refused:
        finding = refused.args[0]
    return None, [*builder.findings, finding]


def parsed_items(file: SourceFile, lines: str, depth: int) -> Sequence | None:
    """The list that some lines of a file are, at a depth of its tree, with offsets in these lines.

    None where they are something else, or not sound.
    """
    builder = _Builder(file, _Parser(lines))
    try:
        node, findings = builder.document(depth)
    except (yaml.YAMLError, ValueError, OverflowError, _Refused):
        return None
    return node if isinstance(node, Sequence) and not findings else None


def _indenting_tab(file: SourceFile) -> int | None:
    """Where a line is indented with a tab: the message of most parsers does not help."""
    if "\t" not in file.text:
        return None
    line_start = 0
    for line in file.text.split("\n"):
        indent = line[: len(line) - len(line.lstrip(" \t"))]
        if "\t" in indent and line.strip():
            return line_start + indent.index("\t")
        line_start += len(line) + 1
    return None


class _Refused(Exception):
    """Carries the finding that ends the reading of a file."""


class _Builder:
    """Builds the tree of nodes from the events of the YAML parser."""

    def __init__(self, file: SourceFile, parser: object) -> None:
        self.file = file
        self.findings: list[Diagnostic] = []
        self.get: Callable[[], Any] = parser.get_event  # type: ignore[attr-defined]
        self.anchors: dict[str, Node | None] = {}
        self.sizes: dict[str, Size] = {}
        self.total = 0

    def document(self, depth: int = 0) -> tuple[Node | None, list[Diagnostic]]:
        """The first document, which is at a depth of a tree; a second one is a finding."""
        root: Node | None = None
        document_count = 0
        while not isinstance(event := self.get(), StreamEndEvent):
            if isinstance(event, DocumentStartEvent):
                document_count += 1
                if document_count > 1:
                    span = self._span(event)
                    text = "a second document starts here; a spec file is one document"
                    self.findings.append(Diagnostic("several_documents", text, span, help="move it to its own file"))
                    return None, self.findings
                root = self._node(self.get(), depth)
        return root, self.findings

    def _span(self, event: Event) -> Span:
        return Span(self.file, *_bounds(event))

    def _tag(self, event: Event) -> Span:
        """The place of a node's tag: before it, perhaps after an anchor."""
        match = _TAG.search(self.file.text, _bounds(event)[0])
        return Span(self.file, *match.span()) if match else self._span(event)

    def _refuse(self, code: str, message: str, event: Event, help: str) -> None:
        raise _Refused(Diagnostic(code, message, self._span(event), help=help))

    def _node(self, event: Event, depth: int) -> Node:
        if isinstance(event, AliasEvent):
            return self._alias(event, depth)
        self._grow(event, 1, depth)
        assert isinstance(event, (ScalarEvent, CollectionStartEvent))
        if event.tag is not None and not (isinstance(event, ScalarEvent) and event.tag == "!"):
            text = f"the tag {quoted(event.tag)}: a spec contains only data"
            raise _Refused(Diagnostic("tag_used", text, self._tag(event), help="remove the tag"))
        if event.anchor:
            self.anchors[event.anchor] = None
        node: Node
        if isinstance(event, MappingStartEvent):
            node = self._mapping(event, depth)
        elif isinstance(event, SequenceStartEvent):
            node = self._sequence(event, depth)
        else:
            assert isinstance(event, ScalarEvent)
            if event.style == '"':
                self._escapes(event)
            node = Scalar(self.file, *_bounds(event), event.value, not event.implicit[0])
        if event.anchor:
            self.anchors[event.anchor] = node
            self.sizes.pop(event.anchor, None)
        return node

    def _escapes(self, event: ScalarEvent) -> None:
        """Refuses escapes for characters that some outputs cannot show."""
        if _HALF.search(event.value):
            self._refuse("yaml_syntax", "an escape names half a character", event, "write the character itself")
        bad = _NO_CHARACTER.search(event.value)
        if bad is not None:
            text = f"an escape names a {_kind(bad[0])} {ord(bad[0]):#04x}"
            self._refuse("yaml_syntax", text, event, "describe it in words")

    def _grow(self, event: Event, values: int, depth: int) -> None:
        """Counts the values of a node, the deepest of which is at a depth."""
        self.total += values
        if depth > DEEPEST_TREE:
            self._refuse("too_deep", f"nested more than {DEEPEST_TREE} levels deep", event, "use fewer levels")
        if self.total > LARGEST_TREE and isinstance(event, AliasEvent):
            text = f"aliases expand this file beyond {LARGEST_TREE} values"
            self._refuse("aliases_grow", text, event, "write the data out")
        if self.total > LARGEST_TREE:
            text = f"the file has more than {LARGEST_TREE} values"
            self._refuse("file_too_large", text, event, "split it into several files")

    def _alias(self, event: AliasEvent, depth: int) -> Node:
        """The node that an alias names, once more: the schema may want something else of it here."""
        name = event.anchor or ""
        node = self.anchors.get(name)
        if node is None:
            known = name in self.anchors
            text = f"the alias {quoted(name)} " + ("is inside its own anchor" if known else "names no anchor")
            self._refuse("alias_unknown", text, event, "write the data out")
            raise AssertionError
        if name not in self.sizes:
            self.sizes[name] = _size(node)
        values, levels = self.sizes[name]
        self._grow(event, values, depth + levels)
        return copied(node)

    def _sequence(self, event: Event, depth: int) -> Sequence:
        items: list[Node] = []
        limit = LARGEST_TREE if depth < DEEPEST_TREE else 0
        while not isinstance(inner := self.get(), SequenceEndEvent):
            if isinstance(inner, MappingStartEvent) and not (inner.tag or inner.anchor) and self.total < limit:
                self.total += 1  # as in `_mapping`: most items are such
                items.append(self._mapping(inner, depth + 1))
            else:
                items.append(self._node(inner, depth + 1))
        return Sequence(self.file, _bounds(event)[0], _bounds(inner)[1], tuple(items))

    def _mapping(self, event: Any, depth: int) -> Mapping:
        # Nearly all of a file is mappings of plain scalars, which are built here without a call for each: half the
        # time. All else, and what is refused, is left to `_node`.
        file, get, new, intern = self.file, self.get, object.__new__, sys.intern
        scalar, end = _SCALAR, _END
        values: dict[str, Node] = {}
        first: dict[str, Any] = {}
        total, limit = self.total, LARGEST_TREE if depth < DEEPEST_TREE else 0
        while (key := get()).__class__ is not end:
            name: str | None
            if key.__class__ is scalar and key.implicit[0] and not (key.style or key.anchor) and total < limit:
                total += 1
                name = intern(key.value)  # the same few words everywhere: a sixth of the memory
            else:
                self.total = total
                key = self._node(key, depth + 1)
                total = self.total
                name = key.text if isinstance(key, Scalar) else None
            event_of_value = get()
            value: Any
            if (
                event_of_value.__class__ is scalar
                and event_of_value.implicit[0]
                and not (event_of_value.style or event_of_value.anchor)
                and total < limit
            ):
                total += 1
                value = new(Scalar)
                value.file = file
                value.start = event_of_value.start_mark.index
                value.end = event_of_value.end_mark.index
                value.text = event_of_value.value
                value.quoted = False
                value.value = None
            else:
                self.total = total
                value = self._node(event_of_value, depth + 1)
                total = self.total
            if name is None or name in first:
                self._misplaced(name, key, first)
            else:
                first[name], values[name] = key, value
        self.total = total
        return Mapping(file, event.start_mark.index, key.end_mark.index, values, ALL_THERE)

    def _misplaced(self, name: str | None, key: Event | Node, first: dict[str, Any]) -> None:
        """Adds a finding for a key that is not a word, or that occurs twice in its mapping."""
        span = self._place(key)
        if name is None:
            self.findings.append(Diagnostic("key_not_text", "a key must be a word", span, help="use a word"))
            return
        label = Label(self._place(first[name]), "the first one")
        text = f"the key {quoted(name)} occurs twice here"
        self.findings.append(Diagnostic("duplicate_key", text, span, (label,), "remove one of them"))

    def _place(self, key: Event | Node) -> Span:
        return self._span(key) if isinstance(key, Event) else key.span


def closing(text: str) -> str:
    """The brackets that close what a text has open at its end."""
    parser = _Parser(text)
    closers: list[str] = []
    try:
        while not isinstance(event := parser.get_event(), StreamEndEvent):
            if isinstance(event, CollectionStartEvent):
                closer = "}" if isinstance(event, MappingStartEvent) else "]"
                closers.append(closer if event.flow_style else "")
            elif isinstance(event, CollectionEndEvent):
                closers.pop()
    except (yaml.YAMLError, ValueError, OverflowError):  # where the text ends, or is not YAML
        pass
    return "".join(reversed(closers))


def key_span(mapping: Mapping, key: str) -> Span:
    """The span of a key of a mapping. It parses the text again, as hardly any key is ever asked for."""
    holder = mapping.holder(key)
    while isinstance(holder, Mapping) and holder is not (inner := holder.holder(key)):
        holder = inner
    if isinstance(holder, Scalar):
        return holder.span
    for word, span in key_spans(holder):
        if word == key:
            return span
    return Span(holder.file, holder.start, holder.start + 1)  # the key is an alias


def key_spans(mapping: Mapping) -> Iterator[tuple[str, Span]]:
    """The keys that the text of a mapping has, with their places."""
    text = mapping.file.text
    column = mapping.start - 1 - max(text.rfind(end, 0, mapping.start) for end in _BREAK)
    shift = mapping.start - column
    for word, start, end in _keys(" " * column + text[mapping.start : mapping.end]):
        yield word, Span(mapping.file, start + shift, end + shift)


def _keys(text: str) -> Iterator[tuple[str, int, int]]:
    """The keys of the mapping that a text is, with their places."""
    parser = _Parser(text)
    depth = 0
    is_key = False
    while not isinstance(event := parser.get_event(), StreamEndEvent):
        if depth == 1 and is_key and isinstance(event, ScalarEvent):
            yield event.value, *_bounds(event)
        if isinstance(event, CollectionStartEvent):
            depth += 1
        elif isinstance(event, CollectionEndEvent):
            depth -= 1
        if depth == 1:
            is_key = not is_key


def size(tree: Node) -> int:
    """How many values a tree has."""
    return _size(tree)[0]


def _size(node: Node) -> Size:
    if isinstance(node, Scalar):
        return 1, 0
    items = node.items if isinstance(node, Sequence) else node.values.values()
    sizes = [_size(item) for item in items]
    keys = len(sizes) if isinstance(node, Mapping) else 0
    return 1 + keys + sum(values for values, _ in sizes), 1 + max((levels for _, levels in sizes), default=-1)


def _bounds(event: Event) -> tuple[int, int]:
    """The offsets of an event's first character and of the one after its last."""
    assert event.start_mark is not None
    assert event.end_mark is not None
    return event.start_mark.index, event.end_mark.index
