"""Cells of tables that spreadsheets open, such tables as CSV, and workbooks before they are packed."""

from __future__ import annotations

import csv
import io
import re
import unicodedata
from collections.abc import Iterable, Mapping, Sequence
from typing import TypeAlias

from fieldspec.foundation.classes import dataclass, field

Cell: TypeAlias = int | str | None

FORMULA_SIGNS = tuple("=+-@\t\r\n")
"""The first characters of a text that a spreadsheet reads as a formula."""

BYTE_ORDER_MARK = "\ufeff"
"""What tells spreadsheets and engineering tools that a text is UTF-8."""

_NUMBER = re.compile(r"[-+]?[0-9]+(\.[0-9]+)?")


def clean(text: str) -> str:
    """A cell's text in one line: no control characters, single blanks, no apostrophe before a sign of a formula."""
    line = text
    if not text.isprintable():
        line = "".join(" " if unicodedata.category(sign) in ("Cc", "Cf", "Cs", "Zl", "Zp") else sign for sign in text)
    line = " ".join(line.split())
    return line[1:] if line[:1] == "'" and line[1:2] in FORMULA_SIGNS else line


def guarded(text: str) -> str:
    """A text that no spreadsheet takes for a formula: with an apostrophe before it, where it would be one."""
    risky = text.startswith(FORMULA_SIGNS) and not _NUMBER.fullmatch(text)
    return f"'{text}" if risky else text


def csv_text(rows: Iterable[Sequence[Cell]], line_end: str = "\r\n") -> str:
    """Rows as RFC 4180 has them: commas, quotes where they are needed, doubled within. Texts become one line each."""
    output = io.StringIO()
    writer = csv.writer(output, lineterminator=line_end)
    texts = _CellTexts()
    writer.writerows([texts[cell] if isinstance(cell, str) else cell for cell in row] for row in rows)
    return output.getvalue()


class _CellTexts(dict[str, str]):
    """Texts as cells have them, each worked out once, since most of a table's texts are in several of its rows."""

    def __missing__(self, text: str) -> str:
        self[text] = cell_text = guarded(clean(text))
        return cell_text


@dataclass(frozen=True, slots=True)
class Worksheet:
    """A sheet by its title: rows of equal length, the first one the heading."""

    title: str
    rows: tuple[tuple[Cell, ...], ...]


@dataclass(frozen=True, slots=True)
class Workbook:
    """Sheets that a program imports, and what the file says of itself: properties by name."""

    sheets: tuple[Worksheet, ...]
    properties: Mapping[str, str] = field(default_factory=dict)
