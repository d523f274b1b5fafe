"""Addresses as people write them: hexadecimal or decimal, counted from 0 or 1, or with a digit for the table before."""

from __future__ import annotations

import re
import unicodedata

from fieldspec.classes import dataclass
from fieldspec.lists.sheet import ListError

HEXADECIMAL, DECIMAL, REFERENCE = "hex", "decimal", "4xxxx"
BASES = (HEXADECIMAL, DECIMAL, REFERENCE)
"""How digits without a mark are read. A reference is 1-based behind a digit for its table: 40001 is 0."""

HIGHEST = 0xFFFFFFFF

_HEX = re.compile(r"(?:0x|&h|\$)([0-9a-f]{1,8})|([0-9a-f]{1,8})h", re.IGNORECASE)
_TABLE = re.compile(r"[34]x[ -]?([0-9]{1,5})", re.IGNORECASE)
_DIGITS = re.compile(r"[0-9a-f]{1,10}", re.IGNORECASE)
_POINTLESS = re.compile(r"([0-9]+)\.0+")
_GROUPED = re.compile(r"[0-9]{1,3}(?:[,.' ][0-9]{3})+")
_SPAN = re.compile(r"\s*(?:\.\.+|~|\u2013|\u2014|-|至|to)\s*", re.IGNORECASE)
_REFERENCES = ((40001, 49999), (30001, 39999), (400001, 465536), (300001, 365536))


@dataclass(frozen=True, slots=True)
class Spelled:
    """One address: its digits, and how they are to be read where a mark says it: `hex`, `4xxxx`, or nothing."""

    digits: str
    mark: str = ""

    @property
    def lettered(self) -> bool:
        """Whether there are letters among digits without a mark, so that they are hexadecimal."""
        return not self.mark and not self.digits.isdecimal()

    def reference(self) -> int | None:
        """The address behind a digit for a table, counted from 0."""
        if self.mark == REFERENCE:
            return int(self.digits) - 1
        number = int(self.digits) if not self.mark and self.digits.isdecimal() else 0
        return next((number - low for low, high in _REFERENCES if low <= number <= high), None)

    def number(self, base: str) -> int | None:
        """The address, where digits without a mark are read as `base` says; None where they cannot be."""
        if self.mark == HEXADECIMAL or (not self.mark and base == HEXADECIMAL):
            return int(self.digits, 16)
        if self.mark == REFERENCE or base == REFERENCE:
            return self.reference()
        return int(self.digits) if self.digits.isdecimal() else None


@dataclass(frozen=True, slots=True)
class Written:
    """What a cell says: one address, or the first and the last of several."""

    first: Spelled
    last: Spelled | None = None


def spelled(text: str) -> Spelled | None:
    """One address, or None where the text is none."""
    text = unicodedata.normalize("NFKC", text).strip()
    pointless = _POINTLESS.fullmatch(text)
    text = pointless[1] if pointless else text
    if marked := _HEX.fullmatch(text):
        return Spelled(marked[1] or marked[2], HEXADECIMAL)
    if table := _TABLE.fullmatch(text):
        return Spelled(table[1], REFERENCE)
    return Spelled(text) if _DIGITS.fullmatch(text) else None


def written(text: str, row: int) -> Written | None:
    """The address or addresses in a cell, or None where there are none. A number with separators is refused."""
    shown = unicodedata.normalize("NFKC", text).strip()
    if _GROUPED.fullmatch(shown):
        raise ListError(f"has the address `{text}` in row {row}, with separators between thousands; take them out")
    whole = spelled(shown)
    if whole is not None:
        return Written(whole)
    parts = _SPAN.split(shown)
    ends = [spelled(part) for part in parts]
    if len(ends) == 2 and ends[0] is not None and ends[1] is not None:
        first, last = ends[0], ends[1]
        if last.mark == HEXADECIMAL and not first.mark:
            first = Spelled(first.digits, HEXADECIMAL)
        if first.mark == HEXADECIMAL and not last.mark:
            last = Spelled(last.digits, HEXADECIMAL)
        return Written(first, last)
    return None


def said_by_heading(heading: str) -> str:
    """The base that a heading names, or nothing."""
    shown = unicodedata.normalize("NFKC", heading).casefold()
    if re.search(r"hex|\(h\)|十六|16\s*[进進]|0x", shown):
        return HEXADECIMAL
    return DECIMAL if re.search(r"\bdec|\(d\)|十进|十進|10\s*[进進]", shown) else ""
