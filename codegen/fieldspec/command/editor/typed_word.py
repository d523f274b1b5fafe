"""The word that is being typed in a document, and what holds it, though the document need not be YAML with it."""

from __future__ import annotations

import re
from collections.abc import Iterator

from fieldspec.command.editor.cursor import Cursor, cursor
from fieldspec.command.editor.projects import EditedProject
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.source import SourceFile, Span
from fieldspec.language.reading.memory import FileRead
from fieldspec.language.reading.nodes import Mapping
from fieldspec.language.reading.yaml_reader import closing, parsed

MARK = "word_being_typed"
"""What stands in place of the word, so that the text is YAML whatever has been typed of it."""

_BEFORE = re.compile(r"[^\s,\[\]{}:\"'#]*\Z")
_AFTER = re.compile(r"[^\s,\[\]{}:\"'#]*")
_LONGEST = 200
"""Characters of a word on each side of the pointer."""


@dataclass(frozen=True, slots=True)
class TypedWord:
    """A word, where it stands in the document, what it has before the pointer, and what holds it.

    The `place` is in another text, with `MARK` for the word. `is_key`: the word is a key of the last node of the place;
    otherwise the last node is the word.
    """

    span: Span
    before: str
    place: Cursor
    is_key: bool

    @property
    def has_colon(self) -> bool:
        """Whether a colon follows the word."""
        return self.span.file.text[self.span.end : self.span.end + 1] == ":"


def typed_word(project: EditedProject, file: SourceFile, offset: int) -> TypedWord | None:
    """The word at an offset of a document, which may be empty; None where nothing can be said of its place."""
    before = _BEFORE.search(file.text, max(0, offset - _LONGEST), offset)
    after = _AFTER.match(file.text, offset, offset + _LONGEST)
    assert before is not None  # both match the empty text
    assert after is not None
    span = Span(file, before.start(), after.end())
    for text in _sound_texts(file.text, span):
        marked = SourceFile(file.path, text)
        tree, findings = parsed(marked)
        if not isinstance(tree, Mapping) or findings:
            continue
        place = cursor(project, FileRead(b"", marked, [], [], tree), span.start)
        if place is None:
            continue
        if place.scalar is not None and place.scalar.text == MARK:
            part = place.part() or {}
            begins_line = not file.text[: span.start].rpartition("\n")[2].strip()
            is_key = "properties" in part and (begins_line or part["type"] == "object")
            return TypedWord(span, before[0], _holding(place) if is_key else place, is_key)
        last = place.nodes[-1]
        if isinstance(last, Mapping) and MARK in last.values:
            return TypedWord(span, before[0], place, is_key=True)
    return None


def _holding(place: Cursor) -> Cursor:
    """The place with an empty mapping in place of a word where the language has a mapping."""
    *nodes, word = place.nodes
    empty = Mapping(word.file, word.start, word.end, {})
    return Cursor(place.project, place.read, place.offset, (*nodes, empty), place.keys, None)


def _sound_texts(text: str, word: Span) -> Iterator[str]:
    """Texts with the mark in place of a word that may be YAML: of the whole document, or of what is before the word."""
    before, after = text[: word.start], text[word.end :]
    for mark in (MARK, f"{MARK}:"):
        yield before + mark + after
    quote = before[-1:] if before[-1:] in ("'", '"') and after[:1] != before[-1:] else ""
    closers = closing(before + MARK + quote)
    for mark in (MARK, f"{MARK}:"):
        yield before + mark + quote + closers
