"""Everything in a manual that looks like a fact, and what the spec has of it."""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Iterator, Sequence
from typing import TypeVar

from fieldspec.audit.agreement import corrects, figures, readings, says
from fieldspec.audit.line_facts import Cited, OnLine
from fieldspec.audit.manual_lines import Aligned
from fieldspec.audit.pattern import Match, PieceValue
from fieldspec.audit.plan import LeftOut, Pattern, Plan
from fieldspec.classes import dataclass

COVERED, CORRECTED, LEFT_OUT, OPEN = "covered", "corrected", "left out", "not accounted for"
STATUSES = (COVERED, CORRECTED, LEFT_OUT, OPEN)
Placed = TypeVar("Placed", Pattern, LeftOut)

LONGEST_SERIES = 4096
_DIGIT = re.compile("[0-9]")
LINE = "line"
"""The kind of a line that has a number, and of which no pattern says what it is."""


@dataclass(frozen=True, slots=True)
class Candidate:
    """Something that looks like a fact: the line of the text at hand, the cited line, and how it stands.

    `missing` are the values that no fact and no erratum has; there are none for a line with a number. `out` is what
    leaves it out.
    """

    kind: str
    line: int
    cited: int
    section: str
    start: int
    end: int
    status: str
    missing: tuple[PieceValue, ...] = ()
    pattern: Pattern | None = None
    out: LeftOut | None = None


@dataclass(frozen=True, slots=True)
class Accounts:
    """All candidates, the patterns that have found none, and what is left out without being there.

    `needed` are the paths of the facts without which something would not be accounted for. `beside` are the numbers of
    lines that patterns know which no pattern finds, and no fact has that cites the line: line, start and end.
    """

    candidates: Sequence[Candidate]
    unused: Sequence[Pattern | LeftOut]
    needed: frozenset[str]
    beside: Sequence[tuple[int, int, int]]


def accounts(manual: Aligned, plan: Plan, cited: Cited) -> Accounts:
    """Looks through the manual line by line: its patterns first, then whatever else has a number."""
    made: list[Candidate] = []
    used: set[int] = set()
    needed: set[str] = set()
    beside: list[tuple[int, int, int]] = []
    patterns = _by_line(plan.patterns)
    left_out = _by_line((*plan.left_out, plan.headings))
    of_changed = _by_line((*(one for one in plan.left_out if not one.exact), plan.headings) if manual.changed else ())
    of_new = _by_line(plan.left_out if manual.new else ())
    for number, text in enumerate(manual.index.lines, 1):
        if not text:
            continue
        at = manual.known[number - 1]
        section = plan.section(at)
        if number in manual.new:
            outs = [one for one in of_new.get(at, ()) if one in of_new.get(at + 1, ())]
        else:
            outs = (of_changed if at in manual.changed else left_out).get(at, [])
        out = _left_out(outs, text)
        before = len(made)
        told = OnLine() if number in manual.new else cited.at(at)
        pieces = list(_pieces(patterns.get(at, ()), text))
        used.update(id(pattern) for pattern, _ in pieces)
        for (pattern, found), (status, missing) in zip(pieces, _standings(pieces, told, cited, needed), strict=True):
            if status == OPEN and out is not None and not (told.facts and "sections" in out.place):
                status, missing = LEFT_OUT, ()
            place = number, at, section, found.start, found.end
            made.append(Candidate(pattern.kind, *place, status, missing, pattern, out if status == LEFT_OUT else None))
        if pieces:
            beside += ((number, *place) for place in _beside(text, pieces, told, cited))
        elif _DIGIT.search(text):
            known = number not in manual.new and at not in manual.changed and at in cited.lines
            status = COVERED if known else LEFT_OUT if out is not None else OPEN
            kept = out if status == LEFT_OUT else None
            made.append(Candidate(LINE, number, at, section, 0, len(text), status, out=kept))
        used.update(id(one.out) for one in made[before:])
    declared: list[Pattern | LeftOut] = [*plan.patterns, *plan.left_out]
    return Accounts(made, [one for one in declared if id(one) not in used], frozenset(needed), beside)


def _by_line(held: Sequence[Placed]) -> dict[int, list[Placed]]:
    """What is about each line, in its order."""
    made: dict[int, list[Placed]] = defaultdict(list)
    for one in held:
        for first, last in one.lines:
            for line in range(first, last + 1):
                made[line].append(one)
    return made


def _left_out(outs: Sequence[LeftOut], text: str) -> LeftOut | None:
    """What leaves a line out."""
    return next((out for out in outs if out.template is None or out.template.whole(text) is not None), None)


def _pieces(patterns: Sequence[Pattern], text: str) -> Iterator[tuple[Pattern, Match]]:
    """The pieces of a line that patterns find."""
    for pattern in patterns:
        if pattern.row is not None:
            found = pattern.row.find(text)
            if found is not None:
                yield pattern, _whole(pattern, found)
        elif pattern.each is not None:
            for one in pattern.each.each(text):
                yield pattern, _whole(pattern, one)


def _beside(
    text: str, pieces: Sequence[tuple[Pattern, Match]], told: OnLine, cited: Cited
) -> Iterator[tuple[int, int]]:
    """The numbers of a line that are no part of what patterns find, and that nothing says which cites the line."""
    texts = {held.text for _, found in pieces for held in found.values}
    for start, end in figures(text):
        held = PieceValue("value", "", text[start:end])
        if any(held.text in other for other in texts):
            continue
        if any(corrects(erratum, held) for erratum in told.errata):
            continue
        if not any(says(row, held, cited.elided) for row in told.facts):
            yield start, end


def _owners(paths: set[str]) -> set[str]:
    """Facts without those that are parts of others: a message and its fields have one code."""
    return {path for path in paths if not any(path.startswith(f"{other}/") for other in paths)}


def _whole(pattern: Pattern, found: Match) -> Match:
    """A piece; of a series, with all numbers from the first to the last in place of those two."""
    if not pattern.series or len(found.values) != 2:
        return found
    low, high = (readings(held.text, held.form)[:1] for held in found.values)
    if not low or not high or not 0 <= high[0] - low[0] <= LONGEST_SERIES:
        return found
    column = found.values[0].column
    numbers = range(int(low[0]), int(high[0]) + 1)
    return Match(tuple(PieceValue(column, "decimal", str(number)) for number in numbers), found.start, found.end)


def _standings(
    pieces: Sequence[tuple[Pattern, Match]], told: OnLine, cited: Cited, needed: set[str]
) -> Iterator[tuple[str, tuple[PieceValue, ...]]]:
    """How the pieces of a line stand: each value must be one of a fact, or of an erratum, that cites the line.

    What a pattern finds in several pieces of the line must be said by as many facts. Paths of facts go to `needed`.
    """
    times = Counter((pattern.name, held) for pattern, found in pieces for held in {*found.values})
    seen: Counter[tuple[str, PieceValue]] = Counter()
    for pattern, found in pieces:
        corrected, missing = False, []
        for held in dict.fromkeys(found.values):
            key = pattern.name, held
            seen[key] += 1
            paths = _owners({str(row["path"]) for row in told.facts if says(row, held, cited.elided)})
            put_right = any(corrects(erratum, held) for erratum in told.errata)
            if len(paths) == times[key] and not put_right:
                needed.update(path.partition("/restated/")[0] for path in paths)
            if len(paths) < seen[key]:
                corrected = corrected or put_right
                missing += [] if put_right else [held]
        if found.values:
            yield (OPEN if missing else CORRECTED if corrected else COVERED), tuple(missing)
        else:
            yield (COVERED if told.facts or told.errata else OPEN), ()
