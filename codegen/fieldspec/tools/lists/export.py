"""Writes a device as a register list: one row for each item, in the columns that docs/export.md describes."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from decimal import Decimal
from typing import TypeAlias

from fieldspec.foundation.line_text import visible_json
from fieldspec.foundation.spreadsheet import clean, guarded
from fieldspec.language.model.fact import LINES, Citation
from fieldspec.language.model.value import Value
from fieldspec.tools.lists.item import Item, exact_number
from fieldspec.tools.lists.workbook_writer import workbook

Cell: TypeAlias = int | Decimal | str | None

COLUMNS = (
    "space",
    "address",
    "hex",
    "name",
    "words",
    "type",
    "access",
    "unit",
    "ucum",
    "scale",
    "offset",
    "min",
    "max",
    "default",
    "const",
    "count",
    "stride",
    "first",
    "subindex",
    "printed_name",
    "label",
    "values",
    "special",
    "bits",
    "bytes",
    "order",
    "section",
    "line",
    "unverified",
)


def _scale(value: Value) -> Cell:
    """The scale of a count; `10^power_sf` where the exponent is in another register."""
    if value.scale_by:
        return f"10^{value.scale_by}"
    return exact_number(value.scale_number) if value.scale != 1 else None


def row(item: Item) -> dict[str, Cell]:
    """The cells of an item by column; None is empty."""
    value, source = item.value, item.source
    is_list = item.count > 1
    ranges = None if value is None else value.writable_ranges
    return {
        "space": item.space,
        "address": item.address,
        "hex": f"0x{item.address:04X}",
        "name": item.name,
        "words": item.words,
        "type": item.type,
        "access": item.access or None,
        "unit": (value.quantity_unit or None) if value else None,
        "ucum": item.ucum or None,
        "scale": _scale(value) if value else None,
        "offset": exact_number(value.offset) if value and value.offset else None,
        "min": ranges.low if ranges else None,
        "max": ranges.high if ranges else None,
        "default": value.default if value else None,
        "const": value.const if value else None,
        "count": item.count if is_list else None,
        "stride": item.stride if is_list and item.stride else None,
        "first": item.first if is_list and item.stride else None,
        "subindex": _run(*item.subindices) if item.subindices else None,
        "printed_name": item.printed_name or None,
        "label": item.label or None,
        "values": "; ".join(f"{number} {name}" for number, name in item.members) or None,
        "special": "; ".join(f"{number} {name}" for number, name in item.special) or None,
        "bits": "; ".join(f"{text} {name}" for _, text, name in item.bits) or None,
        "bytes": value.size if value is not None and (value.digits or value.type.name in ("text", "bytes")) else None,
        "order": item.order or None,
        "section": source.section or None if source else None,
        "line": _line(source) if source else None,
        "unverified": "yes" if item.unverified else None,
    }


def _line(source: Citation) -> Cell:
    """The line of a citation, or its page with its mark: `P17`; None for a section alone."""
    first = source.first() or None
    return first if source.mark == LINES or first is None else f"{source.mark}{first}"


def _run(first: int, last: int) -> str:
    return f"{first}" if first == last else f"{first}..{last}"


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
