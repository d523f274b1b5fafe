"""Lists as XLSX. This is the one module that knows openpyxl."""

from __future__ import annotations

import io
import xml.etree.ElementTree as ElementTree
import zipfile
from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from fieldspec.lists.packing import zipped
from fieldspec.lists.parts import APP, CORE
from fieldspec.lists.sheet import MOST_COLUMNS, MOST_ROWS, ListError, Region, Sheet, SheetRow
from fieldspec.spreadsheet import clean

if TYPE_CHECKING:
    from openpyxl.cell.cell import Cell, MergedCell
    from openpyxl.worksheet.worksheet import Worksheet

MAGIC = b"PK\x03\x04"
_MOST_UNPACKED = 256 << 20
_DECLARATIONS = (b"<!DOCTYPE", b"<!ENTITY")

# openpyxl writes its version and the time there.
_FIXED = {"docProps/app.xml": APP, "docProps/core.xml": CORE}
_WIDEST = 40


def workbook_sheet(content: bytes, named: str = "") -> Sheet:
    """A sheet of a workbook: the one with a name, or the first that is not empty."""
    _harmless(content)
    import openpyxl

    try:
        book = openpyxl.load_workbook(io.BytesIO(content), data_only=False, keep_links=False)
    except Exception:  # openpyxl lets pass whatever its parts raise
        raise ListError("is no workbook that can be read; save it anew as .xlsx, or as CSV") from None
    sheets = list(book.worksheets)
    if named:
        found = [sheet for sheet in sheets if sheet.title == named]
        if not found:
            raise ListError(f"has no sheet {named}; there are {', '.join(sheet.title for sheet in sheets)}")
        return _sheet(found[0])
    for sheet in sheets:
        made = _sheet(sheet)
        if made.rows:
            return made
    raise ListError("is empty")


def _harmless(content: bytes) -> None:
    """Refuses what would unpack to far more than a list, or declares entities."""
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as packed:
            parts = packed.infolist()
            if sum(part.file_size for part in parts) > _MOST_UNPACKED:
                raise ListError("unpacks to more than a list of registers holds")
            if "xl/workbook.xml" not in packed.namelist():
                raise ListError("is packed, and no workbook; give a CSV or XLSX file")
            for part in parts:
                if part.filename.endswith((".xml", ".rels")) and any(
                    sign in packed.read(part)[:4096] for sign in _DECLARATIONS
                ):
                    raise ListError("declares entities, which no workbook needs; save it as CSV")
    except (zipfile.BadZipFile, zipfile.LargeZipFile, EOFError, RuntimeError, ValueError, OSError):
        raise ListError("is a workbook that is cut off or protected; save it anew as .xlsx, or as CSV") from None


def _sheet(sheet: Worksheet) -> Sheet:
    if sheet.max_row > MOST_ROWS:
        raise ListError(f"has more than {MOST_ROWS} rows; a list of registers has fewer")
    if sheet.max_column > MOST_COLUMNS:
        raise ListError(f"has more than {MOST_COLUMNS} columns")
    rows = []
    formulas = set()
    for number, held in enumerate(sheet.iter_rows(), 1):
        cells = []
        for column, one in enumerate(held, 1):
            if one.data_type == "f":
                formulas.add((number, column))
            cells.append(_text(one.value))
        if any(cells):
            rows.append(SheetRow(number, tuple(cells)))
    merged = tuple(
        Region(*(int(bound) for bound in (area.min_row, area.min_col, area.max_row, area.max_col)))
        for area in sorted(sheet.merged_cells.ranges, key=lambda area: (area.min_row, area.min_col))
    )
    return Sheet(tuple(rows), sheet.max_row, str(sheet.title), frozenset(formulas), merged)


def _text(value: object) -> str:
    """What a cell shows: whole numbers without a point."""
    if value is None:
        return ""
    if isinstance(value, float) and value.is_integer() and abs(value) < 1e15:
        return str(int(value))
    return clean(str(value))


def workbook(title: str, columns: Sequence[str], rows: Iterable[Sequence[object]]) -> bytes:
    """A workbook with one sheet: a heading that stays in sight, texts as texts, numbers as numbers.

    The same rows give the same bytes: no times, no versions, no compression, which differs between machines.
    """
    import openpyxl
    from openpyxl.styles import Font
    from openpyxl.utils import get_column_letter

    book = openpyxl.Workbook()
    sheet = book.active
    assert sheet is not None
    sheet.title = title
    widths = [len(column) for column in columns]
    for number, row in enumerate([columns, *rows], 1):
        for column, value in enumerate(row, 1):
            if value is None or value == "":
                continue
            shown = _put(sheet.cell(number, column), value)
            widths[column - 1] = min(max(widths[column - 1], len(str(shown)) + 1), _WIDEST)
    for cell in sheet[1]:
        cell.font = Font(bold=True)
    for column, width in enumerate(widths, 1):
        sheet.column_dimensions[get_column_letter(column)].width = width + 2
    sheet.freeze_panes = "A2"
    sheet.auto_filter.ref = sheet.dimensions
    made = io.BytesIO()
    book.save(made)
    return _settled(made.getvalue())


def _put(cell: Cell | MergedCell, value: object) -> object:
    """Writes a value and gives what the cell then shows. A text that begins with `=` is a text."""
    shown = clean(value) if isinstance(value, str) else value
    cell.value = shown  # type: ignore[assignment]
    if isinstance(shown, str):
        cell.data_type = "s"
        cell.style = "Normal"
        cell.quotePrefix = shown.startswith(("=", "+", "-", "@"))
    return shown


def _settled(content: bytes) -> bytes:
    """A workbook whose parts are in one form, without what the run has left in it."""
    return zipped(_parts(content))


def _parts(content: bytes) -> Iterator[tuple[str, str]]:
    with zipfile.ZipFile(io.BytesIO(content)) as held:
        for name in held.namelist():
            yield name, _FIXED.get(name) or ElementTree.canonicalize(held.read(name).decode("utf-8"))
