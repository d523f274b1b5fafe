"""In a long table, a column of numbers that count or rise in steps does so in all rows.

Why: a table of settings often lists all pairs of two numbers. A misprinted cell breaks the sequence, and readers do
not notice it among dozens of rows.

Example: a gain column with 1, 2, 3, 4, 5, 6, 7, 2 that then starts again, where all other sequences end with
8.

Fix: Correct the cell, and write an erratum. If the number is really different, set `allow: {lookups_regular:
<reason>}` on the table.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from itertools import groupby

from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.texts import Lookup

_FEWEST = 16
_SMALL = 12
_FEWEST_STEPS = 4


def lookups_regular(device: Device) -> Findings:
    for lookup in device.lookups:
        for index, column in enumerate(lookup.columns):
            cells = [row.cells[index] for row in lookup.rows if index < len(row.cells)]
            numbers = [cell for cell in cells if isinstance(cell, int) and not isinstance(cell, bool)]
            if len(numbers) == len(lookup.rows) >= _FEWEST:
                yield from _of_column(lookup, column.name, numbers)


def _of_column(lookup: Lookup, name: str, numbers: Sequence[int]) -> Findings:
    for odd in (_counting(numbers), _rising(numbers)):
        if odd and len(odd) * _SMALL <= len(numbers):
            for index, right in odd.items():
                row, before = lookup.rows[index], lookup.rows[index - 1]
                text = f"{name} is {numbers[index]}, but its column continues with {right}"
                related_label = label(before.place, "cells", "the row before")
                help = "correct the cell, or allow it with a reason"
                yield finding(row.place, "cells", text, help, related_label)
            return


def _counting(numbers: Sequence[int]) -> dict[int, int]:
    """The rows that neither continue nor restart the count of a column, with the expected numbers.

    Nothing where fewer than half of the rows count on.
    """
    odd: dict[int, int] = {}
    good, steps = 0, 0
    for index in range(1, len(numbers)):
        right = numbers[good] + index - good
        if numbers[index] == right or numbers[index] == numbers[0]:
            steps += numbers[index] == right
            good = index
        else:
            odd[index] = right
    return odd if 2 * steps >= len(numbers) else {}


def _rising(numbers: Sequence[int]) -> dict[int, int]:
    """The rows that break a column that rises by one after a fixed number of rows."""
    runs = [len(list(run)) for _, run in groupby(numbers)]
    width = Counter(runs).most_common(1)[0][0]
    if width < 2 or len(numbers) < _FEWEST_STEPS * width:
        return {}
    return {
        index: numbers[0] + index // width
        for index, number in enumerate(numbers)
        if number != numbers[0] + index // width
    }
