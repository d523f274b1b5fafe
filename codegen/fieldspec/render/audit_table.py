"""One table of an audit, for other programs and for people who keep lists."""

from __future__ import annotations

import csv
import io
import json

from fieldspec.audit.section import SectionTable
from fieldspec.lists.packing import workbook
from fieldspec.render.audit_cells import cell_text
from fieldspec.render.audit_json import rows
from fieldspec.spreadsheet import clean, guarded


def as_csv(table: SectionTable) -> bytes:
    """UTF-8 text with a heading, commas and line feeds; no cell is a formula to a spreadsheet."""
    made = io.StringIO()
    writer = csv.writer(made, lineterminator="\n")
    writer.writerow(table.columns)
    writer.writerows([guarded(clean(cell_text(cell))) for cell in row] for row in table.rows)
    return made.getvalue().encode("utf-8")


def as_xlsx(table: SectionTable) -> bytes:
    """A workbook with one sheet; numbers are numbers. The same table gives the same bytes."""
    cells = [[cell if isinstance(cell, int) else cell_text(cell) for cell in row] for row in table.rows]
    return workbook(table.name, table.columns, cells)


def as_json(table: SectionTable) -> bytes:
    """A list of objects, by the names of the columns."""
    return (json.dumps(rows(table), ensure_ascii=False, indent=1) + "\n").encode("utf-8")
