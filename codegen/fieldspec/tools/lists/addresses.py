"""Reads cells with addresses: one, a range, one with the numbers of bits, one with a second notation in brackets."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Sequence
from itertools import pairwise

from fieldspec.foundation.classes import dataclass, replace
from fieldspec.tools.lists.sheet import CellError
from fieldspec.tools.lists.words import meaning, pattern

HEXADECIMAL, DECIMAL, REFERENCE = "hex", "decimal", "4xxxx"
BASES = (HEXADECIMAL, DECIMAL, REFERENCE)
"""How digits without a prefix are read. A reference is a digit for its table and an address from 1: 40001 is 0."""

HIGHEST = 0xFFFFFFFF

TABLES = {"0": "coils", "1": "discrete_inputs", "3": "input_registers", "4": "registers"}
"""The address spaces by the first digit of a reference."""

_HEX = re.compile(r"(?:0x|&h|\$|16#|h'|x)\s?([0-9a-f]{1,8})'?|([0-9a-f]{1,8})h", re.IGNORECASE)
_HALVES = re.compile(r"([0-9a-f]{2}) ([0-9a-f]{2})", re.IGNORECASE)
_BYTES = re.compile("([0-9a-f]{2}), ?([0-9a-f]{2})", re.IGNORECASE)
_COLON, _BIT_TEXT = re.compile("([0134]):([0-9]{1,5})"), len("4:15")
"""The digit of a table before an address, and the longest text that may as well be a register with its bit."""

_LOW_BYTE, _BYTE_LETTER = re.compile("[0-9]+L", re.IGNORECASE), re.compile("[0-9]+[HL]", re.IGNORECASE)
_TABLE = re.compile(r"([0134])x[ -]?([0-9]{5})|([134])x[ -]?([0-9]{1,5})", re.IGNORECASE)
_DIGITS = re.compile(r"[0-9a-f]{1,10}", re.IGNORECASE)
_POINTLESS = re.compile(r"([0-9]+)\.0+")
_POINTED = re.compile(r"[0-9]+\.[0-9]{1,2}")
_GROUPED = re.compile(r"[0-9]{1,3}(?:[,.' ][0-9]{3})+")
_EXPONENT = re.compile(r"[0-9](?:[.,][0-9]+)?e\+[0-9]{1,2}", re.IGNORECASE)
_SPAN = re.compile(r"\s*(?:\.\.+|~|\u2013|\u2014|-|至|\bto\b|\bbis\b)\s*", re.IGNORECASE)
_SEVERAL = re.compile(r"\s*(?:[,;&+]|\band\b|\bund\b)\s*", re.IGNORECASE)
_BREAK = re.compile(r"\s*<br\s*/?>\s*", re.IGNORECASE)
_NAMED = re.compile(r"(?:reg(?:ister)?s?|addr?(?:ess)?|%?([a-z]{1,3}))\.?\s?(?=[0-9])", re.IGNORECASE)

_HALF = re.compile(
    r"(.*[0-9a-f]h?)(?:_(l|h|lo|hi|low|high)|[\s_(\[]*(?:(lo|low|hi|high)[\s_-]*byte|([lm]sb)))\s*[)\]]?", re.IGNORECASE
)
_NUMBERED_BYTE = re.compile(r"[0-9a-fx]+h?[\s,;:._(-]*byte\s*[0-9]\)?", re.IGNORECASE)
_LETTERED = re.compile(r"[a-z]?([0-9]{1,10})", re.IGNORECASE)
_AREA = re.compile(r"([^\W\d_]{2,}(?:[ _-][^\W\d_]+)*)[ _.:#-]*(?=[0-9])")
_PAIR = re.compile(r"(.+?)\s*[(\[/=|]\s*([^()\[\]]+?)\s*[)\]]?")
_BITS = re.compile(
    r"(.*?[0-9a-f]h?)\s*(?:[.:]\s*(?:b(?:it)?|x)?\s?|\s*,?\s*bits?\s*|\[)([0-9]{1,2})(?:\s*(?:-|~|\.\.|to|:)\s*b?([0-9]{1,2}))?\]?",
    re.IGNORECASE,
)
_IN_BRACKETS = re.compile(r"\[([^\[\]]+)\]")
_BIT_SPAN = re.compile(r"([0-9a-fx]+h?)[.:]([0-9]{1,2})\s*(?:\.\.+|~|-|\bto\b)\s*\1[.:]([0-9]{1,2})", re.IGNORECASE)
"""The first and the last bit of a register, as two addresses: `5.2-5.4`."""

_BITS_BY_WIDTH = re.compile(r"[0-9a-fx]+h?:[0-9]+:[0-9]+", re.IGNORECASE)
"""The address, the first bit and the number of bits."""

_NO_AREA = ("", "r", "x", "h", "add", "adr", "no", "nr", "reg")
"""Letters before digits that are not a name of an area, but marks and words for any address."""


@dataclass(frozen=True, slots=True)
class AddressText:
    """An address: its digits, and how its prefix or suffix says to read them: `hex`, `4xxxx`, or empty.

    `area` is the name of an area of memory before the digits, `space` the address space that it names; both are empty
    if there is none. `X10` may be an area, or a mark: it has both.
    """

    digits: str
    mark: str = ""
    space: str = ""
    area: str = ""

    @property
    def lettered(self) -> bool:
        """Whether digits without a mark include letters, which makes them hexadecimal."""
        return not self.mark and not self.digits.isdecimal()

    @property
    def prefixed(self) -> bool:
        """Whether it may be a decimal number after a letter, as controllers write it: `D100`."""
        return self.lettered and not self.area and _LETTERED.fullmatch(self.digits) is not None

    def behind_area(self) -> AddressText:
        """The decimal number after the letter of an area: `C3` is the coil 3, and `X3` an input of a controller."""
        if self.mark:
            return replace(self, mark="")
        return AddressText(self.digits[1:], "", meaning("spaces", self.digits[0]), self.digits[0])

    def reference(self) -> tuple[str, int] | None:
        """The space and the address of a reference, counted from 0; None if the text is not a reference."""
        if self.mark == REFERENCE:
            return (self.space, int(self.digits) - 1) if int(self.digits) else None
        if self.mark or not self.digits.isdecimal() or len(self.digits) not in (5, 6):
            return None
        number = int(self.digits[1:])
        space = TABLES.get(self.digits[0])
        return (space, number - 1) if space and 0 < number <= 0x10000 else None

    def number(self, base: str) -> int | None:
        """The address. Digits without a mark are read as `base` says; None if they cannot be."""
        if self.mark == HEXADECIMAL or (not self.mark and base == HEXADECIMAL):
            return int(self.digits, 16)
        if self.mark == REFERENCE or base == REFERENCE:
            reference = self.reference()
            return reference[1] if reference else None
        number = _LETTERED.fullmatch(self.digits)
        return int(number[1]) if number else None


@dataclass(frozen=True, slots=True)
class Place:
    """The address in a cell: one, or the first and the last of several, and its bits.

    `other` is a second notation of the first address, `bits` the lowest and the highest bit. `pointless`
    says that `.0` may as well be what a spreadsheet adds to a number, `pointed` that the cell is one with a fraction,
    `bracketed` that the number of the bit is in brackets, as that of elements may be.
    """

    first: AddressText
    last: AddressText | None = None
    bits: tuple[int, int] | None = None
    other: AddressText | None = None
    pointless: bool = False
    pointed: bool = False
    bracketed: bool = False


def address_text(text: str) -> AddressText | None:
    """The address in a text, None without one."""
    text = unicodedata.normalize("NFKC", text).strip().strip("`*'\"").strip()
    pointless = _POINTLESS.fullmatch(text)
    text = pointless[1] if pointless else text
    space = area = ""
    if not _DIGITS.fullmatch(text):
        if marked := _HEX.fullmatch(text):
            return AddressText(marked[1] or marked[2], HEXADECIMAL, "", text[0] if text[0] in "xX" else "")
        if halves := _HALVES.fullmatch(text):
            return AddressText(halves[1] + halves[2], HEXADECIMAL)
        if table := _TABLE.fullmatch(text):
            return AddressText(table[2] or table[4], REFERENCE, TABLES[table[1] or table[3]])
        prefix, words = _NAMED.match(text), _AREA.match(text)
        if prefix and (prefix[1] or "").casefold() not in _NO_AREA:
            area = prefix[1]
        elif not prefix and words and meaning("spaces", words[1]):
            prefix, area = words, words[1]
        space, text = meaning("spaces", area), text[prefix.end() :] if prefix else text
    return AddressText(text, "", space, area) if _DIGITS.fullmatch(text) else None


def place(text: str) -> Place | None:
    """The address in a cell, None without one. Raises CellError, with the reason, for two readings."""
    if bracketed := _IN_BRACKETS.fullmatch(text.strip()):
        return place(bracketed[1])
    whole = address_text(text)
    if whole is not None and not _POINTLESS.fullmatch(text.strip()):
        return Place(whole)
    normalized = unicodedata.normalize("NFKC", text).strip().strip("`*").strip()
    if _GROUPED.fullmatch(normalized) and not _HALVES.fullmatch(normalized):
        raise CellError("is written with thousands separators; remove them")
    if _EXPONENT.fullmatch(normalized):
        raise CellError("has an exponent, or is hexadecimal and a spreadsheet took it for such a number; write a text")
    if (pieces := _BREAK.split(normalized))[1:]:
        return _joined([place(piece) for piece in pieces])
    if (bits := _BITS.fullmatch(normalized)) and (address := address_text(bits[1])):
        low, high = int(bits[2]), int(bits[3] or bits[2])
        if _BITS_BY_WIDTH.fullmatch(normalized):
            high = low + max(high, 1) - 1
        pointless = _POINTLESS.fullmatch(normalized) is not None
        pointed = _POINTED.fullmatch(normalized) is not None
        bits_place = (min(low, high), max(low, high))
        return Place(address, None, bits_place, None, pointless, pointed, normalized.endswith("]"))
    if (half := _HALF.fullmatch(normalized)) and (address := address_text(half[1])):
        return Place(address, bits=(0, 7) if half[half.lastindex or 2][0] in "lL" else (8, 15))
    if _NUMBERED_BYTE.fullmatch(normalized):
        raise CellError("is one of two bytes, and a number does not say which; write `high byte` or `low byte`")
    if (bit_span := _BIT_SPAN.fullmatch(normalized)) and (address := address_text(bit_span[1])):
        return Place(address, bits=(int(bit_span[2]), int(bit_span[3])))
    for separator in (_SPAN, _SEVERAL):
        ends = [address_text(part) for part in separator.split(normalized)]
        addresses = [end for end in ends if end is not None]
        if len(ends) > 1 and len(addresses) == len(ends) and (len(ends) == 2 or separator is _SEVERAL):
            return _span(addresses, separator is _SEVERAL)
    if pair := _PAIR.fullmatch(normalized):
        first, other = address_text(pair[1]), address_text(pair[2])
        if first is not None and other is not None:
            return _span([first, other], True) if _follows(first, other) else Place(first, other=other)
    return None


def whole_notation(texts: Sequence[str]) -> Callable[[str], str]:
    """A function that rewrites the addresses of a list which all of them explain: tables before a colon, `4:101` as
    `4x00101`, bytes of a register, `100L` as `100_L`, and two bytes, `07,08` as `07 08`."""
    texts = [text.strip() for text in texts]
    if all(map(_COLON.fullmatch, texts)) and any(len(text) > _BIT_TEXT for text in texts):
        return lambda text: _COLON.sub(lambda match: f"{match[1]}x{match[2]:0>5}", text.strip())
    if any(map(_LOW_BYTE.fullmatch, texts)) and all(map(_BYTE_LETTER.fullmatch, texts)):
        return lambda text: f"{text.strip()[:-1]}_{text.strip()[-1]}"
    if _are_of_two_bytes(texts):
        return lambda text: text.replace(",", " ")
    return str.strip


def _are_of_two_bytes(texts: Sequence[str]) -> bool:
    """Whether all texts have two bytes, and some of these are not neighbours: each is an address, and not a pair of
    registers."""
    pairs = [pair for text in texts if (pair := _BYTES.fullmatch(text.strip()))]
    ends = [(int(pair[1], 16), int(pair[2], 16)) for pair in pairs]
    return 0 < len(pairs) == len(texts) and any(low != high + 1 for high, low in ends)


def _joined(pieces: Sequence[Place | None]) -> Place | None:
    """The places in the lines of a cell as one."""
    places = [piece for piece in pieces if piece is not None]
    if len(places) < len(pieces):
        return None
    joined = _span([piece.first for piece in places], True)
    return replace(joined, other=places[0].other)


def _span(ends: list[AddressText], is_list: bool) -> Place:
    """The first and the last of several addresses. Raises CellError if enumerated addresses are not neighbours."""
    mark = next((end.mark for end in ends if end.mark), "")
    ends = [replace(end, mark=end.mark or mark) for end in ends]
    first, last = ends[0], ends[-1]
    if not is_list and len(last.digits) < len(first.digits) and int(last.digits, 16) < int(first.digits, 16):
        last = replace(last, digits=first.digits[: -len(last.digits)] + last.digits)  # `40001-2`
    if is_list and not all(_follows(address, following) for address, following in pairwise(ends)):
        raise CellError("has several addresses that are not neighbours; give each a row")
    return Place(first, last)


def _follows(first: AddressText, other: AddressText) -> bool:
    """Whether an address is the one after another, in whatever base."""
    bases = (DECIMAL, HEXADECIMAL)
    pairs = [(first.number(base), other.number(base)) for base in bases]
    return first.mark == other.mark and any(a is not None and b is not None and b - a == 1 for a, b in pairs)


def base_of_heading(heading: str) -> str:
    """The base that a heading names, empty if it names none."""
    normalized = unicodedata.normalize("NFKC", heading).casefold()
    if pattern("hexadecimal").search(normalized):
        return HEXADECIMAL
    return DECIMAL if pattern("decimal").search(normalized) else ""
