"""Writes workbooks. No other module knows XlsxWriter.

The same cells give the same bytes: no times, no versions, and no compression, which differs between machines.
"""

from __future__ import annotations

import io
import re
import zipfile
from collections.abc import Callable, Iterable, Sequence
from datetime import datetime
from typing import Any

from xlsxwriter import Workbook as Book

from fieldspec.foundation.spreadsheet import Workbook, clean

LONGEST = 32_767
"""The most characters of a cell."""

LONGEST_TITLE = 31
"""The most characters of the title of a sheet."""

_CREATED = {"created": datetime(1980, 1, 1)}  # else it is the time of the run
_FORMULAS = ("=", "+", "-", "@")
_NOT_XML = re.compile("[\ufffe\uffff]")
_WIDEST = 40


def packed(contents: Workbook) -> bytes:
    """The bytes of a workbook for a program that imports it: every cell is there, an empty one as an empty text."""

    def fill(book: Any) -> None:
        quoted = book.add_format({"quote_prefix": True})
        for sheet in contents.sheets:
            worksheet = book.add_worksheet(sheet.title[:LONGEST_TITLE])
            for number, row in enumerate(sheet.rows):
                for column, value in enumerate(row):
                    _write_cell(worksheet, number, column, "" if value is None else value, quoted)
        for name, text in contents.properties.items():
            book.set_custom_property(name, text, "text")

    return _file_bytes(fill)


def workbook(title: str, columns: Sequence[str], rows: Iterable[Sequence[object]]) -> bytes:
    """A workbook for people, with one sheet: a heading that stays in sight, texts as texts, numbers as numbers."""

    def fill(book: Any) -> None:
        quoted = book.add_format({"quote_prefix": True})
        bold = book.add_format({"bold": True})
        sheet = book.add_worksheet(title[:LONGEST_TITLE])
        widths = [len(column) for column in columns]
        for column, heading in enumerate(columns):
            sheet.write_string(0, column, heading, bold)
        last = 0
        for last, row in enumerate(rows, 1):
            for column, value in enumerate(row):
                if value is not None and value != "":
                    text = _write_cell(sheet, last, column, value, quoted)
                    widths[column] = min(max(widths[column], len(text) + 1), _WIDEST)
        for column, width in enumerate(widths):
            sheet.set_column(column, column, width + 2)
        sheet.freeze_panes(1, 0)
        sheet.autofilter(0, 0, last, len(columns) - 1)

    return _file_bytes(fill)


def _write_cell(sheet: Any, row: int, column: int, value: object, quoted: object) -> str:
    """Writes a value and returns the text of the cell. A text that begins like a formula is marked as a text."""
    if not isinstance(value, str):
        sheet.write_number(row, column, value)
        return str(value)
    text = _NOT_XML.sub("", clean(value))[:LONGEST]
    sheet.write_string(row, column, text, quoted if text.startswith(_FORMULAS) else None)
    return text


def _file_bytes(fill: Callable[[Any], None]) -> bytes:
    package_file = io.BytesIO()
    with Book(package_file, {"in_memory": True}) as book:
        book.set_properties(_CREATED)
        fill(book)
    stored = io.BytesIO()
    with zipfile.ZipFile(package_file) as parts, zipfile.ZipFile(stored, "w", zipfile.ZIP_STORED) as package:
        for part in parts.infolist():
            content = parts.read(part)
            part.compress_type = zipfile.ZIP_STORED
            package.writestr(part, content)
    return stored.getvalue()
