"""Values beneath a register: rows without an address, each with a number and what it means."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.foundation.classes import replace
from fieldspec.tools.lists.cells import whole
from fieldspec.tools.lists.column_roles import Columns
from fieldspec.tools.lists.row_reading import ListRow
from fieldspec.tools.lists.sheet import SheetRow
from fieldspec.tools.lists.value_texts import value_meanings

_NUMBERS = (None, "value", "values", "range", "min")
_TEXTS = (None, "name", "label", "printed_name", "values", "note")
"""The roles of columns with the numbers of such rows, and of those with what they mean."""

_FEWEST = 2
"""A single one may as well be a footnote."""


def with_values_beneath(
    columns: Columns, rows: Sequence[ListRow], skipped: Sequence[SheetRow]
) -> tuple[Columns, list[ListRow]]:
    """The rows with the values beneath them, and the columns with that of their numbers."""
    places = {row.row: place for place, row in enumerate(rows)}
    beneath: dict[int, list[tuple[int, int, str, int]]] = {}
    place: int | None = None
    following = 0
    for sheet_row in skipped:
        place = places.get(sheet_row.number - 1, place if sheet_row.number == following else None)
        own_values = _values(columns, sheet_row)
        if place is None or not own_values:
            continue
        following = sheet_row.number + 1
        beneath.setdefault(place, []).extend((sheet_row.number, *value) for value in own_values)
    result = list(rows)
    used = set(columns.more.get("values", ()))
    for place, values in beneath.items():
        row = result[place]
        members = (*row.meanings.members, *((number, text) for _, number, text, _ in values))
        if len(members) < _FEWEST or row.meanings.bits or len(dict(members)) < len(members):
            continue
        meanings = replace(row.meanings, members=members)
        result[place] = replace(row, meanings=meanings, parts=(*row.parts, *(number for number, *_ in values)))
        used |= {column for *_, column in values}
    return replace(columns, more={**columns.more, "values": tuple(sorted(used))}), result


def _values(columns: Columns, row: SheetRow) -> list[tuple[int, str, int]]:
    """The numbers, each with its meaning and its column, of a row with nothing else."""
    roles = {column: role for role, column in columns.places.items()}
    filled = [(column, text) for column, text in enumerate(row.cells) if text]
    if len(filled) == 1 and roles.get(filled[0][0]) in ("values", "range"):
        meanings = value_meanings(filled[0][1])
        return [(*member, filled[0][0]) for member in meanings.members] if meanings is not None else []
    numbers = [(column, number) for column, text in filled if (number := whole(text)) is not None]
    texts = [(column, text) for column, text in filled if whole(text) is None and any(map(str.isalpha, text))]
    if len(numbers) != 1 or not texts or len(texts) + 1 < len(filled):
        return []
    (column, number), (text_column, meaning) = numbers[0], texts[0]
    is_value = roles.get(column) in _NUMBERS and roles.get(text_column) in _TEXTS
    return [(number, meaning, column)] if is_value else []
