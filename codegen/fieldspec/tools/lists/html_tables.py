"""Reads the tables of a saved HTML page, and the lines of text around them, which may be titles."""

from __future__ import annotations

import re
from collections.abc import Sequence
from html import unescape
from typing import TypeAlias

from fieldspec.foundation.classes import dataclass, field
from fieldspec.foundation.spreadsheet import clean
from fieldspec.tools.lists.sheet import MOST_CELLS, MOST_COLUMNS, MOST_ROWS, ListError, Sheet, SheetRow
from fieldspec.tools.lists.words import folded, whole_words

_PAGE, _TABLE = re.compile(r"\s*<"), re.compile(r"<table[\s>].*?<t[dh][\s>]", re.DOTALL | re.IGNORECASE)
_UNSEEN = re.compile(
    r"<!--.*?(?:-->|\Z)|<(script|style|head|template|noscript|svg|select)\b.*?(?:</\1\s*>|\Z)",
    re.DOTALL | re.IGNORECASE,
)
_TAG = re.compile(r"<(/?)([a-z][a-z0-9]*)((?:[^<>\"']|\"[^\"<]*\"|'[^'<]*')*)>|<![^<>]*>", re.IGNORECASE)
"""A tag. No part of it passes over another `<`, so the time to search all tags grows with the text alone."""

_SPAN = re.compile(r"\b(row|col)span\s*=\s*[\"']?\s*([0-9]{1,6})", re.IGNORECASE)
_STRUCK = ("s", "del", "strike")
_LINES = ("br", "p", "div", "li", "ul", "ol", "dt", "dd", "h1", "h2", "h3", "h4", "h5", "h6", "caption", "hr", "body")
"""The elements that begin and end a line."""

_LINE = "<br>"
"""The end of a line within a cell."""

_MOST_UPPER_HEADINGS = 2
"""The rows of headings that a table may have above the last one."""

_DEEPEST = 50
"""The most tables within each other."""


@dataclass(slots=True)
class _Cell:
    """A cell with its parts of text; it is struck out if all of them are."""

    is_heading: bool = False
    rows: int = 1
    columns: int = 1
    parts: list[str] = field(default_factory=list)
    is_struck: bool = True

    def text(self) -> str:
        """The text. The lines of a heading are one, and others stay apart."""
        lines = [line for text in "".join(self.parts).split(_LINE) if (line := clean(unescape(text)))]
        return (" " if self.is_heading else _LINE).join(lines)


_Row: TypeAlias = tuple[int, list[_Cell]]
"""The line where a row of a table begins in the file, and its cells; a line of text is a row with one."""


def is_page(text: str) -> bool:
    """Whether a text is HTML with a table."""
    return _PAGE.match(text) is not None and _TABLE.search(text) is not None


def page_sheet(text: str) -> Sheet:
    """The tables of a page, one below the other. A merged value counts for each row of its cell. Raises ListError."""
    rows: list[SheetRow] = []
    heads: set[int] = set()
    refused: dict[int, str] = {}
    for table in _tables(text):
        above: tuple[str, ...] = ()
        grid = _grid(table)
        are_heads = [all(cell.is_heading for cell in cells) and sum(map(bool, texts)) > 1 for (_, cells), texts in grid]
        for n, (((line, cells), texts), is_head) in enumerate(zip(grid, are_heads, strict=True), 1):
            texts = _below(above, texts) if is_head else texts
            above = texts if is_head and n <= _MOST_UPPER_HEADINGS and any(are_heads[n : n + 1]) else ()
            if above or not any(texts):
                continue
            number = max(line, rows[-1].number + 1 if rows else 1)
            rows.append(SheetRow(number, texts))
            heads |= {number} if is_head else set()
            refused |= {number: "is struck out"} if all(cell.is_struck for cell in cells) else {}
    return Sheet(tuple(rows), rows[-1].number if rows else 1, refused=refused, heads=frozenset(heads))


def _tables(text: str) -> list[list[_Row]]:
    """The tables of a page, and the lines between them as tables with a row. Raises ListError for too many rows."""
    text = _UNSEEN.sub(lambda match: "\n" * match[0].count("\n"), text)
    tables: list[list[_Row]] = []
    open_tables: list[list[_Row]] = []
    cell = _Cell()
    line, place, rows, struck = 1, 0, 0, 0
    outer_cells: list[_Cell] = []

    def end_line() -> None:
        if not open_tables and "".join(cell.parts).strip():
            tables.append([(line, [_Cell(parts=[*cell.parts], is_struck=cell.is_struck)])])
        if not open_tables:
            cell.parts.clear()

    for tag in [*_TAG.finditer(text), None]:
        piece = text[place : tag.start() if tag else len(text)]
        if piece.strip():
            cell.is_struck &= struck > 0
        cell.parts.append(piece)
        line += piece.count("\n")
        place = tag.end() if tag else len(text)
        is_end, name = (bool(tag[1]), (tag[2] or "").casefold()) if tag else (True, "body")
        if name in _STRUCK:
            struck = max(struck + (-1 if is_end else 1), 0)
        elif name in _LINES:
            cell.parts.append(_LINE)
            end_line()
        elif name == "table" and not is_end:
            end_line()
            if len(open_tables) == _DEEPEST:
                raise ListError(f"has more than {_DEEPEST} tables within each other")
            open_tables.append([])
            outer_cells.append(cell)
            cell = _Cell()
        elif name == "table" and open_tables:
            tables.append(open_tables.pop())
            cell = outer_cells.pop()
        elif name == "tr" and not is_end and open_tables:
            rows += 1
            open_tables[-1].append((line, []))
        elif name in ("td", "th") and not is_end and open_tables and open_tables[-1]:
            spans = {kind.casefold(): max(int(span), 1) for kind, span in _SPAN.findall(tag[3] if tag else "")}
            cell = _Cell(name == "th", spans.get("row", 1), min(spans.get("col", 1), MOST_COLUMNS))
            open_tables[-1][-1][1].append(cell)
            if len(open_tables[-1][-1][1]) > MOST_COLUMNS:
                raise ListError(f"has a row in line {line} with more than {MOST_COLUMNS} cells")
        line += tag[0].count("\n") if tag else 0
        if rows + len(tables) > MOST_ROWS:
            raise ListError(f"has more than {MOST_ROWS} rows; a list of registers has fewer")
    return [*tables, *open_tables]


def _grid(table: Sequence[_Row]) -> list[tuple[_Row, tuple[str, ...]]]:
    """The rows of a table with their texts by column. Raises ListError for too many columns or cells."""
    grid: list[tuple[_Row, tuple[str, ...]]] = []
    merged: dict[int, tuple[int, str]] = {}
    total = 0
    for row in table:
        texts: list[str] = []
        begun: dict[int, tuple[int, str]] = {}
        for cell in [*row[1], None]:
            while len(texts) in merged:
                texts.append(merged[len(texts)][1])
            if cell is not None:
                text = cell.text()
                below = text if cell.columns == 1 else ""
                begun |= dict.fromkeys(range(len(texts), len(texts) + cell.columns), (cell.rows, below))
                texts += [text, *([text] if cell.is_heading else [""]) * (cell.columns - 1)]
        total += len(texts)
        if len(texts) > MOST_COLUMNS or total > MOST_CELLS:
            raise ListError(f"has a table with more than {MOST_COLUMNS} columns, or {MOST_CELLS} cells")
        merged = {column: (rows - 1, text) for column, (rows, text) in {**merged, **begun}.items() if rows > 1}
        grid.append((row, tuple(texts)))
    return grid


def _below(above: Sequence[str], texts: Sequence[str]) -> tuple[str, ...]:
    """The headings of a row, each after the one above it unless it is a known heading itself: `Value Min`."""
    pairs = ((above[n] if n < len(above) else "", text) for n, text in enumerate(texts))
    return tuple(
        text if folded(text) in whole_words() or not upper or upper == text else f"{upper} {text}".strip()
        for upper, text in pairs
    )
