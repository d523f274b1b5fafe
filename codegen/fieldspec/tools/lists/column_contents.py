"""The conditions for the cells of a column, so that it has the role that its heading names."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence, Set

from fieldspec.tools.lists import cells
from fieldspec.tools.lists.addresses import address_text, place
from fieldspec.tools.lists.brackets import without_brackets
from fieldspec.tools.lists.orders import stated_order
from fieldspec.tools.lists.quantities import formula, known_unit, scaled_unit
from fieldspec.tools.lists.row_quantity import COUNT, decimal_places, example
from fieldspec.tools.lists.sheet import CellError, SheetRow
from fieldspec.tools.lists.type_words import typed
from fieldspec.tools.lists.value_texts import bit_names, value_meanings
from fieldspec.tools.lists.words import folded, meaning

_NO_SPACES = ("input", "inputs", "i", "register", "registers", "contact", "discrete", "c", "h")
"""Names of address spaces that also are directions, and types."""


def are_no_types(rows: Sequence[SheetRow], column: int) -> bool:
    """Whether a column, whose heading is that of types, has only names of address spaces, or accesses."""
    texts = {text for row in rows if (text := row.cell(column))}
    are_spaces = all(map(cells.space, texts)) and not all(folded(text) in _NO_SPACES for text in texts)
    return are_spaces or all(map(cells.access, texts))


def are_of_memory(rows: Sequence[SheetRow], column: int) -> bool:
    """Whether a column has only places in the memory of a controller: `D100`, `%MW10`, `X3`."""
    addresses = [(text, address_text(text)) for row in rows if (text := row.cell(column))]
    return all(
        text[0] == "%" or (address is not None and not address.space and bool(address.area or address.prefixed))
        for text, address in addresses
    )


def counts_on(rows: Sequence[SheetRow], column: int) -> bool:
    """Whether a column has numbers that rise from row to row, or have the mark of addresses: it adds to no value."""
    texts = [text for row in rows if (text := row.cell(column))]
    addresses = [address_text(text) for text in texts]
    numbers = [cells.whole(text) for text in texts]
    are_marked = bool(addresses) and all(address is not None and address.mark for address in addresses)
    rising = [number for number in numbers if number is not None]
    return are_marked or (len(rising) == len(texts) > 2 and rising == sorted(set(rising)))


def are_lengths(rows: Sequence[SheetRow], column: int) -> bool:
    """Whether most numbers of a column may be lengths: they are small."""
    numbers = [number for row in rows if (number := cells.whole(row.cell(column))) is not None]
    return sum(number <= _LONGEST for number in numbers) * 2 >= len(numbers)


def are_ranks(rows: Sequence[SheetRow], column: int) -> bool:
    """Whether a column, whose heading is that of orders of bytes, has numbers of rows, as in `order: 12`."""
    texts = [text for row in rows if (text := row.cell(column))]
    return any((cells.whole(text) or 0) > 1 and not stated_order(text) for text in texts)


def are_of_parts(heading: str, rows: Sequence[SheetRow], column: int) -> bool:
    """Whether a column has the units of parts of registers: all are the end of its heading, as in `unit_min`."""
    texts = {text.casefold() for row in rows if (text := row.cell(column))}
    return len(texts) == 1 and heading.casefold().endswith(f"_{texts.pop()}")


def are_exponents(rows: Sequence[SheetRow], column: int) -> bool:
    """Whether a column of scales has powers of ten: small whole numbers, some of them no factors of anything."""
    numbers = [cells.whole(text) for row in rows if any(map(str.isdigit, text := row.cell(column)))]
    powers = [number for number in numbers if number is not None and abs(number) <= _MOST_PLACES]
    return 0 < len(powers) == len(numbers) and min(powers) <= 0


def repeats(rows: Sequence[SheetRow], column: int) -> bool:
    """Whether a column has most of its texts several times, as one of groups has; those in brackets do not count."""
    texts = [without_brackets(text) for row in rows if (text := row.cell(column))]
    return len(texts) > 3 and len(set(texts)) * 2 < len(texts)


def is_place(text: str) -> bool:
    """Whether a text is an address, or several."""
    try:
        return place(text) is not None
    except CellError:
        return True


def _is_word_of_other(text: str) -> bool:
    """Whether a text is one of a column of functions, accesses, address spaces, or directions of factors."""
    is_word = cells.access(text) or cells.space(text) or meaning("operators", text)
    return cells.functions(text) is not None or bool(is_word)


_CONTENTS: dict[str, Callable[[str], object]] = {
    "address": is_place,
    "words": lambda text: re.fullmatch(
        r"[0-9]{1,5}\s*(?:words?|bytes?|bits?|reg(?:ister)?s?|ワード|バイト)?\.?", text, re.IGNORECASE
    ),
    "bits": lambda text: bit_names(text) is not None,
    "last": address_text,
    "access": cells.access,
    "writable": lambda text: cells.answer(text) is not None or cells.access(text),
    "function": cells.functions,
    "function_write": cells.functions,
    "places": lambda text: decimal_places(text) is not None,
    "value_offset": lambda text: cells.number(text, cells.COMMA) is not None,
    "bit": lambda text: re.search(r"[0-9]", text),
    "name": lambda text: any(map(str.isalpha, text)),
    "label": lambda text: (any(map(str.isalpha, text)) or value_meanings(text)) and not _is_word_of_other(text),
    "operator": lambda text: meaning("operators", text),
    "unit": lambda text: not text.isdecimal() or text == "1",
    "type": typed,
    **dict.fromkeys(("readable", "read_only"), lambda text: cells.answer(text) is not None),
    **dict.fromkeys(("exponent", "mask", "count", "stride", "first"), lambda text: cells.whole(text) is not None),
    **dict.fromkeys(("word_order", "byte_order"), lambda text: stated_order(text) or cells.answer(text) is not None),
}
"""What at least a third of the cells of a column must be, so that it has a role that its heading names."""


_MOST_PLACES, _LONGEST = 9, 1000
_FALLBACK_CONTENTS: dict[str, Callable[[str], object]] = {
    "type": typed,
    "space": cells.space,
    "places": lambda text: decimal_places(text) is not None and int(decimal_places(text) or 0) <= _MOST_PLACES,
    "scale": lambda text: re.fullmatch(r"0[.,]0*1|1|10+", text),
    "values": lambda text: value_meanings(text) is not None,
    "name": lambda text: any(map(str.isalpha, text)) and not cells.access(text),
}
"""The same for roles whose own headings are enough, and others are not."""

NOTED = ("access", "unit", "writable", "word_order", "byte_order", "type")
"""Roles whose heading, if it is a whole word, is enough: cells that do not fit become notes."""


BY_CELLS: dict[str, Callable[[str], object]] = {
    "type": lambda text: typed(text) is not None and not text.isdecimal(),
    "space": cells.space,
    "access": cells.access,
    "unit": known_unit,
    "values": lambda text: value_meanings(text) is not None and example(text, cells.COMMA) is None,
    "formula": lambda text: COUNT.match(text) and formula(text, cells.POINT) is not None,
}
"""The roles that the cells of a column show without a heading, where all of them fit."""

_FEWEST, _LETTERS, _FEWEST_NAMES = 2, 3, 3
_LETTERS_OF_UNITS = {"V", "A", "W"}
"""Letters that are units without a heading; others may be of kinds, or of places."""

_MOST_OF_MIXED, _MIXED_OF = 1, 2
"""The part of the cells of a column that are units, ranges or meanings of values."""


def role_by_cells(texts: Sequence[str], existing: Set[str], repeats: bool) -> str:
    """The role that all texts of a column fit, and that no other column has; empty for none.

    Texts that differ are names where no column has names or descriptions.
    """
    if len(texts) < _FEWEST:
        return ""
    are_letters = all(len(text) == 1 and text.isalpha() for text in texts) and not {*texts} <= _LETTERS_OF_UNITS
    for role, check in BY_CELLS.items():
        if role not in existing and all(map(check, texts)) and not all(folded(text) in _NO_SPACES for text in texts):
            return "" if role == "unit" and are_letters else role
    known = sum(bool(scaled_unit(text, cells.COMMA) or known_unit(text) or cells.bounds(text)) for text in texts)
    known += sum(value_meanings(text) is not None for text in texts)
    is_mixed = _MOST_OF_MIXED * len(texts) <= known * _MIXED_OF and not are_letters
    if is_mixed and existing.isdisjoint(("unit", "values", "range")):
        return "unit"  # whose cells may also be ranges, and values with their meanings
    are_words = sum(sum(map(str.isalpha, text)) >= _LETTERS for text in texts) * 4 >= len(texts) * 3
    return "name" if are_words and not repeats and existing.isdisjoint(("name", "label")) else ""


def is_alike(texts: Sequence[str]) -> bool:
    """Whether some of the texts of a column are equal, as texts of few kinds are; a short column has none."""
    return len(texts) <= _FEWEST_NAMES or len(set(texts)) < len(texts)


def has_role(role: str, texts: Sequence[str], is_fallback: bool) -> bool:
    """Whether the texts of a column fit a role whose heading other roles may share."""
    check = (_FALLBACK_CONTENTS.get(role) if is_fallback else None) or _CONTENTS.get(role)
    if check is None or not texts:
        return check is None or role != "address"
    return sum(bool(check(text)) for text in texts) * 3 >= len(texts)
