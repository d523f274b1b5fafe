"""A comment for every word of memory, short and in ASCII."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from fieldspec.backends.kv.areas import Area
from fieldspec.backends.kv.dialect import WordDialect
from fieldspec.backends.kv.held import Held

_LETTERS = re.compile("[A-Za-z]+")
_FOREIGN = {"°C": "degC"}


def rows(placed: Sequence[tuple[int, Area]], dialect: WordDialect) -> Iterator[tuple[str, str]]:
    """Devices and their comments, for areas and the numbers of their first words."""
    for base, area in placed:
        texts: dict[int, dict[str, str]] = {}
        for held in area.held:
            for name, start in held.names():
                for word, text in _words(area, held, name, start):
                    texts.setdefault(word, {}).setdefault(text, _scaled(held))
        for word, found in sorted(texts.items()):
            device = dialect.device(base + word)
            if device:
                yield device, _fitted(area.tag, found, dialect.width)


def _words(area: Area, held: Held, name: str, start: int) -> Iterator[tuple[int, str]]:
    """The words of an element, each with its name."""
    first, last = start // area.unit, (start + max(held.size, 1) - 1) // area.unit
    for word in range(first, last + 1):
        yield word, name if word == first else f"{name}+{word - first}"


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
    longest = max((len(word) for word in _LETTERS.findall(text)), default=0)
    for letters in range(longest, 0, -1):
        cut = _cut(text, letters)
        if len(cut) <= width:
            return cut
    return text[:width]


def _cut(text: str, letters: int) -> str:
    return _LETTERS.sub(lambda word: word[0][:letters], text)
