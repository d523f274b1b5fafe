"""The type and the size of a register: the name of its type, the length and the next address decide together."""

from __future__ import annotations

import re

from fieldspec.foundation.classes import dataclass, replace
from fieldspec.language.model.primitives import PRIMITIVES
from fieldspec.tools.lists.row_reading import ListRow
from fieldspec.tools.lists.type_words import UNSIGNED, Loose

BIT = "bit"

_NUMBERS = re.compile(
    r"(.*[^\W\d_])[\s_#(\[]*(?<![0-9.])([0-9]{1,2})\s*(?:\.\.+|-|\u2013|~|…|\bto\b|\bbis\b)\s*([0-9]{1,2})[)\]]?",
    re.IGNORECASE,
)
"""A name with the first and the last number of its values."""

_MOST_WORDS = 4
"""The most words of a number."""

_WORD_BITS = 16
_WHOLE_WORDS = {"u8": "u16", "i8": "i16", "u24": "u32", "i24": "i32"}


@dataclass(frozen=True, slots=True)
class Shape:
    """A type with its words, how often it is repeated, what contradicts it, and what the list leaves open."""

    type: str
    words: int
    count: int = 1
    doubts: tuple[str, ...] = ()
    inferred: str = ""


def shape(row: ListRow, in_bits: bool) -> Shape:
    """The shape of a row's register. Where two of three agree, they win; else the length does. The rest is a doubt."""
    last_bit = max((bit.high for bit in row.meanings.bits), default=0)
    if row.type is None and row.words is None and last_bit >= _WORD_BITS:
        row = replace(row, words=2 if last_bit < 2 * _WORD_BITS else 4)
    own_type = row.type
    type_text = row.texts.get("type", "")
    if in_bits:
        is_bit = own_type is None or own_type.kind is Loose.TRUTH or own_type.size <= 1
        return Shape(BIT, 1, row.count, () if is_bit else (f"The list says {type_text}, and the space is of bits.",))
    name = own_type.of_words(row.words) if own_type is not None else ""
    name = "bool16" if name == BIT else name
    if not name:
        name = UNSIGNED.get(row.words or 1, "bytes")
        if row.low is not None and row.low < 0 and name != "bytes":
            name = name.replace("u", "i")
        is_short = any(map(str.isalpha, type_text)) and row.words is None and 1 < row.gap <= _MOST_WORDS
        doubts = (f"The list has a type of unknown size, and the next address is {row.gap} after.",) if is_short else ()
        return Shape(name, row.words or 1, row.count, doubts, "The list does not say it.")
    size = (PRIMITIVES[name].size + 1) // 2
    length = own_type.length if own_type is not None else 0
    if not size:
        return _of_text(row, name, length)
    if name in _WHOLE_WORDS:
        doubt = f"The list says {type_text}, which fills no whole number of words."
        whole = _WHOLE_WORDS[name] if row.words in (None, size) else "bytes"
        return Shape(whole, row.words or size, row.count, (doubt,))
    if row.words in (None, size):
        return Shape(name, size, row.count)
    doubt = f"The list says {type_text or name}, and {row.words} words."
    if row.gap == size:
        return Shape(name, size, row.count, (doubt,))
    return Shape(_of_length(name, row.words or 1), row.words or 1, row.count, (doubt,))


def with_elements(row: ListRow, in_bits: bool) -> ListRow:
    """A row, of whose words or whose type's length it is that counts values: bits, and `U16[6]`."""
    size = row.type.size if row.type is not None and row.type.name else 0
    length = row.type.length if row.type is not None else 0
    if in_bits and (row.words or 1) > 1:
        return replace(row, words=None, count=max(row.count, row.words or 1))
    if not (size and length > 1 and row.count == 1 and row.words in (None, length * size)):
        return _with_numbers_of_names(row, in_bits)
    if row.gap < length * size and (row.gap or "(" in row.texts.get("type", "")):
        further = f"and the next address is {row.gap} after" if row.gap else "which may be a count"
        doubt = f"The list says {row.texts.get('type')}, {further}."
        return replace(row, type=replace(row.type, length=0) if row.type else None, doubts=(*row.doubts, doubt))
    return replace(row, words=size, count=length)


def _with_numbers_of_names(row: ListRow, in_bits: bool) -> ListRow:
    """A row whose name has the numbers of several values, as `Temperature 1..8`: a count where they reach up to the
    next address, else a doubt."""
    span = _NUMBERS.fullmatch(row.names[0]) if row.names else None
    if span is None or row.bits is not None or row.count > 1:
        return row
    first, last = int(span[2]), int(span[3])
    size = shape(row, in_bits).words
    if last > first and row.gap == (last - first + 1) * size:
        texts = {**row.texts, "first": str(first)}
        return replace(row, count=last - first + 1, names=(span[1], *row.names[1:]), texts=texts)
    if last <= first or row.words == last - first + 1:
        return row
    doubt = f"The name has the numbers {first} to {last}, and the list has one value."
    return replace(row, doubts=(*row.doubts, doubt))


def _of_length(name: str, words: int) -> str:
    """The type with this number of words that is like the named type."""
    if name == "f32" and words == 4:
        return "f64"
    by_words = UNSIGNED.get(words, "bytes")
    return by_words.replace("u", "i") if name.startswith("i") else by_words


def _of_text(row: ListRow, name: str, length: int) -> Shape:
    """The shape of a text or of bytes: by the length, the characters in brackets, or the next address."""
    halves = (length + 1) // 2
    type_text = row.texts.get("type", name)
    if row.words is not None:
        fits = not length or row.words in (length, halves)
        return Shape(
            name, row.words, row.count, () if fits else (f"The list says {type_text}, and {row.words} words.",)
        )
    if length:
        words = length if row.gap == length else halves
        fits = row.gap == 0 or row.gap >= words
        doubt = f"The list says {type_text}, and the next address is {row.gap} after."
        return Shape(name, words, row.count, () if fits else (doubt,))
    doubt = f"The list says {type_text} without a length; it is taken up to the next address."
    return Shape(name, row.gap or 1, row.count, (doubt,))
