"""The section of the report that compares the spec with its manual, in both directions."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from fieldspec.audit.accounting import CORRECTED, COVERED, LEFT_OUT, LINE, OPEN, Accounts, Candidate, accounts
from fieldspec.audit.citations import Judged, judged
from fieldspec.audit.line_facts import cited
from fieldspec.audit.manual_lines import Aligned, aligned, unmoved
from fieldspec.audit.pattern import PieceValue
from fieldspec.audit.plan import Pattern, Plan, plan
from fieldspec.audit.section import Cell, Figure, Section, SectionTable, Subject
from fieldspec.diagnostics import Diagnostic, Label
from fieldspec.source import Span

NAME, TITLE = "coverage", "Coverage of the manual"
_KINDS = {
    "address": "addresses",
    "code": "codes",
    "bit_row": "rows of bits",
    "table_row": "rows of tables",
    "frame": "frames",
    LINE: "other lines with numbers",
}

_MOST_ROWS = {OPEN: "bad", CORRECTED: "warning", LEFT_OUT: ""}


def coverage(subject: Subject) -> Section:
    """How the manual is covered, and whether what the spec cites is there."""
    told = subject.device.manual
    found: list[Diagnostic] = []
    recorded = subject.recorded
    manual = _manual(subject, found)
    made, wrong = plan(subject.spec, len((recorded or manual.index).lines) if manual else told.lines)
    found += wrong
    if made is None:
        text = "the spec does not say how an audit reads the manual"
        help = "write a section `audit`, with the sections of the manual and what looks like a fact"
        found.append(Diagnostic("audit_sound", text, _head(subject), help=help))
    if made is None or manual is None:
        return Section(NAME, TITLE, ("The manual cannot be compared.",), findings=tuple(found))
    counted = accounts(manual, made, cited(subject.spec, subject.layouts, subject.facts))
    claims = judged([layout.device for layout in subject.layouts], manual, made)
    found += [
        *_open(counted, manual),
        *_uncited(claims),
        *_unused(counted, claims),
    ]
    tables = (
        _by_kind(counted),
        _by_section(counted, made),
        _reasons(counted, made),
        _rows(counted, manual),
        _beside(counted, made, manual),
        _unneeded(counted, claims),
    )
    figures = tuple(_figures(counted, claims))
    return Section(NAME, TITLE, tuple(_says(subject, manual)), figures, tables, tuple(found))


def _head(subject: Subject) -> Span:
    return subject.device.place["id"]


def _manual(subject: Subject, found: list[Diagnostic]) -> Aligned | None:
    """The manual at hand in the lines that the spec cites; what is wrong with its index is found."""
    told, recorded, manual = subject.device.manual, subject.recorded, subject.manual
    if recorded is None and manual is None:
        text = f"there is no index of the manual {told.file}"
        help = f"record it: fieldspec audit {subject.device.id} --manual FILE --record"
        found.append(Diagnostic("manual_recorded", text, _head(subject), help=help))
        return None
    fresh = recorded is not None and recorded.sha256 == told.sha256 and len(recorded.lines) == told.lines
    same = manual is None or manual.sha256 != told.sha256 or recorded is None or manual == recorded
    if recorded is None or not fresh or not same:
        text = "the index of the manual is not that of the text which the spec cites"
        help = f"record it anew: fieldspec audit {subject.device.id} --manual FILE --record"
        found.append(Diagnostic("manual_recorded", text, _head(subject), help=help))
    if manual is None:
        assert recorded is not None
        return unmoved(recorded)
    return aligned(recorded, manual) if recorded is not None else unmoved(manual)


def _says(subject: Subject, manual: Aligned) -> Iterator[str]:
    """Which text is compared, and how much of it is the one that the spec cites."""
    told = subject.device.manual
    edition = f", {told.edition}" if told.edition else ""
    yield f"{told.title}{edition}: {told.file}, {told.lines} lines, sha256 {told.sha256}"
    if subject.manual is None:
        yield "Compared with the index that is recorded beside the spec."
    elif subject.manual.sha256 == told.sha256:
        yield "Compared with the text itself, which is the edition that the spec cites."
    else:
        share = 100 * manual.same // max(manual.whole, 1)
        yield (
            f"The text is another edition, or was saved in another way: sha256 {subject.manual.sha256}, "
            f"{len(manual.index.lines)} lines."
        )
        moved = sum(cited != here for cited, here in manual.here.items() if cited not in manual.changed)
        yield (
            f"{manual.same} of {manual.whole} lines with text are there unchanged ({share} %), {moved} of them "
            f"elsewhere; {len(manual.changed)} lines are changed, {len(manual.gone)} gone, {len(manual.new)} new."
        )


def _figures(counted: Accounts, claims: Judged) -> Iterator[Figure]:
    states = Counter(one.status for one in counted.candidates)
    whole = len(counted.candidates)
    yield Figure("places in the manual that look like facts are covered", states[COVERED], whole)
    yield Figure("are covered with a correction", states[CORRECTED], whole)
    yield Figure("are left out on purpose", states[LEFT_OUT], whole)
    yield Figure("are not accounted for", states[OPEN], whole, states[OPEN] == 0)
    needed = len(counted.needed & claims.numbered.keys())
    yield Figure("facts that have a number would be missed if they were gone", needed, len(claims.numbered))
    beside = len(counted.beside)
    yield Figure("numbers beside them, in remarks or of rows, are compared with nothing", beside)
    failing = len({(one.path, one.what) for one in claims.missing})
    yield Figure(
        "addresses, codes, identifiers and prints stand where the spec cites them",
        claims.looked_up - failing,
        claims.looked_up,
        failing == 0,
    )


def _states(candidates: list[Candidate]) -> tuple[int, ...]:
    states = Counter(one.status for one in candidates)
    return states[COVERED], states[CORRECTED], states[LEFT_OUT], states[OPEN]


def _by_kind(counted: Accounts) -> SectionTable:
    """How many of each kind there are."""
    rows: list[tuple[Cell, ...]] = []
    for kind, words in _KINDS.items():
        held = [one for one in counted.candidates if one.kind == kind]
        if held:
            rows.append((words, len(held), *_states(held)))
    columns = ("what", "number", COVERED, CORRECTED, LEFT_OUT, OPEN)
    kinds = tuple("bad" if row[-1] else "" for row in rows)
    return SectionTable("kinds", "By kind", columns, tuple(rows), kinds)


def _by_section(counted: Accounts, made: Plan) -> SectionTable:
    """How many there are in each section of the manual."""
    rows: list[tuple[Cell, ...]] = []
    titles = {section.name: section.title for section in made.sections}
    for name in ("", *titles):
        held = [one for one in counted.candidates if one.section == name]
        if held:
            rows.append((name, titles.get(name, "before the first section"), len(held), *_states(held)))
    columns = ("section", "title", "number", COVERED, CORRECTED, LEFT_OUT, OPEN)
    kinds = tuple("bad" if row[-1] else "" for row in rows)
    return SectionTable("sections", "By section of the manual", columns, tuple(rows), kinds)


def _reasons(counted: Accounts, made: Plan) -> SectionTable:
    """What is left out, how often it is there, and why."""
    times = Counter(id(one.out) for one in counted.candidates if one.out is not None)
    rows: list[tuple[Cell, ...]] = []
    for out in (*made.left_out, made.headings):
        heads = out is made.headings
        lines = "" if heads else ", ".join(f"{a}" if a == b else f"{a}-{b}" for a, b in out.lines)
        rows.append((times[id(out)], lines, out.like, out.reason, out.place.whole))
    columns = ("number", "lines", "like", "reason", "place")
    return SectionTable("left_out", "Left out on purpose", columns, tuple(rows))


def _rows(counted: Accounts, manual: Aligned) -> SectionTable:
    """Every place that is not simply covered."""
    held = [one for one in counted.candidates if one.status != COVERED]
    rows = []
    for one in held:
        printed = manual.index.lines[one.line - 1][one.start : one.end]
        reason = one.out.reason if one.out is not None else ""
        rows.append((one.section, one.line, _KINDS[one.kind], one.status, reason, printed))
    kinds = tuple(_MOST_ROWS[one.status] for one in held)
    columns = ("section", "line", "what", "how", "reason", "print")
    title = "Corrected, left out, and not accounted for"
    return SectionTable("places", title, columns, tuple(rows), kinds, detail=True)


def _beside(counted: Accounts, made: Plan, manual: Aligned) -> SectionTable:
    """The numbers that nothing compares, for a person to look at."""
    rows: list[tuple[Cell, ...]] = []
    for line, start, end in counted.beside:
        text = manual.index.lines[line - 1]
        rows.append((made.section(manual.known[line - 1]), line, text[start:end], text))
    title = "Numbers in known lines that no fact has"
    return SectionTable("beside", title, ("section", "line", "number", "print"), tuple(rows), detail=True)


def _unneeded(counted: Accounts, claims: Judged) -> SectionTable:
    """The facts whose loss would not show."""
    gone = [(path, *place) for path, place in claims.numbered.items() if path not in counted.needed]
    rows: tuple[tuple[Cell, ...], ...] = tuple((path, source, span) for path, span, source in gone)
    title = "Facts that would not be missed: printed twice, or in words, or in a line that others cite"
    return SectionTable("unmissed", title, ("fact", "source", "place"), rows, detail=True)


def _open(counted: Accounts, manual: Aligned) -> Iterator[Diagnostic]:
    for one in counted.candidates:
        if one.status != OPEN:
            continue
        printed = manual.index.lines[one.line - 1][one.start : one.end]
        where = f"line {one.line} of the manual" + (f", section {one.section}," if one.section else "")
        if one.pattern is None:
            changed = one.line not in manual.new and one.cited in manual.changed
            why = "says something else in the edition that the spec cites" if changed else _UNCITED
            text = f"{where} has numbers, and {why}"
            yield Diagnostic("manual_accounted", text, manual.index.span(one.line), help=_CURE)
            continue
        what = ", ".join(_value_text(held) for held in one.missing) or f"`{printed}`"
        text = f"{where} prints {what}, and no fact that cites it says so"
        label = Label(one.pattern.place["name"], "the pattern that finds it")
        yield Diagnostic("manual_accounted", text, manual.index.span(one.line), (label,), _CURE)


_UNCITED = "nothing in the spec cites it"
_CURE = "transcribe it, put it right with an erratum, or say why it is left out"


def _value_text(held: PieceValue) -> str:
    return f"`{held.column}` {held.text}"


def _uncited(claims: Judged) -> Iterator[Diagnostic]:
    for one in claims.missing:
        if one.what.startswith("`"):
            text = f"{one.path} cites {one.source.text()}, where the manual does not print {one.what}"
        else:
            text = f"{one.path} cites {one.what}"
        help = "put the section or the lines right, or the value; an erratum says what is printed instead"
        yield Diagnostic("citations_hold", text, one.span, help=help)


def _unused(counted: Accounts, claims: Judged) -> Iterator[Diagnostic]:
    for one in counted.unused:
        what = f"the pattern `{one.name}` finds" if isinstance(one, Pattern) else "this leaves out"
        text = f"{what} nothing in its lines of the manual"
        yield Diagnostic(
            "audit_sound",
            text,
            one.place.whole,
            help="put its lines or its form right, or remove it",
        )
    for held in claims.unused:
        text = "what these facts cite does hold them, or there are no such facts"
        yield Diagnostic("audit_sound", text, held.place["facts"], help="remove the entry, or put the paths right")
