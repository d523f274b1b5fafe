"""Positions in documents of an editor: lines and units of text, counted from 0, as offsets in a text."""

from __future__ import annotations

import re
from bisect import bisect_right

from lsprotocol.types import Position, PositionEncodingKind, Range

from fieldspec.foundation.source import SourceFile, Span
from fieldspec.language.reading.revision import equal_start

_LINE_END = re.compile(r"\r\n|\n|\r")
"""The ends of lines in an editor. A text of YAML has others too, which an editor takes for characters."""


class Positions:
    """The positions in one text, whose columns count the units of an encoding."""

    def __init__(self, text: str, encoding: PositionEncodingKind | str) -> None:
        self._text, self._encoding = text, encoding
        ends = [*_LINE_END.finditer(text)]
        self._starts = [0, *(end.end() for end in ends)]
        self._ends = [*(end.start() for end in ends), len(text)]

    def position(self, offset: int) -> Position:
        """The position of an offset; one within the end of a line is that of the end."""
        line = bisect_right(self._starts, offset) - 1
        start = self._starts[line]
        return Position(line, self._units(self._text[start : min(offset, self._ends[line])]))

    def range(self, start: int, end: int) -> Range:
        """The range between two offsets."""
        return Range(self.position(start), self.position(end))

    def offset(self, position: Position) -> int:
        """The offset of a position; one beyond the text, or beyond a line, is its end."""
        if position.line >= len(self._starts):
            return len(self._text)
        start, end = self._starts[position.line], self._ends[position.line]
        units = 0
        for offset in range(start, end):
            units += self._units(self._text[offset])
            if units > position.character:
                return offset
        return end

    def _units(self, text: str) -> int:
        if text.isascii() or self._encoding == PositionEncodingKind.Utf32:
            return len(text)
        if self._encoding == PositionEncodingKind.Utf8:
            return len(text.encode("utf-8", "surrogatepass"))
        return len(text) + sum(char > "\uffff" for char in text)


def moved(span: Span, file: SourceFile) -> Span | None:
    """The place of a span of an earlier text in a newer one; None where the text has changed there.

    What stands before the first and after the last change of the text has a place in both.
    """
    if span.file is file:
        return span
    old, new = span.file.text, file.text
    before = equal_start(old, new)
    equal_end = min(equal_start(old[::-1], new[::-1]), len(old) - before, len(new) - before)
    if span.end <= before:
        return Span(file, span.start, span.end)
    if span.start >= len(old) - equal_end:
        shift = len(new) - len(old)
        return Span(file, span.start + shift, span.end + shift)
    return None
