"""The role of each column of a list: by its heading, in the languages of `words.json`, and by its cells."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from itertools import pairwise, product

from fieldspec.foundation.classes import dataclass, field
from fieldspec.tools.lists import cells
from fieldspec.tools.lists.addresses import DECIMAL, HEXADECIMAL, address_text
from fieldspec.tools.lists.brackets import without_brackets
from fieldspec.tools.lists.column_contents import (
    BY_CELLS,
    NOTED,
    are_exponents,
    are_lengths,
    are_no_types,
    are_of_memory,
    are_of_parts,
    are_ranks,
    counts_on,
    has_role,
    is_alike,
    repeats,
    role_by_cells,
)
from fieldspec.tools.lists.heading_words import NOTE, heads_of, is_of_station, ranked
from fieldspec.tools.lists.object_groups import GROUP
from fieldspec.tools.lists.row_quantity import FACTORS
from fieldspec.tools.lists.sheet import SheetRow, column_of, letters
from fieldspec.tools.lists.type_words import typed
from fieldspec.tools.lists.value_texts import value_meanings
from fieldspec.tools.lists.words import folded, words

_LONGEST = 200
FURTHER = ("unit", "type", "values", "space")
"""The roles of which a row has the cell of any column: the first one with a text, and others become notes."""

_NOTATIONS = ("hex", "dec", "decimal", "hexadecimal", "index", "offset", "start", "end")
"""Headings of numbers of any kind."""

_SHORTEST_SPACE, _SHORT_SPACES = 4, ("hr", "ir", "3x", "4x")
"""The fewest letters of an address space that heads its addresses, and the shorter names that nothing else has."""

_USUAL = (0, 1, 10000, 30000, 40000, 10001, 30001, 40001, 100000, 300000, 400000, 100001, 300001, 400001)
"""The differences between the notations of an address, of which a single row is enough."""

_FEWEST_ROLES = 3
"""The fewest columns with roles, and rows, so that another column is that of addresses by its cells."""

LOOKED_AT = 200
"""The number of rows whose cells show what a column has_role."""


@dataclass(frozen=True, slots=True)
class Columns:
    """The columns of a list by role, counted from 0, its headings, and the rows below them.

    `more` are further columns of roles that several may have: addresses, names and notes. `by_cells` are the roles
    whose columns their cells show, whatever their headings are, `other_tables` the headings of tables without
    addresses, each with its number of rows.
    """

    places: Mapping[str, int]
    headings: tuple[str, ...]
    rows: tuple[SheetRow, ...]
    more: Mapping[str, tuple[int, ...]] = field(default_factory=dict)
    by_cells: tuple[str, ...] = ()
    other_tables: tuple[tuple[SheetRow, int], ...] = ()

    @property
    def headed(self) -> int:
        """How many roles have a heading of their own."""
        headings = {self.headings[column] for column in self.places.values() if column < len(self.headings)}
        return len(headings) - len(self.by_cells)

    def cell(self, row: SheetRow, role: str) -> str:
        """The cell of a row in the column of a role; empty if the list has no such column."""
        column = self.places.get(role)
        return row.cell(column) if column is not None else ""

    def texts(self, row: SheetRow) -> dict[str, str]:
        """The cells of a row by role."""
        texts = {role: text for role in self.places if (text := self.cell(row, role))}
        further = [(role, row.cell(column)) for role in FURTHER for column in self.more.get(role, ())]
        return {role: text for role, text in reversed(further) if text} | texts

    def heading(self, role: str) -> str:
        """The heading of a role's column, or its letter if it has none."""
        return self.heading_at(self.places[role])

    def heading_at(self, column: int) -> str:
        """The heading of a column, or its letter if it has none."""
        text = self.headings[column] if column < len(self.headings) else ""
        return text or f"column {letters(column + 1)}"

    def unused(self) -> list[int]:
        """The columns without a role that have cells."""
        used = _used(self.places, self.more)
        width = max((len(row.cells) for row in self.rows), default=0)
        return [column for column in range(width) if column not in used and any(row.cell(column) for row in self.rows)]


def _used(places: Mapping[str, int], further: Mapping[str, tuple[int, ...]]) -> set[int]:
    return {*places.values(), *(column for columns in further.values() for column in columns)}


def guessed_columns(parts: list[list[str]], names: Mapping[str, str], rows: tuple[SheetRow, ...]) -> Columns | None:
    """The columns below a heading, None if none has addresses, or if one that the user names is not there."""
    headings = tuple(" ".join(dict.fromkeys(texts)) for texts in parts)
    places: dict[str, int] = {}
    for role, text in names.items():
        column = column_index(headings, text)
        if column is None:
            return None
        places[role] = column
    heads = [heads_of(texts) for texts in parts]
    sample = rows[:LOOKED_AT]
    byte_columns = _byte_columns(heads, {*places.values()})
    further: dict[str, tuple[int, ...]] = {"bytes of addresses": byte_columns} if byte_columns else {}
    unit_columns = ranked(heads, words("headings")["unit"], set())
    of_parts = {column for column in unit_columns if are_of_parts(headings[column], sample, column)}
    for role, role_words in words("headings").items():
        used_columns = _used(places, further) | of_parts
        fits = ranked(heads, role_words, used_columns)
        if role == "type":
            fits = [column for column in fits if not are_no_types(sample, column)]
        if role in ("word_order", "byte_order"):
            fits = [column for column in fits if not are_ranks(sample, column)]
        own_fits = set(fits)
        if role in FURTHER or not fits:
            fits += ranked(heads, words("fallbacks").get(role, ()), {*used_columns, *fits})
        texts = {column: [text for row in sample if (text := row.cell(column))] for column in fits}
        columns = [column for column in fits if has_role(role, texts[column], column not in own_fits)]
        if role in NOTED and not columns:
            columns = [
                column
                for column in fits
                if not {*heads[column]}.isdisjoint(role_words) and (role != "access" or is_alike(texts[column]))
            ]
        if role == "words":
            columns = [column for column in columns if "n" not in heads[column] or not counts_on(sample, column)]
        if role in FACTORS:
            columns = [column for column in columns if not are_exponents(sample, column)]
        if role == "exponent" and not columns:
            columns = [
                column
                for column in ranked(heads, words("headings")["scale"], used_columns)
                if are_exponents(sample, column)
            ]
        if role == "address" and not fits and len(set(filter(None, headings))) > 1:
            columns = [column for column, text in enumerate(headings) if _space_of_heading(text)]
        if role == "address" and "address" not in places:
            columns = (
                columns or [column for column in fits if any(address_text(row.cell(column)) for row in sample)] or fits
            )
        if role == "address" and (len(columns) > 1 or "address" in places):
            lengths = [n for n in ranked(heads, words("headings")["words"], set()) if are_lengths(sample, n)]
            columns = [column for column in columns if column not in lengths] or columns
            columns = [
                column
                for column in columns
                if not is_of_station(headings[column])
                and (len(sample) == 1 or len({row.cell(column) for row in sample}) > 1)
            ] or columns
            columns = [column for column in columns if not folded(headings[column]).endswith("offset")] or columns
            columns = [column for column in columns if not are_of_memory(sample, column)] or columns
            if not names:
                main = [places["address"]] if "address" in places else columns[:1]
                columns = [
                    column
                    for column in columns
                    if column in main
                    or (not _is_of_writes(headings[column]) and _has_addresses_of(sample, main[0], column))
                ]
        if role == "name" and "name" not in places:
            columns = sorted(columns, key=lambda column: repeats(sample, column))
        if role not in places and columns:
            places[role] = columns[0]
            columns = columns[1:]
        if role in FURTHER:
            columns = [column for column in columns if all(map(BY_CELLS[role], texts[column]))]
        if role in (*FURTHER, "address", "name", NOTE) and columns and not (role == "address" and "address" in names):
            further[role] = tuple(columns)
    codes = ranked([heads[column] for column in further.get("address", ())], words("codes")["printed_name"], set())
    if codes and "printed_name" not in places:
        places["printed_name"] = further["address"][codes[0]]
        further["address"] = tuple(column for column in further["address"] if column != places["printed_name"])
    if "value_offset" in places and "address" in places and counts_on(sample, places["value_offset"]):
        further["address"] = (*further.get("address", ()), places.pop("value_offset"))
    if "name" not in places:
        used_columns = _used(places, further)
        labels = [
            column
            for column in ranked(heads, words("headings")["address"], used_columns)
            if has_role("name", [text for row in sample if (text := row.cell(column))], False)
            and not are_of_memory(sample, column)
        ]
        labels += ranked(heads, words("headings")["label"], {*used_columns, *labels})
        if labels := [column for column in labels if not repeats(sample, column)] or labels[:1]:
            places["name"] = labels[0]
    if "value" in places and "values" not in places:
        filled = [text for row in sample if (text := row.cell(places["value"]))]
        if 0 < len(filled) <= 3 * sum(bool(cells.bounds(text) or value_meanings(text)) for text in filled):
            places["values" if "range" in places else "range"] = places.pop("value")
        elif filled and "type" not in places and all(map(typed, filled)):
            places["type"] = places.pop("value")
    of_heading = cells.space(headings[places["address"]]) if "address" in places else ""
    if of_heading and "address" in further:
        column_spaces = {column: cells.space(headings[column]) for column in further["address"]}
        further["address"] = tuple(column for column, other in column_spaces.items() if other in ("", of_heading))
    if byte_columns:
        rows, headings = _with_addresses_of_bytes(rows, headings, byte_columns)
        if "address" in places:
            further["address"] = (*further.get("address", ()), len(headings) - 1)
        places.setdefault("address", len(headings) - 1)
    if "address" not in places and len(marked := _marked_columns(sample, {*places.values()})) == 1:
        places["address"] = marked[0]
    has_roles = len(places) >= _FEWEST_ROLES or not any(headings)
    rising = _rising_columns(sample, {*places.values()}) if has_roles else []
    risen = {"address": rising[0]} if "address" not in places and len(rising) == 1 else {}
    places |= risen
    if "address" not in places:
        return None
    by_cells = _places_by_cells(headings, sample, places, further)
    if (space := _space_of_heading(headings[places["address"]])) and "space" not in {*places, *by_cells}:
        rows, places["space"] = _with_spaces_of_heading(rows, len(headings), space), len(headings)
        headings = (*headings, headings[places["address"]])
    return Columns({**places, **by_cells}, headings, rows, further, (*risen, *by_cells))


def _places_by_cells(
    headings: tuple[str, ...],
    rows: Sequence[SheetRow],
    places: Mapping[str, int],
    further: Mapping[str, tuple[int, ...]],
) -> dict[str, int]:
    """The columns of roles that no heading names, where all their cells show the role."""
    used_columns = _used(places, further)
    result: dict[str, int] = {}
    label = places.get("label")
    is_sparse = label is not None and _is_sparse(rows, label)
    for column in range(max((len(row.cells) for row in rows), default=0)):
        texts = [text for row in rows if (text := row.cell(column))]
        if column in used_columns or headings[column : column + 1] == (GROUP,):
            continue
        existing = {*places, *result} - ({"label"} if is_sparse else set())
        role = role_by_cells(texts, existing, repeats(rows, column) or _is_sparse(rows, column))
        result |= {role: column} if role else {}
    return result


def _is_sparse(rows: Sequence[SheetRow], column: int) -> bool:
    """Whether less than half of the rows with several cells have one in a column."""
    filled = [row for row in rows if sum(map(bool, row.cells)) > 1]
    return sum(bool(row.cell(column)) for row in filled) * 2 < len(filled)


def _has_addresses_of(rows: Sequence[SheetRow], column: int, further_column: int) -> bool:
    """Whether a further column has the addresses of a column too: in most rows they differ by the same number."""
    pairs = [(address_text(row.cell(column)), address_text(row.cell(further_column))) for row in rows]
    pairs = [pair for pair in pairs if all(pair)]
    filled = [row for row in rows if row.cell(column) and row.cell(further_column)]
    if len({row.cell(column) for row in filled}) != len({row.cell(further_column) for row in filled}):
        return False
    for base, other_base in product((DECIMAL, HEXADECIMAL), repeat=2):
        numbers = [(first.number(base), other.number(other_base)) for first, other in pairs if first and other]
        differences = Counter(b - a for a, b in numbers if a is not None and b is not None)
        (usual, times), *_ = differences.most_common(1) or [(0, 0)]
        if times * 2 > len(pairs) and (abs(usual) in _USUAL or times >= _FEWEST_ROLES):
            return True
    return not pairs


def _is_of_writes(heading: str) -> bool:
    """Whether a heading is that of addresses where values are written, which are other registers."""
    return folded(heading).startswith(tuple(word for word in words("headings")["writable"] if len(word) > len("wrt")))


def address_rank(heading: str) -> int:
    """How clearly a heading is that of addresses: 2 for one that says so, 1 for a notation of any numbers, else 0."""
    heads = heads_of([heading])
    is_address = _space_of_heading(heading) or ranked([heads], words("headings")["address"], set())
    is_clear = set(_NOTATIONS).isdisjoint(heads) or _space_of_heading(without_brackets(heading))
    return 0 if not is_address else 2 if is_clear else 1


def _space_of_heading(heading: str) -> str:
    """The address space that a heading of addresses names: `Discrete input`; empty for `Register`."""
    bare = without_brackets(heading)
    is_short = len(folded(heading)) < _SHORTEST_SPACE and folded(heading) not in _SHORT_SPACES
    is_general = not {folded(heading), folded(bare)}.isdisjoint(words("headings")["address"]) or is_short
    return "" if is_general else cells.space(heading)


def _with_spaces_of_heading(rows: Iterable[SheetRow], width: int, space: str) -> tuple[SheetRow, ...]:
    """The rows with a further column that has the address space."""
    return tuple(SheetRow(row.number, (*(row.cell(column) for column in range(width)), space)) for row in rows)


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


def _rising_columns(rows: Sequence[SheetRow], used_columns: set[int]) -> list[int]:
    """The columns whose cells are addresses that rise from row to row, but those that number the rows."""
    columns = []
    for column in set(range(max((len(row.cells) for row in rows), default=0))) - used_columns:
        addresses = [address_text(row.cell(column)) for row in rows]
        numbers = [address.number(DECIMAL) for address in addresses if address is not None]
        rising = [number for number in numbers if number is not None]
        steps = {after - before for before, after in pairwise(rising)}
        if len(rising) == len(addresses) > _FEWEST_ROLES and min(steps) > 0 and (steps != {1} or rising[0] > 1):
            columns.append(column)
    return columns


def _byte_columns(heads: Sequence[Mapping[str, frozenset[int]]], used_columns: set[int]) -> tuple[int, ...]:
    """The columns with the high and the low byte of addresses; empty if the list has none."""
    halves = [ranked(heads, words("address_bytes")[half], used_columns)[:1] for half in ("high", "low")]
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


def column_index(headings: Sequence[str], text: str) -> int | None:
    """The column that a user names: by its heading, by its number, or by its letters."""
    heads = [folded(heading) for heading in headings]
    if folded(text) and folded(text) in heads:
        return heads.index(folded(text))
    return column_number(text, len(headings))


def column_number(text: str, width: int) -> int | None:
    """The column that a number from 1 or letters name; None for another text, and beyond the last one."""
    if re.fullmatch("[0-9]{1,4}", text) and 1 <= int(text) <= width:
        return int(text) - 1
    if re.fullmatch("[A-Za-z]{1,2}", text):
        return column_of(text) - 1 if column_of(text) <= width else None
    return None


def headings_text(headings: Iterable[str]) -> str:
    """The headings of a file for a message, cut if there are many."""
    joined = ", ".join(text for text in headings if text)
    if not joined:
        return "no headings"
    return joined if len(joined) <= _LONGEST else f"{joined[:_LONGEST]}..."
