"""Reads lists from XLSX. No other module knows openpyxl."""

from __future__ import annotations

import io
from collections.abc import Mapping
from decimal import Decimal
from functools import reduce
from typing import TYPE_CHECKING

from fieldspec.foundation.classes import replace
from fieldspec.foundation.spreadsheet import clean
from fieldspec.tools.lists.addresses import address_text
from fieldspec.tools.lists.cells import space
from fieldspec.tools.lists.column_roles import Columns
from fieldspec.tools.lists.sheet import ListError, Sheet, SheetRow, letters
from fieldspec.tools.lists.tables import headed_columns, joined_columns
from fieldspec.tools.lists.workbook_size import used_area

if TYPE_CHECKING:
    from openpyxl.cell.cell import Cell, MergedCell
    from openpyxl.comments import Comment
    from openpyxl.worksheet.worksheet import Worksheet

MAGIC = b"PK\x03\x04"

_REPEATED = 20
"""One address in this number may be on several sheets of a device."""

_FEWEST_ROLES = 2
"""The headings of sheets that may have anything in them."""


def workbook_sheet(content: bytes, sheet_name: str = "") -> Sheet:
    """A sheet of a workbook: the one with a name, or the visible one with most columns of a list. Raises ListError."""
    area = used_area(content)
    sheets = _worksheets(content, formulas=True)
    if sheet_name:
        matches = [number for number, sheet in enumerate(sheets) if sheet.title == sheet_name]
        if not matches:
            raise ListError(f"has no sheet {sheet_name}; choose from {', '.join(sheet.title for sheet in sheets)}")
        return _filled(content, _sheet(sheets[matches[0]], area), matches[0], area)
    read = {number: sheet_rows for number, sheet in enumerate(sheets) if (sheet_rows := _sheet(sheet, area)).rows}
    if not read:
        raise ListError("is empty")
    visible = [number for number in read if sheets[number].sheet_state == "visible"] or [*read]
    tables = {number: headed_columns(read[number]) for number in visible}
    role_counts = {number: table.headed if table else 0 for number, table in tables.items()}
    best = max(visible, key=lambda number: (role_counts[number], len(read[number].rows), -number))
    titled = {number: table for number, table in tables.items() if table and space(read[number].name)}
    of_spaces = [
        number
        for number, table in titled.items()
        if table.headed > 1 and table.places.keys().isdisjoint(("space", "function"))
    ]
    alike = [number for number, table in tables.items() if table and _are_alike(table, tables[best])]
    alike = of_spaces if best in of_spaces and len(of_spaces) > len(alike) else alike
    parts = {number: _filled(content, read[number], number, area) for number in alike} if len(alike) > 1 else {}
    filled = {number: table for number, sheet in parts.items() if (table := headed_columns(sheet)) is not None}
    if len(filled) > 1 and not any(sheet.formulas for sheet in parts.values()) and _are_disjoint(parts, filled):
        other_names = tuple(sheet.name for number, sheet in read.items() if number not in filled)
        return replace(_joined(parts, filled), others=other_names)
    other_names = tuple(sheet.name for number, sheet in read.items() if number != best)
    return replace(_filled(content, read[best], best, area), others=other_names)


def _filled(content: bytes, sheet: Sheet, number: int, area: tuple[int, int]) -> Sheet:
    """A sheet with the values of its formulas, as far as the file has them. Raises ListError if it is empty."""
    if not sheet.rows:
        raise ListError("is empty")
    if not sheet.formulas:
        return sheet
    return _with_values(sheet, _sheet(_worksheets(content, formulas=False)[number], area))


def _are_alike(table: Columns, other: Columns | None) -> bool:
    """Whether two sheets have columns of the same roles, several of them."""
    roles = [{*columns.places} - {*columns.by_cells} for columns in (table, other) if columns is not None]
    return len(roles) > 1 and roles[0] == roles[1] and len(roles[0]) > _FEWEST_ROLES


def _are_disjoint(sheets: Mapping[int, Sheet], tables: Mapping[int, Columns]) -> bool:
    """Whether hardly an address is on two sheets, but of address spaces that the sheets are named after."""
    addresses = [
        {
            (space(sheets[number].name), table.cell(row, "space"), text)
            for row in table.rows
            if (text := table.cell(row, "address")) and address_text(text) is not None
        }
        for number, table in tables.items()
    ]
    total = sum(map(len, addresses))
    return (total - len(set[tuple[str, str, str]]().union(*addresses))) * _REPEATED < total


def _joined(sheets: Mapping[int, Sheet], tables: Mapping[int, Columns]) -> Sheet:
    """Sheets with the same columns as one, with the titles and perhaps the address space of each. Rows count on."""
    above: list[SheetRow] = []
    parts: list[Columns] = []
    spaces: dict[int, str] = {}
    refused: dict[int, str] = {}
    comments: dict[int, tuple[tuple[str, str], ...]] = {}
    hidden: list[str] = []
    before = 0
    for number, table in tables.items():
        sheet = sheets[number]
        titles = [row for row in sheet.rows if row.number < table.rows[0].number and sum(map(bool, row.cells)) == 1]
        above += [SheetRow(before + row.number, row.cells) for row in titles]
        parts.append(replace(table, rows=tuple(SheetRow(before + row.number, row.cells) for row in table.rows)))
        spaces |= dict.fromkeys((row.number for row in parts[-1].rows), space(sheet.name))
        refused |= {before + number: reason for number, reason in sheet.refused.items()}
        comments |= {before + number: texts for number, texts in sheet.comments.items()}
        hidden += [f"{place} of {sheet.name}" for place in sheet.hidden]
        before += sheet.lines
    joined = reduce(joined_columns, parts)
    heading = SheetRow(max(joined.rows[0].number - 1, 1), (*joined.headings, "space"))
    rows = [
        SheetRow(row.number, (*(row.cell(n) for n in range(len(joined.headings))), spaces[row.number]))
        for row in joined.rows
    ]
    ordered = sorted([*above, heading, *rows], key=lambda row: row.number)
    names = tuple(sheets[number].name for number in tables)
    return Sheet(tuple(ordered), before, joined=names, refused=refused, comments=comments, hidden=tuple(hidden))


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
    refused = {}
    comments = {}
    lines = sheet.iter_rows(max_row=last_row, max_col=last_column) if last_row and last_column else ()
    for number, row in enumerate(lines, 1):
        cells = []
        for column, cell in enumerate(row, 1):
            if cell.data_type == "f":
                formulas.add((number, column))
            cells.append(_cell_in_format(cell) or merged.get((number, column), ""))
        if texts := tuple((cell.coordinate, _comment_text(cell.comment)) for cell in row if cell.comment):
            comments[number] = texts
        if any(cells):
            rows.append(SheetRow(number, tuple(cells)))
            if all(cell.font.strike for cell in row if cell.value is not None):
                refused[number] = "is struck out"
    numbers = {row.number for row in rows}
    hidden = [f"row {number}" for number, row in sheet.row_dimensions.items() if row.hidden and number in numbers]
    for dimension in sheet.column_dimensions.values():
        span = range(dimension.min or 0, min(dimension.max or 0, last_column) + 1) if dimension.hidden else ()
        hidden += [f"column {letters(column)}" for column in span if any(row.cell(column - 1) for row in rows)]
    return Sheet(
        tuple(rows),
        max(last_row, 1),
        str(sheet.title),
        frozenset(formulas),
        refused=refused,
        comments=comments,
        hidden=tuple(hidden),
    )


def _comment_text(comment: Comment) -> str:
    """The text of a comment, without its author and what Excel says above one of a thread."""
    _, _, threaded = comment.text.partition("\nComment:\n")
    return clean((threaded or comment.text).strip().removeprefix(f"{comment.author}:").strip())


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


def _cell_in_format(cell: Cell | MergedCell) -> str:
    """The text of a cell; a number that is shown with an exponent has one: it may have been typed as `12E2`."""
    value = cell.value
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    has_exponent = is_number and "E+" in str(cell.number_format).upper()
    return f"{Decimal(str(value)).normalize():E}" if has_exponent else _cell_text(value)


def _cell_text(value: object) -> str:
    """The text of a cell: whole numbers have no point."""
    if value is None:
        return ""
    if isinstance(value, float) and value.is_integer() and abs(value) < 1e15:
        return str(int(value))
    return clean(str(value))
