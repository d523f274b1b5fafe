"""The tables of a sheet: their headings, the rows below them, and several tables as one."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from functools import reduce
from itertools import pairwise

from fieldspec.foundation.classes import replace
from fieldspec.tools.lists.addresses import HEXADECIMAL, address_text, base_of_heading
from fieldspec.tools.lists.column_contents import is_place
from fieldspec.tools.lists.column_roles import (
    LOOKED_AT,
    Columns,
    address_rank,
    column_index,
    column_number,
    guessed_columns,
    headings_text,
)
from fieldspec.tools.lists.sheet import ListError, Sheet, SheetRow
from fieldspec.tools.lists.words import folded, meaning, whole_words

_BARE = re.compile("[0-9A-Fa-f]{1,8}")
_HEADED_BY = 40
"""The number of rows among which the heading is searched."""

_SEARCHED, _CLEAR = 1000, 2
"""The number of rows among which a heading is searched whose addresses are clear, where no other has two roles."""

_MOST_HEADING_ROWS, _FEWEST_NUMBERS = 3, 3
_MOST_TABLES, _MOST_MARKED_TABLES = 40, 200
_LONGEST_HEADING = 100
_NUMBERS_AND_NAMES = 2
"""The headings of a table that may be one of anything: its numbers, and their names."""


def columns(sheet: Sheet, names: Mapping[str, str]) -> Columns:
    """The columns of a sheet. `names` has a heading, a letter or a number for some roles.

    Raises ListError if no column has addresses.
    """
    if not sheet.rows:
        raise ListError("is empty")
    if sheet.heads and (marked := _marked_tables(sheet, names)) is not None:
        return marked
    best: Columns | None = None
    earlier: list[Columns] = []
    for index, row in enumerate(sheet.rows[:_SEARCHED]):
        if index >= _HEADED_BY and ((best and best.headed > 1) or max(map(address_rank, row.cells)) < _CLEAR):
            continue
        if sheet.heads and sum(map(bool, row.cells)) == 1:
            continue  # a line of a document, whose tables have headings
        is_comment = _is_comment(row) and not all(map(_is_comment, sheet.rows[:index]))
        if not _is_heading(row) or is_comment:
            continue
        for last in range(index, min(index + _MOST_HEADING_ROWS, len(sheet.rows))):
            below = sheet.rows[index : last + 1]
            is_whole = all(_is_heading(row_below) for row_below in below) and not any(map(_is_comment, below[1:]))
            if not is_whole or (last - index and not _continues(below)):
                break
            parts = _heading_parts(below)
            candidate = guessed_columns(parts, names, sheet.rows[last + 1 :])
            if candidate is not None and last == index and candidate.headed > 1:
                earlier.append(candidate)
            if candidate is not None and (best is None or candidate.headed >= best.headed + (last == index)):
                best = candidate
    if best is None:
        best = _without_heading(sheet, names)
    if "address" not in names:
        _refuse_identifiers(best)
        _refuse_neighbours(sheet.rows[:_HEADED_BY])
    if not best.rows:
        raise ListError("has a heading and no rows")
    if names:
        return best
    first_row = best.rows[0].number
    tables = (table for table in earlier if _has_rows_before(table, first_row))
    return _with_further_tables(next(tables, best))


def without_numbers(sheet: Sheet) -> Sheet:
    """A sheet without a first row that numbers its columns from 0, and without the numbers of rows below it, which
    programs write that have tables without headings."""
    if not sheet.rows:
        return sheet
    first, *rows = sheet.rows
    numbers = [cell for cell in first.cells if cell]
    if len(numbers) < _FEWEST_NUMBERS or numbers != [str(number) for number in range(len(numbers))] or not rows:
        return sheet
    if first.cell(0) or [row.cell(0) for row in rows] != [str(number) for number in range(len(rows))]:
        return replace(sheet, rows=tuple(rows))
    return replace(sheet, rows=tuple(SheetRow(row.number, ("", *row.cells[1:])) for row in rows))


def _refuse_identifiers(table: Columns) -> None:
    """Raises ListError for a list of messages on a CAN bus, which have identifiers and not addresses of registers."""
    kinds = {meaning("can", heading): heading for heading in table.headings if heading}
    is_clear = address_rank(table.heading("address")) >= _CLEAR
    if not is_clear and ("identifier" in kinds or {"message", "place"} <= kinds.keys()):
        heading = kinds.get("identifier") or table.heading("address")
        raise ListError(
            f"has messages of a CAN bus, with identifiers under {heading}, and not addresses of registers; import its "
            "DBC, or name the column of registers with --address"
        )


def _refuse_neighbours(rows: Sequence[SheetRow]) -> None:
    """Raises ListError for two tables side by side, whose headings stand twice in a row."""
    for row in rows:
        heads = [folded(cell) for cell in row.cells if cell]
        half = len(heads) // 2
        if half > 1 and heads[:half] == heads[half:] and "address" in map(whole_words().get, heads):
            raise ListError(
                f"has two tables side by side, with the headings {headings_text(row.cells)}; give each a sheet"
            )


def _marked_tables(sheet: Sheet, names: Mapping[str, str]) -> Columns | None:
    """The columns of all tables with addresses of a sheet that marks its headings; None if it has none."""
    starts = [index for index, row in enumerate(sheet.rows) if row.number in sheet.heads]
    if len(starts) > _MOST_MARKED_TABLES:
        raise ListError(f"has more than {_MOST_MARKED_TABLES} tables; a list of registers has fewer")
    parts: list[tuple[SheetRow, int, Columns | None]] = []
    for start, end in pairwise([*starts, len(sheet.rows)]):
        head = sheet.rows[start]
        rows = tuple(row for row in sheet.rows[start + 1 : end] if sum(map(bool, row.cells)) > (row.cell(0) != ""))
        table = guessed_columns([[cell] if cell else [] for cell in head.cells], names, rows) if rows else None
        has_addresses = table is not None and any(is_place(table.cell(row, "address")) for row in rows)
        parts.append((head, len(rows), table if has_addresses else None))
    ranks = [_rank(table) if table is not None else 0 for _, _, table in parts]
    tables = [table for (_, _, table), rank in zip(parts, ranks, strict=True) if table and rank == max(ranks)]
    if "address" not in names and tables and not max(ranks):
        heading = tables[0].heading("address")
        raise ListError(
            f"has tables, and none that says it has addresses; if {heading} has them, name it with --address"
        )
    used = set(map(id, tables))
    other_tables = tuple((head, number) for head, number, table in parts if number and id(table) not in used)
    return replace(reduce(joined_columns, tables), other_tables=other_tables) if tables else None


def _rank(table: Columns) -> int:
    """How clearly a table is one of registers: 0 for a column of numbers with names alone."""
    headings = [table.heading("address"), *map(table.heading_at, table.more.get("address", ()))]
    is_clear = max(map(address_rank, headings)) >= _CLEAR
    return _CLEAR if is_clear else int(table.headed > _NUMBERS_AND_NAMES)


def _has_rows_before(table: Columns, number: int) -> bool:
    """Whether a table has rows with addresses before that of a number, below a heading whose words are all known."""
    heads = [folded(text) for text in table.headings if text]
    texts = (table.cell(row, "address") for row in table.rows if row.number < number - 1)
    return all(head in whole_words() for head in heads) and any(address_text(text) for text in texts)


def _with_further_tables(first: Columns) -> Columns:
    """The columns of a sheet, with the rows of the tables below in them, each of which has a heading of its own."""
    tables = [(first, 0, first.headings)]
    for index, row in enumerate(first.rows):
        roles = [whole_words().get(folded(cell)) for cell in row.cells if cell]
        is_heading = "address" in roles and roles.count(None) * 2 <= len(roles) and row.cells != tables[-1][2]
        text = row.cell(tables[-1][0].places["address"])
        is_heading = is_heading and (folded(text) in whole_words() or address_text(text) is None)
        if is_heading and len(tables) < _MOST_TABLES:
            sample = first.rows[index + 1 : index + 1 + LOOKED_AT]
            further = guessed_columns([[cell] if cell else [] for cell in row.cells], {}, sample)
            if further is not None and further.headed > 1:
                tables.append((further, index + 1, row.cells))
    ends = [start - 1 for _, start, _ in tables[1:]] + [len(first.rows)]
    parts = [replace(table, rows=first.rows[start:end]) for (table, start, _), end in zip(tables, ends, strict=True)]
    return reduce(joined_columns, parts)


def joined_columns(first: Columns, further: Columns) -> Columns:
    """Two tables as one: columns of a role that both have are one, and others follow the columns of the first table."""
    first, further = _with_marks(first, further), _with_marks(further, first)
    headings = [*first.headings]
    places, further_columns = dict(first.places), dict(first.more)
    targets: dict[int, int] = {}
    unused = {folded(first.heading_at(column)): column for column in first.unused()}
    existing = {heading: column for column, heading in _further_headings(first)}
    targets |= {column: existing[heading] for column, heading in _further_headings(further) if heading in existing}
    for role, column in further.places.items():
        targets[column] = places.setdefault(role, unused.get(folded(further.heading_at(column)), len(headings)))
        headings += [further.heading_at(column)] if targets[column] == len(headings) else []
    unused |= {folded(first.heading(role)): first.places[role] for role in first.by_cells}
    for column in range(max((len(row.cells) for row in further.rows), default=0)):
        if column not in targets:
            targets[column] = unused.get(folded(further.heading_at(column)), len(headings))
            headings += [further.heading_at(column)] if targets[column] == len(headings) else []
    for role, columns_of_role in further.more.items():
        joined = (*further_columns.get(role, ()), *(targets[column] for column in columns_of_role))
        further_columns[role] = tuple(dict.fromkeys(joined))
    rows = list(first.rows)
    for row in further.rows:
        cells = [""] * len(headings)
        for column, target in targets.items():
            cells[target] = row.cell(column)
        rows.append(SheetRow(row.number, tuple(cells)))
    by_cells = tuple(dict.fromkeys((*first.by_cells, *further.by_cells)))
    return Columns(places, tuple(headings), tuple(rows), further_columns, by_cells)


def _with_marks(table: Columns, other: Columns) -> Columns:
    """A table with marks of hexadecimal addresses, where its heading says that, and that of another one does not."""
    place, heading = table.places["address"], other.heading("address")
    if base_of_heading(table.heading("address")) != HEXADECIMAL or base_of_heading(heading) == HEXADECIMAL:
        return table
    rows = []
    for row in table.rows:
        text = row.cell(place)
        marked = f"0x{text}" if _BARE.fullmatch(text) else text
        rows.append(SheetRow(row.number, (*row.cells[:place], marked, *row.cells[place + 1 :])))
    headings = (*table.headings[:place], heading, *table.headings[place + 1 :])
    return replace(table, rows=tuple(rows), headings=headings)


def _further_headings(table: Columns) -> Iterator[tuple[int, tuple[str, str]]]:
    """The further columns of roles that several may have, each with the role and its heading."""
    for role, columns_of_role in table.more.items():
        yield from ((column, (role, folded(table.heading_at(column)))) for column in columns_of_role)


def headed_columns(sheet: Sheet) -> Columns | None:
    """The columns of a sheet with a heading, and with addresses below it; None where there are none."""
    try:
        columns_of_sheet = columns(without_numbers(sheet), {})
    except ListError:
        return None
    return columns_of_sheet if columns_of_sheet.headings and columns_of_sheet.headed else None


def _is_heading(row: SheetRow) -> bool:
    """Whether a row may be a heading: it has texts, and none of them is an address with digits."""
    filled = [cell for cell in row.cells if cell]
    numbers = sum(cell[:1].isdigit() and is_place(cell) for cell in filled)
    return bool(filled) and not numbers and max(map(len, filled)) <= _LONGEST_HEADING


def _is_comment(row: SheetRow) -> bool:
    """Whether a row may be a comment of a file of text, as one after other rows is."""
    return row.cell(0).startswith("# ") or row.cell(0) == "#"


def _continues(rows: Sequence[SheetRow]) -> bool:
    """Whether the last of some rows continues the heading above: half of its cells are headings, or in brackets."""
    counts = [sum(map(bool, row.cells)) for row in rows]
    labels = sum(folded(cell) in whole_words() or cell.startswith(("(", "[")) for cell in rows[-1].cells if cell)
    return counts[0] > 1 and counts[-1] <= max(counts[:-1]) and labels * 2 >= counts[-1]


def _heading_parts(rows: Sequence[SheetRow]) -> list[list[str]]:
    """The texts of each column in the rows of a heading. A text over several columns counts for all of them."""
    width = max(len(row.cells) for row in rows)
    parts: list[list[str]] = []
    for column in range(width):
        texts = []
        for number, row in enumerate(rows):
            text = row.cell(column)
            later = any(below.cell(column) for below in rows[number + 1 :])
            if not text and later and column and parts[column - 1] and not number:
                text = parts[column - 1][0]
            if text:
                texts.append(text)
        parts.append(texts)
    return parts


def _without_heading(sheet: Sheet, names: Mapping[str, str]) -> Columns:
    """The columns of a list whose first row is data, or a heading that names no role."""
    first = sheet.rows[0]
    width = max(len(row.cells) for row in sheet.rows)
    heads = first.cells if _is_heading(first) else ()
    headings = headings_text(heads)
    by_cells = guessed_columns([[]] * width, names, sheet.rows) if not heads else None
    if by_cells is not None and ("name" in by_cells.places or "address" in names):
        return by_cells
    places = {}
    for role, text in names.items():
        column = column_index(heads, text) if heads else None
        column = column_number(text, width) if column is None else column
        if column is None:
            raise ListError(f"has no column {text}; choose from {headings}, or give a letter or a number")
        places[role] = column
    if "address" not in places:
        raise ListError(
            f"has no column that looks like addresses ({headings}); name it with --address, by its heading, letter or "
            "number"
        )
    rows = sheet.rows[1:] if heads else sheet.rows
    return Columns(places, heads, rows)
