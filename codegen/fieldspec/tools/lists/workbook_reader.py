"""Reads lists from XLSX. No other module knows openpyxl."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING

from fieldspec.foundation.spreadsheet import clean
from fieldspec.tools.lists.sheet import MOST_COLUMNS, MOST_ROWS, ListError, Region, Sheet, SheetRow
from fieldspec.tools.lists.workbook_size import check_workbook

if TYPE_CHECKING:
    from openpyxl.worksheet.worksheet import Worksheet

MAGIC = b"PK\x03\x04"


def workbook_sheet(content: bytes, sheet_name: str = "") -> Sheet:
    """A sheet of a workbook: the one with a name, or the first one that is not empty. Raises ListError."""
    check_workbook(content)
    import openpyxl

    try:
        book = openpyxl.load_workbook(io.BytesIO(content), data_only=False, keep_links=False)
    except Exception:  # openpyxl lets pass whatever its parts raise
        raise ListError("is not a readable workbook; save it again as .xlsx, or as CSV") from None
    sheets = list(book.worksheets)
    if sheet_name:
        matches = [sheet for sheet in sheets if sheet.title == sheet_name]
        if not matches:
            raise ListError(f"has no sheet {sheet_name}; there are {', '.join(sheet.title for sheet in sheets)}")
        return _sheet(matches[0])
    for sheet in sheets:
        result = _sheet(sheet)
        if result.rows:
            return result
    raise ListError("is empty")


def _sheet(sheet: Worksheet) -> Sheet:
    if sheet.max_row > MOST_ROWS:
        raise ListError(f"has more than {MOST_ROWS} rows; a list of registers has fewer")
    if sheet.max_column > MOST_COLUMNS:
        raise ListError(f"has more than {MOST_COLUMNS} columns")
    rows = []
    formulas = set()
    for number, row in enumerate(sheet.iter_rows(), 1):
        cells = []
        for column, cell in enumerate(row, 1):
            if cell.data_type == "f":
                formulas.add((number, column))
            cells.append(_cell_text(cell.value))
        if any(cells):
            rows.append(SheetRow(number, tuple(cells)))
    merged = tuple(
        Region(*(int(bound) for bound in (area.min_row, area.min_col, area.max_row, area.max_col)))
        for area in sorted(sheet.merged_cells.ranges, key=lambda area: (area.min_row, area.min_col))
    )
    return Sheet(tuple(rows), sheet.max_row, str(sheet.title), frozenset(formulas), merged)


def _cell_text(value: object) -> str:
    """The text of a cell: whole numbers have no point."""
    if value is None:
        return ""
    if isinstance(value, float) and value.is_integer() and abs(value) < 1e15:
        return str(int(value))
    return clean(str(value))
