"""Numbers, intervals, words and bytes as manuals spell them, read from reduced lines."""

from __future__ import annotations

import re
from collections.abc import Iterator
from decimal import Decimal
from functools import lru_cache

from fieldspec.classes import dataclass

_HEX = r"0[xX][0-9A-Fa-f]{1,16}|&H[0-9A-Fa-f]{1,16}|[0-9A-Fa-f]{1,16} ?[Hh](?![A-Za-z0-9])"
_DECIMAL = r"[0-9]{1,3}(?:,[0-9]{3})+(?![0-9])|[0-9]{1,20}(?:\.[0-9]{1,10})?"
_POWER = r"2 ?\^ ?\{?[0-9]{1,2}\}?(?: ?- ?1(?![0-9]))?"
_BARE = r"(?=[A-Fa-f]*[0-9])[0-9A-Fa-f]{1,16}(?![A-Za-z])"
_NUMBER = re.compile(
    rf"(?<![A-Za-z0-9.])(?:{_POWER}|{_HEX}|{_DECIMAL}|{_BARE})(?![0-9])"
    r"|(?<=[A-Za-z_])[0-9][0-9A-Fa-f]{0,5}\b|(?<=[A-Za-z_])[0-9]{1,6}(?![0-9])|(?<=[A-Za-z]\.)[0-9A-Fa-f]{1,6}\b|(?<=[A-Za-z][0-9]\.)[0-9]{1,2}\b"
)
_SINGLE = re.compile(r"(?<![^|\" ~])([0-9A-F])(?:[|\" ~]+(?:\.[|\" ~]+)?([0-9A-F])(?![^|\" ~]))+")
_TO = re.compile(r"\s*(?:~|-|\.\.+|to)\s*([+(-]*)[A-Za-z_]*|[^0-9|]{0,40}(?:~|\.\.\.)[^0-9|]{0,40}()")
_WORD = re.compile(r"[A-Za-z0-9]+")
_BYTES = re.compile(r"(?<![0-9A-Za-z])(?:0x)?([0-9A-Fa-f]{2})[Hh]?(?![0-9A-Za-z])")


@dataclass(frozen=True, slots=True)
class Numbers:
    """What a line can be read to say: numbers, and intervals from one number to another.

    `characters` are hexadecimal digits that stand one by one, as in a row of characters.
    """

    values: frozenset[Decimal]
    intervals: tuple[tuple[Decimal, Decimal], ...]
    characters: tuple[str, ...]

    def holds(self, number: int | Decimal) -> bool:
        """Whether the number stands in the line, as such, within an interval, or digit by digit."""
        if number in self.values or any(low <= number <= high for low, high in self.intervals):
            return True
        if number < 0 or number != int(number):
            return False
        digits = f"{int(number):X}"
        return any(digits.zfill(len(digits) + len(digits) % 2) in characters for characters in self.characters)


@lru_cache(maxsize=16384)
def readings(text: str, form: str = "") -> tuple[Decimal, ...]:
    """The numbers that a spelling may mean: `10h` and `0x10` are sixteen, `1,000` is a thousand.

    `10` is ten or sixteen, unless the form of a pattern says that it is decimal or hexadecimal.
    """
    bare = text.replace(" ", "")
    sign = -1 if bare.startswith("-") else 1
    bare = bare.lstrip("+-")
    power = re.fullmatch(r"2\^\{?([0-9]{1,2})\}?(-1)?", bare)
    if power:
        return (sign * (Decimal(2) ** int(power[1]) - (1 if power[2] else 0)),)
    marked = re.fullmatch(r"(?:0[xX]|&H)([0-9A-Fa-f]{1,16})|([0-9A-Fa-f]{1,16})[Hh]", bare)
    if marked:
        return (sign * Decimal(int(marked[1] or marked[2], 16)),)
    found: list[Decimal] = []
    hexadecimal = form.startswith("hex")
    if not hexadecimal and re.fullmatch(r"[0-9]{1,3}(?:,[0-9]{3})+|[0-9]{1,20}(?:\.[0-9]{1,10})?", bare):
        found.append(sign * Decimal(bare.replace(",", "")))
    if (hexadecimal or not form) and re.fullmatch(r"[0-9A-Fa-f]{1,16}", bare):
        found.append(sign * Decimal(int(bare, 16)))
    return tuple(found)


@lru_cache(maxsize=16384)
def numbers(line: str) -> Numbers:
    """All numbers of a reduced line in all their readings."""
    values: set[Decimal] = set()
    intervals: list[tuple[Decimal, Decimal]] = []
    before: tuple[int, tuple[Decimal, ...]] | None = None
    for found in _NUMBER.finditer(line):
        text = found[0]
        negative = found.start() and line[found.start() - 1] == "-"
        means = readings(text)
        values.update(means)
        if negative:
            values.update(-one for one in means)
        if before is not None and (between := _TO.fullmatch(line, before[0], found.start())):
            ends = tuple(-one for one in means) if "-" in (between[1] or "") else means
            intervals += ((low, high) for low, high in zip(before[1], ends, strict=False) if low < high)
        before = found.end(), tuple(-one for one in means) if negative else means
    single = tuple(re.sub(r"[^0-9A-F]", "", found[0]) for found in _SINGLE.finditer(line))
    return Numbers(frozenset(values), tuple(intervals), single)


def figures(line: str) -> Iterator[tuple[int, int]]:
    """Where the numbers of a reduced line stand."""
    for found in _NUMBER.finditer(line):
        yield found.span()


def words(text: str) -> tuple[str, ...]:
    """The words of a text as they are compared: in lower case, without what stands between them."""
    return tuple(word.lower() for word in _WORD.findall(text))


def hold(line: str, word: str) -> bool:
    """Whether a word stands in a reduced line, or in a series of such words: `IN5`, or `IN`, in `IN1 ~ IN14`."""
    have = words(line)
    if word in have:
        return True
    if word.isdecimal():
        return numbers(line).holds(int(word))
    if any(other.startswith(word) and other[len(word) :].isdecimal() for other in have):
        return True
    stem = word.rstrip("0123456789")
    if stem in ("", word) or not any(sign in line for sign in ("~", "...")):
        return False
    ends = [int(other[len(stem) :]) for other in have if other.startswith(stem) and other[len(stem) :].isdecimal()]
    return bool(ends) and min(ends) < int(word[len(stem) :]) < max(ends)


def in_order(part: bytes, frame: bytes) -> bool:
    """Whether some bytes are those of a frame in their order, with others between them."""
    left = iter(frame)
    return all(byte in left for byte in part)


def byte_pairs(line: str) -> Iterator[int]:
    """The bytes of a frame: `01 | 06`, `04H+00H`, `0x3A`."""
    for found in _BYTES.finditer(line):
        yield int(found[1], 16)
