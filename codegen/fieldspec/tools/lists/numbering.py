"""Which addresses a list has on the wire: the bases in which its digits may be read, and the evidence for each."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence

from fieldspec.foundation.classes import dataclass, replace
from fieldspec.tools.lists.addresses import (
    DECIMAL,
    HEXADECIMAL,
    HIGHEST,
    REFERENCE,
    AddressText,
    Place,
    address_text,
    base_of_heading,
    place,
    whole_notation,
)
from fieldspec.tools.lists.assumption import Assumption, Refusal
from fieldspec.tools.lists.column_roles import Columns
from fieldspec.tools.lists.memories import of_memories, undecided, with_areas
from fieldspec.tools.lists.notations import are_most, with_notations
from fieldspec.tools.lists.sheet import CellError, ListError, SheetRow
from fieldspec.tools.lists.words import folded, words

_NEAR = 20
_FAR = 1000
_LAST_WORD = 0xFFFF
_MOST_EXAMPLES = 3
_FEWEST = 3
"""The rows that show a difference of two columns of addresses, which is more than that of counting from 1."""

_NOTATIONS = {HEXADECIMAL: "hexadecimal", DECIMAL: "decimal", REFERENCE: "references that count from 1"}


@dataclass(frozen=True, slots=True)
class Placed:
    """The rows with a place, the rows without an address, and those whose address is refused. `wire_heading` is that of
    a further column that has the addresses on the wire; empty for none."""

    rows: tuple[tuple[SheetRow, Place], ...]
    skipped: tuple[SheetRow, ...]
    refused: tuple[Refusal, ...]
    wire_heading: str = ""


def placed(columns: Columns, base: str = "") -> Placed:
    """The places of the rows of a list, whose digits are of a base if the user says it. Raises ListError if there is
    none."""
    rows: list[tuple[SheetRow, Place]] = []
    skipped: list[SheetRow] = []
    refused: list[Refusal] = []
    heading = columns.heading("address")
    texts = [text for row in columns.rows if (text := columns.cell(row, "address"))]
    headings = {*filter(None, columns.headings)}
    rewritten, memories = whole_notation(texts), of_memories(texts)
    for row in columns.rows:
        filled = [*filter(None, row.cells)]
        is_heading = sum(cell in headings for cell in filled) * 2 > len(filled)
        text = columns.cell(row, "address") if not is_heading else ""
        try:
            if text in memories:
                raise CellError(memories[text])
            row_place = place(rewritten(text)) if text else None
        except CellError as error:
            refused.append(Refusal(row.number, heading, text, str(error)))
            continue
        if row_place is not None:
            last = address_text(columns.cell(row, "last"))
            is_span = last is not None and row_place.last is None and row_place.bits is None
            rows.append((row, replace(row_place, last=last) if is_span else row_place))
        elif text and sum(map(bool, row.cells)) > 1 and row.cells != columns.headings:
            refused.append(Refusal(row.number, heading, text, "is not an address"))
        else:
            skipped.append(row)
    if not rows:
        _refuse_all(columns, refused)
    rows, wire_heading = with_notations(rows, columns)
    placed_rows = list(with_areas(rows, base, heading))
    shortened = {row.number for row in _shortened(placed_rows)}
    reason = "is this bit, or one whose number ends in a zero that a spreadsheet has dropped; write it as a text"
    refused += [
        Refusal(row.number, heading, columns.cell(row, "address"), reason)
        for row, _ in placed_rows
        if row.number in shortened
    ]
    placed_rows = [(row, row_place) for row, row_place in placed_rows if row.number not in shortened]
    return Placed(tuple(placed_rows), tuple(skipped), tuple(refused), wire_heading)


def _refuse_all(columns: Columns, refused: Sequence[Refusal]) -> None:
    heading = columns.heading("address")
    alone = len(columns.headings) == 1 and len(heading.split()) > 1
    parted = "; if spaces separate its columns, use tabs, commas or bars instead" if alone else ""
    examples_text = "; ".join(
        f"`{refusal.cell[:40]}` in row {refusal.row}, which {refusal.reason}" for refusal in refused[:_MOST_EXAMPLES]
    )
    raise ListError(
        f"has no address under {heading}{': ' + examples_text if examples_text else ''}"
        f"{parted or '; name the column with --address'}"
    )


def _shortened(rows: Sequence[tuple[SheetRow, Place]]) -> Iterator[SheetRow]:
    """The rows of a bit `100.1` after a higher one of the same register: it may be `100.10`."""
    last: dict[AddressText, int] = {}
    for row, row_place in rows:
        if row_place.bits is not None:
            low, high = row_place.bits
            if low == high and 0 < low < 10 and row_place.pointed and low < last.get(row_place.first, 0):
                yield row
            last[row_place.first] = high


def shortened_bits(placed_rows: Placed) -> Iterator[Assumption]:
    """The assumption that a bit `100.1` may be `100.10`, in a list where no bit of two digits ends in zero."""
    pointed = [
        (row_place.first.digits, row_place.bits[0])
        for _, row_place in placed_rows.rows
        if row_place.bits and row_place.pointed
    ]
    highest = dict(sorted(pointed))
    doubtful = [f"{digits}.{bit}" for digits, bit in pointed if 0 < bit * 10 < highest[digits]]
    if doubtful and not any(bit and bit % 10 == 0 for _, bit in pointed):
        evidence = f"`{doubtful[0]}` may be `{doubtful[0]}0`, whose zero a spreadsheet has dropped"
        yield Assumption("bits", "those that are written", evidence)


def bases(placed_rows: Placed, base: str, heading: str) -> tuple[str, ...]:
    """The ways to read digits without a mark, the likeliest first: only one if the user or the heading says it.

    Raises ListError for a base in which no address can be read.
    """
    ends = list(_ends(placed_rows))
    stated = base or base_of_heading(heading)
    lettered = [end for end in ends if end.lettered]
    if not stated and lettered and not _is_prefixed(ends):
        if any(end.area and not end.space for end in ends) and not all(end.area for end in ends):
            raise undecided(lettered[0].digits, heading)
        stated = HEXADECIMAL
    if stated:
        if all(end.number(stated) is None for end in ends):
            raise ListError(f"has the address `{ends[0].digits}` under {heading}, which cannot be read as {stated}")
        return (stated,)
    bare = [end for end in ends if not end.mark]
    if not bare:
        return (HEXADECIMAL,)
    ways = [DECIMAL, HEXADECIMAL]
    if _are_references(bare):
        ways.append(REFERENCE)
    return tuple(ways)


def _ends(placed_rows: Placed) -> Iterator[AddressText]:
    for _, row_place in placed_rows.rows:
        yield row_place.first
        if row_place.last is not None:
            yield row_place.last


def _is_prefixed(ends: Sequence[AddressText]) -> bool:
    """Whether all addresses are decimal digits after a letter, which may be an area of a controller's memory."""
    return bool(ends) and all(end.prefixed for end in ends)


def _are_references(ends: Sequence[AddressText]) -> bool:
    """Whether numbers may all be references. Those that begin with 0 or 1 are some only beside others."""
    firsts = {end.digits[0] for end in ends}
    return bool(firsts & {"3", "4"}) and all(end.reference() for end in ends)


@dataclass(frozen=True, slots=True)
class Reading:
    """A way to read addresses, and the evidence for it."""

    base: str
    evidence: tuple[str, ...]

    @property
    def text(self) -> str:
        """The evidence for it, in a line."""
        return ", ".join(self.evidence) or "nothing"


def chosen(
    placed_rows: Placed, ways: Sequence[str], columns: Columns, spaces: Mapping[int, str]
) -> tuple[str, Assumption | None]:
    """The base of a list that is not compared with a device, and the assumptions.

    `spaces` are those that further columns name, by row. Raises ListError where the evidence is equal.
    """
    heading = columns.heading("address")
    if len(ways) == 1:
        ends = list(_ends(placed_rows))
        lettered = next((end.digits for end in ends if end.lettered), "")
        if marked := next((end.digits for end in ends if end.mark == REFERENCE), ""):
            evidence = f"no number of a table is 0, as in `{marked}`"
            return ways[0], Assumption("addresses", _NOTATIONS[REFERENCE], evidence, "--offset")
        if base_of_heading(heading) == ways[0] or not lettered:
            return ways[0], None
        return ways[0], Assumption("addresses", _NOTATIONS[ways[0]], f"letters among digits: `{lettered}`", "--base")
    ends = [end for end in _ends(placed_rows) if not end.mark]
    if _is_prefixed(ends):
        raise undecided(ends[0].digits, heading)
    if REFERENCE in ways and all(map(is_reference_of_other, (row_place for _, row_place in placed_rows.rows))):
        return REFERENCE, Assumption(
            "addresses", "those in brackets", "the numbers before them are their references", "--base"
        )
    if REFERENCE not in ways:
        return DECIMAL, Assumption("addresses", "decimal", "digits without a mark", "--base hex")
    keys = {folded(text): text for text in columns.headings}
    if len(own_keys := [keys[word] for word in words("programs")["wire"] if word in keys]) > 1:
        evidence = f"{' and '.join(own_keys[:2])} are keys of a program that sends them so"
        return DECIMAL, Assumption("addresses", "those on the wire", evidence, "--base 4xxxx")
    return _between(
        Reading(DECIMAL, tuple(_for_wire(placed_rows, ends, columns, spaces))),
        Reading(REFERENCE, tuple(_for_references(placed_rows, ends, spaces))),
        ends[0],
    )


def _between(wire: Reading, references: Reading, first: AddressText) -> tuple[str, Assumption]:
    reference = first.reference()
    assert reference is not None
    examples = f"`{first.digits}` is the address {int(first.digits)} on the wire, or {reference[1]} of {reference[0]}"
    evidence = f"as decimal: {wire.text}; as references: {references.text}"
    if len(wire.evidence) == len(references.evidence):
        raise ListError(
            f"has numbers with two readings: {examples}. The evidence is equal ({evidence}); choose with "
            "--base decimal or --base 4xxxx"
        )
    best = max(wire, references, key=lambda reading: len(reading.evidence))
    return best.base, Assumption(
        "addresses", f"{_NOTATIONS[best.base]}; {examples}", evidence, "--base decimal or --base 4xxxx"
    )


def _for_references(placed_rows: Placed, ends: Sequence[AddressText], spaces: Mapping[int, str]) -> Iterator[str]:
    references = [reference for end in ends if (reference := end.reference())]
    lowest = min(references, key=lambda reference: reference[1])
    if any(_is_beyond(end) for end in ends):
        yield f"some numbers are greater than {_LAST_WORD}"
    are_low = are_most(sum(reference[1] < _FAR for reference in references), len(references))
    if lowest[1] == 0 or (lowest[1] < _NEAR and are_low):
        yield f"the numbers begin {lowest[1] + 1} above the numbers of a table"
    agreeing = [row.number for row, row_place in placed_rows.rows if _table(row_place) == spaces.get(row.number)]
    contradicting = _contradicting(placed_rows, spaces)
    if len({reference[0] for reference in references}) > 1 and contradicting <= len(agreeing):
        yield "several tables"
    if len(agreeing) > contradicting:
        yield f"the kinds of registers of {len(agreeing)} rows agree with the first digits"


def _for_wire(
    placed_rows: Placed, ends: Sequence[AddressText], columns: Columns, spaces: Mapping[int, str]
) -> Iterator[str]:
    references = [reference for end in ends if (reference := end.reference())]
    lowest = min((reference[1] for reference in references), default=0)
    if lowest >= _FAR and not any(_is_beyond(end) for end in ends):
        yield f"no number is less than {lowest} above the first of a table"
        if len({reference[0] for reference in references}) > 1:
            yield "and so in each of several tables"
    if contradicting := _contradicting(placed_rows, spaces):
        yield f"the kinds of registers of {contradicting} rows contradict the first digits"
    for column in columns.more.get("address", ()):
        differences = [difference for difference, _ in _differences(placed_rows, DECIMAL, column, columns).values()]
        if len(differences) == len(placed_rows.rows) and not any(differences):
            yield f"{columns.heading_at(column)} has the same numbers"


def _contradicting(placed_rows: Placed, spaces: Mapping[int, str]) -> int:
    """How many rows name another kind of registers than the first digit of their number would."""
    return sum(spaces.get(row.number, "") not in ("", _table(row_place)) for row, row_place in placed_rows.rows)


def _is_beyond(end: AddressText) -> bool:
    """Whether a number is greater than any address of a table is."""
    return (end.number(DECIMAL) or 0) > _LAST_WORD


def _table(row_place: Place) -> str:
    reference = row_place.first.reference()
    return reference[0] if reference else ""


def is_reference_of_other(row_place: Place) -> bool:
    """Whether an address is the reference of the one in its second notation."""
    reference = row_place.first.reference()
    return row_place.other is not None and reference is not None and row_place.other.number(DECIMAL) == reference[1]


def _differences(placed_rows: Placed, base: str, column: int, columns: Columns) -> dict[int, tuple[int, str]]:
    """The number of a further column less the address of each row that has both, with its cell there."""
    return {
        row.number: (other - number, row.cell(column))
        for row, row_place in placed_rows.rows
        if (number := wire_number(row_place, base)) is not None
        and (other := _further(row, column, columns)) is not None
    }


def _further(row: SheetRow, column: int, columns: Columns) -> int | None:
    try:
        other = place(row.cell(column)) if row.cell(column) else None
    except CellError:
        return None
    if other is None:
        return None
    return other.first.number(
        base_of_heading(columns.heading_at(column)) or (HEXADECIMAL if other.first.lettered else DECIMAL)
    )


def contradictions(placed_rows: Placed, base: str, columns: Columns) -> tuple[dict[int, Refusal], list[Assumption]]:
    """The rows whose columns with addresses contradict each other, and the usual difference of each further column."""
    refused: dict[int, Refusal] = {}
    assumptions = []
    for column in columns.more.get("address", ()):
        pairs = _differences(placed_rows, base, column, columns)
        if not pairs:
            continue
        (usual, times), *_ = Counter(difference for difference, _ in pairs.values()).most_common(1)
        heading = columns.heading_at(column)
        if times * 2 <= len(pairs) or (abs(usual) > 1 and times < _FEWEST):
            continue  # the column has other numbers, such as those of rows
        if usual:
            evidence = (
                f"{heading} is {usual} more in {times} rows"
                if usual > 0
                else f"{heading} is {-usual} less in {times} rows"
            )
            assumptions.append(Assumption("addresses", f"as in {columns.heading('address')}", evidence, "--address"))
        for number, (difference, cell) in pairs.items():
            if difference != usual:
                reason = f"contradicts the address under {columns.heading('address')}"
                refused[number] = Refusal(number, heading, cell, reason)
    return refused, assumptions


def wire_number(row_place: Place, base: str) -> int | None:
    """The first address of a place; the number in brackets where the one before it is its reference."""
    number = row_place.first.number(base)
    if row_place.other is None:
        return number
    other = row_place.other.number(DECIMAL if not row_place.other.lettered else HEXADECIMAL)
    reference = row_place.first.reference()
    decimal = row_place.first.number(DECIMAL)
    if other is None or other > HIGHEST:
        return None
    return other if other in (number, reference and reference[1], decimal, decimal and decimal - 1) else None
