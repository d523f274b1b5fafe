"""Whether a fact, or an erratum, says what is printed, in whatever spelling."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence
from decimal import Decimal
from functools import lru_cache

from fieldspec.audit.cited import lines_of
from fieldspec.audit.pattern import Held
from fieldspec.audit.reduced import reduced
from fieldspec.audit.spelling import byte_pairs, in_order, numbers, readings, words
from fieldspec.facts import Row
from fieldspec.model.erratum import Erratum
from fieldspec.model.ranges import intervals
from fieldspec.reading.building.context import citations

_ALSO = {"code": ("code", "number"), "number": ("number", "code")}
_SCALED = ("min", "max", "default")
_VALUES = ("code", "number", "address", "bit", "words", "bytes", "count", "position", "min", "max", "default", "scale")
_INTERVAL = re.compile(r"(-?[0-9]+)(?:\.\.(-?[0-9]+))?")
_INTEGER = re.compile("int")
_BOUNDS = re.compile(r"(?:(?<![0-9A-Fa-f])-)?(?:0[xX][0-9A-Fa-f]+|[0-9][0-9A-Fa-f,]* ?[Hh]|[0-9][0-9,]*(?:\.[0-9]+)?)")
_FIGURES = re.compile(r"[0-9]+")


def says(row: Row, held: Held, elided: Collection[str]) -> bool:
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


_reduced = lru_cache(maxsize=16384)(reduced)


@lru_cache(maxsize=16384)
def _words(text: str) -> tuple[str, ...]:
    """The words of a text, as far as an index has them."""
    return words(_reduced(text))


@lru_cache(maxsize=16384)
def _numbers(text: str) -> frozenset[Decimal]:
    """The numbers in a text, as far as an index has them."""
    return numbers(_reduced(text.replace("..", "~"))).values


def _ranges(row: Row, held: Held) -> bool:
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


def _frame(row: Row) -> bytes:
    return bytes.fromhex(str(row["printed_name"])) if row["kind"] == "example" else b""


def _named(row: Row, text: str) -> bool:
    """Whether a printed text is the name or the label of a fact, as far as an index has it."""
    printed = _words(text)
    if not printed:
        return True
    if row["label"] and " | " in str(row["label"]) and _holds(_words(str(row["label"])), printed):
        return True  # one of the cells of a look-up table
    names = [_words(str(row[key])) for key in ("printed_name", "label") if row[key]]
    return printed in names or (len(names) > 1 and printed in (names[0] + names[1], names[1] + names[0]))


def _counts(row: Row, column: str, held: Held) -> bool:
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
        return cell == held.text or _same_range(cell, held) or _one_of(row, cell, held)
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
def _means(held: Held) -> tuple[Decimal, ...]:
    if held.form == "mask":
        return tuple(
            Decimal(int(one).bit_length() - 1) for one in readings(held.text, "hex") if int(one).bit_count() == 1
        )
    return readings(held.text, "decimal" if held.form in ("range", "span") else held.form)


def _same_range(cell: str, held: Held) -> bool:
    """Whether two texts of numbers, such as `4..5` and `4 ~ 5`, have the same bounds."""
    return [int(one) for one in _FIGURES.findall(cell)] == [int(one) for one in _FIGURES.findall(held.text)]


def _one_of(row: Row, cell: str, held: Held) -> bool:
    """Whether a printed number is one of those of a cell such as `4..6`: a table may print them one a line."""
    if len({*lines_of(citations(str(row["sources"] or ""), ""))}) < 2:
        return False
    bounds = [int(one) for one in _FIGURES.findall(cell)]
    return len(bounds) == 2 and held.text.isdecimal() and bounds[0] <= int(held.text) <= bounds[1]


def _in_text(row: Row, held: Held) -> bool:
    """Whether a number stands in a text of a fact."""
    means = _means(held)
    for key in ("printed_name", "label", "ranges", "name"):
        text = row[key]
        if text and not _numbers(str(text)).isdisjoint(means):
            return True
    return False


def corrects(erratum: Erratum, held: Held) -> bool:
    """Whether an erratum is about what is printed: its print has the number, the word or the bytes."""
    values = [_plain(value) for value in erratum.printed.values()]
    texts = [_reduced(text.replace("..", "~")) for text in (erratum.literal, *values) if text]
    if held.column == "frame":
        return any(bytes(byte_pairs(held.text)) in bytes(byte_pairs(text)) for text in texts)
    if held.column in ("name", "type", "access"):
        wanted = _words(held.text)
        return any(_holds(words(text), wanted) for text in texts)
    if held.form in ("range", "span") and any(_same_range(text, held) for text in texts):
        return True
    means = _means(held)
    return any(one in numbers(text).values for text in texts for one in means)


def _plain(value: object) -> str:
    return " ".join(map(_plain, value)) if isinstance(value, list | tuple) else str(value)


def _holds(have: Sequence[str], wanted: Sequence[str]) -> bool:
    """Whether some words stand in others, one behind the other."""
    size = len(wanted)
    return any(tuple(have[at : at + size]) == tuple(wanted) for at in range(len(have) - size + 1))
