"""A table of priorities is unambiguous: the same states of the inputs always give the same result.

Why: a table that shows both servo on and servo off for the same command and the same input decides nothing.

Example: a row `on | off -> on -> off | on -> on -> off` in a table of the kind `priority`.

Fix: Correct the row. If the manual prints it that way, write an erratum and add an allowance to the table.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.texts import Lookup, LookupRow

_STEP = "->"
"""What stands between the states of a cell that follow each other."""


def priorities_decide(device: Device) -> Findings:
    for lookup in device.lookups:
        if lookup.kind == "priority" and len(lookup.columns) > 1:
            yield from _of(lookup)


def _of(lookup: Lookup) -> Findings:
    first: dict[tuple[str, ...], tuple[str, LookupRow]] = {}
    for row in lookup.rows:
        for *states, result in _moments(row):
            before, first_row = first.setdefault(tuple(states), (result, row))
            if before != result:
                text = f"{lookup.name} has {before} and {result} for {', '.join(states)}"
                related_label = label(first_row.place, "cells", f"{before} here")
                help = "correct the row, or write an erratum and add an allowance to the table"
                yield finding(row.place, "cells", text, help, related_label)
                break


def _moments(row: LookupRow) -> Iterator[tuple[str, ...]]:
    """The states of all columns, moment by moment; a cell of one state has it in all of them."""
    cells = [[part.strip() for part in str(cell).split(_STEP)] for cell in row.cells]
    moment_count = max(len(cell) for cell in cells)
    if moment_count > 1 and all(len(cell) in (1, moment_count) for cell in cells):
        for index in range(moment_count):
            yield tuple(cell[index] if len(cell) > 1 else cell[0] for cell in cells)
