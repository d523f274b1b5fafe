"""Whether a fact, or an erratum, states what the manual prints, however the manual spells it."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from decimal import Decimal
from functools import lru_cache

from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.ranges import intervals
from fieldspec.language.model.texts import Erratum
from fieldspec.language.reading.building.citations import citations
from fieldspec.tools.audit.line_facts import lines_of
from fieldspec.tools.audit.manual_lines import index_line
from fieldspec.tools.audit.pattern import PieceValue
from fieldspec.tools.facts import FactRow

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
    """The numbers of a line in all their readings, and intervals from one number to another.

    `characters` are runs of single hexadecimal digits, as a row of a table of characters prints them.
    """

    values: frozenset[Decimal]
    intervals: tuple[tuple[Decimal, Decimal], ...]
    characters: tuple[str, ...]

    def holds(self, number: int | Decimal) -> bool:
        """Whether the line has a number: as such, within an interval, or digit by digit."""
        if number in self.values or any(low <= number <= high for low, high in self.intervals):
            return True
        if number < 0 or number != int(number):
            return False
        digits = f"{int(number):X}"
        return any(digits.zfill(len(digits) + len(digits) % 2) in characters for characters in self.characters)


@lru_cache(maxsize=16384)
def readings(text: str, form: str = "") -> tuple[Decimal, ...]:
    """The numbers that a text may mean: `10h` and `0x10` are sixteen, `1,000` is a thousand.

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
    values: list[Decimal] = []
    hexadecimal = form.startswith("hex")
    if not hexadecimal and re.fullmatch(r"[0-9]{1,3}(?:,[0-9]{3})+|[0-9]{1,20}(?:\.[0-9]{1,10})?", bare):
        values.append(sign * Decimal(bare.replace(",", "")))
    if (hexadecimal or not form) and re.fullmatch(r"[0-9A-Fa-f]{1,16}", bare):
        values.append(sign * Decimal(int(bare, 16)))
    return tuple(values)


@lru_cache(maxsize=16384)
def numbers(line: str) -> Numbers:
    """All numbers of an index line in all their readings."""
    values: set[Decimal] = set()
    intervals: list[tuple[Decimal, Decimal]] = []
    before: tuple[int, tuple[Decimal, ...]] | None = None
    for match in _NUMBER.finditer(line):
        text = match[0]
        negative = match.start() and line[match.start() - 1] == "-"
        means = readings(text)
        values.update(means)
        if negative:
            values.update(-number for number in means)
        if before is not None and (between := _TO.fullmatch(line, before[0], match.start())):
            ends = tuple(-number for number in means) if "-" in (between[1] or "") else means
            intervals += ((low, high) for low, high in zip(before[1], ends, strict=False) if low < high)
        before = match.end(), tuple(-number for number in means) if negative else means
    single = tuple(re.sub(r"[^0-9A-F]", "", match[0]) for match in _SINGLE.finditer(line))
    return Numbers(frozenset(values), tuple(intervals), single)


def number_places(line: str) -> Iterator[tuple[int, int]]:
    """The start and end of each number in an index line."""
    for match in _NUMBER.finditer(line):
        yield match.span()


def words(text: str) -> tuple[str, ...]:
    """The words of a text for comparisons: in lower case, without the characters between them."""
    return tuple(word.lower() for word in _WORD.findall(text))


def has_word(line: str, word: str) -> bool:
    """Whether an index line has a word, also within a series: `IN1 ~ IN14` has `IN5` and `IN`."""
    line_words = words(line)
    if word in line_words:
        return True
    if word.isdecimal():
        return numbers(line).holds(int(word))
    if any(other.startswith(word) and other[len(word) :].isdecimal() for other in line_words):
        return True
    stem = word.rstrip("0123456789")
    if stem in ("", word) or not any(sign in line for sign in ("~", "...")):
        return False
    ends = [
        int(other[len(stem) :]) for other in line_words if other.startswith(stem) and other[len(stem) :].isdecimal()
    ]
    return bool(ends) and min(ends) < int(word[len(stem) :]) < max(ends)


def in_order(part: bytes, frame: bytes) -> bool:
    """Whether a frame has all bytes of a part in the same order, with any bytes between them."""
    left = iter(frame)
    return all(byte in left for byte in part)


def byte_pairs(line: str) -> Iterator[int]:
    """The bytes of a frame: `01 | 06`, `04H+00H`, `0x3A`."""
    for match in _BYTES.finditer(line):
        yield int(match[1], 16)


_ALSO = {"code": ("code", "number"), "number": ("number", "code"), "default": ("default", "const")}
_SCALED = ("min", "max", "default", "const")
_VALUES = ("code", "number", "address", "bit", "words", "bytes", "count", "position", *_SCALED, "scale")
_INTERVAL = re.compile(r"(-?[0-9]+)(?:\.\.(-?[0-9]+))?")
_INTEGER = re.compile("int")
_BOUNDS = re.compile(r"(?:(?<![0-9A-Fa-f])-)?(?:0[xX][0-9A-Fa-f]+|[0-9][0-9A-Fa-f,]* ?[Hh]|[0-9][0-9,]*(?:\.[0-9]+)?)")
_FIGURES = re.compile(r"[0-9]+")


def has_printed_value(row: FactRow, value: PieceValue, elided: Collection[str]) -> bool:
    """Whether a fact has a printed value. `elided` are the paths of examples that the manual prints with gaps."""
    if value.column == "frame":
        printed, frame = bytes(byte_pairs(value.text)), _frame(row)
        if printed == frame or (row["path"] in elided and in_order(printed, frame)):
            return True
        broken = len({*lines_of(citations(str(row["sources"] or ""), ""))}) > 1
        return broken and printed in frame
    if value.column == "name":
        return _named(row, value.text)
    if value.column == "access":
        return row["access"] == value.text.lower()
    if value.column == "type":
        kind = _INTEGER.sub("i", value.text.lower()).replace("ui", "u")
        return str(row["type"]) in (kind, f"bool{kind[1:]}")
    if value.column == "range":
        return _ranges(row, value)
    if value.column == "value":
        if row["kind"] == "example":
            return row["path"] in elided and any(
                int(number) in _frame(row) for number in _means(value) if number in range(256)
            )
        return _in_text(row, value) or any(_counts(row, column, value) for column in _VALUES)
    return any(_counts(row, column, value) for column in _ALSO.get(value.column, (value.column,)))


_index_line = lru_cache(maxsize=16384)(index_line)


@lru_cache(maxsize=16384)
def _words(text: str) -> tuple[str, ...]:
    """The words of a text as an index has them."""
    return words(_index_line(text))


@lru_cache(maxsize=16384)
def _numbers(text: str) -> frozenset[Decimal]:
    """The numbers of a text as an index has them."""
    return numbers(_index_line(text.replace("..", "~"))).values


def _ranges(row: FactRow, value: PieceValue) -> bool:
    """Whether printed bounds equal the bounds of a fact, or of values written to it: as raw values or as quantities."""
    if isinstance(write_ranges := row["write_ranges"], str):
        pairs = intervals(write_ranges)
        low, high = min(pair[0] for pair in pairs), max(pair[1] for pair in pairs)
        if _ranges({**row, "write_ranges": None, "min": low, "max": high}, value):
            return True
    bounds = [readings(bound, "decimal" if bound.isdecimal() else "number") for bound in _BOUNDS.findall(value.text)]
    known = (row["min"], row["max"]) if len(bounds) > 1 else (row["min"],)
    low_high = [cell for cell in known if isinstance(cell, int | Decimal)]
    scale = row["scale"] if isinstance(row["scale"], Decimal) else 1
    fact_bounds = [{Decimal(cell), Decimal(cell) * scale} for cell in low_high]
    return len(fact_bounds) == len(bounds) and all(
        alternatives & {*means} for alternatives, means in zip(fact_bounds, bounds, strict=True)
    )


def _frame(row: FactRow) -> bytes:
    return bytes.fromhex(str(row["printed_name"])) if row["kind"] == "example" else b""


def _named(row: FactRow, text: str) -> bool:
    """Whether a printed text is the name or the label of a fact, as an index has it."""
    printed = _words(text)
    if not printed:
        return True
    if row["label"] and " | " in str(row["label"]) and _holds(_words(str(row["label"])), printed):
        return True  # one of the cells of a look-up table
    names = [_words(str(row[key])) for key in ("printed_name", "label") if row[key]]
    return printed in names or (len(names) > 1 and printed in (names[0] + names[1], names[1] + names[0]))


def _counts(row: FactRow, column: str, value: PieceValue) -> bool:
    """Whether a number of a fact is the printed one; bounds and defaults may be printed as quantities."""
    if column == "code" and (row["kind"] == "bit" or str(row["type"]).startswith("bool")):
        if 0 in (means := _means(value)) or 1 in means:
            return True
    elif column in ("min", "max") and row["ranges"] is not None:
        known = tuple(
            [number if isinstance(number, int | Decimal) else None for number in (row["scale"], row["bytes"])]
        )
        ends = _ends(str(row["ranges"]), column, str(row["type"]), *known)
        if not ends.isdisjoint(_means(value)):
            return True
    cell = row[column]
    if cell is None:
        return False
    if isinstance(cell, str):
        return cell == value.text or _same_range(cell, value) or _is_among(row, cell, value)
    if not isinstance(cell, int | Decimal):
        return False
    scale = row["scale"]
    means = _means(value)
    return cell in means or (column in _SCALED and isinstance(scale, Decimal) and cell * scale in means)


@lru_cache(maxsize=16384)
def _ends(
    ranges: str, column: str, kind: str, scale: int | Decimal | None, size: int | Decimal | None
) -> frozenset[Decimal]:
    """The lower or the upper bounds of all intervals of a fact, as raw values and as quantities."""
    bounds = _INTERVAL.findall(ranges)
    ends = [Decimal(high or low) if column == "max" else Decimal(low) for low, high in bounds]
    if kind.startswith("i") and isinstance(size, int):
        ends += [end + (1 << 8 * size) for end in ends if end < 0]  # a negative bound as its bytes show it
    return frozenset((*ends, *(end * scale for end in ends if isinstance(scale, Decimal))))


@lru_cache(maxsize=16384)
def _means(value: PieceValue) -> tuple[Decimal, ...]:
    if value.form == "mask":
        return tuple(
            Decimal(int(number).bit_length() - 1)
            for number in readings(value.text, "hex")
            if int(number).bit_count() == 1
        )
    return readings(value.text, "decimal" if value.form in ("range", "span") else value.form)


def _same_range(cell: str, value: PieceValue) -> bool:
    """Whether two texts of numbers, such as `4..5` and `4 ~ 5`, have the same bounds."""
    return [int(digits) for digits in _FIGURES.findall(cell)] == [
        int(digits) for digits in _FIGURES.findall(value.text)
    ]


def _is_among(row: FactRow, cell: str, value: PieceValue) -> bool:
    """Whether a printed number is in a cell such as `4..6`: a table may print each number on a line of its own."""
    if len({*lines_of(citations(str(row["sources"] or ""), ""))}) < 2:
        return False
    bounds = [int(digits) for digits in _FIGURES.findall(cell)]
    return len(bounds) == 2 and value.text.isdecimal() and bounds[0] <= int(value.text) <= bounds[1]


def _in_text(row: FactRow, value: PieceValue) -> bool:
    """Whether a text of a fact contains a number."""
    means = _means(value)
    for key in ("printed_name", "label", "ranges", "name"):
        text = row[key]
        if text and not _numbers(str(text)).isdisjoint(means):
            return True
    return False


def corrects(erratum: Erratum, value: PieceValue) -> bool:
    """Whether an erratum corrects a printed value: its print has the number, the word or the bytes."""
    printed = [_comparable_text(cell) for cell in erratum.printed.values()]
    texts = [_index_line(text.replace("..", "~")) for text in (erratum.literal, *printed) if text]
    if value.column == "frame":
        return any(bytes(byte_pairs(value.text)) in bytes(byte_pairs(text)) for text in texts)
    if value.column in ("name", "type", "access"):
        value_words = _words(value.text)
        return any(_holds(words(text), value_words) for text in texts)
    if value.form in ("range", "span") and any(_same_range(text, value) for text in texts):
        return True
    means = _means(value)
    return any(number in numbers(text).values for text in texts for number in means)


def _comparable_text(value: object) -> str:
    return " ".join(map(_comparable_text, value)) if isinstance(value, list | tuple) else str(value)


def _holds(words: Sequence[str], part: Sequence[str]) -> bool:
    """Whether a list of words contains another list."""
    size = len(part)
    return any(tuple(words[start : start + size]) == tuple(part) for start in range(len(words) - size + 1))
