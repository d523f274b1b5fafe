"""The role of each column of a list: by its heading, in the languages of `words.json`, and by its cells."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cache, reduce

from fieldspec.foundation.classes import dataclass, field, replace
from fieldspec.tools.lists import cells
from fieldspec.tools.lists.addresses import address_text
from fieldspec.tools.lists.brackets import without_brackets
from fieldspec.tools.lists.column_contents import NOTED, are_spaces, counts_on, has_role, repeats
from fieldspec.tools.lists.sheet import ListError, Sheet, SheetRow, letters
from fieldspec.tools.lists.type_words import typed
from fieldspec.tools.lists.value_texts import value_meanings
from fieldspec.tools.lists.words import folded, words

_SHORT_REGISTER = re.compile(r"reg(?![a-z])", re.IGNORECASE)
_BETWEEN = re.compile(r"\s*[/|\n]\s*")
_LONGEST = 200
_HEADED_BY = 40
"""The number of rows among which the heading is searched."""

_MOST_HEADING_ROWS = 3
_MOST_TABLES = 40
_LOOKED_AT = 200
"""The number of rows whose cells show what a column has_role."""

NOTE = "note"


@dataclass(frozen=True, slots=True)
class Columns:
    """The columns of a list by role, counted from 0, its headings, and the rows below them.

    `more` are further columns of roles that several may have: addresses, names and notes.
    """

    places: Mapping[str, int]
    headings: tuple[str, ...]
    rows: tuple[SheetRow, ...]
    more: Mapping[str, tuple[int, ...]] = field(default_factory=dict)

    def cell(self, row: SheetRow, role: str) -> str:
        """The cell of a row in the column of a role; empty if the list has no such column."""
        column = self.places.get(role)
        return row.cell(column) if column is not None else ""

    def heading(self, role: str) -> str:
        """The heading of a role's column, or its letter if it has none."""
        return self.heading_at(self.places[role])

    def heading_at(self, column: int) -> str:
        """The heading of a column, or its letter if it has none."""
        text = self.headings[column] if column < len(self.headings) else ""
        return text or f"column {letters(column + 1)}"

    def unused(self) -> list[int]:
        """The columns without a role that have cells."""
        used = {*self.places.values(), *(column for columns in self.more.values() for column in columns)}
        width = max((len(row.cells) for row in self.rows), default=0)
        return [column for column in range(width) if column not in used and any(row.cell(column) for row in self.rows)]


def columns(sheet: Sheet, names: Mapping[str, str]) -> Columns:
    """The columns of a sheet. `names` has a heading, a letter or a number for some roles.

    Raises ListError if no column has addresses.
    """
    if not sheet.rows:
        raise ListError("is empty")
    best: Columns | None = None
    earlier: list[Columns] = []
    for index, row in enumerate(sheet.rows[:_HEADED_BY]):
        if not _is_heading(row):
            continue
        for last in range(index, min(index + _MOST_HEADING_ROWS, len(sheet.rows))):
            below = sheet.rows[index : last + 1]
            if not all(_is_heading(row_below) for row_below in below) or (last - index and not _continues(below)):
                break
            parts = _heading_parts(below)
            candidate = _guessed(parts, names, sheet.rows[last + 1 :])
            if candidate is not None and last == index and len(candidate.places) > 1:
                earlier.append(candidate)
            if candidate is not None and (best is None or len(candidate.places) >= len(best.places) + (last == index)):
                best = candidate
    if best is None:
        best = _without_heading(sheet, names)
    if not best.rows:
        raise ListError("has a heading and no rows")
    if names:
        return best
    first_row = best.rows[0].number
    tables = (table for table in earlier if _has_rows_before(table, first_row))
    return _with_further_tables(next(tables, best))


def _has_rows_before(table: Columns, number: int) -> bool:
    """Whether a table has rows with addresses before that of a number, below a heading whose words are all known."""
    heads = [folded(text) for text in table.headings if text]
    texts = (table.cell(row, "address") for row in table.rows if row.number < number - 1)
    return all(head in _whole_words() for head in heads) and any(address_text(text) for text in texts)


def _with_further_tables(first: Columns) -> Columns:
    """The columns of a sheet, with the rows of the tables below in them, each of which has a heading of its own."""
    tables = [(first, 0, first.headings)]
    for index, row in enumerate(first.rows):
        roles = [_whole_words().get(folded(cell)) for cell in row.cells if cell]
        is_heading = "address" in roles and roles.count(None) * 2 <= len(roles) and row.cells != tables[-1][2]
        text = row.cell(tables[-1][0].places["address"])
        is_heading = is_heading and (folded(text) in _whole_words() or address_text(text) is None)
        if is_heading and len(tables) < _MOST_TABLES:
            sample = first.rows[index + 1 : index + 1 + _LOOKED_AT]
            further = _guessed([[cell] if cell else [] for cell in row.cells], {}, sample)
            if further is not None and len(further.places) > 1:
                tables.append((further, index + 1, row.cells))
    ends = [start - 1 for _, start, _ in tables[1:]] + [len(first.rows)]
    parts = [replace(table, rows=first.rows[start:end]) for (table, start, _), end in zip(tables, ends, strict=True)]
    return reduce(_joined, parts)


def _joined(first: Columns, further: Columns) -> Columns:
    """Two tables as one: columns of a role that both have are one, and others follow the columns of the first table."""
    headings = [*first.headings]
    places, further_columns = dict(first.places), dict(first.more)
    targets: dict[int, int] = {}
    for role, column in further.places.items():
        targets[column] = places.setdefault(role, len(headings))
        headings += [further.heading_at(column)] if targets[column] == len(headings) else []
    for column in range(max((len(row.cells) for row in further.rows), default=0)):
        if column not in targets:
            targets[column] = len(headings)
            headings.append(further.heading_at(column))
    for role, columns_of_role in further.more.items():
        further_columns[role] = (*further_columns.get(role, ()), *(targets[column] for column in columns_of_role))
    rows = list(first.rows)
    for row in further.rows:
        cells = [""] * len(headings)
        for column, target in targets.items():
            cells[target] = row.cell(column)
        rows.append(SheetRow(row.number, tuple(cells)))
    return Columns(places, tuple(headings), tuple(rows), further_columns)


def role_count(sheet: Sheet) -> int:
    """How many columns of a sheet have a role by a heading, with addresses below it; 0 where there are none."""
    try:
        ranked_columns = columns(sheet, {})
    except ListError:
        return 0
    return len(ranked_columns.places) if ranked_columns.headings else 0


def _is_heading(row: SheetRow) -> bool:
    """Whether a row may be a heading: it has texts, and none of them is an address with digits."""
    filled = [cell for cell in row.cells if cell]
    numbers = sum(cell[:1].isdigit() and address_text(cell) is not None for cell in filled)
    return bool(filled) and not numbers


def _continues(rows: Sequence[SheetRow]) -> bool:
    """Whether the last of some rows continues the heading above: half of its cells are headings, or in brackets."""
    counts = [sum(map(bool, row.cells)) for row in rows]
    labels = sum(folded(cell) in _whole_words() or cell.startswith(("(", "[")) for cell in rows[-1].cells if cell)
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


def _guessed(parts: list[list[str]], names: Mapping[str, str], rows: tuple[SheetRow, ...]) -> Columns | None:
    """The columns below a heading, None if none has addresses, or if one that the user names is not there."""
    headings = tuple(" ".join(texts) for texts in parts)
    places: dict[str, int] = {}
    for role, text in names.items():
        column = _column_index(headings, text)
        if column is None:
            return None
        places[role] = column
    heads = [tuple(dict.fromkeys(map(folded, _variants(texts)))) for texts in parts]
    sample = rows[:_LOOKED_AT]
    further: dict[str, tuple[int, ...]] = {}
    of_spaces = [column for column in _ranked(heads, words("headings")["type"], set()) if are_spaces(sample, column)]
    for role, role_words in words("headings").items():
        used_columns = {*places.values(), *(column for columns in further.values() for column in columns)}
        fits = _ranked(heads, role_words, used_columns)
        if role in ("type", "space"):
            fits = [column for column in fits if column not in of_spaces] + (of_spaces if role == "space" else [])
        is_fallback = not fits
        if is_fallback:
            fits = _ranked(heads, words("fallbacks").get(role, ()), used_columns)
        texts = {column: [text for row in sample if (text := row.cell(column))] for column in fits}
        columns = [column for column in fits if has_role(role, texts[column], is_fallback)]
        if role in NOTED and not columns:
            columns = [column for column in fits if not {*heads[column]}.isdisjoint(role_words)]
        if role == "address" and "address" not in places:
            columns = (
                columns or [column for column in fits if any(address_text(row.cell(column)) for row in sample)] or fits
            )
        if role == "address" and (len(columns) > 1 or "address" in places):
            lengths = _ranked(heads, words("headings")["words"], set())
            columns = [column for column in columns if column not in lengths] or columns
            columns = [column for column in columns if not folded(headings[column]).endswith("offset")] or columns
        if role == "name" and "name" not in places:
            columns = sorted(columns, key=lambda column: repeats(sample, column))
        if role not in places and columns:
            places[role] = columns[0]
            columns = columns[1:]
        if role in ("address", "name", NOTE) and columns and not (role == "address" and "address" in names):
            further[role] = tuple(columns)
    codes = _ranked([heads[column] for column in further.get("address", ())], words("codes")["printed_name"], set())
    if codes and "printed_name" not in places:
        places["printed_name"] = further["address"][codes[0]]
        further["address"] = tuple(column for column in further["address"] if column != places["printed_name"])
    if "value_offset" in places and "address" in places and counts_on(sample, places["value_offset"]):
        further["address"] = (*further.get("address", ()), places.pop("value_offset"))
    if "name" not in places:
        used_columns = {*places.values(), *(column for columns in further.values() for column in columns)}
        if labels := _ranked(heads, words("headings")["label"], used_columns):
            places["name"] = labels[0]
    if "value" in places and not {"range", "values"} & {*places}:
        filled = [text for row in sample if (text := row.cell(places["value"]))]
        if 0 < len(filled) <= 3 * sum(bool(cells.bounds(text) or value_meanings(text)) for text in filled):
            places["range"] = places.pop("value")
        elif filled and "type" not in places and all(map(typed, filled)):
            places["type"] = places.pop("value")
    of_heading = cells.space(headings[places["address"]]) if "address" in places else ""
    if of_heading and "address" in further:
        column_spaces = {column: cells.space(headings[column]) for column in further["address"]}
        further["address"] = tuple(column for column, other in column_spaces.items() if other in ("", of_heading))
    if byte_columns := _byte_columns(heads, {*places.values()}):
        rows, headings = _with_addresses_of_bytes(rows, headings, byte_columns)
        further |= {"bytes of addresses": byte_columns}
        if "address" in places:
            further["address"] = (*further.get("address", ()), len(headings) - 1)
        places.setdefault("address", len(headings) - 1)
    if "address" not in places and len(marked := _marked_columns(sample, {*places.values()})) == 1:
        places["address"] = marked[0]
    if "address" not in places:
        return None
    return Columns(places, headings, rows, further)


def _marked_columns(rows: Sequence[SheetRow], used_columns: set[int]) -> list[int]:
    """The columns with only addresses that have a mark, such as `0x10`, whatever their headings are."""
    texts: dict[int, list[str]] = {}
    for row in rows:
        for column, text in enumerate(row.cells):
            texts.setdefault(column, []).extend(filter(None, [text]))
    return [
        column
        for column, cells_of_column in texts.items()
        if column not in used_columns
        and len(cells_of_column) * 2 > len(rows)
        and all((address := address_text(text)) is not None and address.mark for text in cells_of_column)
    ]


def _byte_columns(heads: Sequence[tuple[str, ...]], used_columns: set[int]) -> tuple[int, ...]:
    """The columns with the high and the low byte of addresses; empty if the list has none."""
    halves = [_ranked(heads, words("address_bytes")[half], used_columns)[:1] for half in ("high", "low")]
    return (*halves[0], *halves[1]) if all(halves) else ()


def _with_addresses_of_bytes(
    rows: tuple[SheetRow, ...], headings: tuple[str, ...], byte_columns: tuple[int, ...]
) -> tuple[tuple[SheetRow, ...], tuple[str, ...]]:
    """The rows with a further column of addresses, made of two bytes: `01 56`."""
    joined = []
    for row in rows:
        cells = [row.cell(column) for column in range(len(headings))]
        digits = [cells[column].zfill(2) if cells[column] else "" for column in byte_columns]
        joined.append(SheetRow(row.number, (*cells, " ".join(filter(None, digits)))))
    return tuple(joined), (*headings, " ".join(headings[column] for column in byte_columns))


def _variants(texts: Sequence[str]) -> Iterator[str]:
    """A heading as a whole, its rows, each without what is in brackets, and what means the same in two languages."""
    for text in (" ".join(texts), *texts):
        yield text
        if bare := without_brackets(text).strip():
            yield bare
        if _SHORT_REGISTER.match(text):
            yield _SHORT_REGISTER.sub("register", text)
        pieces = _BETWEEN.split(text)
        roles = {_whole_words().get(folded(piece)) for piece in pieces}
        if len(pieces) > 1 and len(roles - {None}) == 1:
            yield next(piece for piece in pieces if folded(piece) in _whole_words())


def _ranked(heads: Sequence[tuple[str, ...]], role_words: Sequence[str], used_columns: set[int]) -> list[int]:
    """The columns whose headings fit a role, the likeliest first. No part counts of a heading that is another word."""
    whole = _whole_words()
    ranked_columns: dict[int, None] = {}
    for word in role_words:
        for column, texts in enumerate(heads):
            if (
                column not in used_columns
                and any(_fits(text, word) for text in texts)
                and (
                    not word.startswith("*")
                    or whole.keys().isdisjoint(texts)
                    or not whole.keys().isdisjoint({*texts} & {*role_words})
                )
            ):
                ranked_columns.setdefault(column)
    return list(ranked_columns)


@cache
def _whole_words() -> Mapping[str, str]:
    """The headings that are whole words of a role, with the first such role."""
    return {
        word: role
        for role, role_words in reversed([*words("headings").items()])
        for word in role_words
        if not word.startswith("*")
    }


def _fits(head: str, word: str) -> bool:
    return word[1:] in head if word.startswith("*") else head == word


def _column_index(headings: Sequence[str], text: str) -> int | None:
    """The column that a user names: by its heading, by its number, or by its letters."""
    heads = [folded(heading) for heading in headings]
    if folded(text) and folded(text) in heads:
        return heads.index(folded(text))
    return _numbered(text, len(headings))


def _numbered(text: str, width: int) -> int | None:
    if re.fullmatch("[0-9]{1,4}", text) and 1 <= int(text) <= width:
        return int(text) - 1
    if re.fullmatch("[A-Za-z]{1,2}", text):
        number = 0
        for letter in text.upper():
            number = number * 26 + ord(letter) - ord("A") + 1
        return number - 1 if number <= width else None
    return None


def _without_heading(sheet: Sheet, names: Mapping[str, str]) -> Columns:
    """The columns of a list whose first row is data, or a heading that names no role."""
    first = sheet.rows[0]
    width = max(len(row.cells) for row in sheet.rows)
    heads = first.cells if _is_heading(first) else ()
    headings = headings_text(heads)
    places = {}
    for role, text in names.items():
        column = _column_index(heads, text) if heads else None
        column = _numbered(text, width) if column is None else column
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


def headings_text(headings: Iterable[str]) -> str:
    """The headings of a file for a message, cut if there are many."""
    joined = ", ".join(text for text in headings if text)
    if not joined:
        return "no headings"
    return joined if len(joined) <= _LONGEST else f"{joined[:_LONGEST]}..."
