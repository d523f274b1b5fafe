"""A register list, row by row: what each row says, what was assumed for all of them, and what was not taken."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from math import gcd

from fieldspec.foundation.classes import dataclass, replace
from fieldspec.language.model.fact import LINES
from fieldspec.tools.lists import cells
from fieldspec.tools.lists.addresses import HEXADECIMAL, HIGHEST, REFERENCE, Place, address_text
from fieldspec.tools.lists.assumption import STATED_NOTHING, Assumption, Options, Refusal
from fieldspec.tools.lists.cells import COMMA, POINT, decimal_sign
from fieldspec.tools.lists.column_roles import Columns, address_rank, headings_text
from fieldspec.tools.lists.decisions import decided
from fieldspec.tools.lists.entries import SPACES
from fieldspec.tools.lists.export import COLUMNS as OWN_COLUMNS
from fieldspec.tools.lists.exported_rows import OF_THE_MANUAL, exported_row, uncited
from fieldspec.tools.lists.memories import assumed_areas, unknown_areas
from fieldspec.tools.lists.numbering import (
    Placed,
    bases,
    contradictions,
    is_reference_of_other,
    placed,
    shortened_bits,
    wire_number,
)
from fieldspec.tools.lists.object_rows import as_parameters, with_objects, with_subindices_apart
from fieldspec.tools.lists.row_cells import row_cells, row_texts
from fieldspec.tools.lists.row_quantity import FACTORS, SCALED_BOUNDS
from fieldspec.tools.lists.row_reading import ListRow, read_row
from fieldspec.tools.lists.row_spaces import (
    stated_base,
    titled_order,
    titles,
    unread_texts,
    with_bits_from_zero,
    with_spaces,
)
from fieldspec.tools.lists.shapes import BIT, with_elements
from fieldspec.tools.lists.sheet import ListError, Sheet, SheetRow, letters
from fieldspec.tools.lists.tables import columns, without_numbers
from fieldspec.tools.lists.type_words import UNSIGNED, Loose
from fieldspec.tools.lists.unrolled import matrix, side_by_side
from fieldspec.tools.lists.values_beneath import with_values_beneath
from fieldspec.tools.lists.words import meaning

_NUMERIC = (*FACTORS, *SCALED_BOUNDS, "min", "max", "range", "default", "const", "value_offset", "unit", "formula")

_FEWEST_CODES, _MOST_EXAMPLES = 3, 3
_WIDE_STEPS = (4, 8)
"""The bytes of registers with more than a word."""

_BIT_NAME = re.compile(
    r"(?:bit|b)\s*\.?([0-9]{1,2})(?:\s*(?:-|\.\.|~)\s*(?:bit|b)?([0-9]{1,2}))?\b[\s:=.)-]*(.*)", re.IGNORECASE
)


@dataclass(frozen=True, slots=True)
class Listing:
    """A list. `skipped` are the numbers of rows without an address, `refused` what was not taken of rows and cells.

    `bases` are the ways in which the addresses can be read, the likeliest first. `open` are the decisions for which the
    evidence is equal. `own` says that the list is an export, whose columns need no decisions, `in_bytes` that its
    addresses count bytes.
    """

    columns: Columns
    places: Placed
    read: tuple[ListRow, ...]
    skipped: tuple[int, ...]
    refused: tuple[Refusal, ...]
    bases: tuple[str, ...]
    assumptions: tuple[Assumption, ...]
    open: tuple[Assumption, ...]
    own: bool
    in_bytes: bool = False

    def rows(self, base: str) -> list[ListRow]:
        """The rows, with the addresses read in one of the ways of `bases`, but those that cannot be read so."""
        return list(self._placed_rows(base)[0])

    def numbered(self, base: str) -> tuple[list[ListRow], list[Refusal], list[Assumption]]:
        """The same, with the rows that are refused for their numbers, and what was assumed of further columns."""
        rows, refused = self._placed_rows(base)
        contradicting, assumptions = contradictions(self.places, base, self.columns)
        return ([row for row in rows if row.row not in contradicting], [*refused, *contradicting.values()], assumptions)

    def heading(self, role: str) -> str:
        """The heading of a role's column."""
        return self.columns.heading(role)

    def _placed_rows(self, base: str) -> tuple[list[ListRow], list[Refusal]]:
        rows: list[ListRow] = []
        refused: list[Refusal] = []
        heading = self.columns.heading("address")
        by_number = {sheet_row.number: (sheet_row, row_place) for sheet_row, row_place in self.places.rows}
        step = gcd(*(wire_number(row_place, base) or 0 for _, row_place in self.places.rows))
        for row in self.read:
            sheet_row, row_place = by_number[row.row]
            address = wire_number(row_place, base)
            if address is None or address > HIGHEST:
                reason = "is too great" if address is not None else f"cannot be read as {base}"
                refused.append(Refusal(row.row, heading, self.columns.cell(sheet_row, "address"), reason))
                continue
            numbered = _numbered(row, row_place, address, base)
            whole = _of_bytes(numbered, step) if self.in_bytes else numbered
            if whole is None:
                cell = self.columns.cell(sheet_row, "address")
                refused.append(Refusal(row.row, heading, cell, "begins at the second byte of a register"))
            else:
                rows.append(whole)
        rows = _with_gaps(_with_bits_beneath(rows, self))
        if not self.own:
            rows = [with_elements(row, SPACES.get(row.space, False)) for row in rows]
        return rows, refused


def listing(sheet: Sheet, names: Mapping[str, str], options: Options = STATED_NOTHING) -> Listing:
    """The list in a sheet. `names` has the columns of some roles. Raises ListError if the sheet is not a list."""
    assumptions: list[Assumption] = []
    sheet, columns_of_sheet = _with_columns(without_numbers(sheet), names, assumptions)
    first_row = columns_of_sheet.rows[0].number
    own = sorted(columns_of_sheet.headings) == sorted(OWN_COLUMNS)
    refused: list[Refusal] = []
    has_objects = False
    if not own:
        columns_of_sheet, has_objects = with_objects(columns_of_sheet, options.base, refused, assumptions)
    base = options.base or ("" if own else stated_base(sheet, assumptions))
    places = placed(columns_of_sheet, base)
    ways = bases(places, base, columns_of_sheet.heading("address"))
    if own:
        cited = {role: columns_of_sheet.headings.index(role) for role in OF_THE_MANUAL}
        columns_of_sheet = replace(columns_of_sheet, places={**columns_of_sheet.places, **cited})
    assumptions += [*shortened_bits(places), *assumed_areas(places.rows)]
    if places.wire_heading:
        evidence = "other columns have their references, or count from 1"
        assumptions.append(Assumption("addresses", f"as in {places.wire_heading}", evidence, "--address"))
    assumptions += [
        Assumption(columns_of_sheet.heading(role), f"column of {role}", "all its cells", f"--column {role}")
        for role in columns_of_sheet.by_cells
    ]
    refused += [
        Refusal(row.number, "", "", "has a number, and is above the headings of the list")
        for row in sheet.rows
        if row.number < first_row and not sheet.heads and _has_number(row)
    ]
    refused += [
        Refusal(number, "", "", f"is not used: `{text}`")
        for number, text in titles(sheet).items()
        if number < first_row and meaning("settings", re.split("[:=]", text)[0])
    ]
    refused += [
        Refusal(head.number, "", "", f"begins a table without addresses, of {number} rows: {headings_text(head.cells)}")
        for head, number in columns_of_sheet.other_tables
    ]
    decimal = options.decimal or (POINT if own else _decimal(columns_of_sheet, assumptions))
    refused += [*places.refused, *_formulas(sheet, columns_of_sheet)]
    refused += [
        Refusal(row.number, "", "", sheet.refused[row.number]) for row, _ in places.rows if row.number in sheet.refused
    ]
    places = replace(places, rows=tuple(pair for pair in places.rows if pair[0].number not in sheet.refused))
    numbers = {row.number for row, _ in places.rows}
    refused += [
        Refusal(number, place, text, "is a comment beside the registers")
        for number, comments in sheet.comments.items()
        for place, text in comments
        if number not in numbers
    ]
    if sheet.wrapped:
        lines = ", ".join(f"{line} of row {number}" for line, number in sheet.wrapped[:_MOST_EXAMPLES])
        evidence = f"{len(sheet.wrapped)} have no address, as line {lines}"
        assumptions.append(Assumption("lines", "cells of a row go on in the lines next to it", evidence))
    if sheet.hidden:
        assumptions.append(Assumption("hidden cells", "read as others", ", ".join(sheet.hidden)))
    has_factors = not columns_of_sheet.places.keys().isdisjoint(FACTORS)
    assumptions += [] if own else unread_texts(sheet, numbers, has_factors)
    order = options.order or titled_order(sheet, numbers, assumptions)
    further = _further_cells(columns_of_sheet, places, assumptions)
    read = []
    for sheet_row, row_place in places.rows:
        texts = row_texts(columns_of_sheet, sheet_row)
        row = read_row(row_cells(columns_of_sheet, sheet_row, texts, sheet.comments), decimal, order)
        if row_place.bits is not None and row_place.bracketed and "array" in texts.get("type", "").casefold():
            row = replace(row, count=max(row_place.bits[1], 1))  # `100 [4]` has four elements
            row_place = replace(row_place, bits=None)
        area = row_place.first.space
        if area and row.space not in ("", area):
            row = replace(row, doubts=(*row.doubts, f"The list says {row.space}, and {row_place.first.area}."))
        if texts_beyond := further.get(sheet_row.number):
            row = replace(row, doubts=(*row.doubts, f"Cells beyond the headings in the list: {texts_beyond}."))
        space = area or row.space or cells.space(sheet.name)
        read.append(replace(row, bits=row_place.bits or row.bits, space=space))
    read = with_spaces(read, sheet, assumptions)
    read = read if own else with_bits_from_zero(read, assumptions)
    spaces = {row.row: row.space for row in read}
    unknown = list(unknown_areas(places.rows, spaces, columns_of_sheet.heading("address")))
    refused += unknown
    refused_rows = {refusal.row for refusal in unknown}
    read = [row for row in read if row.row not in refused_rows]
    places = replace(places, rows=tuple(pair for pair in places.rows if pair[0].number not in refused_rows))
    if not read:
        raise ListError(f"has no row that can be taken: {refused[0].text()}")
    undecided: list[Assumption] = []
    if own:
        read = [exported_row(row) for row in read]
        marks = {row.cited.mark if row.cited is not None else LINES for row in read}
        if len(marks) > 1:  # a manual has lines or pages, and rows without a place have lines of the list
            read = [uncited(row) if row.cited is not None and row.cited.mark != LINES else row for row in read]
    else:
        _refuse_codes(read, places, columns_of_sheet)
        columns_of_sheet, read = with_values_beneath(columns_of_sheet, read, places.skipped)
        read = decided(columns_of_sheet, read, places, ways, options, assumptions, undecided)
    if has_objects:
        indices = {row.number: row_place.first.number(HEXADECIMAL) or 0 for row, row_place in places.rows}
        read = list(as_parameters(read, indices, refused, assumptions))
    return Listing(
        columns_of_sheet,
        places,
        tuple(read),
        tuple(row.number for row in places.skipped),
        tuple(refused),
        ways,
        tuple(assumptions),
        tuple(undecided),
        own,
        options.address_unit == "bytes",
    )


def _with_columns(sheet: Sheet, names: Mapping[str, str], assumptions: list[Assumption]) -> tuple[Sheet, Columns]:
    """A sheet with a row for each register, and its columns. Raises ListError where none has addresses."""
    if names:
        return sheet, columns(with_subindices_apart(sheet), names)
    sheet = side_by_side(sheet, assumptions)
    fault = None
    try:
        sheet_columns = columns(with_subindices_apart(sheet), names)
    except ListError as error:
        fault = error
    else:
        heading = sheet_columns.heading("address")
        if {*sheet_columns.places} <= {"address", "space"} and len(sheet_columns.unused()) > 1:
            fault = ListError(
                f"has addresses under {heading}, and no other column that is understood "
                f"({headings_text(sheet_columns.headings)}); name the column of addresses with --address"
            )
        elif address_rank(heading):
            return sheet, sheet_columns
    if (unrolled := matrix(sheet, assumptions)) is not None:
        return unrolled, columns(unrolled, names)
    if fault is not None:
        raise fault
    return sheet, sheet_columns


def _refuse_codes(rows: Sequence[ListRow], places: Placed, columns_of_sheet: Columns) -> None:
    """Raises ListError for numbers such as `P01.02` that are codes of parameters: most have more values than a bit."""
    of_bits = {row.number for row, place in places.rows if place.bits is not None and place.bits[0] == place.bits[1]}
    bits = [row for row in rows if row.row in of_bits]
    wider = [
        row for row in bits if max(row.high or 0, row.default or 0, *dict(row.meanings.members), 0) > 1 or row.unit
    ]
    if len(wider) >= _FEWEST_CODES and len(wider) * 2 > len(bits):
        text = wider[0].texts["address"]
        raise ListError(
            f"has `{text}` under {columns_of_sheet.heading('address')}, which is a bit, or the code of a parameter: "
            f"row {wider[0].row} has more values than a bit; give whole addresses, or name their column with --address"
        )


def _decimal(columns_of_sheet: Columns, assumptions: list[Assumption]) -> str:
    texts = (
        columns_of_sheet.cell(row, role)
        for role in _NUMERIC
        if role in columns_of_sheet.places
        for row in columns_of_sheet.rows
    )
    sign, example = decimal_sign(texts)
    if sign == COMMA:
        assumptions.append(Assumption("numbers", "a comma is before the fraction", f"`{example}`", "--decimal point"))
    return sign


def _has_number(row: SheetRow) -> bool:
    """Whether a row has several cells, one of which is a number that may be an address."""
    filled = [cell for cell in row.cells if cell]
    return len(filled) > 1 and any(cell[:1].isdigit() and address_text(cell) for cell in filled)


def _formulas(sheet: Sheet, columns_of_sheet: Columns) -> Iterator[Refusal]:
    """The cells in use with a formula whose value the file does not have."""
    used = {column + 1: role for role, column in columns_of_sheet.places.items()}
    first = columns_of_sheet.rows[0].number
    for row, column in sorted(sheet.formulas):
        if column in used and row >= first:
            heading = columns_of_sheet.heading(used[column])
            yield Refusal(row, heading, f"{letters(column)}{row}", "is a formula whose value the file does not have")


def _further_cells(columns_of_sheet: Columns, places: Placed, assumptions: list[Assumption]) -> dict[int, str]:
    """The cells to the right of all headings by row, where few rows have some: their other cells may be shifted."""
    width = max((n for n, heading in enumerate(columns_of_sheet.headings, 1) if heading), default=0)
    further = {row.number: ", ".join(filter(None, row.cells[width:])) for row, _ in places.rows if width}
    further = {number: text for number, text in further.items() if text}
    if not 0 < 2 * len(further) < len(places.rows):
        return {}
    example = ", ".join(map(str, [*further][:3]))
    evidence = (
        f"{len(further)} rows have cells beyond them, as row {example}; a separator that is not quoted shifts cells"
    )
    assumptions.append(Assumption("cells", "each under its heading", evidence))
    return further


def _of_bytes(row: ListRow, step: int) -> ListRow | None:
    """A row whose address counts bytes with that of its register; None for more bytes than one from its second one.

    `step` divides all addresses: it is the number of bytes of a row without a type and a length.
    """
    address, is_second = divmod(row.address, 2)
    if row.type is not None and row.type.bytes == 1 and row.bits is None:
        low = 0 if is_second else 8
        return replace(row, address=address, bits=(low, low + 7), words=None)
    is_wide = row.type is None and row.words is None and step in _WIDE_STEPS
    return None if is_second else replace(row, address=address, words=step // 2 if is_wide else row.words)


def _numbered(row: ListRow, row_place: Place, address: int, base: str) -> ListRow:
    """A row with its address, and with the words from it to the last one that the cell has."""
    is_reference = base == REFERENCE or row_place.first.mark == REFERENCE or is_reference_of_other(row_place)
    reference = row_place.first.reference() if is_reference else None
    last = row_place.last.number(base) if row_place.last is not None else None
    first = row_place.first.number(base)
    span = last - first + 1 if last is not None and first is not None and last >= first else None
    doubts = row.doubts
    if reference and row.space and row.space != reference[0]:
        doubts = (
            *doubts,
            f"The list says {row.texts.get('space') or row.texts.get('function')}, and the number of {reference[0]}.",
        )
    if span is not None and row.words not in (None, span):
        doubts = (*doubts, f"The list says {row.texts.get('words')} words, and {span} addresses.")
    names = re.split(r"\s*[/,+]\s*", row.names[0]) if row.names and row.type is None and not row.length else []
    if span is not None and span == len(names) > 1:
        doubts = (*doubts, f"The list has {span} addresses, and a name for each.")
        are_apart = len(re.split("[,;/&]", row.texts["address"])) == span
        if are_apart and span not in UNSIGNED:  # no number has so many words
            row, span = replace(row, count=span), None
    is_bit = row.type is not None and (row.type.name == BIT or row.type.kind is Loose.TRUTH)
    if span is not None and span > 1 and is_bit and not row.words:
        doubts = (*doubts, f"The list says {row.texts.get('type')}, and {span} addresses.")
    space = reference[0] if reference else row.space
    return replace(row, address=address, words=span or row.words, space=space, doubts=doubts)


def _with_bits_beneath(rows: list[ListRow], register_list: Listing) -> list[ListRow]:
    """The rows, also the rows beneath a register whose only address is the number of a bit."""
    bits_of = list(_bits_beneath(register_list))
    if not bits_of:
        return rows
    by_row = sorted([*rows, *bits_of], key=lambda row: row.row)
    result: list[ListRow] = []
    for row in by_row:
        above = result[-1] if result else None
        if row.address < 0 and above is not None:
            row = replace(row, address=above.address, space=above.space)
        if row.address >= 0:
            result.append(row)
    return result


def _bits_beneath(register_list: Listing) -> Iterator[ListRow]:
    """Rows of bits without an address, which stand at -1 until the register above is known."""
    for row in register_list.places.skipped:
        texts = {role: text for role in register_list.columns.places if (text := register_list.columns.cell(row, role))}
        cells = row_cells(register_list.columns, row, texts, {})
        match = next((match for name in cells.names if (match := _BIT_NAME.fullmatch(name))), None)
        list_row = read_row(cells, POINT, "")
        if list_row.bits is not None and "bit" in texts and cells.names:
            yield replace(list_row, address=-1)
        elif match and (names := tuple(filter(None, (match[3], *(name for name in cells.names if name != match[0]))))):
            low, high = int(match[1]), int(match[2] or match[1])
            yield replace(list_row, address=-1, bits=(min(low, high), max(low, high)), names=names)


def _with_gaps(rows: list[ListRow]) -> list[ListRow]:
    """The rows with the distances to the next address of their space, 0 after the last one."""
    addresses: dict[str, list[int]] = defaultdict(list)
    for row in rows:
        addresses[row.space].append(row.address)
    following: dict[tuple[str, int], int] = {}
    for space, numbers in addresses.items():
        ordered = sorted(set(numbers))
        following.update({(space, a): b - a for a, b in pairwise(ordered)})
    return [replace(row, gap=following.get((row.space, row.address), 0)) for row in rows]
