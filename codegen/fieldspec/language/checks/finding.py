"""How checks report a finding, and which findings a fact allows."""

from __future__ import annotations

import sys
from bisect import bisect_left, bisect_right
from collections.abc import Callable, Collection, Iterator, Sequence
from itertools import accumulate
from typing import TypeAlias

from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.line_text import plural
from fieldspec.foundation.source import Span
from fieldspec.language.checks.facts import allowing
from fieldspec.language.diagnostics import Diagnostic, Label, Severity
from fieldspec.language.model.device import Device
from fieldspec.language.model.digits import digits_text
from fieldspec.language.model.fact import Fact, Place
from fieldspec.language.model.ranges import Ranges, merged, uncovered
from fieldspec.language.model.value import Value

Findings: TypeAlias = Iterator[Diagnostic]
Check: TypeAlias = Callable[[Device], Findings]

_MOST_WORDS = 6
_SEARCHED = 2000


def finding(
    place: Place, key: str, message: str, help: str, *labels: Label, severity: Severity = Severity.ERROR
) -> Diagnostic:
    """A finding of a check at the value of a fact's key. The table of checks adds the name of the check."""
    return finding_of("", place, key, message, help, *labels, severity=severity)


def finding_of(
    code: str, place: Place, key: str, message: str, help: str, *labels: Label, severity: Severity = Severity.ERROR
) -> Diagnostic:
    """A finding of the rule `code` at the value of a fact's key."""
    return Diagnostic(code, message, place[key], labels, help, severity)


def label(place: Place, key: str, text: str) -> Label:
    """The value of another fact's key, and what it has to do with the finding."""
    return Label(place[key], text)


def is_imported(place: Place, device: Device) -> bool:
    """Whether only the file of a protocol states a fact. The device that uses the protocol states what is missing."""
    path = device.place.whole.file.path
    return not place.whole.file.path.startswith(path[: path.rfind("/") + 1])


def hexadecimal(address: int) -> str:
    """`0x2011`"""
    return f"0x{address:04X}" if address >= 0 else str(address)


def addresses(first: int, last: int) -> str:
    """`0x2011`, or `0x2011..0x2014`"""
    return hexadecimal(first) if first == last else f"{hexadecimal(first)}..{hexadecimal(last)}"


def interval(first: object, last: object) -> str:
    """`5`, or `5..8`"""
    return str(first) if first == last else f"{first}..{last}"


def enumeration(words: Collection[object]) -> str:
    """`a, b and c`, or `a, b, c, d, e and 12 more`"""
    texts = [str(word) for word in words]
    if len(texts) > _MOST_WORDS:
        texts = [*texts[: _MOST_WORDS - 1], f"{len(texts) - _MOST_WORDS + 1} more"]
    return texts[0] if len(texts) == 1 else ", ".join(texts[:-1]) + " and " + texts[-1]


def type_text(value: Value) -> str:
    """What holds the numbers of a value: `u8`, `5 bits` or `2 decimal digits`."""
    if value.packed_bits:
        return plural(value.packed_bits, "bit")
    return digits_text(value) if value.digits else value.type.name


def range_key(place: Place) -> str:
    """The key that holds a fact's range: in counts or in the unit."""
    return "unit_range" if "unit_range" in place else "range"


def default_key(place: Place) -> str:
    """The key that holds a fact's default: in counts or in the unit."""
    return "unit_default" if "unit_default" in place else "default"


def outside(ranges: Ranges | None, low: int, high: int) -> bool:
    """Whether any of the intervals leaves `low` to `high`."""
    return ranges is not None and any(a < low or b > high for a, b in ranges.intervals)


def missing(ranges: Ranges, numbers: Collection[int]) -> list[tuple[int, int]]:
    """The parts of the intervals that none of the values lies in, in order."""
    known = merged((value, value) for value in numbers)
    return [hole for low, high in sorted(ranges.intervals) for hole in uncovered(low, high, known)]


def near(word: str, known: Collection[str]) -> str:
    """The help for a word that is not among the known ones."""
    if len(known) > _SEARCHED:
        return "define it, or correct the name"
    from difflib import get_close_matches

    names = sorted(known)
    close = get_close_matches(word, names, 1)
    if close:
        return f"did you mean `{close[0]}`?"
    return f"choose from {enumeration([f'`{name}`' for name in names])}" if names else "define it first"


def longest_ascent(numbers: Sequence[int]) -> frozenset[int]:
    """The indices that are left when as few numbers as possible are taken out so that the rest never falls."""
    tails: list[int] = []
    ends: list[int] = []
    before: list[int] = []
    for index, number in enumerate(numbers):
        length = bisect_left(tails, number + 1)
        before.append(ends[length - 1] if length else -1)
        tails[length : length + 1] = [number]
        ends[length : length + 1] = [index]
    ascent = set()
    index = ends[-1] if ends else -1
    while index >= 0:
        ascent.add(index)
        index = before[index]
    return frozenset(ascent)


@dataclass(frozen=True, slots=True, eq=False)
class Allowance:
    """Permission for a check to fail at a fact and at everything below it."""

    fact: Fact
    check: str

    def spans(self) -> list[Span]:
        """The spans of the fact and of its values, some of which may come from elsewhere."""
        return [self.fact.place.whole, *self.fact.place.spans.values()]


class Coverage:
    """Allowances by the places that they cover. A finding asks for those around its place and around its labels."""

    def __init__(self, all_allowances: Sequence[Allowance]) -> None:
        self._by_file: dict[int, list[tuple[int, int, int]]] = {}
        self._allowances = all_allowances
        for number, allowance in enumerate(all_allowances):
            for span in allowance.spans():
                self._by_file.setdefault(id(span.file), []).append((span.start, span.end, number))
        self._ends: dict[int, list[int]] = {}
        for file, spans in self._by_file.items():
            spans.sort()
            self._ends[file] = list(accumulate((end for _, end, _ in spans), max))

    def of(self, finding: Diagnostic) -> list[Allowance]:
        """The allowances that cover a finding, in their order."""
        spans = [finding.span, *(label.span for label in finding.labels)]
        return [
            self._allowances[number] for number in sorted({number for span in spans for number in self._around(span)})
        ]

    def _around(self, span: Span) -> Iterator[int]:
        """The allowances with a span around one: of those that begin before it, back to where none reaches its end."""
        spans, ends = self._by_file.get(id(span.file), []), self._ends.get(id(span.file), [])
        index = bisect_right(spans, (span.start, sys.maxsize, 0)) - 1
        while index >= 0 and ends[index] >= span.end:
            _, end, number = spans[index]
            if end >= span.end:
                yield number
            index -= 1


def allowances(device: Device, check: str = "") -> Iterator[Allowance]:
    """All allowances of a device, or those for one check."""
    for fact in allowing(device):
        for allowed in fact.allowed:
            if not check or allowed == check:
                yield Allowance(fact, allowed)
