"""Facts by versions: which versions have a fact, and what it states there."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from fieldspec.foundation.classes import TYPE_CHECKING, dataclass
from fieldspec.tools.facts.row import Cell, FactRow

if TYPE_CHECKING:
    from typing import TypeAlias

Renaming: TypeAlias = "Callable[[str], str]"
"""Gives the path that a fact of a version has in the next one."""

SAME = "same"
# Columns that say where a fact is in the spec and in the manual, and not what it states.
_PLACES = ("kind", "path", "section", "line", "printed", "errata", "sources")
_LONGEST = 40


@dataclass(frozen=True, slots=True)
class MatrixRow:
    """A fact with a cell for each version: empty if it is missing, what it states, or `same` as the version before.

    `path` is that of the newest version that has the fact.
    """

    path: str
    kind: str
    cells: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Matrix:
    """A table of facts with a column for each version."""

    versions: tuple[str, ...]
    rows: tuple[MatrixRow, ...]


def matrix(facts: Mapping[str, Sequence[FactRow]], everything: bool, renamings: Sequence[Renaming] = ()) -> Matrix:
    """The matrix of the facts of each version, in their order: of those that differ, or of everything.

    `renamings` lead from each version to the next one; without them, a renamed fact is two.
    """
    columns = []
    for number, rows in enumerate(facts.values()):
        columns.append(_by_path(rows, renamings[number:]))
    paths: dict[str, None] = {}
    for rows_by_path in columns:
        paths |= dict.fromkeys(rows_by_path)
    rows_of_matrix = []
    for path in paths:
        of_path = [rows_by_path.get(path) for rows_by_path in columns]
        if everything or len({_row_values(row) for row in of_path}) > 1:
            kind = next(str(row["kind"]) for row in of_path if row is not None)
            rows_of_matrix.append(MatrixRow(path, kind, tuple(_cells(of_path))))
    return Matrix(tuple(facts), tuple(rows_of_matrix))


def _by_path(rows: Sequence[FactRow], renamings: Sequence[Renaming]) -> dict[str, FactRow]:
    """The first row of each path, which is the newest one. The others are the same fact, printed again."""
    first_rows: dict[str, FactRow] = {}
    for row in rows:
        path = str(row["path"])
        for renaming in renamings:
            path = renaming(path)
        first_rows.setdefault(path, row)
    return first_rows


def _row_values(row: FactRow | None) -> tuple[tuple[str, str], ...] | None:
    """The statements of a fact; None if it is missing. Versions are compared by this."""
    if row is None:
        return None
    return tuple((key, _cell_text(key, cell)) for key, cell in row.items() if key not in _PLACES and cell is not None)


def _cells(rows: Sequence[FactRow | None]) -> list[str]:
    cells: list[str] = []
    before: dict[str, str] | None = None
    for row in rows:
        values = _row_values(row)
        if values is None:
            cells.append("")
            continue
        now = dict(values)
        if before is None:
            cells.append(_described(now))
        elif now == before:
            cells.append(SAME)
        else:
            keys = [key for key in {**before, **now} if before.get(key) != now.get(key)]
            cells.append(", ".join(f"{key} {now.get(key, 'not given')}" for key in keys))
        before = now
    return cells


def _described(values: Mapping[str, str]) -> str:
    """A fact in a few words, for the first version that has it."""
    texts = [values[key] for key in ("type", "access", "ranges", "unit", "code") if key in values]
    return " ".join(texts) or "there"


def _cell_text(key: str, cell: Cell) -> str:
    """A cell as text. Addresses are hexadecimal, with the decimal number after them."""
    text = f"0x{cell:04X} ({cell})" if key == "address" and isinstance(cell, int) else str(cell)
    return text if len(text) <= _LONGEST else f"{text[:_LONGEST]}..."
