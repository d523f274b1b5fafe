"""Whether a fact, or an erratum, states what the manual prints, however the manual spells it."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from decimal import Decimal
from functools import lru_cache

from fieldspec.audit.line_facts import lines_of
from fieldspec.audit.manual_lines import index_line
from fieldspec.audit.pattern import PieceValue
from fieldspec.classes import dataclass
from fieldspec.facts import FactRow
from fieldspec.model.texts import Erratum
from fieldspec.model.value import intervals
from fieldspec.reading.building.context import citations

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


_ALSO = {"code": ("code", "number"), "number": ("number", "code")}
_SCALED = ("min", "max", "default")
_VALUES = ("code", "number", "address", "bit", "words", "bytes", "count", "position", "min", "max", "default", "scale")
_INTERVAL = re.compile(r"(-?[0-9]+)(?:\.\.(-?[0-9]+))?")
_INTEGER = re.compile("int")
_BOUNDS = re.compile(r"(?:(?<![0-9A-Fa-f])-)?(?:0[xX][0-9A-Fa-f]+|[0-9][0-9A-Fa-f,]* ?[Hh]|[0-9][0-9,]*(?:\.[0-9]+)?)")
_FIGURES = re.compile(r"[0-9]+")


def says(row: FactRow, held: PieceValue, elided: Collection[str]) -> bool:
    """Whether a fact says what is printed. `elided` are the paths of examples of which some bytes are not."""
    if held.column == "frame":
        printed, frame = bytes(byte_pairs(held.text)), _frame(row)
        if printed == frame or (row["path"] in elided and in_order(printed, frame)):
            return True
        broken = len({*lines_of(citations(str(row["sources"] or ""), ""))}) > 1
        return broken and printed in frame
    if held.column == "name":
        return _named(row, held.text)
    if held.column == "access":
        return row["access"] == held.text.lower()
    if held.column == "type":
        kind = _INTEGER.sub("i", held.text.lower()).replace("ui", "u")
        return str(row["type"]) in (kind, f"bool{kind[1:]}")
    if held.column == "range":
        return _ranges(row, held)
    if held.column == "value":
        if row["kind"] == "example":
            return row["path"] in elided and any(int(one) in _frame(row) for one in _means(held) if one in range(256))
        return _in_text(row, held) or any(_counts(row, column, held) for column in _VALUES)
    return any(_counts(row, column, held) for column in _ALSO.get(held.column, (held.column,)))


_index_line = lru_cache(maxsize=16384)(index_line)


@lru_cache(maxsize=16384)
def _words(text: str) -> tuple[str, ...]:
    """The words of a text, as far as an index has them."""
    return words(_index_line(text))


@lru_cache(maxsize=16384)
def _numbers(text: str) -> frozenset[Decimal]:
    """The numbers in a text, as far as an index has them."""
    return numbers(_index_line(text.replace("..", "~"))).values


def _ranges(row: FactRow, held: PieceValue) -> bool:
    """Whether the printed bounds are those of a fact, or of what may be written to it, in counts or in its unit."""
    if isinstance(written := row["write_ranges"], str):
        pairs = intervals(written)
        low, high = min(pair[0] for pair in pairs), max(pair[1] for pair in pairs)
        if _ranges({**row, "write_ranges": None, "min": low, "max": high}, held):
            return True
    bounds = [readings(one, "decimal" if one.isdecimal() else "number") for one in _BOUNDS.findall(held.text)]
    known = (row["min"], row["max"]) if len(bounds) > 1 else (row["min"],)
    low_high = [cell for cell in known if isinstance(cell, int | Decimal)]
    scale = row["scale"] if isinstance(row["scale"], Decimal) else 1
    wanted = [{Decimal(cell), Decimal(cell) * scale} for cell in low_high]
    return len(wanted) == len(bounds) and all(one & {*means} for one, means in zip(wanted, bounds, strict=True))


def _frame(row: FactRow) -> bytes:
    return bytes.fromhex(str(row["printed_name"])) if row["kind"] == "example" else b""


def _named(row: FactRow, text: str) -> bool:
    """Whether a printed text is the name or the label of a fact, as far as an index has it."""
    printed = _words(text)
    if not printed:
        return True
    if row["label"] and " | " in str(row["label"]) and _holds(_words(str(row["label"])), printed):
        return True  # one of the cells of a look-up table
    names = [_words(str(row[key])) for key in ("printed_name", "label") if row[key]]
    return printed in names or (len(names) > 1 and printed in (names[0] + names[1], names[1] + names[0]))


def _counts(row: FactRow, column: str, held: PieceValue) -> bool:
    """Whether a number of a fact is the printed one; bounds and defaults may be printed in the unit."""
    if column == "code" and (row["kind"] == "bit" or str(row["type"]).startswith("bool")):
        if 0 in (means := _means(held)) or 1 in means:
            return True
    elif column in ("min", "max") and row["ranges"] is not None:
        known = tuple([one if isinstance(one, int | Decimal) else None for one in (row["scale"], row["bytes"])])
        ends = _ends(str(row["ranges"]), column, str(row["type"]), *known)
        if not ends.isdisjoint(_means(held)):
            return True
    cell = row[column]
    if cell is None:
        return False
    if isinstance(cell, str):
        return cell == held.text or _same_range(cell, held) or _is_among(row, cell, held)
    if not isinstance(cell, int | Decimal):
        return False
    scale = row["scale"]
    means = _means(held)
    return cell in means or (column in _SCALED and isinstance(scale, Decimal) and cell * scale in means)


@lru_cache(maxsize=16384)
def _ends(
    ranges: str, column: str, kind: str, scale: int | Decimal | None, size: int | Decimal | None
) -> frozenset[Decimal]:
    """The lower, or the upper, bounds of all intervals of a fact, in counts and in its unit."""
    found = _INTERVAL.findall(ranges)
    ends = [Decimal(high or low) if column == "max" else Decimal(low) for low, high in found]
    if kind.startswith("i") and isinstance(size, int):
        ends += [end + (1 << 8 * size) for end in ends if end < 0]  # a negative bound as its bytes show it
    return frozenset((*ends, *(end * scale for end in ends if isinstance(scale, Decimal))))


@lru_cache(maxsize=16384)
def _means(held: PieceValue) -> tuple[Decimal, ...]:
    if held.form == "mask":
        return tuple(
            Decimal(int(one).bit_length() - 1) for one in readings(held.text, "hex") if int(one).bit_count() == 1
        )
    return readings(held.text, "decimal" if held.form in ("range", "span") else held.form)


def _same_range(cell: str, held: PieceValue) -> bool:
    """Whether two texts of numbers, such as `4..5` and `4 ~ 5`, have the same bounds."""
    return [int(one) for one in _FIGURES.findall(cell)] == [int(one) for one in _FIGURES.findall(held.text)]


def _is_among(row: FactRow, cell: str, held: PieceValue) -> bool:
    """Whether a printed number is one of those of a cell such as `4..6`: a table may print them one a line."""
    if len({*lines_of(citations(str(row["sources"] or ""), ""))}) < 2:
        return False
    bounds = [int(one) for one in _FIGURES.findall(cell)]
    return len(bounds) == 2 and held.text.isdecimal() and bounds[0] <= int(held.text) <= bounds[1]


def _in_text(row: FactRow, held: PieceValue) -> bool:
    """Whether a number stands in a text of a fact."""
    means = _means(held)
    for key in ("printed_name", "label", "ranges", "name"):
        text = row[key]
        if text and not _numbers(str(text)).isdisjoint(means):
            return True
    return False


def corrects(erratum: Erratum, held: PieceValue) -> bool:
    """Whether an erratum is about what is printed: its print has the number, the word or the bytes."""
    values = [_comparable_text(value) for value in erratum.printed.values()]
    texts = [_index_line(text.replace("..", "~")) for text in (erratum.literal, *values) if text]
    if held.column == "frame":
        return any(bytes(byte_pairs(held.text)) in bytes(byte_pairs(text)) for text in texts)
    if held.column in ("name", "type", "access"):
        wanted = _words(held.text)
        return any(_holds(words(text), wanted) for text in texts)
    if held.form in ("range", "span") and any(_same_range(text, held) for text in texts):
        return True
    means = _means(held)
    return any(one in numbers(text).values for text in texts for one in means)


def _comparable_text(value: object) -> str:
    return " ".join(map(_comparable_text, value)) if isinstance(value, list | tuple) else str(value)


def _holds(have: Sequence[str], wanted: Sequence[str]) -> bool:
    """Whether some words stand in others, one behind the other."""
    size = len(wanted)
    return any(tuple(have[at : at + size]) == tuple(wanted) for at in range(len(have) - size + 1))
