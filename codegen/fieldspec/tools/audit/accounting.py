"""Everything in a manual that looks like a fact, and whether the spec accounts for it."""

from __future__ import annotations

import re
from collections import Counter, defaultdict, deque
from collections.abc import Iterator, Sequence
from typing import TypeVar

from fieldspec.foundation.classes import dataclass
from fieldspec.tools.audit.agreement import corrects, has_printed_value, number_places, readings
from fieldspec.tools.audit.line_facts import LineCitations, LineFacts
from fieldspec.tools.audit.manual_lines import AlignedManual
from fieldspec.tools.audit.pattern import Match, PieceValue
from fieldspec.tools.audit.plan import Omission, Pattern, Plan

COVERED, CORRECTED, LEFT_OUT, OPEN = "covered", "corrected", "left out", "not accounted for"
Ruled = TypeVar("Ruled", Pattern, Omission)

LONGEST_SERIES = 4096
"""The most numbers of a series; a longer one counts as its two ends."""

_DIGIT = re.compile("[0-9]")
LINE = "line"
"""The kind of a line that has a number, and of which no pattern says what it is."""


@dataclass(frozen=True, slots=True)
class Candidate:
    """A piece of a line that looks like a fact.

    `line` is its line in the text at hand, `cited` the number by which the spec cites that line. `status` is one of
    the four above. `missing` are the values that no fact and no erratum has; a line with a number and no pattern has
    none.
    `omission` is the omission that applies.
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
    omission: Omission | None = None


@dataclass(frozen=True, slots=True)
class Accounts:
    """All candidates. `unused` are the patterns and omissions that apply to nothing in the manual.

    `needed` are the paths of the facts without which a candidate would be open. `beside` are places of numbers (line,
    start, end) on lines with candidates: no pattern finds them, and no fact that cites the line has them.
    """

    candidates: Sequence[Candidate]
    unused: Sequence[Pattern | Omission]
    needed: frozenset[str]
    beside: Sequence[tuple[int, int, int]]


_LAST: deque[tuple[AlignedManual, Plan, LineCitations, Accounts]] = deque(maxlen=4)


def accounts_of(manual: AlignedManual, plan: Plan, cited: LineCitations) -> Accounts:
    """Accounts for a manual line by line: first by patterns, then by any number on a line without a match.

    A process that audits again and again takes the last accounts of the same.
    """
    for last_manual, last_plan, last_cited, accounts in _LAST:
        if last_plan is plan and last_manual == manual and last_cited == cited:
            return accounts
    accounts = _accounts_of(manual, plan, cited)
    _LAST.append((manual, plan, cited, accounts))
    return accounts


def _accounts_of(manual: AlignedManual, plan: Plan, cited: LineCitations) -> Accounts:
    candidates: list[Candidate] = []
    used: set[int] = set()
    needed_paths: set[str] = set()
    uncompared: list[tuple[int, int, int]] = []
    patterns = by_line(plan.patterns)
    left_out = by_line((*plan.left_out, plan.headings))
    of_changed = by_line(
        (*(entry for entry in plan.left_out if not entry.exact), plan.headings) if manual.changed else ()
    )
    of_new = by_line(plan.left_out if manual.new else ())
    for number, text in enumerate(manual.index.lines, 1):
        if not text:
            continue
        cited_line = manual.known[number - 1]
        section = plan.section(cited_line)
        if number in manual.new:
            omissions = [entry for entry in of_new.get(cited_line, ()) if entry in of_new.get(cited_line + 1, ())]
        else:
            omissions = (of_changed if cited_line in manual.changed else left_out).get(cited_line, [])
        omission = first_omission(omissions, text)
        before = len(candidates)
        line_facts = LineFacts() if number in manual.new else cited.at(cited_line)
        pieces = list(_pieces(patterns.get(cited_line, ()), text))
        used.update(id(pattern) for pattern, _ in pieces)
        for (pattern, match), (status, missing) in zip(
            pieces, _standings(pieces, line_facts, cited, needed_paths), strict=True
        ):
            if status == OPEN and omission is not None and not (line_facts.facts and "sections" in omission.place):
                status, missing = LEFT_OUT, ()
            place = number, cited_line, section, match.start, match.end
            candidates.append(
                Candidate(pattern.kind, *place, status, missing, pattern, omission if status == LEFT_OUT else None)
            )
        if pieces:
            uncompared += ((number, *place) for place in _beside(text, pieces, line_facts, cited))
        elif _DIGIT.search(text):
            known = number not in manual.new and cited_line not in manual.changed and cited_line in cited.lines
            status = COVERED if known else LEFT_OUT if omission is not None else OPEN
            applied = omission if status == LEFT_OUT else None
            candidates.append(Candidate(LINE, number, cited_line, section, 0, len(text), status, omission=applied))
        elif cited_line not in cited.lines:
            used.add(id(omission))
        used.update(id(entry.omission) for entry in candidates[before:])
    declared: list[Pattern | Omission] = [*plan.patterns, *plan.left_out]
    return Accounts(
        candidates, [entry for entry in declared if id(entry) not in used], frozenset(needed_paths), uncompared
    )


def by_line(entries: Sequence[Ruled]) -> dict[int, list[Ruled]]:
    """The patterns or omissions that apply to each line, in their order."""
    by_line: dict[int, list[Ruled]] = defaultdict(list)
    for entry in entries:
        for first, last in entry.lines:
            for line in range(first, last + 1):
                by_line[line].append(entry)
    return by_line


def first_omission(omissions: Sequence[Omission], text: str) -> Omission | None:
    """The first omission that applies to a text."""
    return next(
        (omission for omission in omissions if omission.template is None or omission.template.whole(text) is not None),
        None,
    )


def _pieces(patterns: Sequence[Pattern], text: str) -> Iterator[tuple[Pattern, Match]]:
    """The matches of patterns in a line, each with its pattern."""
    for pattern in patterns:
        if pattern.row is not None:
            match = pattern.row.find(text)
            if match is not None:
                yield pattern, _whole(pattern, match)
        elif pattern.each is not None:
            for piece in pattern.each.each(text):
                yield pattern, _whole(pattern, piece)


def _beside(
    text: str, pieces: Sequence[tuple[Pattern, Match]], line_facts: LineFacts, cited: LineCitations
) -> Iterator[tuple[int, int]]:
    """Places of numbers that are in no match, and in no fact or erratum that cites the line."""
    texts = {value.text for _, match in pieces for value in match.values}
    for start, end in number_places(text):
        value = PieceValue("value", "", text[start:end])
        if any(value.text in other for other in texts):
            continue
        if any(corrects(erratum, value) for erratum in line_facts.errata):
            continue
        if not any(has_printed_value(row, value, cited.elided) for row in line_facts.facts):
            yield start, end


def _owners(paths: set[str]) -> set[str]:
    """Paths without parts of other facts: a message and its fields share a code."""
    return {path for path in paths if not any(path.startswith(f"{other}/") for other in paths)}


def _whole(pattern: Pattern, match: Match) -> Match:
    """A match with what its pattern says: all numbers of a series, from the first to the last, and the access."""
    values = _series(match) if pattern.series and len(match.values) == 2 else match.values
    if pattern.access:
        values = (*values, PieceValue("access", "word", pattern.access))
    return match if values is match.values else Match(values, match.start, match.end)


def _series(match: Match) -> tuple[PieceValue, ...]:
    """All numbers from the first to the second one of a match; these two where they are not series."""
    low, high = (readings(value.text, value.form)[:1] for value in match.values)
    if not low or not high or not 0 <= high[0] - low[0] <= LONGEST_SERIES:
        return match.values
    column = match.values[0].column
    return tuple(PieceValue(column, "decimal", str(number)) for number in range(int(low[0]), int(high[0]) + 1))


def _standings(
    pieces: Sequence[tuple[Pattern, Match]], line_facts: LineFacts, cited: LineCitations, needed_paths: set[str]
) -> Iterator[tuple[str, tuple[PieceValue, ...]]]:
    """Status and missing values of each match: a fact, or an erratum, that cites the line must have each value.

    A value that a pattern finds several times on the line needs the same number of facts. Adds paths of facts to
    `needed_paths`.
    """
    times = Counter((pattern.name, value) for pattern, match in pieces for value in {*match.values})
    counts: Counter[tuple[str, PieceValue]] = Counter()
    for pattern, match in pieces:
        corrected, missing = False, []
        for value in dict.fromkeys(match.values):
            key = pattern.name, value
            counts[key] += 1
            paths = _owners(
                {str(row["path"]) for row in line_facts.facts if has_printed_value(row, value, cited.elided)}
            )
            put_right = any(corrects(erratum, value) for erratum in line_facts.errata)
            if len(paths) == times[key] and not put_right:
                needed_paths.update(path.partition("/restated/")[0] for path in paths)
            if len(paths) < counts[key]:
                corrected = corrected or put_right
                missing += [] if put_right else [value]
        if match.values:
            yield (OPEN if missing else CORRECTED if corrected else COVERED), tuple(missing)
        else:
            yield (COVERED if line_facts.facts or line_facts.errata else OPEN), ()
