"""The address spaces of rows by titles, functions and numbers of kinds, and the order of words by titles."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence, Set

from fieldspec.foundation.classes import replace
from fieldspec.tools.lists import cells
from fieldspec.tools.lists.addresses import HEXADECIMAL, TABLES
from fieldspec.tools.lists.assumption import Assumption
from fieldspec.tools.lists.brackets import parted, without_brackets
from fieldspec.tools.lists.cells import functions
from fieldspec.tools.lists.row_reading import ListRow
from fieldspec.tools.lists.sheet import Sheet
from fieldspec.tools.lists.type_words import described_order
from fieldspec.tools.lists.words import alternatives, folded, pattern

_FUNCTION = re.compile(
    rf"\b{alternatives('function')} ?((?:0x)?[0-9]{{1,2}}(?:\s*[,/&]\s*(?:0x)?[0-9]{{1,2}})*)\b", re.IGNORECASE
)
_SCALED = re.compile(
    r"(?:\b1/10+|\b0[.,]0{0,3}1) ?(?:°|%|[a-z]{1,3}\b)|[x\u00d7*÷/] ?10+(?![0-9])|\b" + alternatives("tenth"),
    re.IGNORECASE,
)
_LONGEST_QUOTE = 100
_FEWEST_BITS, _LAST_BIT = 2, 16
_PHRASE = 8
"""The fewest letters of an access in a title: `read only`, and not `input`."""

_SHORTEST_TITLE, _LONGEST_TITLE, _COILS = 8, 5, "coils"
"""The fewest bytes of a title that names a space: shorter titles, such as `Inputs`, name groups; and the most words
of one that begins with it."""


def with_spaces(rows: list[ListRow], sheet: Sheet, assumptions: list[Assumption]) -> list[ListRow]:
    """The rows of a sheet with their address spaces, and with accesses where functions show these."""
    return _by_functions(_beneath_titles(_with_numbered_spaces(rows, assumptions), sheet, assumptions))


def with_bits_from_zero(rows: list[ListRow], assumptions: list[Assumption]) -> list[ListRow]:
    """The rows of a list with single bits of words, counted from 0: bit 16 beside no bit 0 shows that a list counts
    from 1, and where no bit is 0, it may."""
    bits = [row.bits[0] for row in rows if row.bits is not None and row.bits[0] == row.bits[1]]
    if len(bits) < _FEWEST_BITS or min(bits) != 1:
        return rows
    if max(bits) != _LAST_BIT:
        if bits.count(1) > 1 or bits[:2] == [1, 2]:
            assumptions.append(Assumption("bits", "those that are written", "none is 0; they may count from 1"))
        return rows
    assumptions.append(Assumption("bits", "counted from 1", "a bit 16 and no bit 0"))
    return [replace(row, bits=(row.bits[0] - 1, row.bits[1] - 1)) if row.bits else row for row in rows]


def titled_order(sheet: Sheet, used: Set[int], assumptions: list[Assumption]) -> str:
    """The order of words that a text beside the rows of a list states for all of them; empty where none does."""
    texts = [*_texts_beside(sheet, used), *sheet.orders]
    orders = {order: text for text in texts if (order := described_order(text))}
    if len(orders) == 1:
        ((order, text),) = orders.items()
        assumptions.append(Assumption("order of words", order, f"`{text}`", "--order"))
        return order
    if doubtful := next(filter(pattern("low_word").search, texts), ""):
        evidence = f"`{doubtful[:_LONGEST_QUOTE]}` is not understood"
        assumptions.append(Assumption("order of words", "ABCD, the high word first", evidence, "--order"))
    return "ABCD" if doubtful else ""


def unread_texts(sheet: Sheet, used: Set[int], has_factors: bool) -> Iterator[Assumption]:
    """The assumptions about texts beside the rows of a list that say how its addresses count, or which scales hold."""
    of_addresses = filter(pattern("of_addresses").search, _texts_beside(sheet, used))
    if text := next(filter(pattern("numbering").search, of_addresses), ""):
        evidence = f"`{text[:_LONGEST_QUOTE]}` may say that they count otherwise"
        yield Assumption("addresses", "those that are written", evidence, "--offset")
    elif text := next(filter(pattern("restarting").search, titles(sheet).values()), ""):
        yield Assumption("addresses", "those that are written", f"`{text[:_LONGEST_QUOTE]}` is not used", "--offset")
    if not has_factors and (text := next(filter(_SCALED.search, titles(sheet).values()), "")):
        yield Assumption("scales", "as each row has them", f"`{text[:_LONGEST_QUOTE]}` is not used")


def stated_base(sheet: Sheet, assumptions: list[Assumption]) -> str:
    """The base that a text of its own says all addresses to have; empty where none does."""
    texts = filter(pattern("of_addresses").search, titles(sheet).values())
    statement = next((text for text in texts if pattern("in_hexadecimal").search(text)), "")
    if not statement or pattern("decimal").search(pattern("in_hexadecimal").sub("", statement)):
        return ""
    assumptions.append(Assumption("addresses", "hexadecimal", f"`{statement[:_LONGEST_QUOTE]}`", "--base decimal"))
    return HEXADECIMAL


def _texts_beside(sheet: Sheet, used: Set[int]) -> Iterator[str]:
    return (text for row in sheet.rows if row.number not in used for text in row.cells if text)


def titles(sheet: Sheet) -> dict[int, str]:
    """The texts of rows with nothing else, by the numbers of the rows."""
    texts = {row.number: {*filter(None, row.cells)} for row in sheet.rows}
    return {number: next(iter(cells_of_row)) for number, cells_of_row in texts.items() if len(cells_of_row) == 1}


def _beneath_titles(rows: Sequence[ListRow], sheet: Sheet, assumptions: list[Assumption]) -> list[ListRow]:
    """The rows; rows that name no space are in the space of the title above, a row with only the name of a space, and
    have the access that it says. In a document, another heading of the same level ends it."""
    headed: dict[int, tuple[str, str, str]] = {}
    level = 0
    for number, text in titles(sheet).items():
        own_level = len(text) - len(text.lstrip("#"))
        if space := _titled_space(text):
            headed[number], level = (space, text, _titled_access(text)), own_level
        elif access := cells.access(text.strip("#*_: ")) if len(text) >= _PHRASE else "":
            headed[number], level = ("", text, access), own_level
        elif 0 < own_level <= level:
            headed[number], level = ("", "", ""), 0
    result = []
    title, used, titled = ("", "", ""), dict[str, str](), dict[str, str]()
    ordered = sorted(
        [*((number, None) for number in headed), *((row.row, row) for row in rows)], key=lambda pair: pair[0]
    )
    for number, list_row in ordered:
        if list_row is None:
            title = headed[number]
        else:
            space, text, access = title
            used |= {space: text} if space and not list_row.space else {}
            is_titled = bool(access) and not list_row.access and list_row.space in ("", space)
            titled |= {access: text} if is_titled else {}
            own_access = access if is_titled else list_row.access
            result.append(replace(list_row, space=list_row.space or space, access=own_access))
    if used:
        reading = ", ".join(f"{space} below `{text}`" for space, text in used.items())
        assumptions.append(Assumption("address space", reading, "the titles", "--space"))
    if titled:
        reading = ", ".join(f"{access} below `{text}`" for access, text in titled.items())
        assumptions.append(Assumption("access", reading, "the titles", "--access"))
    return result


def _titled_space(text: str) -> str:
    """The space that a title names, or whose function it has: `### Input Registers (read only) - Function 04`."""
    bare, aside = parted(text.strip("#*_ "))
    title_words = without_brackets(bare).split()
    beginning = " ".join(title_words[:2]) if len(title_words) <= _LONGEST_TITLE else ""
    is_long = len(folded(text).encode()) >= _SHORTEST_TITLE or folded(text) == _COILS
    is_title = text.startswith("#") or len(title_words) <= _LONGEST_TITLE
    code = _FUNCTION.search(text) if is_title else None
    if (read := functions(code[1]) if code else None) is not None:
        return read.space
    pieces = [piece for piece in re.split(r" [-\u2013] |[,;:]", aside) if len(folded(piece)) >= _SHORTEST_TITLE]
    return next(filter(None, map(cells.space, (text, aside, beginning, *pieces))), "") if is_long else ""


def _titled_access(text: str) -> str:
    """The access that a title says between other words: `(read/write)`, `- Read-Only Sensor Data`."""
    code = _FUNCTION.search(text)
    if (codes := functions(code[1]) if code else None) is not None and codes.reads and codes.writes:
        return "rw"
    pieces = [piece.strip(" #*_") for piece in re.split(r"[()\[\],:\u2013]| - ", text)]
    phrases = [piece for piece in (*pieces, *(piece.partition(" ")[0] for piece in pieces)) if len(piece) >= _PHRASE]
    return next(filter(None, map(cells.access, phrases)), "")


def _with_numbered_spaces(rows: list[ListRow], assumptions: list[Assumption]) -> list[ListRow]:
    """The rows, of whose spaces those that are numbers are codes of functions, or the first digits of references: what
    is written shows which."""
    numbers = {row.space for row in rows}
    writable = {row.space for row in rows if row.access in ("rw", "wo")}
    are_codes, are_digits = bool({"2"} & numbers or {"1", "3"} & writable), bool({"0"} & numbers or {"4"} & writable)
    spaces = {code: read.space for code in "1234" if (read := functions(code))} if are_codes else TABLES
    if are_codes is are_digits or not numbers & spaces.keys():
        return rows
    reading = "codes of functions" if are_codes else "first digits of references"
    assumptions.append(Assumption("kinds of registers", reading, "the other does not fit all rows", "--space"))
    return [replace(row, space=spaces.get(row.space, row.space)) for row in rows]


def _by_functions(rows: list[ListRow]) -> list[ListRow]:
    """The rows, read only where the functions that the list names for them only read, and others also write."""
    codes = [functions(row.texts.get("function", "")) for row in rows]
    if not any(code is not None and code.writes for code in codes):
        return rows
    return [
        replace(row, access="ro") if code is not None and not code.writes and not row.access else row
        for row, code in zip(rows, codes, strict=True)
    ]
