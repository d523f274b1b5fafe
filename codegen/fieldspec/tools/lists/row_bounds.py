"""The bounds and the default of a row, as numbers or as the meanings that a list has in their place."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from decimal import Decimal

from fieldspec.tools.lists.brackets import parted
from fieldspec.tools.lists.cells import bounds, number_in_unit
from fieldspec.tools.lists.row_quantity import described_range
from fieldspec.tools.lists.value_texts import Meanings, value_meanings
from fieldspec.tools.lists.words import folded

_HEX_END = re.compile(r"[0-9][0-9A-Fa-f]*?([A-Fa-f]+)")
"""A number that may be hexadecimal, or have a unit: `1F`."""


def row_bounds(
    texts: Mapping[str, str], described: Sequence[str], decimal: str, doubts: list[str]
) -> tuple[Decimal | None, Decimal | None, Meanings | None]:
    """The least and the greatest number, or the meanings that a list has in their place."""
    low, high = (_number_in_unit(texts, role, decimal) for role in ("min", "max"))
    if low == high == 0:
        low = high = None  # programs write 0 for both where there are none
    values = texts.get("values", "")
    text = texts.get("range", "") or (values if bounds(values, decimal) is not None else "")
    if not text and (low, high) == (None, None):
        text = next((text for text in described if described_range(text, decimal)), "")
    bare, aside = parted(text)
    in_brackets = value_meanings(aside) if aside and bounds(bare, decimal) is not None else None
    range_ends = bounds(bare if in_brackets else text, decimal)
    if range_ends is not None:
        if (low, high) != (None, None) and (low, high) != range_ends:
            doubts.append(f"Range in the list: {text}.")
            return low, high, in_brackets
        return *range_ends, in_brackets
    meanings = value_meanings(text) if text else None
    if text and meanings is None:
        doubts.append(f"Range in the list: {text}.")
    return low, high, meanings


def _number_in_unit(texts: Mapping[str, str], role: str, decimal: str) -> Decimal | None:
    """The number of a cell, perhaps with its unit; None for one that may be hexadecimal, as `1F` may in a row without
    that unit."""
    letters = _HEX_END.fullmatch(texts.get(role, "").strip())
    is_open = letters is not None and folded(letters[1]) != folded(texts.get("unit", ""))
    return None if is_open else number_in_unit(texts.get(role, ""), decimal)


def default_of(texts: Mapping[str, str], meanings: Meanings, decimal: str) -> Decimal | None:
    """The number of a default; that of a value where the default is its text: `Auto`, or `19200` of a rate."""
    text, number_text = texts.get("default", ""), _number_in_unit(texts, "default", decimal)
    members = [number for number, name in meanings.members if text and folded(name) == folded(text)]
    return Decimal(members[0]) if members and number_text not in dict(meanings.members) else number_text
