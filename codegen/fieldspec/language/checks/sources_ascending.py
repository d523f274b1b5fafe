"""The rows of a list cite lines of the manual in ascending order.

Why: registers, fields, bits, signals and parameters are transcribed in the order of the manual. If a line
number falls, it is mistyped, or the row is at the wrong place. If a table prints several columns side by
side, each column starts again at the same line. Members of enums may be in another order.

Example: rows that cite L1160, L1611 and L1162.

Fix: Correct the line or the order of the rows.
"""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.language.checks.facts import lists
from fieldspec.language.checks.finding import Findings, finding, label, longest_ascent
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import LINES, PAGES, Fact

_UNITS = {LINES: "line", PAGES: "page", "": "section"}


def sources_ascending(device: Device) -> Findings:
    for rows in lists(device):
        sections: dict[str, list[Fact]] = {}
        for row in rows:
            if row.sources and "source" in row.place:
                sections.setdefault(row.sources[0].section, []).append(row)
        for cited in sections.values():
            for column in _columns(cited):
                yield from _of_column(column)


def _columns(rows: Sequence[Fact]) -> list[list[Fact]]:
    """Rows that stand one below the other: a new column begins where the first line comes again."""
    columns: list[list[Fact]] = []
    for row in rows:
        first = row.sources[0].first()
        if not columns or first == columns[0][0].sources[0].first() != columns[-1][-1].sources[0].first():
            columns.append([])
        columns[-1].append(row)
    return columns


def _of_column(rows: Sequence[Fact]) -> Findings:
    ascent = longest_ascent([row.sources[0].first() for row in rows])
    for number, row in enumerate(rows):
        if number not in ascent:
            other = rows[number - 1] if number else rows[1]
            text = f"{row.name} cites {_place(row)}, out of order with the rows around it"
            related_label = label(other.place, "source", f"{other.name} cites {_place(other)}")
            help = f"correct the {_UNITS[row.sources[0].mark]} or the order of the rows"
            yield finding(row.place, "source", text, help, related_label)


def _place(row: Fact) -> str:
    """`line 5` or `page 5`"""
    return f"{_UNITS[row.sources[0].mark]} {row.sources[0].first()}"
