"""What is printed for people: lines and tables, without any printing."""

from __future__ import annotations

from fieldspec.classes import TYPE_CHECKING, dataclass

if TYPE_CHECKING:
    from typing import TypeAlias


@dataclass(frozen=True, slots=True)
class Line:
    """A line; `style` is how a terminal shows it: `bold`, `dim`, `red`, `yellow`, or empty.

    A `drawn` line is not broken, and its blanks stay.
    """

    text: str
    style: str = ""
    drawn: bool = False


@dataclass(frozen=True, slots=True)
class Table:
    """Cells by row, and the style of each row; no styles where all are plain."""

    headings: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    styles: tuple[str, ...] = ()


Block: TypeAlias = Line | Table


def narrowed(table: Table) -> Table:
    """A table without the columns that are empty."""
    full = [at for at in range(len(table.headings)) if any(cells[at] for cells in table.rows)]
    rows = tuple(tuple(cells[at] for at in full) for cells in table.rows)
    return Table(tuple(table.headings[at] for at in full), rows, table.styles)
