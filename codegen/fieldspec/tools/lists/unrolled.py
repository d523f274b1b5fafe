"""Lists whose rows are not single registers: matrices with an address in each cell, and registers side by side."""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import pairwise, zip_longest

from fieldspec.foundation.classes import replace
from fieldspec.tools.lists.addresses import DECIMAL, address_text
from fieldspec.tools.lists.assumption import Assumption
from fieldspec.tools.lists.sheet import Sheet, SheetRow
from fieldspec.tools.lists.words import folded, pattern, whole_words

_FEWEST_ROLES, _FEWEST = 3, 2
"""The fewest roles of the first cells of rows, and the fewest columns and rows of a matrix."""

_MOST_ROWS = 200
_NONE = ("", "-", "--", "n/a", "\u2013", "\u2014")
_NUMBERED = re.compile(r"(.*?)[\s_#-]*(?:[0-9]{1,2}|[A-Z])")
"""A heading of one of several things: `Motor 1`, `L2`, `Phase B`."""


def side_by_side(sheet: Sheet, assumptions: list[Assumption]) -> Sheet:
    """A sheet whose rows are columns of registers, turned round: the first cells of its rows are headings, and a
    further block begins with the first of them again. Any other sheet is as it is."""
    heads = [row.cell(0) for row in sheet.rows]
    roles = [whole_words().get(folded(head)) for head in heads]
    addresses = [row for row, role in zip(sheet.rows, roles, strict=True) if role == "address"]
    cells = [cell for row in addresses for cell in row.cells[1:]]
    are_headings = len({*roles} - {None}) >= _FEWEST_ROLES and roles.count(None) * 4 <= len(roles) <= _MOST_ROWS
    if not are_headings or len(cells) < _FEWEST or not all(map(address_text, filter(None, cells))):
        return sheet
    headings = tuple(dict.fromkeys(heads))
    starts = [n for n, head in enumerate(heads) if folded(head) == folded(heads[0])]
    rows = [SheetRow(1, headings)]
    for start, end in pairwise([*starts, len(heads)]):
        for column in [*zip_longest(*(row.cells for row in sheet.rows[start:end]), fillvalue="")][1:]:
            texts = dict(zip(heads[start:end], column, strict=True))
            rows.append(SheetRow(len(rows) + 1, tuple(texts.get(heading, "") for heading in headings)))
    evidence = f"{', '.join(headings[:_FEWEST_ROLES])} are the first cells of rows"
    assumptions.append(Assumption("registers", "side by side; rows are columns of the file", evidence))
    return replace(sheet, rows=tuple(row for row in rows if any(row.cells)))


def matrix(sheet: Sheet, assumptions: list[Assumption]) -> Sheet | None:
    """A sheet with a row for each cell that is an address, named after its row and its column; None where the sheet
    does not show that its cells are addresses. Rows count on from column to column."""
    for index, head in enumerate(sheet.rows):
        rows = [row for row in sheet.rows[index + 1 :] if sum(map(bool, row.cells)) > 1]
        names = next((n for n in range(len(head.cells)) if _are_names(rows, n, head.cell(n))), None)
        columns = [n for n, text in enumerate(head.cells) if n != names and _heads_addresses(text, rows, n)]
        texts_above = [text for row in sheet.rows[: index + 1] for text in row.cells]
        if (
            names is not None
            and len(columns) >= _FEWEST <= len(rows)
            and _have_addresses(texts_above, head, rows, columns)
        ):
            break
    else:
        return None
    other_columns = [n for n in range(len(head.cells)) if n not in (*columns, names)]
    below = [SheetRow(head.number, ("address", "name", *(head.cell(n) for n in other_columns)))]
    for column in columns:
        for row in rows:
            text = row.cell(names)
            text = text if any(map(str.isalpha, text)) else f"{head.cell(names)} {text}".strip()
            address = "" if row.cell(column) in _NONE else row.cell(column)
            cells = (address, f"{text} {head.cell(column)}", *(row.cell(n) for n in other_columns))
            below.append(SheetRow(below[-1].number + 1, cells))
    reading = f"cells under {', '.join(map(head.cell, columns))} are addresses; rows count on from column to column"
    assumptions.append(Assumption("matrix", reading, "each cell is there once"))
    unrolled_rows = (*sheet.rows[:index], *(row for row in below if row.cell(0)))
    return replace(sheet, rows=unrolled_rows, heads=frozenset())


def _heads_addresses(text: str, rows: Sequence[SheetRow], column: int) -> bool:
    """Whether a heading names no other role, and whether most rows have an address below it, and none anything else."""
    texts = [cell for row in rows if (cell := row.cell(column)) not in _NONE]
    is_free = bool(text) and whole_words().get(folded(text), "name") in ("name", "label") and not text[0].isdigit()
    are_addresses = all((address := address_text(cell)) is not None and not address.prefixed for cell in texts)
    return is_free and are_addresses and len(texts) * 2 > len(rows)


def _are_names(rows: Sequence[SheetRow], column: int, heading: str) -> bool:
    """Whether a column has a text or a number for each row, below a heading that may be of names."""
    texts = [row.cell(column) for row in rows]
    may_be_named = whole_words().get(folded(heading), "name") in ("name", "label")
    return may_be_named and all(texts) and len({*texts}) == len(texts)


def _have_addresses(
    texts_above: Sequence[str], head: SheetRow, rows: Sequence[SheetRow], columns: Sequence[int]
) -> bool:
    """Whether cells are addresses: each is there once, and has a mark, or they lie apart alike in all rows below
    headings of one thing with numbers, or below a text about addresses."""
    texts = [[row.cell(n) for n in columns] for row in rows]
    addresses = [[address_text(text) for text in line] for line in texts]
    filled = [address for line in addresses for address in line if address is not None]
    if len({address.digits.casefold() for address in filled}) < len(filled):
        return False
    if all(address.mark for address in filled):
        return True
    numbers = [[address.number(DECIMAL) if address else None for address in line] for line in addresses]
    steps = {tuple(b - a if a is not None and b is not None else None for a, b in pairwise(line)) for line in numbers}
    stems = {match[1] if (match := _NUMBERED.fullmatch(head.cell(n))) else head.cell(n) for n in columns}
    is_stated = any(map(pattern("of_addresses").search, texts_above))
    return len(steps) == 1 and None not in steps.pop() and (len(stems) == 1 or is_stated)
