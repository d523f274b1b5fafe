"""The cells of the rows of a list by their roles, with those that other columns say, and their notes."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from fieldspec.tools.lists import cells
from fieldspec.tools.lists.addresses import HEXADECIMAL, base_of_heading
from fieldspec.tools.lists.column_roles import FURTHER, Columns
from fieldspec.tools.lists.heading_words import NOTE
from fieldspec.tools.lists.row_quantity import FACTORS
from fieldspec.tools.lists.row_reading import Cells
from fieldspec.tools.lists.sheet import SheetRow

_EMPTY = ("-", "--", "---", "n/a", "N/A", "undefined", "\u2013", "\u2014", "/")
_COUNTS = ("min", "max", "default", "const")
"""The roles of numbers that may be hexadecimal below a heading that says so."""

_MEASURED = (*_COUNTS, "range", "value", "scale")
"""The roles of numbers whose unit a heading may say: `Min [°C]`."""

_HEX = re.compile("[0-9A-Fa-f]{1,8}")


def row_texts(columns: Columns, row: SheetRow) -> dict[str, str]:
    """The cells of a row by role, without those that say nothing; numbers below headings of hexadecimal ones are so."""
    roles = columns.places.keys() & {*_COUNTS}
    hexadecimal = {role for role in roles if base_of_heading(columns.heading(role)) == HEXADECIMAL}
    texts = {
        role: f"0x{text}" if role in hexadecimal and _HEX.fullmatch(text) else text
        for role, text in columns.texts(row).items()
        if text not in _EMPTY or role == "address"
    }
    if "readable" in columns.places and "writable" in texts:
        texts.setdefault("readable", "no")
    if text := texts.get("read_only", ""):
        answers = {True: "no", False: "yes", None: f"read only: {text}"}
        texts.setdefault("writable", answers[cells.answer(text)])
    if "function_write" in texts:
        texts["function"] = ",".join(texts[role] for role in ("function", "function_write") if role in texts)
    return texts


def row_cells(
    columns: Columns,
    row: SheetRow,
    texts: Mapping[str, str],
    comments: Mapping[int, Sequence[tuple[str, str]]],
) -> Cells:
    """The cells of a row: its names are the cells of all columns of names, then its printed name and its label. The
    comments of its cells are notes."""
    further_columns = columns.more
    further = [text for column in further_columns.get("name", ()) if (text := row.cell(column)) and text not in _EMPTY]
    names = [texts[role] for role in ("name",) if role in texts] + further
    names += [texts[role] for role in ("printed_name", "label") if role in texts]
    noted = [columns.places[NOTE]] if NOTE in columns.places else []
    notes = (
        *((f"Comment of {place}", text) for place, text in comments.get(row.number, ())),
        *(
            (columns.heading_at(column), row.cell(column))
            for column in (
                *noted,
                *further_columns.get(NOTE, ()),
                *(n for role in FURTHER for n in further_columns.get(role, ())),
            )
            if row.cell(column) and row.cell(column) not in (*_EMPTY, *(texts.get(role) for role in FURTHER))
        ),
    )
    has_factors = not columns.places.keys().isdisjoint(FACTORS)
    headings = tuple(columns.heading(role) for role in _MEASURED if role in texts)
    return Cells(row.number, texts, tuple(names), notes, has_factors, headings)
