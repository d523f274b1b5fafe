"""Writes a device as a register list: one row for each item, in the columns that docs/export.md describes."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Sequence
from decimal import Decimal
from typing import TypeAlias

from fieldspec.foundation.line_text import visible_json
from fieldspec.foundation.spreadsheet import clean, guarded
from fieldspec.language.model.fact import LINES, Citation
from fieldspec.language.model.value import Value
from fieldspec.tools.lists.item import Item, exact_number
from fieldspec.tools.lists.workbook_writer import workbook

Cell: TypeAlias = int | Decimal | str | None


def _scale(value: Value) -> Cell:
    """The scale of a count; `10^power_sf` where the exponent is in another register."""
    if value.scale_by:
        return f"10^{value.scale_by}"
    return exact_number(value.scale_number) if value.scale != 1 else None


def _line(source: Citation) -> Cell:
    """The line of a citation, or its page with its mark: `P17`; None for a section alone."""
    first = source.first() or None
    return first if source.mark == LINES or first is None else f"{source.mark}{first}"


def _run(first: int, last: int) -> str:
    return f"{first}" if first == last else f"{first}..{last}"


_CELLS: dict[str, Callable[[Item], Cell]] = {
    "space": lambda item: item.space,
    "address": lambda item: item.address,
    "hex": lambda item: f"0x{item.address:04X}",
    "name": lambda item: item.name,
    "words": lambda item: item.words,
    "type": lambda item: item.type,
    "access": lambda item: item.access,
    "unit": lambda item: item.value.quantity_unit if item.value else None,
    "ucum": lambda item: item.ucum,
    "scale": lambda item: _scale(item.value) if item.value else None,
    "offset": lambda item: exact_number(item.value.offset) if item.value and item.value.offset else None,
    "min": lambda item: item.value.writable_ranges.low if item.value and item.value.writable_ranges else None,
    "max": lambda item: item.value.writable_ranges.high if item.value and item.value.writable_ranges else None,
    "default": lambda item: item.value.default if item.value else None,
    "const": lambda item: item.value.const if item.value else None,
    "count": lambda item: item.count if item.count > 1 else None,
    "stride": lambda item: item.stride if item.count > 1 and item.stride else None,
    "first": lambda item: item.first if item.count > 1 and item.stride else None,
    "subindex": lambda item: _run(*item.subindices) if item.subindices else None,
    "printed_name": lambda item: item.printed_name,
    "label": lambda item: item.label,
    "values": lambda item: "; ".join(f"{number} {name}" for number, name in item.members),
    "special": lambda item: "; ".join(f"{number} {name}" for number, name in item.special),
    "bits": lambda item: "; ".join(f"{text} {name}" for _, text, name in item.bits),
    "bytes": lambda item: item.value.size if item.value and _has_own_size(item.value) else None,
    "order": lambda item: item.order,
    "section": lambda item: item.source.section if item.source else None,
    "line": lambda item: _line(item.source) if item.source else None,
    "unverified": lambda item: "yes" if item.unverified else None,
}
"""The cell of an item in each column."""

COLUMNS = tuple(_CELLS)


def row(item: Item) -> dict[str, Cell]:
    """The cells of an item by column; None is empty."""
    cells = {column: cell(item) for column, cell in _CELLS.items()}
    return {column: None if cell == "" else cell for column, cell in cells.items()}


def _has_own_size(value: Value) -> bool:
    """Whether the type of a value does not say its size."""
    return bool(value.digits) or value.type.name in ("text", "bytes")


def as_csv(items: Sequence[Item]) -> str:
    """CSV with a heading, commas and line feeds. No spreadsheet takes a cell for a formula."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(COLUMNS)
    writer.writerows([_cell_text(cell) for cell in row(item).values()] for item in items)
    return text.getvalue()


def as_json(items: Sequence[Item]) -> str:
    """A JSON list of objects with all columns. Numbers are numbers, empty cells are null."""
    return visible_json([row(item) for item in items], 1, _json_number) + "\n"


def as_xlsx(items: Sequence[Item], title: str) -> bytes:
    """A workbook with one sheet. The same items give the same bytes."""
    rows = [[_workbook_cell(cell) for cell in row(item).values()] for item in items]
    return workbook(title, COLUMNS, rows)


def _cell_text(cell: Cell) -> str:
    if isinstance(cell, str):
        return guarded(clean(cell))
    return "" if cell is None else f"{cell:f}" if isinstance(cell, Decimal) else str(cell)


def _json_number(cell: object) -> float:
    if isinstance(cell, Decimal):
        return float(cell)
    raise TypeError(type(cell).__name__)


def _workbook_cell(cell: Cell) -> Cell:
    """A spreadsheet keeps 15 digits; a longer number is a text."""
    if isinstance(cell, int | Decimal) and len(str(cell).strip("-0.").replace(".", "")) > 15:
        return str(cell) if isinstance(cell, int) else f"{cell:f}"
    return cell
