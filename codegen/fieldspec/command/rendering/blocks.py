"""Terminal output as data: lines and tables, aligned columns, and drawings of words of bits."""

from __future__ import annotations

import unicodedata
from collections.abc import Iterator, Sequence
from functools import lru_cache

from fieldspec.codec.explain.values import in_unit, range_in_unit
from fieldspec.foundation.caches import ByIdentity
from fieldspec.foundation.classes import TYPE_CHECKING, dataclass
from fieldspec.foundation.line_text import visible_text
from fieldspec.language.model.enums import Bit, Flags

if TYPE_CHECKING:
    from typing import TypeAlias


def width(text: str) -> int:
    """The columns that a text takes in a terminal: two for a wide character, none for a combining one."""
    return len(text) if text.isascii() else _wide_width(text)


@lru_cache(4096)
def _wide_width(text: str) -> int:
    return sum(map(_char_width, text))


def _char_width(char: str) -> int:
    if unicodedata.combining(char) or unicodedata.category(char) in ("Cf", "Mn"):
        return 0
    return 2 if unicodedata.east_asian_width(char) in "WF" else 1


def aligned(headings: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A table as text, with two blanks between columns."""
    lines = [[visible_text(cell) for cell in row] for row in (headings, *rows)]
    sizes = [list(map(width, line)) for line in lines]
    widths = list(map(max, *sizes)) if rows else sizes[0]
    text = ""
    for line, own in zip(lines, sizes, strict=True):
        padded = [cell + " " * (column - size) for cell, size, column in zip(line, own, widths, strict=True)]
        text += "  ".join(padded).rstrip() + "\n"
    return text


@dataclass(frozen=True, slots=True)
class Line:
    """A line; `style` is that of a terminal: `bold`, `dim`, `red`, `green`, `yellow`, or empty.

    A `drawn` line is never wrapped, and keeps its blanks.
    """

    text: str
    style: str = ""
    drawn: bool = False


@dataclass(frozen=True, slots=True)
class Table:
    """Cells by row, and the style of each row; `styles` is empty where no row has one."""

    headings: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    styles: tuple[str, ...] = ()


Block: TypeAlias = Line | Table


def bare_text(block: Block) -> str:
    """A block as lines of bare text."""
    if isinstance(block, Line):
        return visible_text(block.text) + "\n"
    return _TABLES.get_or_compute(block, lambda table: aligned(table.headings, table.rows))


_TABLES: ByIdentity[Table, str] = ByIdentity(limit=1024)
"""The texts of tables, which logs of frames print again and again."""


_GAP = 2
_FIXED = 2
"""The columns that stay in a table that is split: they tell its rows apart."""


def split(table: Table, limit: int) -> tuple[tuple[int, ...], tuple[int, ...]]:
    """The numbers of the columns that fit into `limit` columns of a terminal, and of the columns below their rows.

    The widest columns go first, of equal ones the last; the first two always stay.
    """
    lines = [[visible_text(cell) for cell in row] for row in (table.headings, *table.rows)]
    widths = [max(width(line[index]) for line in lines) for index in range(len(table.headings))]
    stay = list(range(len(widths)))
    below: list[int] = []
    while len(stay) > _FIXED and sum(widths[index] + _GAP for index in stay) - _GAP > limit:
        widest = max(stay[_FIXED:], key=lambda index: (widths[index], index))
        stay.remove(widest)
        below.append(widest)
    return tuple(stay), tuple(sorted(below))


def narrowed(table: Table) -> Table:
    """A table without its empty columns."""
    full = [index for index in range(len(table.headings)) if any(cells[index] for cells in table.rows)]
    rows = tuple(tuple(cells[index] for index in full) for cells in table.rows)
    return Table(tuple(table.headings[index] for index in full), rows, table.styles)


_A_ROW = 16


def drawn(word: Flags) -> Iterator[str]:
    """A drawing of a word: a box for each bit, the highest first, 16 per row, with lines to the bit names.

    There is no wall between the bits of one field. The boxes of bits without a name are empty.
    """
    width = word.type.size * 8
    for high in range(width, 0, -_A_ROW):
        if high < width:
            yield ""
        yield from _bits_drawing(word, max(0, high - _A_ROW), high)


def _bits_drawing(word: Flags, low: int, high: int) -> Iterator[str]:
    holders = {number: bit for bit in word.bits for number in bit.places}
    numbers = range(high - 1, low - 1, -1)
    wall = "+---" * len(numbers) + "+"
    boxes = ""
    for number in numbers:
        holder = holders.get(number)
        inner = holder is not None and holder is holders.get(number + 1) and number != high - 1
        boxes += (" " if inner else "|") + (" x " if holder is not None and not holder.reserved else "   ")
    yield "".join(f"{number:>3} " for number in numbers).rstrip()
    yield wall
    yield boxes + "|"
    yield wall
    meaningful_bits = [bit for bit in word.bits if not bit.reserved and low <= bit.first < high]
    for index, bit in enumerate(meaningful_bits):
        line = [" "] * _column(bit, high)
        for later in meaningful_bits[index + 1 :]:
            line[_column(later, high)] = "|"
        yield "".join(line) + _bit_text(bit)


def _column(bit: Bit, high: int) -> int:
    """The middle of the box of a bit, or of the lowest bit of a field."""
    return 4 * (high - 1 - bit.first) + 2


def _bit_text(bit: Bit) -> str:
    """`+- 4..5 level 液位: how full it is; when the mode is 3`"""
    name = " ".join(text for text in (bit.name, bit.printed_name, bit.label) if text)
    states = ", ".join(f"{number} {text}" for number, text in ((0, bit.zero), (1, bit.one)) if text)
    details = (
        states or bit.doc.removesuffix("."),
        f"range {range_in_unit(bit.as_value, bit.ranges)}" if bit.ranges is not None else "",
        f"default {in_unit(bit.as_value, bit.default) or bit.default}" if bit.default is not None else "",
        f"values {bit.enum}" if bit.enum else "",
        f"at its {bit.edge} edge" if bit.edge else "",
        "active low" if bit.active == "low" else "",
        f"when {bit.when}" if bit.when else "",
    )
    description = "; ".join(detail for detail in details if detail)
    return f"+- {bit.number_text} {name}" + (f": {description}" if description else "")
