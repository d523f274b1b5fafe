"""A sheet of cells from a file, whatever its columns mean."""

from __future__ import annotations

from collections.abc import Mapping
from functools import reduce

from fieldspec.foundation.classes import dataclass, field

MOST_BYTES = 32 << 20
MOST_ROWS = 100_000
MOST_COLUMNS = 1_000
MOST_CELLS = 500_000
"""The most cells in the rectangle around the used ones; all of them are in memory at a time."""


class ListError(Exception):
    """A list that cannot be used. The message, after the name of the file, says what is wrong and what to do."""


class CellError(Exception):
    """A cell that is not taken. The message says why, `key` which of an object's values it is."""

    def __init__(self, reason: str, key: str = "") -> None:
        super().__init__(reason)
        self.key = key


@dataclass(frozen=True, slots=True)
class SheetRow:
    """The cells of a row as texts, and its number in the file, counted from 1."""

    number: int
    cells: tuple[str, ...]

    def cell(self, column: int) -> str:
        """The cell in a column, which is counted from 0; empty after the last one."""
        return self.cells[column] if column < len(self.cells) else ""


@dataclass(frozen=True, slots=True)
class Sheet:
    """The rows that are not empty. `formulas` are the cells with formulas, as row and column from 1.

    `name` is that of one of several sheets, else empty. `lines` is the number of rows in the file. `others` are the
    names of further sheets with cells, `joined` the names of the sheets that form this sheet, `encoding` that of a text
    where it was guessed, `refused` the rows that cannot be used, with the reasons, `heads` the rows that the file
    marks as headings, `comments` the comments of cells by row, each with the cell, `hidden` the rows and columns that a
    workbook does not show. `format` is that of another program, empty for a table, `beside` the contents of the
    file that are not part of the list, `orders` its settings of orders of bytes and words. `wrapped` are the lines that
    continue a row, each with the number of the row.
    """

    rows: tuple[SheetRow, ...]
    lines: int
    name: str = ""
    formulas: frozenset[tuple[int, int]] = frozenset()
    others: tuple[str, ...] = ()
    joined: tuple[str, ...] = ()
    encoding: str = ""
    refused: Mapping[int, str] = field(default_factory=dict)
    heads: frozenset[int] = frozenset()
    comments: Mapping[int, tuple[tuple[str, str], ...]] = field(default_factory=dict)
    hidden: tuple[str, ...] = ()
    format: str = ""
    beside: tuple[str, ...] = ()
    orders: tuple[str, ...] = ()
    wrapped: tuple[tuple[int, int], ...] = ()


def column_of(text: str) -> int:
    """The number of the column with some letters, counted from 1."""
    return reduce(lambda number, letter: number * 26 + ord(letter) - ord("A") + 1, text.upper(), 0)


def letters(column: int) -> str:
    """The letters of a column, counted from 1: `A`, `Z`, `AA`."""
    text = ""
    while column:
        column, left = divmod(column - 1, 26)
        text = chr(ord("A") + left) + text
    return text
