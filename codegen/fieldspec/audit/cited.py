"""What the spec says of each line of the manual: the facts that cite it, with their values, and its errata."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Collection, Iterator, Mapping, Sequence
from decimal import Decimal

from fieldspec.audit.pattern import Held
from fieldspec.audit.reduced import reduced
from fieldspec.audit.spelling import byte_pairs, in_order, numbers, readings, words
from fieldspec.classes import dataclass, field
from fieldspec.facts import Row, rows
from fieldspec.layout.device import DeviceLayout
from fieldspec.model.erratum import Erratum
from fieldspec.model.fact import Citation
from fieldspec.reading.building.context import citations
from fieldspec.reading.nodes import Node, Scalar, children
from fieldspec.reading.project import DeviceSpec

_ALSO = {"code": ("code", "number"), "number": ("number", "code")}
_SCALED = ("min", "max", "default")
_VALUES = ("code", "number", "address", "bit", "words", "bytes", "count", "position", "min", "max", "default")
_IN_TEXT = re.compile(r"(?:[0-9A-Za-z.]+ )?L[0-9]{1,6}(?:-[0-9]{1,6})?(?:, [0-9]{1,6}(?:-[0-9]{1,6})?)*")
_INTERVAL = re.compile(r"(-?[0-9]+)(?:\.\.(-?[0-9]+))?")
_INTEGER = re.compile("int")
_BOUNDS = re.compile(r"(?:(?<![0-9A-Fa-f])-)?(?:0[xX][0-9A-Fa-f]+|[0-9][0-9A-Fa-f,]* ?[Hh]|[0-9][0-9,]*(?:\.[0-9]+)?)")
_FIGURES = re.compile(r"[0-9]+")


@dataclass(slots=True)
class OnLine:
    """What cites a line: rows of facts, and errata."""

    facts: list[Row] = field(default_factory=list)
    errata: list[Erratum] = field(default_factory=list)


@dataclass(frozen=True, slots=True)
class Cited:
    """What cites each line, and all lines that are cited, be it in a remark.

    `elided` are the paths of examples of which some bytes are not printed.
    """

    by_line: Mapping[int, OnLine]
    lines: frozenset[int]
    elided: frozenset[str]

    def at(self, line: int) -> OnLine:
        """What cites a line."""
        return self.by_line.get(line) or OnLine()


def cited(spec: DeviceSpec, layouts: Sequence[DeviceLayout]) -> Cited:
    """What cites each line of the manual, in any version."""
    by_line: dict[int, OnLine] = defaultdict(OnLine)
    known: set[str] = set()
    for layout in layouts:
        for row in _completed(rows(layout)):
            key = repr(row)
            if key not in known:
                known.add(key)
                for line in lines_of(citations(str(row["sources"] or ""), "")):
                    by_line[line].facts.append(row)
        for erratum in layout.device.errata:
            if f"erratum {erratum.id}" not in known:
                known.add(f"erratum {erratum.id}")
                for line in lines_of(erratum.sources):
                    by_line[line].errata.append(erratum)
    told = frozenset(line for tree in (spec.tree, *spec.trees.values()) for line in _told(tree))
    elided = frozenset(
        example.place.path for layout in layouts for example in layout.device.examples.values() if example.elided
    )
    return Cited(dict(by_line), told | by_line.keys(), elided)


def _completed(found: Sequence[Row]) -> Iterator[Row]:
    """The rows; where another place states a fact again, any value of the fact may be what is printed there."""
    by_path = {str(row["path"]): row for row in found}
    for row in found:
        path, again, _ = str(row["path"]).rpartition("/restated/")
        fact = by_path.get(path) if again else None
        yield row if fact is None else {key: fact[key] if cell is None else cell for key, cell in row.items()}


def lines_of(sources: Sequence[Citation]) -> Iterator[int]:
    """All lines of some citations."""
    for citation in sources:
        for first, last in citation.lines:
            yield from range(first, last + 1)


def _told(node: Node) -> Iterator[int]:
    """The lines that any text of the spec cites."""
    if isinstance(node, Scalar):
        for found in _IN_TEXT.finditer(node.text) if "L" in node.text else ():
            yield from lines_of(citations(found[0], ""))
        return
    for key, inner in children(node):
        if key != "audit":
            yield from _told(inner)


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
        printed = _INTEGER.sub("i", held.text.lower()).replace("ui", "u")
        return str(row["type"]) in (printed, f"bool{printed[1:]}")
    if held.column == "range":
        return _ranges(row, held)
    if held.column == "value":
        return _in_text(row, held) or any(_counts(row, column, held) for column in _VALUES)
    return any(_counts(row, column, held) for column in _ALSO.get(held.column, (held.column,)))


def _ranges(row: Row, held: Held) -> bool:
    """Whether the printed bounds are those of a fact, in counts or in its unit."""
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
    printed = words(reduced(text))
    if not printed:
        return True
    if row["label"] and " | " in str(row["label"]) and _holds(words(reduced(str(row["label"]))), printed):
        return True  # one of the cells of a look-up table
    names = [words(reduced(str(row[key]))) for key in ("printed_name", "label", "name") if row[key]]
    return printed in names or (len(names) > 1 and printed in (names[0] + names[1], names[1] + names[0]))


def _counts(row: Row, column: str, held: Held) -> bool:
    """Whether a number of a fact is the printed one; bounds and defaults may be printed in the unit."""
    if (
        column == "code"
        and (row["kind"] == "bit" or str(row["type"]).startswith("bool"))
        and set(_means(held)) & {0, 1}
    ):
        return True
    if column in ("min", "max") and _bounds(row, column) & {*_means(held)}:
        return True
    cell = row[column]
    if cell is None:
        return False
    if isinstance(cell, str):
        return cell == held.text or _same_range(cell, held) or _one_of(row, cell, held)
    if not isinstance(cell, int | Decimal):
        return False
    scale = row["scale"]
    known = {Decimal(cell)}
    if column in _SCALED and isinstance(scale, Decimal):
        known.add(cell * scale)
    means = _means(held)
    return bool(known.intersection(means))


def _bounds(row: Row, column: str) -> set[Decimal]:
    """The lower, or the upper, bounds of all intervals of a fact, in counts and in its unit."""
    scale = row["scale"] if isinstance(row["scale"], Decimal) else 1
    found = _INTERVAL.findall(str(row["ranges"]))
    ends = [Decimal(high or low) if column == "max" else Decimal(low) for low, high in found]
    size = row["bytes"]
    if str(row["type"]).startswith("i") and isinstance(size, int):
        ends += [end + (1 << 8 * size) for end in ends if end < 0]  # a negative bound as its bytes show it
    return {*ends, *(end * scale for end in ends)}


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
    """Whether a number stands in a text of a fact, or is one of the bytes of an example."""
    if row["kind"] == "example":
        return any(int(one) in _frame(row) for one in _means(held) if one in range(256))
    texts = (row[key] for key in ("printed_name", "label", "ranges", "name"))
    return any(numbers(reduced(str(text))).values.intersection(_means(held)) for text in texts if text)


def corrects(erratum: Erratum, held: Held) -> bool:
    """Whether an erratum is about what is printed: its print has the number, the word or the bytes."""
    values = [_plain(value) for value in erratum.printed.values()]
    texts = [reduced(text) for text in (erratum.literal, *values) if text]
    if held.column == "frame":
        return any(bytes(byte_pairs(held.text)) in bytes(byte_pairs(text)) for text in texts)
    if held.column in ("name", "type", "access"):
        wanted = words(reduced(held.text))
        return any(_holds(words(text), wanted) for text in texts)
    if held.form in ("range", "span") and any(_same_range(text, held) for text in texts):
        return True
    means = _means(held)
    return any(numbers(text).holds(one) for text in texts for one in means)


def _plain(value: object) -> str:
    return " ".join(map(_plain, value)) if isinstance(value, list | tuple) else str(value)


def _holds(have: Sequence[str], wanted: Sequence[str]) -> bool:
    """Whether some words stand in others, one behind the other."""
    size = len(wanted)
    return any(tuple(have[at : at + size]) == tuple(wanted) for at in range(len(have) - size + 1))
