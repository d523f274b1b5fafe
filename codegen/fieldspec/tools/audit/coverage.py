"""The section of the report that compares the spec with its manual, in both directions."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from fieldspec.foundation.source import Span
from fieldspec.language.diagnostics import Diagnostic, Label
from fieldspec.tools.audit.accounting import CORRECTED, COVERED, LEFT_OUT, LINE, OPEN, Accounts, Candidate, accounts_of
from fieldspec.tools.audit.citations import CitationResults, citation_results
from fieldspec.tools.audit.line_facts import line_citations
from fieldspec.tools.audit.manual_lines import AlignedManual, aligned, unmoved
from fieldspec.tools.audit.plan import Pattern, Plan, plan_of
from fieldspec.tools.audit.section import Cell, Figure, Section, SectionTable, Subject

NAME, TITLE = "coverage", "Coverage of the manual"
_KINDS = {
    "address": "addresses",
    "code": "codes",
    "bit_row": "rows of bits",
    "table_row": "rows of tables",
    "frame": "frames",
    LINE: "other lines with numbers",
}

_STATUS_KINDS = {OPEN: "bad", CORRECTED: "warning", LEFT_OUT: ""}


def coverage(subject: Subject) -> Section:
    """The section about coverage: what in the manual is in the spec, and whether cited lines print the facts."""
    cited_manual = subject.device.manual
    if not cited_manual.lines:
        text = f"{cited_manual.title}: {cited_manual.extent}. It has no lines that an audit could compare."
        return Section(NAME, TITLE, (text,))
    findings: list[Diagnostic] = []
    recorded = subject.recorded
    manual = _manual(subject, findings)
    plan, wrong = plan_of(subject.spec, len((recorded or manual.index).lines) if manual else cited_manual.lines)
    findings += wrong
    if plan is None:
        text = "the spec does not say how an audit reads the manual"
        help = "write a section `audit`, with the sections of the manual and what looks like a fact"
        findings.append(Diagnostic("audit_sound", text, _head(subject), help=help))
    if plan is None or manual is None:
        return Section(NAME, TITLE, ("The manual cannot be compared.",), findings=tuple(findings))
    accounts = accounts_of(manual, plan, line_citations(subject.spec, subject.layouts, subject.facts))
    claims = citation_results([layout.device for layout in subject.layouts], manual, plan)
    findings += [
        *_open(accounts, manual),
        *_uncited(claims),
        *_unused(accounts, claims),
    ]
    tables = (
        _by_kind(accounts),
        _by_section(accounts, plan),
        _reasons(accounts, plan),
        _rows(accounts, manual),
        _beside(accounts, plan, manual),
        _unneeded(accounts, claims),
    )
    figures = tuple(_figures(accounts, claims))
    return Section(NAME, TITLE, tuple(_introduction(subject, manual)), figures, tables, tuple(findings))


def _head(subject: Subject) -> Span:
    return subject.device.place["id"]


def _manual(subject: Subject, findings: list[Diagnostic]) -> AlignedManual | None:
    """The manual at hand with the line numbers that the spec cites, or None. Adds what is wrong with its index."""
    cited_manual, recorded, manual = subject.device.manual, subject.recorded, subject.manual
    if recorded is None and manual is None:
        text = f"there is no index of the manual {cited_manual.file}"
        help = f"record it: fieldspec audit {subject.device.id} --manual FILE --record"
        findings.append(Diagnostic("manual_recorded", text, _head(subject), help=help))
        return None
    fresh = (
        recorded is not None and recorded.sha256 == cited_manual.sha256 and len(recorded.lines) == cited_manual.lines
    )
    same = manual is None or manual.sha256 != cited_manual.sha256 or recorded is None or manual == recorded
    if recorded is None or not fresh or not same:
        text = "the index of the manual does not belong to the text that the spec cites"
        help = f"record it again: fieldspec audit {subject.device.id} --manual FILE --record"
        findings.append(Diagnostic("manual_recorded", text, _head(subject), help=help))
    if manual is None:
        assert recorded is not None
        return unmoved(recorded)
    return aligned(recorded, manual) if recorded is not None else unmoved(manual)


def _introduction(subject: Subject, manual: AlignedManual) -> Iterator[str]:
    """Sentences about the text that is compared, and how much of it is the edition that the spec cites."""
    cited = subject.device.manual
    edition = f", {cited.edition}" if cited.edition else ""
    yield f"{cited.title}{edition}: {cited.extent}, sha256 {cited.sha256}"
    if subject.manual is None:
        yield "Compared with the recorded index of the manual."
    elif subject.manual.sha256 == cited.sha256:
        yield "Compared with the text of the edition that the spec cites."
    else:
        share = 100 * manual.same // max(manual.whole, 1)
        yield (
            f"The text is another edition, or was saved in another way: sha256 {subject.manual.sha256}, "
            f"{len(manual.index.lines)} lines."
        )
        moved = sum(old != new for old, new in manual.here.items() if old not in manual.changed)
        yield (
            f"{manual.same} of {manual.whole} lines with text are there unchanged ({share} %), {moved} of them "
            f"elsewhere; {len(manual.changed)} lines are changed, {len(manual.gone)} gone, {len(manual.new)} new."
        )


def _figures(accounts: Accounts, claims: CitationResults) -> Iterator[Figure]:
    states = Counter(candidate.status for candidate in accounts.candidates)
    whole = len(accounts.candidates)
    yield Figure("places in the manual that look like facts are covered", states[COVERED], whole)
    yield Figure("are covered with a correction", states[CORRECTED], whole)
    yield Figure("are left out intentionally", states[LEFT_OUT], whole)
    yield Figure("are not accounted for", states[OPEN], whole, states[OPEN] == 0)
    noticed = len(accounts.needed & claims.numbered.keys())
    yield Figure("facts with a number would be noticed if they were missing", noticed, len(claims.numbered))
    uncompared = len(accounts.beside)
    yield Figure("other numbers, in remarks or as row numbers, are not compared", uncompared)
    failing = len({(missing.path, missing.what) for missing in claims.missing})
    yield Figure(
        "addresses, codes, identifiers, values and misprints are in the lines that the spec cites",
        claims.looked_up - failing,
        claims.looked_up,
        failing == 0,
    )


def _states(candidates: list[Candidate]) -> tuple[int, ...]:
    states = Counter(candidate.status for candidate in candidates)
    return states[COVERED], states[CORRECTED], states[LEFT_OUT], states[OPEN]


def _by_kind(accounts: Accounts) -> SectionTable:
    """The candidates by kind."""
    rows: list[tuple[Cell, ...]] = []
    for kind, words in _KINDS.items():
        candidates = [candidate for candidate in accounts.candidates if candidate.kind == kind]
        if candidates:
            rows.append((words, len(candidates), *_states(candidates)))
    columns = ("what", "number", COVERED, CORRECTED, LEFT_OUT, OPEN)
    kinds = tuple("bad" if row[-1] else "" for row in rows)
    return SectionTable("kinds", "By kind", columns, tuple(rows), kinds)


def _by_section(accounts: Accounts, plan: Plan) -> SectionTable:
    """The candidates by section of the manual."""
    rows: list[tuple[Cell, ...]] = []
    titles = {section.name: section.title for section in plan.sections}
    for name in ("", *titles):
        candidates = [candidate for candidate in accounts.candidates if candidate.section == name]
        if candidates:
            rows.append((name, titles.get(name, "before the first section"), len(candidates), *_states(candidates)))
    columns = ("section", "title", "number", COVERED, CORRECTED, LEFT_OUT, OPEN)
    kinds = tuple("bad" if row[-1] else "" for row in rows)
    return SectionTable("sections", "By section of the manual", columns, tuple(rows), kinds)


def _reasons(accounts: Accounts, plan: Plan) -> SectionTable:
    """The omissions: how often each applies, and its reason."""
    times = Counter(id(candidate.omission) for candidate in accounts.candidates if candidate.omission is not None)
    rows: list[tuple[Cell, ...]] = []
    for omission in (*plan.left_out, plan.headings):
        heads = omission is plan.headings
        lines = "" if heads else ", ".join(f"{a}" if a == b else f"{a}-{b}" for a, b in omission.lines)
        rows.append((times[id(omission)], lines, omission.like, omission.reason, omission.place.whole))
    columns = ("number", "lines", "like", "reason", "place")
    return SectionTable("left_out", "Left out on purpose", columns, tuple(rows))


def _rows(accounts: Accounts, manual: AlignedManual) -> SectionTable:
    """The candidates that are not covered."""
    candidates = [candidate for candidate in accounts.candidates if candidate.status != COVERED]
    rows = []
    for candidate in candidates:
        printed = manual.index.lines[candidate.line - 1][candidate.start : candidate.end]
        reason = candidate.omission.reason if candidate.omission is not None else ""
        rows.append((candidate.section, candidate.line, _KINDS[candidate.kind], candidate.status, reason, printed))
    kinds = tuple(_STATUS_KINDS[candidate.status] for candidate in candidates)
    columns = ("section", "line", "what", "how", "reason", "print")
    title = "Corrected, left out, and not accounted for"
    return SectionTable("places", title, columns, tuple(rows), kinds, detail=True)


def _beside(accounts: Accounts, plan: Plan, manual: AlignedManual) -> SectionTable:
    """The numbers that no fact accounts for, for a person to look at."""
    rows: list[tuple[Cell, ...]] = []
    for line, start, end in accounts.beside:
        text = manual.index.lines[line - 1]
        rows.append((plan.section(manual.known[line - 1]), line, text[start:end], text))
    title = "Numbers in cited lines that no fact has"
    return SectionTable("beside", title, ("section", "line", "number", "print"), tuple(rows), detail=True)


def _unneeded(accounts: Accounts, claims: CitationResults) -> SectionTable:
    """The facts whose loss the audit would not notice."""
    unneeded = [(path, *place) for path, place in claims.numbered.items() if path not in accounts.needed]
    rows: tuple[tuple[Cell, ...], ...] = tuple((path, source, span) for path, span, source in unneeded)
    title = "Facts whose loss no audit would notice: printed twice, in words, or in a line that other facts cite"
    return SectionTable("unmissed", title, ("fact", "source", "place"), rows, detail=True)


def _open(accounts: Accounts, manual: AlignedManual) -> Iterator[Diagnostic]:
    for candidate in accounts.candidates:
        if candidate.status != OPEN:
            continue
        printed = manual.index.lines[candidate.line - 1][candidate.start : candidate.end]
        place_text = f"line {candidate.line} of the manual" + (
            f", section {candidate.section}," if candidate.section else ""
        )
        if candidate.pattern is None:
            changed = candidate.line not in manual.new and candidate.cited in manual.changed
            reason = "says something else in the edition that the spec cites" if changed else _UNCITED
            text = f"{place_text} has numbers, and {reason}"
            yield Diagnostic("manual_accounted", text, manual.index.span(candidate.line), help=_CURE)
            continue
        values_text = ", ".join(f"`{value.column}` {value.text}" for value in candidate.missing) or f"`{printed}`"
        text = f"{place_text} prints {values_text}, and no fact that cites it says so"
        label = Label(candidate.pattern.place["name"], "the pattern that finds it")
        yield Diagnostic("manual_accounted", text, manual.index.span(candidate.line), (label,), _CURE)


_UNCITED = "no fact cites it"
_CURE = "transcribe it, correct it with an erratum, or state why it is left out"


def _uncited(claims: CitationResults) -> Iterator[Diagnostic]:
    for missing in claims.missing:
        if missing.what.startswith("`"):
            text = f"{missing.path} cites {missing.source.text()}, where the manual does not print {missing.what}"
        else:
            text = f"{missing.path} cites {missing.what}"
        help = "correct the section, the lines or the value; if the manual is wrong, write an erratum"
        yield Diagnostic("citations_hold", text, missing.span, help=help)


def _unused(accounts: Accounts, claims: CitationResults) -> Iterator[Diagnostic]:
    for entry in accounts.unused:
        subject = f"the pattern `{entry.name}` finds" if isinstance(entry, Pattern) else "this leaves out"
        text = f"{subject} nothing in its lines of the manual"
        yield Diagnostic(
            "audit_sound",
            text,
            entry.place.whole,
            help="correct its lines or its form, or remove it",
        )
    for unprinted in claims.unused:
        text = "the lines that these facts cite contain them, or there are no such facts"
        yield Diagnostic("audit_sound", text, unprinted.place["facts"], help="remove the entry, or correct the paths")
