"""Reads lists from XLSX. No other module knows openpyxl."""

from __future__ import annotations

import io
from collections.abc import Sequence
from typing import TYPE_CHECKING

from fieldspec.foundation.classes import replace
from fieldspec.foundation.spreadsheet import clean
from fieldspec.tools.lists.sheet import ListError, Sheet, SheetRow
from fieldspec.tools.lists.tables import role_count
from fieldspec.tools.lists.words import meaning
from fieldspec.tools.lists.workbook_size import used_area

if TYPE_CHECKING:
    from openpyxl.worksheet.worksheet import Worksheet

MAGIC = b"PK\x03\x04"


def workbook_sheet(content: bytes, sheet_name: str = "") -> Sheet:
    """A sheet of a workbook: the one with a name, or the one with most columns of a list. Raises ListError."""
    area = used_area(content)
    sheets = _worksheets(content, formulas=True)
    if sheet_name:
        matches = [number for number, sheet in enumerate(sheets) if sheet.title == sheet_name]
        if not matches:
            raise ListError(f"has no sheet {sheet_name}; choose from {', '.join(sheet.title for sheet in sheets)}")
        return _filled(content, _sheet(sheets[matches[0]], area), matches[0], area)
    read = {number: sheet_rows for number, sheet in enumerate(sheets) if (sheet_rows := _sheet(sheet, area)).rows}
    role_counts = {number: role_count(sheet) for number, sheet in read.items()}
    if joined := _joined([sheet for number, sheet in read.items() if role_counts[number]]):
        return replace(joined, others=tuple(sheet.name for number, sheet in read.items() if not role_counts[number]))
    if not read:
        raise ListError("is empty")
    best = max(read, key=lambda number: (role_counts[number], -number))
    other_names = tuple(sheet.name for number, sheet in read.items() if number != best)
    return replace(_filled(content, read[best], best, area), others=other_names)


def _filled(content: bytes, sheet: Sheet, number: int, area: tuple[int, int]) -> Sheet:
    """A sheet with the values of its formulas, as far as the file has them. Raises ListError if it is empty."""
    if not sheet.rows:
        raise ListError("is empty")
    if not sheet.formulas:
        return sheet
    return _with_values(sheet, _sheet(_worksheets(content, formulas=False)[number], area))


def _joined(sheets: Sequence[Sheet]) -> Sheet | None:
    """Sheets with the same headings that are each named after an address space, as one. Rows count on.

    None where the sheets differ from this form.
    """
    spaces = [meaning("spaces", sheet.name) for sheet in sheets]
    heading = sheets[0].rows[0].cells if sheets else ()
    alike = all(sheet.rows[0].cells == heading and not sheet.formulas for sheet in sheets)
    if len(sheets) < 2 or "" in spaces or len(set(spaces)) < len(spaces) or not alike:
        return None
    rows = [SheetRow(sheets[0].rows[0].number, (*heading, "space"))]
    before = 0
    for sheet, space in zip(sheets, spaces, strict=True):
        width = len(heading)
        for row in sheet.rows[1:]:
            cells = (*row.cells[:width], *[""] * (width - len(row.cells)), space)
            rows.append(SheetRow(before + row.number, cells))
        before += sheet.lines
    return Sheet(tuple(rows), before, joined=tuple(sheet.name for sheet in sheets))


def _worksheets(content: bytes, formulas: bool) -> list[Worksheet]:
    import openpyxl

    try:
        book = openpyxl.load_workbook(io.BytesIO(content), data_only=not formulas, keep_links=False)
    except Exception:  # openpyxl lets pass whatever its parts raise
        raise ListError("is not a readable workbook; save it again as .xlsx, or as CSV") from None
    return list(book.worksheets)


def _sheet(sheet: Worksheet, area: tuple[int, int]) -> Sheet:
    """The cells of a sheet within the used area. A merged value counts for each of its cells."""
    last_row, last_column = min(sheet.max_row, area[0]), min(sheet.max_column, area[1])
    merged = _merged_texts(sheet)
    rows = []
    formulas = set()
    lines = sheet.iter_rows(max_row=last_row, max_col=last_column) if last_row and last_column else ()
    for number, row in enumerate(lines, 1):
        cells = []
        for column, cell in enumerate(row, 1):
            if cell.data_type == "f":
                formulas.add((number, column))
            cells.append(_cell_text(cell.value) or merged.get((number, column), ""))
        if any(cells):
            rows.append(SheetRow(number, tuple(cells)))
    return Sheet(tuple(rows), max(last_row, 1), str(sheet.title), frozenset(formulas))


def _merged_texts(sheet: Worksheet) -> dict[tuple[int, int], str]:
    """The texts of merged cells below the first rows of their areas, by row and column."""
    texts: dict[tuple[int, int], str] = {}
    for area in sheet.merged_cells.ranges:
        first_row, first_column, last_row, last_column = (
            int(bound) for bound in (area.min_row, area.min_col, area.max_row, area.max_col)
        )
        text = _cell_text(sheet.cell(first_row, first_column).value)
        if text and first_column == last_column:
            texts |= {(row, first_column): text for row in range(first_row + 1, last_row + 1)}
    return texts


def _with_values(sheet: Sheet, values: Sheet) -> Sheet:
    """A sheet with the stored values of its formulas; only cells whose value the file does not have keep theirs."""
    stored = {row.number: row for row in values.rows}
    rows, left = [], set()
    for row in sheet.rows:
        cells = list(row.cells)
        for column in range(len(cells)):
            if (row.number, column + 1) in sheet.formulas:
                cells[column] = stored[row.number].cell(column) if row.number in stored else ""
                left |= {(row.number, column + 1)} if not cells[column] else set()
        rows.append(SheetRow(row.number, tuple(cells)))
    return replace(sheet, rows=tuple(row for row in rows if any(row.cells)), formulas=frozenset(left))


def _cell_text(value: object) -> str:
    """The text of a cell: whole numbers have no point."""
    if value is None:
        return ""
    if isinstance(value, float) and value.is_integer() and abs(value) < 1e15:
        return str(int(value))
    return clean(str(value))
