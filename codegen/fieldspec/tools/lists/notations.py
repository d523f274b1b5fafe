"""Addresses that a list has in two notations: bits with a fraction, coils, references beside numbers on the wire."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.foundation.classes import replace
from fieldspec.tools.lists import cells
from fieldspec.tools.lists.addresses import DECIMAL, HEXADECIMAL, REFERENCE, TABLES, AddressText, Place, address_text
from fieldspec.tools.lists.column_roles import Columns
from fieldspec.tools.lists.sheet import SheetRow
from fieldspec.tools.lists.words import folded, words

_DIGITS, _COILS = 5, "coils"
"""The digits of a reference, and the address space whose references may begin with zeros."""


def are_most(number: int, total: int) -> bool:
    """Whether a number of rows show what holds for all of them: three quarters do."""
    return number * 4 >= total * 3


def with_notations(rows: list[tuple[SheetRow, Place]], columns: Columns) -> tuple[list[tuple[SheetRow, Place]], str]:
    """The places as the whole list writes them, and the heading of a further column with the addresses on the wire."""
    keys = {*map(folded, columns.headings)}
    if not keys.isdisjoint(words("programs")["function_digit"]):
        return [(row, _behind_function(row_place)) for row, row_place in rows], ""
    placed_rows = list(_with_short_references(list(_with_bits(rows)), columns))
    if any(row_place.first.mark == REFERENCE and not int(row_place.first.digits) for _, row_place in rows):
        placed_rows = [(row, _from_zero(row_place)) for row, row_place in placed_rows]
    placed_rows, heading = _with_wire_numbers(placed_rows, columns)
    return list(_with_coils(placed_rows)), heading


def _behind_function(row_place: Place) -> Place:
    """The place of an address whose first digit is the code of the function that reads it: `300022`."""
    digits = row_place.first.digits
    code = cells.functions(digits[:1])
    if code is None or len(digits) < _DIGITS or not digits.isdecimal():
        return row_place
    return replace(row_place, first=AddressText(str(int(digits[1:])), "", code.space))


def _from_zero(row_place: Place) -> Place:
    """The place of a number such as `3x0000` in a list where it shows that tables count from 0."""
    first, last = (
        replace(end, mark="") if end is not None and end.mark == REFERENCE else end
        for end in (row_place.first, row_place.last)
    )
    return replace(row_place, first=first or row_place.first, last=last)


def _with_bits(rows: list[tuple[SheetRow, Place]]) -> Iterator[tuple[SheetRow, Place]]:
    """The places, with `100.0` as a bit only where other places have bits."""
    bits = any(row_place.bits and not row_place.pointless for _, row_place in rows)
    for row, row_place in rows:
        whole = row_place.pointless and not bits
        yield row, Place(row_place.first, row_place.last, None, row_place.other) if whole else row_place


def _with_coils(rows: list[tuple[SheetRow, Place]]) -> Iterator[tuple[SheetRow, Place]]:
    """The places, with `0x0002` as the coil 2 beside `4x0010`, where each of them is written so in decimal digits."""
    firsts = [row_place.first for _, row_place in rows]
    widths = {len(first.digits) for first in firsts if first.mark == REFERENCE}
    marked = [first for first in firsts if first.mark == HEXADECIMAL]
    are_coils = widths and all(first.digits.isdecimal() and len(first.digits) in widths for first in marked)
    for row, row_place in rows:
        first = row_place.first
        if are_coils and first.mark == HEXADECIMAL:
            row_place = replace(row_place, first=replace(first, mark=REFERENCE, space=TABLES["0"]))
        yield row, row_place


def _with_short_references(rows: list[tuple[SheetRow, Place]], columns: Columns) -> Iterator[tuple[SheetRow, Place]]:
    """The places, with `6` in a row of coils or beside the references of several tables, and `0006`, as `00006` beside
    references with all their digits."""
    digits = [row_place.first.digits for _, row_place in rows]
    of_tables = {text[0] for text in digits if len(text) == _DIGITS}
    codes = [cells.functions(columns.cell(row, "function")) for row, _ in rows]
    own_spaces = [
        code.space if code else cells.space(columns.cell(row, "space"))
        for (row, _), code in zip(rows, codes, strict=True)
    ]
    has_tables = of_tables <= TABLES.keys() and len(of_tables) > 1
    are_coils = [
        own_space == _COILS or (has_tables and not own_space and text.isdecimal() and int(text) > 0)
        for text, own_space in zip(digits, own_spaces, strict=True)
    ]
    short = [
        text.isdecimal() and len(text) < _DIGITS and (is_coil or (text.startswith("0") and len(text) == _DIGITS - 1))
        for text, is_coil in zip(digits, are_coils, strict=True)
    ]
    longer = [row_place.first.reference() for (_, row_place), is_short in zip(rows, short, strict=True) if not is_short]
    are_references = bool(longer) and all(longer)
    for (row, row_place), is_short in zip(rows, short, strict=True):
        first = row_place.first
        whole = replace(first, digits=first.digits.zfill(_DIGITS)) if is_short and are_references else first
        yield row, replace(row_place, first=whole)


def _with_wire_numbers(
    rows: list[tuple[SheetRow, Place]], columns: Columns
) -> tuple[list[tuple[SheetRow, Place]], str]:
    """The places with the addresses on the wire that a further column has beside references, or beside numbers from 1,
    and its heading; the addresses of this column where the further one has the references. Rows that contradict most
    others are refused for their second notation."""
    for column in columns.more.get("address", ()):
        pairs = [(row_place.first, address_text(row.cell(column))) for row, row_place in rows]
        for is_swapped in (False, True):
            ends = [(b, a) if is_swapped else (a, b) for a, b in pairs]
            filled_pairs = [(a, b) for a, b in ends if a is not None and b is not None]
            are_references = all(a is not None and a.reference() for a, _ in ends)
            are_marked = len(filled_pairs) == len(ends) and all(b.mark == HEXADECIMAL for _, b in filled_pairs)
            fitting = sum(_is_reference_or_next(a, b) for a, b in filled_pairs)
            if not filled_pairs or not are_most(fitting, len(filled_pairs)) or not (are_references or are_marked):
                continue
            heading = columns.heading("address") if is_swapped else columns.heading_at(column)
            return [
                (row, replace(row_place, first=a or row_place.first, other=b))
                for (row, row_place), (a, b) in zip(rows, ends, strict=True)
            ], heading
    return rows, ""


def _is_reference_or_next(first: AddressText, other: AddressText) -> bool:
    """Whether an address is the reference of another one, or one more than it."""
    number = other.number(HEXADECIMAL if other.lettered else DECIMAL)
    reference = first.reference()
    decimal = first.number(DECIMAL)
    return number is not None and not first.mark and number in (reference and reference[1], decimal and decimal - 1)
