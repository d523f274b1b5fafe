"""Tables of objects with subindices, as CiA 301 has them: each row is a parameter, or an element of one."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

from fieldspec.foundation.classes import replace
from fieldspec.language.model.primitives import PRIMITIVES
from fieldspec.tools.lists.addresses import DECIMAL, HEXADECIMAL, address_text, base_of_heading
from fieldspec.tools.lists.assumption import Assumption, Refusal
from fieldspec.tools.lists.column_roles import Columns
from fieldspec.tools.lists.row_reading import PARAMETER, ListRow, bits
from fieldspec.tools.lists.sheet import ListError, Sheet, SheetRow
from fieldspec.tools.lists.type_words import Loose, Typed
from fieldspec.tools.lists.words import meaning, pattern

OBJECTS = "objects"
"""The space of the numbers of objects."""

TEXT_BYTES = 64
"""The size of texts, of which such lists have no lengths."""

_INDEX, _SUBINDEX = "index", "subindex"
_HEADED_BY = 40
_FIRST, _LAST, _LAST_SUBINDEX = 0x1000, 0xFFFF, 0xFE
_DIGITS_OF_INDEX = 4
_TEXT = "text"
_LENGTH = "Length in the list"
_INDEX_AND_SUBINDEX = re.compile(
    r"((?:0x|16#)?[0-9a-f]{4}h?)\s*(?:[:./,_-]|\bsub(?:index)?|[\[(]|\s)\s*((?:0x)?[0-9a-f]{1,2}h?)\s*[\])]?",
    re.IGNORECASE,
)

_SPAN = re.compile(r"\s*(?:\.\.+|-|\u2013|~|\bto\b)\s*")


def with_subindices_apart(sheet: Sheet) -> Sheet:
    """A sheet with a column for subindices where it has them after their indices: `6040h:00`."""
    for number, row in enumerate(sheet.rows[:_HEADED_BY]):
        for column, text in enumerate(row.cells):
            if not meaning("object_headings", text):
                continue  # before all cells below: a list has thousands
            below = [other.cell(column) for other in sheet.rows[number + 1 :] if other.cell(column)]
            if below and all(map(_INDEX_AND_SUBINDEX.fullmatch, below)):
                return replace(sheet, rows=tuple(_apart(sheet.rows, number, column)))
    return sheet


def _apart(rows: Sequence[SheetRow], heading: int, column: int) -> Iterator[SheetRow]:
    width = max(len(row.cells) for row in rows)
    for number, row in enumerate(rows):
        match = _INDEX_AND_SUBINDEX.fullmatch(row.cell(column)) if number > heading else None
        first, last = (
            (match[1], match[2]) if match else (_INDEX, _SUBINDEX) if number == heading else (row.cell(column), "")
        )
        cells = [row.cell(place) for place in range(width)]
        yield SheetRow(row.number, (*cells[:column], first, *cells[column + 1 :], last))


def with_objects(
    columns: Columns, base: str, refused: list[Refusal], assumptions: list[Assumption]
) -> tuple[Columns, bool]:
    """The columns of a list, and whether its rows are objects: each has its index then, such as 0x6040, and a decimal
    subindex. In another list, such as one that names spaces, rows with a subindex are refused.

    Raises ListError for indices with two readings.
    """
    if _SUBINDEX not in columns.places:
        return columns, False
    texts = [text for row in columns.rows if (text := address_text(columns.cell(row, "address")))]
    subindices = [text for row in columns.rows if (text := address_text(columns.cell(row, _SUBINDEX)))]
    stated = base or base_of_heading(columns.heading("address"))
    own_base = stated or (HEXADECIMAL if all(len(text.digits) <= _DIGITS_OF_INDEX for text in texts) else DECIMAL)
    is_hexadecimal = any(text.mark or text.lettered for text in subindices)
    has_spaces = "space" in columns.places and any(columns.cell(row, "space") for row in columns.rows)
    rows: list[SheetRow] = []
    other: dict[SheetRow, str] = {}
    index: int | None = None
    for row in columns.rows:
        index_text, subindex = columns.cell(row, "address"), columns.cell(row, _SUBINDEX)
        address = address_text(index_text)
        index = address.number(own_base) if address is not None else None if index_text else index
        ends = _ends(subindex, HEXADECIMAL if is_hexadecimal else DECIMAL)
        if subindex and (has_spaces or ends is None or index is None or not _FIRST <= index <= _LAST):
            other[row] = subindex
        elif index is not None and (address is not None or subindex):
            row = _with_cell(row, columns.places["address"], f"0x{index:04X}")
            row = _with_cell(row, columns.places[_SUBINDEX], ends or "")
        rows.append(row)
    if other or not subindices:
        reason = (
            "is not a subindex of an object (CiA 301), whose index is 0x1000..0xFFFF; rename the column if it has none"
        )
        refused += [Refusal(row.number, columns.heading(_SUBINDEX), cell, reason) for row, cell in other.items()]
        return replace(columns, rows=tuple(row for row in columns.rows if row not in other)), False
    if not stated and not any(text.mark or text.lettered for text in texts):
        reading = "hexadecimal" if own_base == HEXADECIMAL else "decimal"
        lowest = min((text.digits for text in texts), key=int)
        if own_base == HEXADECIMAL and int(lowest) >= _FIRST:
            raise ListError(
                f"has indices with two readings: `{lowest}` is 0x{lowest}, or 0x{int(lowest):04X}. The evidence is "
                "equal; choose with --base hex or --base decimal"
            )
        evidence = "objects have indices from 0x1000 to 0xFFFF"
        if own_base == HEXADECIMAL:
            evidence = f"`{lowest}` is less than 0x1000 as a decimal number"
        assumptions.append(Assumption("indices", reading, evidence, "--base"))
    return replace(columns, rows=tuple(rows)), True


def _ends(text: str, base: str) -> str | None:
    """The subindices in a cell as decimal numbers; None if the cell has no subindices."""
    ends = [end.number(base) if (end := address_text(part)) else None for part in _SPAN.split(text)]
    numbers = [end for end in ends if end is not None and end <= _LAST_SUBINDEX]
    return "..".join(map(str, numbers)) if len(numbers) == len(ends) <= 2 else None


def _with_cell(row: SheetRow, column: int, text: str) -> SheetRow:
    cells = [*row.cells, *[""] * (column + 1 - len(row.cells))]
    return SheetRow(row.number, (*cells[:column], text, *cells[column + 1 :]))


def as_parameters(
    rows: Sequence[ListRow], indices: Mapping[int, int], refused: list[Refusal], assumptions: list[Assumption]
) -> Iterator[ListRow]:
    """The rows as objects and their elements, below an object for elements that have none. `indices` are by row."""
    groups: dict[int, list[ListRow]] = {}
    for row in rows:
        if row.bits is not None:
            refused.append(Refusal(row.row, "", "", "is a bit of an object; write its bits into the row of the object"))
        else:
            groups.setdefault(indices[row.row], []).append(_object(row))
    if any(
        row.type == Typed(_TEXT) and row.texts["bytes"] == str(TEXT_BYTES) for group in groups.values() for row in group
    ):
        assumptions.append(Assumption("texts", f"up to {TEXT_BYTES} bytes", "the list has no lengths"))
    for group in groups.values():
        elements = [row for row in group if row.subindices is not None]
        wholes = [row for row in group if row.subindices is None]
        if not elements or (not wholes and {row.subindices for row in elements} == {(0, 0)}):
            yield from (replace(row, subindices=None) for row in group)
            continue
        whole = wholes[0] if wholes else _headed(elements[0])
        yield from (object_of(whole, elements), *elements, *wholes[1:])


def _headed(first: ListRow) -> ListRow:
    """The row of an object that has none, with the name of the first element, if this does not count the others."""
    names = first.names if first.subindices == (0, 0) and not pattern("counting").search(" ".join(first.names)) else ()
    return ListRow(first.row, first.address, names=names, texts={"label": names[0]} if names else {})


def object_of(whole: ListRow, elements: Sequence[ListRow]) -> ListRow:
    """The object that consists of elements, with the names of a row and the type of its last element."""
    usual = max((row for row in elements if row.type), key=lambda row: row.subindices or (0, 0), default=elements[0])
    texts = {"space": OBJECTS, "bytes": usual.texts["bytes"]}
    texts |= {"label": whole.texts["label"]} if "label" in whole.texts else {}
    count = max((row.subindices or (0, 0))[1] for row in elements) + 1
    names, own_type = whole.names, usual.type
    return ListRow(
        whole.row, whole.address, None, names, own_type, texts=texts, count=count, kind=PARAMETER, space=OBJECTS
    )


def _object(row: ListRow) -> ListRow:
    """A row as an object or an element, of the size that its type says."""
    own_type = row.type
    if own_type is not None and not own_type.name and own_type.kind is Loose.TRUTH:
        own_type = Typed("bool8")
    elif own_type is not None and not own_type.name and own_type.bits:
        own_type = Typed(own_type.of_words(None))
    size = PRIMITIVES[own_type.name].size if own_type is not None and own_type.name else 0
    agrees = row.length is None or not size or row.length in (size, size * 8)
    doubts = [doubt for doubt in row.doubts if not doubt.startswith(_LENGTH)]
    doubts += [] if agrees else [f"{_LENGTH}: {row.texts['words']}."]
    texts = {role: text for role, text in row.texts.items() if role not in ("name", "printed_name")}
    texts |= {"space": OBJECTS, "bytes": ""} | ({"label": row.names[0]} if row.names else {})
    if own_type is not None and own_type.name == _TEXT:
        texts["bytes"] = str(own_type.length or row.length or TEXT_BYTES)
    return replace(
        row,
        type=own_type,
        texts=texts,
        kind=PARAMETER,
        space=OBJECTS,
        subindices=bits(row.texts.get(_SUBINDEX, ""), _LAST_SUBINDEX),
        words=None,
        doubts=tuple(doubts),
    )
