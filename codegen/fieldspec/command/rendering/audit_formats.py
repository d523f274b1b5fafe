"""An audit report as terminal text, JSON, CSV and XLSX."""

from __future__ import annotations

import json
from collections.abc import Iterator
from itertools import zip_longest

from fieldspec.command.rendering.blocks import Block, Line, Table, narrowed, width
from fieldspec.command.rendering.finding_formats import json_text
from fieldspec.foundation.classes import replace
from fieldspec.foundation.line_text import visible_json
from fieldspec.foundation.source import Span
from fieldspec.foundation.spreadsheet import csv_text
from fieldspec.language.model.fact import Citation
from fieldspec.tools.audit.section import Cell, Figure, Report, Section, SectionTable
from fieldspec.tools.lists.workbook_writer import workbook

SIGNS = {"good": ("✓", "right"), "bad": ("✗", "wrong"), "warning": ("!", "to be examined"), "": ("", "")}
"""The marks of rows and figures, as a sign and in words."""


def cell_text(cell: Cell, column: str = "") -> str:
    """The text of a cell: a place in a file as `path:line`, one in the manual as specs cite it, an address `0x1005`."""
    if cell is None:
        return ""
    if column == "address" and isinstance(cell, int):
        return f"0x{cell:04X}"
    if isinstance(cell, Span):
        return f"{cell.file.path}:{cell.position()[0]}"
    return cell.text() if isinstance(cell, Citation) else str(cell)


def figure_text(figure: Figure) -> str:
    """`812 of 820 facts of the manual are covered`."""
    whole = "" if figure.whole is None else f" of {figure.whole}"
    return f"{figure.number}{whole} {figure.what}"


def rendered(report: Report) -> str:
    """The report as JSON: the device and its sections; a table is a list of objects with its columns as keys."""
    data = {
        "device": report.device,
        "version": report.version,
        "identity": report.identity,
        "sections": {section.name: _section(section) for section in report.sections},
    }
    return visible_json(data, 1) + "\n"


def _section(section: Section) -> dict[str, object]:
    return {
        "title": section.title,
        "says": list(section.paragraphs),
        "figures": [
            {"what": figure.what, "number": figure.number, "of": figure.whole, "good": figure.good}
            for figure in section.figures
        ],
        "tables": {table.name: rows(table) for table in section.tables},
        "findings": json.loads(json_text(section.findings)),
    }


def rows(table: SectionTable) -> list[dict[str, object]]:
    """The rows of a table as objects."""
    return [dict(zip(table.columns, map(_cell, row), strict=True)) for row in table.rows]


def _cell(cell: Cell) -> object:
    """A cell for JSON; a place in a file has line and column, one in the manual section and intervals of lines."""
    if isinstance(cell, Span):
        line, column = cell.position()
        return {"file": cell.file.path, "line": line, "column": column}
    if isinstance(cell, Citation):
        return {"section": cell.section, "lines": [list(pair) for pair in cell.lines]}
    return cell


def as_csv(table: SectionTable) -> bytes:
    """A table as CSV in UTF-8, with a heading, commas and line feeds; spreadsheets take no cell for a formula."""
    return csv_text([table.columns, *(list(map(cell_text, row)) for row in table.rows)], "\n").encode("utf-8")


def as_xlsx(table: SectionTable) -> bytes:
    """A table as a workbook with one sheet; numbers are numbers. The same table gives the same bytes."""
    cells = [[cell if isinstance(cell, int) else cell_text(cell) for cell in row] for row in table.rows]
    return workbook(table.name, table.columns, cells)


def as_json(table: SectionTable) -> bytes:
    """A table as JSON: a list of objects with its columns as keys."""
    return (visible_json(rows(table), 1) + "\n").encode("utf-8")


_WIDEST = 240
_NAMING = 2
"""How many of the first columns identify a row."""
_MOST_ROWS = 500
"""The most rows of a table that is not asked for alone."""
_STYLES = {"good": "green", "bad": "red", "warning": "yellow", "": ""}


def blocks(report: Report, everything: bool) -> Iterator[Block]:
    """Each section with its figures and tables; tables of details, and all rows, only with `everything`."""
    yield Line(f"{report.title}, version {report.version}, identity {report.identity}", "bold")
    for section in report.sections:
        yield Line("")
        yield from _section_blocks(section, everything)


def _section_blocks(section: Section, everything: bool) -> Iterator[Block]:
    yield Line(section.title, "bold")
    for text in section.paragraphs:
        yield Line(text)
    for figure in section.figures:
        yield Line(figure_text(figure), _style(figure))
    for table in section.tables:
        if table.rows and (everything or not table.detail):
            yield Line("")
            yield Line(table.title)
            rows = table.rows if everything else table.rows[:_MOST_ROWS]
            yield from table_blocks(replace(table, rows=rows, kinds=table.kinds[: len(rows)]))
            if len(rows) < len(table.rows):
                yield Line(f"and {len(table.rows) - len(rows)} more; --table {table.name} has all of them")


def _style(figure: Figure) -> str:
    return "" if figure.good is None else "green" if figure.good else "red"


def table_blocks(table: SectionTable) -> Iterator[Block]:
    """A table without its empty columns; one that is too wide, as a paragraph for each row."""
    rows = tuple(tuple(map(cell_text, row, table.columns)) for row in table.rows)
    block = narrowed(Table(table.columns, rows, tuple(_STYLES[kind] for kind in table.kinds)))
    lines = (block.headings, *block.rows)
    if sum(max(map(width, column)) + 2 for column in zip(*lines, strict=True)) <= _WIDEST:
        yield block
        return
    for row, style in zip_longest(block.rows, block.styles, fillvalue=""):
        yield Line(", ".join(row[:_NAMING]), style)
        for heading, text in zip(block.headings[_NAMING:], row[_NAMING:], strict=True):
            if text:
                yield Line(f"    {heading}: {text}")
