"""The conditions for the cells of a column, so that it has the role that its heading names."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from fieldspec.tools.lists import cells
from fieldspec.tools.lists.addresses import address_text, place
from fieldspec.tools.lists.brackets import without_brackets
from fieldspec.tools.lists.orders import stated_order
from fieldspec.tools.lists.row_quantity import decimal_places
from fieldspec.tools.lists.sheet import CellError, SheetRow
from fieldspec.tools.lists.type_words import typed
from fieldspec.tools.lists.value_texts import bit_names
from fieldspec.tools.lists.words import folded

_NO_SPACES = ("input", "inputs", "i", "register", "registers", "contact", "discrete", "c", "h")
"""Names of address spaces that also are directions, and types."""


def are_spaces(rows: Sequence[SheetRow], column: int) -> bool:
    """Whether a column, whose heading is that of types, has only names of address spaces."""
    texts = {text for row in rows if (text := row.cell(column))}
    return all(map(cells.space, texts)) and not all(folded(text) in _NO_SPACES for text in texts)


def counts_on(rows: Sequence[SheetRow], column: int) -> bool:
    """Whether a column has numbers that rise from row to row, or have the mark of addresses: it adds to no value."""
    texts = [text for row in rows if (text := row.cell(column))]
    addresses = [address_text(text) for text in texts]
    numbers = [cells.whole(text) for text in texts]
    are_marked = bool(addresses) and all(address is not None and address.mark for address in addresses)
    rising = [number for number in numbers if number is not None]
    return are_marked or (len(rising) == len(texts) > 2 and rising == sorted(set(rising)))


def repeats(rows: Sequence[SheetRow], column: int) -> bool:
    """Whether a column has most of its texts several times, as one of groups has; those in brackets do not count."""
    texts = [without_brackets(text) for row in rows if (text := row.cell(column))]
    return len(texts) > 3 and len(set(texts)) * 2 < len(texts)


def _is_place(text: str) -> bool:
    try:
        return place(text) is not None
    except CellError:
        return True


_CONTENTS: dict[str, Callable[[str], object]] = {
    "address": _is_place,
    "words": lambda text: re.fullmatch(
        r"[0-9]{1,5}\s*(?:words?|bytes?|bits?|reg(?:ister)?s?)?\.?", text, re.IGNORECASE
    ),
    "bits": lambda text: bit_names(text) is not None,
    "last": address_text,
    "access": cells.access,
    "readable": lambda text: cells.answer(text) is not None,
    "writable": lambda text: cells.answer(text) is not None or cells.access(text),
    "function": cells.functions,
    "function_write": cells.functions,
    "places": lambda text: decimal_places(text) is not None,
    "exponent": lambda text: cells.whole(text) is not None,
    "value_offset": lambda text: cells.number(text, cells.COMMA) is not None,
    "count": lambda text: cells.whole(text) is not None,
    "stride": lambda text: cells.whole(text) is not None,
    "first": lambda text: cells.whole(text) is not None,
    "bit": lambda text: re.search(r"[0-9]", text),
    "name": lambda text: any(map(str.isalpha, text)),
    "label": lambda text: any(map(str.isalpha, text)) and cells.functions(text) is None,
    "unit": lambda text: not text.isdecimal() or text == "1",
    "word_order": lambda text: stated_order(text) or cells.answer(text) is not None,
    "byte_order": lambda text: stated_order(text) or cells.answer(text) is not None,
}
"""What at least a third of the cells of a column must be, so that it has a role that its heading names."""


_FALLBACK_CONTENTS: dict[str, Callable[[str], object]] = {
    "type": typed,
    "places": lambda text: not text.isdecimal() and decimal_places(text) is not None,
}
"""The same for roles whose own headings are enough, and others are not."""

NOTED = ("access", "unit", "writable", "word_order", "byte_order")
"""Roles whose heading, if it is a whole word, is enough: cells that do not fit become notes."""


def has_role(role: str, texts: Sequence[str], is_fallback: bool) -> bool:
    """Whether the texts of a column fit a role whose heading other roles may share."""
    check = (_FALLBACK_CONTENTS.get(role) if is_fallback else None) or _CONTENTS.get(role)
    if check is None or not texts:
        return check is None or role != "address"
    return sum(bool(check(text)) for text in texts) * 3 >= len(texts)
