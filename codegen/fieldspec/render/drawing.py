"""A word of bits, drawn in characters."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.model.flags import Bit, Flags

_A_ROW = 16


def drawn(word: Flags) -> Iterator[str]:
    """One box a bit, the highest first, at most 16 in a row, and a line from each named bit to its name.

    The bits of one field have no wall between them. Bits that have no name are empty.
    """
    width = word.type.size * 8
    for high in range(width, 0, -_A_ROW):
        if high < width:
            yield ""
        yield from _row(word, max(0, high - _A_ROW), high)


def _row(word: Flags, low: int, high: int) -> Iterator[str]:
    holders = {number: bit for bit in word.bits for number in range(bit.first, bit.last + 1)}
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
    named = [bit for bit in word.bits if not bit.reserved and low <= bit.first < high]
    for at, bit in enumerate(named):
        line = [" "] * _column(bit, high)
        for later in named[at + 1 :]:
            line[_column(later, high)] = "|"
        yield "".join(line) + _said(bit)


def _column(bit: Bit, high: int) -> int:
    """The middle of the box of a bit, or of the lowest bit of a field."""
    return 4 * (high - 1 - bit.first) + 2


def _said(bit: Bit) -> str:
    """`+- 4..5 level 液位: how full it is; when the mode is 3`"""
    span = f"{bit.first}" if bit.width == 1 else f"{bit.first}..{bit.last}"
    name = " ".join(text for text in (bit.name, bit.printed_name, bit.label) if text)
    states = ", ".join(f"{number} {text}" for number, text in ((0, bit.zero), (1, bit.one)) if text)
    details = (
        states or bit.doc.removesuffix("."),
        f"values {bit.enum}" if bit.enum else "",
        f"at its {bit.edge} edge" if bit.edge else "",
        "active low" if bit.active == "low" else "",
        f"when {bit.when}" if bit.when else "",
    )
    said = "; ".join(detail for detail in details if detail)
    return f"+- {span} {name}" + (f": {said}" if said else "")
