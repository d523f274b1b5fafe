"""The imported content of a list: registers, refused rows, and assumptions."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from fieldspec.foundation.classes import dataclass, replace
from fieldspec.foundation.line_text import plural
from fieldspec.language.model.primitives import PRIMITIVES
from fieldspec.tools.lists.addresses import DECIMAL, HEXADECIMAL, REFERENCE
from fieldspec.tools.lists.assumption import Assumption, Refusal
from fieldspec.tools.lists.entries import SPACES, Entry, entries
from fieldspec.tools.lists.halves import with_halves_joined
from fieldspec.tools.lists.listing import Listing
from fieldspec.tools.lists.message_entries import message_entries
from fieldspec.tools.lists.numbering import chosen
from fieldspec.tools.lists.rolling_up import rolled_up
from fieldspec.tools.lists.row_reading import MESSAGE, PARAMETER, REGISTER, SIGNAL, ListRow, moved
from fieldspec.tools.lists.shapes import BIT, shape
from fieldspec.tools.lists.sheet import ListError, Sheet

_MOST_WORDS, _MOST_ROWS = 4, 5
"""The words of the greatest number, and the most rows that are named."""


@dataclass(frozen=True, slots=True)
class Imported:
    """The imported content of a list. `rows` are those with an address, of which `refused` may have some.

    `skipped` are the numbers of the rows that have no address and are not bits of a register above.
    """

    listing: Listing
    sheet: Sheet
    base: str
    rows: tuple[ListRow, ...]
    registers: tuple[Entry, ...]
    refused: tuple[Refusal, ...]
    assumptions: tuple[Assumption, ...]
    skipped: tuple[int, ...]
    reasons: Mapping[int, str]
    refused_cells: tuple[Refusal, ...]

    def spaces(self) -> list[str]:
        """The address spaces that registers are in; empty for the first one."""
        used = {entry.space for entry in self.registers}
        return ["" if number == 0 else name for number, name in enumerate(SPACES) if name in used]

    def has_usual_spaces(self) -> bool:
        """Whether all registers are in spaces that lists usually have, each in units of words or bits."""
        list_registers = [entry for entry in self.registers if entry.kind != PARAMETER]
        in_words = all(entry.shape.type == BIT or entry.row.words for entry in list_registers if entry.row.is_own)
        return bool(list_registers) and in_words and all(entry.space in SPACES for entry in list_registers)

    def has_objects(self) -> bool:
        """Whether the list is one of objects with elements, as files of other programs have them."""
        return all(entry.kind == PARAMETER and not entry.row.is_own for entry in self.registers)

    def without(self, reasons: Mapping[int, str]) -> Imported:
        """The same, without some rows, each with its reason."""
        if not reasons:
            return self
        return _entered(replace(self, reasons={**self.reasons, **reasons}))

    def used_rows(self) -> set[int]:
        """The numbers of the rows that are registers or bits."""
        rows = [row for entry in self.registers if entry.is_own for row in entry.rows or (entry.row,)]
        register_rows = {row.row for row in rows} | {number for row in rows for number in row.parts}
        return register_rows | {bit.row.row for entry in self.registers for bit in entry.bits if bit.row is not None}


def imported(register_list: Listing, sheet: Sheet, offset: int) -> Imported:
    """The imported content of a list whose addresses are higher by an offset than on the wire. Raises ListError where
    it leaves something open that the user has to decide.
    """
    if register_list.open:
        raise ListError("; ".join(f"leaves open: {undecided.text()}" for undecided in register_list.open))
    spaces = {row.row: row.space for row in register_list.read if row.space}
    base, assumption = chosen(register_list.places, register_list.bases, register_list.columns, spaces)
    digits = [row_place.first.digits for _, row_place in register_list.places.rows]
    are_padded = len({*map(len, digits)}) == 1 and any(text.startswith("0") for text in digits)
    if are_padded and register_list.bases == (DECIMAL, HEXADECIMAL):
        overlaps = {own_base: sum(map(_overlaps, register_list.rows(own_base))) for own_base in register_list.bases}
        if overlaps[DECIMAL] and not overlaps[HEXADECIMAL]:
            evidence = f"as decimal numbers, {overlaps[DECIMAL]} rows overlap the next ones"
            base, assumption = HEXADECIMAL, Assumption("addresses", "hexadecimal", evidence, "--base decimal")
    rows, refused, further = register_list.numbered(base)
    assumptions = [*([assumption] if assumption else []), *further, *register_list.assumptions]
    rows = with_halves_joined(rows, assumptions)
    silent = sum(not row.space and row.kind == REGISTER for row in rows)
    if silent and base != REFERENCE and not register_list.own:
        scope = "" if silent == len(rows) else f" of {silent} rows"
        assumptions.append(Assumption("address space", "registers", f"the list does not say it{scope}", "--space"))
    if sheet.encoding:
        assumptions.append(Assumption("encoding", sheet.encoding, "the bytes are not UTF-8", "--encoding"))
    result = _entered(
        Imported(
            register_list,
            sheet,
            base,
            tuple(moved(rows, offset)),
            (),
            (),
            tuple(assumptions),
            register_list.skipped,
            {},
            (*register_list.refused, *refused),
        )
    )
    if register_list.own:
        return result
    result = replace(result, assumptions=(*result.assumptions, *_types(result.registers)))
    if not any(map(_lacks_order, result.registers)):
        return result
    order = Assumption("order of words", "ABCD, the high word first", "the list does not say it", "--order")
    return replace(result, assumptions=(*result.assumptions, order))


def _types(registers: Sequence[Entry]) -> Iterator[Assumption]:
    """The assumption about the registers whose types the list does not say."""
    silent = [entry for entry in registers if entry.kind == REGISTER and entry.is_own and entry.shape.inferred]
    types = ", ".join(sorted({entry.shape.type for entry in silent} - {BIT}))
    wide = [
        entry.row.row
        for entry in silent
        if entry.row.words is None and entry.shape.words < entry.row.gap <= _MOST_WORDS
    ]
    if types:
        numbers = ", ".join(map(str, wide[:_MOST_ROWS]))
        places = f"; the next address is further after row{'s' * (len(wide) > 1)} {numbers}" if wide else ""
        yield Assumption(
            "types", types, f"the list does not say them of {plural(len(silent), 'row')}{places}", "--column type"
        )


def _overlaps(row: ListRow) -> bool:
    """Whether a row has more words than there are addresses up to the next one."""
    return row.type is not None and row.bits is None and shape(row, False).words > row.gap > 0


def _lacks_order(entry: Entry) -> bool:
    """Whether a register has several words, and the list does not say which of them is first."""
    primitive = PRIMITIVES[entry.shape.type]
    return entry.kind == REGISTER and not entry.row.order and primitive.is_number and primitive.size > 2


def _entered(result: Imported) -> Imported:
    """The result with its registers, and the refused rows of the list."""
    registers, contradicting = entries(result.rows, result.reasons)
    registers = rolled_up(registers)
    messages = [row for row in result.rows if row.kind in (MESSAGE, SIGNAL)]
    registers += message_entries(messages, result.reasons, contradicting)
    if not registers:
        refusals: Sequence[Refusal] = [*result.refused_cells, *contradicting]
        raise ListError(f"has no row that can be a register: {refusals[0].text()}")
    refused = sorted([*result.refused_cells, *contradicting], key=lambda refusal: refusal.row)
    entered = replace(result, registers=tuple(registers), refused=tuple(refused))
    used = entered.used_rows() | {refusal.row for refusal in refused}
    return replace(entered, skipped=tuple(number for number in result.listing.skipped if number not in used))
