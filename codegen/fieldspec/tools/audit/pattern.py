"""Patterns of what looks like a fact, as specs declare them, matched in time that grows with the line alone.

A pattern is a text with placeholders: `{address:hex} H` is a number and an H. `*` skips as little as possible, blanks
are optional, everything else means itself. A placeholder takes as much as its form can. So a pattern is a chain of
pieces that are searched one after the other, and no piece is tried twice from the same place.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import lru_cache
from typing import NamedTuple

from fieldspec.foundation.classes import dataclass
from fieldspec.tools.audit.manual_lines import CELL

_HEX = r"0[xX][0-9A-Fa-f]{1,16}|[0-9A-Fa-f]{1,16}"
_DECIMAL = r"[+-]?(?:[0-9]{1,3}(?:,[0-9]{3}){1,6}|[0-9]{1,20})(?:\.[0-9]{1,10})?(?![0-9])"
_NUMBER = rf"(?:0[xX][0-9A-Fa-f]{{1,16}}|[0-9A-Fa-f]{{1,16}} ?[Hh](?![A-Za-z0-9])|{_DECIMAL})"
_PAIR = r"(?:0x)?[0-9A-Fa-f]{2}[Hh]?"
FORMS = {
    "hex": f"(?:{_HEX})",
    "hex2": r"(?:0[xX])?[0-9A-Fa-f]{2}(?![0-9A-Fa-f])",
    "hex4": r"(?:0[xX])?[0-9A-Fa-f]{4}(?![0-9A-Fa-f])",
    "hex8": r"(?:0[xX])?[0-9A-Fa-f]{8}(?![0-9A-Fa-f])",
    "mask": r"0[xX][0-9A-Fa-f]{1,16}|[0-9A-Fa-f]{2,16} ?[Hh]?(?![0-9A-Za-z])",
    "decimal": _DECIMAL,
    "number": _NUMBER,
    "word": r"[A-Za-z_][A-Za-z0-9_]{0,63}",
    "text": r"[^|\s](?:[^|]{0,200}[^|\s])?",
    "range": rf"{_NUMBER}(?: ?(?:~|-|\.\.) ?{_NUMBER})?",
    "span": rf"{_NUMBER} ?(?:~|-|\.\.) ?{_NUMBER}",
    "bytes": rf"{_PAIR}(?:[ |,+]{{1,5}}{_PAIR}){{1,300}}(?![0-9A-Za-z])",
}
"""The forms of placeholders. `mask` is a number with one bit set, `bytes` a frame of two bytes or more."""

COLUMNS = {
    "address": "number",
    "code": "number",
    "number": "number",
    "bit": "range",
    "words": "decimal",
    "bytes": "decimal",
    "count": "decimal",
    "position": "range",
    "name": "text",
    "min": "decimal",
    "max": "decimal",
    "range": "range",
    "default": "decimal",
    "const": "decimal",
    "scale": "decimal",
    "access": "word",
    "type": "word",
    "value": "number",
    "frame": "bytes",
}
"""The columns of placeholders, and the form of each where a pattern gives none. All but `name`, `value` and `frame`
are columns of the table of facts."""

_PLACE = re.compile(r"\{([a-z]+)(?::([a-z0-9]+))?\}")
_EDGE = r"(?<![0-9A-Za-z])"


class PatternError(Exception):
    """A pattern that cannot be understood. The message says what is wrong, and what is possible."""


class PieceValue(NamedTuple):
    """A value in a match: its column, its form, and the printed text."""

    column: str
    form: str
    text: str


class Match(NamedTuple):
    """A part of a line, from `start` to `end`, that looks like a fact, with its values."""

    values: tuple[PieceValue, ...]
    start: int
    end: int


@dataclass(frozen=True, slots=True)
class Template:
    """A pattern ready for use: the pieces between its `*`, and the columns and forms of their groups.

    `whole_pieces` are the same, but tied to the ends of the text where the pattern does not begin or end with `*`.
    Pieces are compiled at their first use, as a pattern needs only one of the two.
    """

    pieces: tuple[str, ...]
    whole_pieces: tuple[str, ...]
    columns: tuple[tuple[str, str], ...]

    def whole(self, text: str) -> Match | None:
        """The match of a whole text, from its first character to its last."""
        return self._chained(self.whole_pieces, text, 0)

    def each(self, text: str) -> Iterator[Match]:
        """All matches in a text, without overlaps."""
        position = 0
        while position <= len(text) and (match := self._chained(self.pieces, text, position)) is not None:
            yield match
            position = max(match.end, position + 1)

    def _chained(self, pieces: tuple[str, ...], text: str, start: int) -> Match | None:
        """The match of the pieces in their order, each at the first place after the one before it."""
        position, begin = start, start
        texts: list[str] = []
        for number, piece in enumerate(_expressions(pieces)):
            match = piece.search(text, position)
            if match is None:
                return None
            begin = begin if number else match.start()
            texts += match.groups()
            position = match.end()
        values = [PieceValue(*column, text) for column, text in zip(self.columns, texts, strict=True)]
        return Match(tuple(values), begin, position)


@lru_cache(maxsize=1024)
def _expressions(pieces: tuple[str, ...]) -> tuple[re.Pattern[str], ...]:
    return tuple(map(re.compile, pieces))


def template(text: str) -> Template:
    """A pattern as specs write it. Raises PatternError where it cannot be understood."""
    parts = [part.strip() for part in text.split("*")]
    sources = []
    columns: list[tuple[str, str]] = []
    for part in filter(None, parts):
        source, names = _piece(part)
        sources.append(source)
        columns += names
    tied = list(sources)
    if parts[0]:
        tied[0] = rf"\A\s*{tied[0]}"
    if parts[-1]:
        tied[-1] = rf"{tied[-1]}\s*\Z"
    return Template(tuple(sources), tuple(tied), tuple(columns))


def _piece(part: str) -> tuple[str, list[tuple[str, str]]]:
    """The regular expression of a piece, and the columns and forms of its groups. Raises PatternError."""
    source, position = "", 0
    names: list[tuple[str, str]] = []
    for match in _PLACE.finditer(part):
        column, form = match[1], match[2]
        if column not in COLUMNS:
            raise PatternError(f"nothing is called `{column}`; a placeholder is one of {', '.join(COLUMNS)}")
        if form is not None and form not in FORMS:
            raise PatternError(f"there is no form `{form}`; choose from {', '.join(FORMS)}")
        form = form or COLUMNS[column]
        literal = _literal(part[position : match.start()])
        edge = "" if form in ("text", "bytes", "range", "decimal") and literal else _EDGE
        source += f"{literal}{edge}({FORMS[form]})"
        names.append((column, form))
        position = match.end()
    source += _literal(part[position:])
    return source, names


def _literal(text: str) -> str:
    if "{" in text or "}" in text:
        raise PatternError("a placeholder is written as {column} or {column:form}")
    spaced = [re.escape(word) for word in text.split()]
    start = r"\s*" if text[:1].isspace() or not spaced else ""
    end = r"\s*" if text[-1:].isspace() and spaced else ""
    return start + r"\s*".join(spaced) + end if text else ""


@dataclass(frozen=True, slots=True)
class RowPattern:
    """The first cells of a row, each with a template; None is an empty cell."""

    cells: Sequence[Template | None]

    def find(self, line: str) -> Match | None:
        """The match of a line that is such a row, with the values of all cells; else None."""
        texts = line.split(CELL.strip())
        if len(texts) < len(self.cells):
            return None
        values: list[PieceValue] = []
        for cell, text in zip(self.cells, texts, strict=False):
            match = cell.whole(text.strip()) if cell is not None else None
            if (match is None and cell is not None) or (cell is None and text.strip()):
                return None
            values += match.values if match is not None else ()
        return Match(tuple(values), 0, len(line))


def row(cells: Sequence[str]) -> RowPattern:
    """A row as specs write it. Raises PatternError where a cell cannot be understood."""
    return RowPattern([template(cell) if cell.strip() else None for cell in cells])
