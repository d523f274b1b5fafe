"""A comment for every word of memory, short and in ASCII."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache

from fieldspec.backends.kv.areas import Area
from fieldspec.backends.kv.dialect import WordDialect
from fieldspec.backends.kv.held import Held

_LETTERS = re.compile("[A-Za-z]+")
_FOREIGN = {"°C": "degC"}


def rows(base: int, area: Area, dialect: WordDialect) -> Iterator[tuple[str, str]]:
    """Devices and their comments, for an area whose first word has the number `base`."""
    texts: dict[int, dict[str, str]] = {}
    for held in area.held:
        unit = _scaled(held)
        for name, start in held.names():
            first, last = start // area.unit, (start + max(held.size, 1) - 1) // area.unit
            texts.setdefault(first, {}).setdefault(name, unit)
            for word in range(first + 1, last + 1):
                texts.setdefault(word, {}).setdefault(f"{name}+{word - first}", unit)
    for word, found in sorted(texts.items()):
        device = dialect.device(base + word)
        if device:
            yield device, _fitted(area.tag, found, dialect.width)


def _scaled(held: Held) -> str:
    """What one count is worth: `0.01mm`."""
    value = held.value
    if value is None or not value.unit:
        return ""
    unit = _FOREIGN.get(value.unit, value.unit)
    return f"{value.scale_text}{unit}" if value.scaled else unit


def _fitted(tag: str, found: dict[str, str], width: int) -> str:
    """The names of what a word holds, and the unit of a single one if there is room.

    Words of letters are cut, all to the same length, until it fits.
    """
    text = tag + "/".join(found)
    (unit, *others) = found.values()
    if unit and not others and len(text) + len(unit) < width:
        return f"{text} {unit}"
    if len(text) <= width:
        return text
    lengths = [len(word) for word in _LETTERS.findall(text)]
    for letters in range(max(lengths, default=0) - 1, 0, -1):
        if len(text) - sum(length - letters for length in lengths if length > letters) <= width:
            return _longer(letters).sub(r"\1", text)
    return text[:width]


@cache
def _longer(letters: int) -> re.Pattern[str]:
    """Words of more letters; the group is what is kept of them."""
    return re.compile(f"([A-Za-z]{{{letters}}})[A-Za-z]+")
