"""Lookup tables that give the same facts about the same keys agree in all rows.

Why: a manual prints the pins of one connector in several chapters. If two tables agree in nearly all rows,
the row that differs is misprinted.

Example: three tables of terminals and signals; one of them has the signal of an output at IN 12.

Fix: Correct the cell and write an erratum, or set `allow: {lookups_agree: <reason>}` on one of the tables.
"""

from __future__ import annotations

from itertools import permutations

from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import ScalarValue
from fieldspec.language.model.texts import Lookup, LookupRow

_FEWEST = 4
_SMALL = 4
_COMPARED = 20
"""With how many earlier tables one is compared."""

_Cells = dict[ScalarValue, tuple[ScalarValue, LookupRow]]


def lookups_agree(device: Device) -> Findings:
    earlier: dict[tuple[str, str], list[tuple[Lookup, _Cells]]] = {}
    for lookup in device.lookups:
        reported: set[int] = set()
        for (key_index, key), (column_index, column) in permutations(enumerate(lookup.columns), 2):
            cells = _by_key(lookup, key_index, column_index)
            if len(cells) < _FEWEST:
                continue
            earlier_tables = earlier.setdefault((key.name, column.name), [])
            for other, theirs in earlier_tables[-_COMPARED:]:
                yield from _compare_cells(f"{column.name} of {key.name}", cells, theirs, other, reported)
            earlier_tables.append((lookup, cells))


def _by_key(lookup: Lookup, key_index: int, column_index: int) -> _Cells:
    """The cells of one column by the cells of a key column; empty if the keys do not distinguish the rows."""
    cells: _Cells = {}
    for row in lookup.rows:
        key = row.cells[key_index]
        if key in cells:
            return {}
        if key is not None:
            cells[key] = row.cells[column_index], row
    return cells


def _compare_cells(subject: str, cells: _Cells, theirs: _Cells, other: Lookup, reported: set[int]) -> Findings:
    common = [key for key in cells if key in theirs]
    odd = [key for key in common if cells[key][0] != theirs[key][0]]
    if len(common) - len(odd) < _FEWEST or len(odd) * _SMALL > len(common):
        return
    for key in odd:
        (mine, row), (their, their_row) = cells[key], theirs[key]
        if id(row) not in reported:
            reported.add(id(row))
            text = f"the {subject} {key} is {mine}, but {their} in {other.name}, which otherwise agrees"
            help = "correct one of the cells, or allow the difference with a reason"
            related_label = label(their_row.place, "cells", f"the row of {other.name}")
            yield finding(row.place, "cells", text, help, related_label)
