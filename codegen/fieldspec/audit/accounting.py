"""Everything in a manual that looks like a fact, and what the spec has of it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from fieldspec.audit.alignment import Aligned
from fieldspec.audit.cited import Cited, OnLine, corrects, says
from fieldspec.audit.pattern import Found, Held
from fieldspec.audit.plan import LeftOut, Pattern, Plan, within
from fieldspec.classes import dataclass

COVERED, CORRECTED, LEFT_OUT, OPEN = "covered", "corrected", "left out", "not accounted for"
STATUSES = (COVERED, CORRECTED, LEFT_OUT, OPEN)
LINE = "line"
"""The kind of a line that has a number, and of which no pattern says what it is."""


@dataclass(frozen=True, slots=True)
class Candidate:
    """Something that looks like a fact: the line of the text at hand, the cited line, and how it stands.

    `missing` are the values that no fact and no erratum has; there are none for a line with a number.
    """

    kind: str
    line: int
    cited: int
    section: str
    start: int
    end: int
    status: str
    missing: tuple[Held, ...] = ()
    pattern: Pattern | None = None


@dataclass(frozen=True, slots=True)
class Accounts:
    """All candidates, the patterns that have found none, and what is left out without being there."""

    candidates: Sequence[Candidate]
    unused: Sequence[Pattern | LeftOut]


def accounts(manual: Aligned, plan: Plan, cited: Cited) -> Accounts:
    """Looks through the manual line by line: its patterns first, then whatever else has a number."""
    made: list[Candidate] = []
    used: set[int] = set()
    for number, text in enumerate(manual.index.lines, 1):
        if not text:
            continue
        at = manual.known[number - 1]
        out = _left_out(plan, at, text)
        before = len(made)
        told = OnLine() if number in manual.new else cited.at(at)
        pieces = list(_pieces(plan, at, text))
        used.update(id(pattern) for pattern, _ in pieces)
        for pattern, found in pieces:
            status, missing = _standing(found, told, cited)
            if status == OPEN and out is not None:
                status, missing = LEFT_OUT, ()
            made.append(
                Candidate(pattern.kind, number, at, plan.section(at), found.start, found.end, status, missing, pattern)
            )
        if not pieces and any(char.isdigit() for char in text):
            known = number not in manual.new and at in cited.lines
            status = COVERED if known else LEFT_OUT if out is not None else OPEN
            made.append(Candidate(LINE, number, at, plan.section(at), 0, len(text), status))
        if out is not None and any(one.status == LEFT_OUT for one in made[before:]):
            used.add(id(out))
    declared: list[Pattern | LeftOut] = [*plan.patterns, *plan.left_out]
    return Accounts(made, [one for one in declared if id(one) not in used])


def _left_out(plan: Plan, line: int, text: str) -> LeftOut | None:
    """What leaves a line out."""
    for out in plan.left_out:
        if within(line, out.lines) and (out.like is None or out.like.whole(text) is not None):
            return out
    return None


def _pieces(plan: Plan, line: int, text: str) -> Iterator[tuple[Pattern, Found]]:
    """The pieces of a line that patterns find."""
    for pattern in plan.patterns:
        if within(line, pattern.lines):
            if pattern.row is not None:
                found = pattern.row.find(text)
                if found is not None:
                    yield pattern, found
            elif pattern.each is not None:
                for one in pattern.each.each(text):
                    yield pattern, one


def _standing(found: Found, told: OnLine, cited: Cited) -> tuple[str, tuple[Held, ...]]:
    """How a piece stands: each of its values must be one of a fact, or of an erratum, that cites the line."""
    open_ = [held for held in found.values if not any(says(row, held, cited.elided) for row in told.facts)]
    missing = tuple(held for held in open_ if not any(corrects(erratum, held) for erratum in told.errata))
    if not found.values:
        return (COVERED, ()) if told.facts or told.errata else (OPEN, ())
    if missing:
        return OPEN, missing
    return (CORRECTED if open_ else COVERED), ()
