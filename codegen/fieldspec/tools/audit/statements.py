"""The section about what the device does: each line of the manual, and whether the simulator carries it out."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.language.behaviour.part import MODELLED, NOT_MODELLED, STANDINGS, Behaviour, Part
from fieldspec.language.behaviour.reading import behaviour_of
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.access import narrowed, writable
from fieldspec.language.model.encoding import is_count
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.ranges import Ranges
from fieldspec.language.model.value import Value
from fieldspec.tools.audit.accounting import LEFT_OUT, OPEN, by_line, first_omission
from fieldspec.tools.audit.line_facts import line_citations, lines_of
from fieldspec.tools.audit.manual_lines import ManualIndex
from fieldspec.tools.audit.plan import Plan, plan_of
from fieldspec.tools.audit.section import Cell, Figure, Section, SectionTable, Subject

NAME, TITLE = "statements", "Statements of behaviour"
WITHOUT = "facts alone"
_INTRODUCTION = (
    "The statements of the manual about behaviour over time. Each line with words is in a part of the behaviour, "
    "which a simulator implements, implements with an assumption, or leaves out with its reason; or it states only "
    "facts."
)


def statements(subject: Subject) -> Section:
    """The section about the statements of the manual, line by line."""
    index = subject.recorded or subject.manual
    parts = _parts(subject)
    plan, _ = plan_of(subject.spec, len(index.lines) if index is not None else subject.device.manual.lines)
    if plan is None or index is None or not parts or not subject.device.manual.lines:
        return Section(NAME, TITLE, ("The device has no behaviour, or its manual is not at hand.",))
    citing: dict[int, list[Part]] = defaultdict(list)
    for part in parts:
        for line in lines_of(part.sources):
            citing[line].append(part)
    cited_lines = line_citations(subject.spec, subject.layouts, subject.facts).lines
    lines = _Lines(plan, index, citing, cited_lines)
    standings = {line: lines.standing(line) for line, text in enumerate(index.lines, 1) if text}
    judged = bool(plan.without_behaviour)
    findings = (*lines.findings(standings), *_unused(plan, lines.used)) if judged else ()
    behaviour = behaviour_of(subject.spec.tree_at(subject.device.version))
    beyond_figures, beyond_table = beyond_ranges(subject.layout, behaviour)
    tables = (_by_section(plan, standings), _rows(parts), beyond_table)
    figures = (*_figures(parts, standings, judged), *beyond_figures)
    return Section(NAME, TITLE, (_INTRODUCTION,), figures, tables, findings)


def _parts(subject: Subject) -> list[Part]:
    """The parts of all versions, each once, in the order in which the manual states them."""
    known: dict[str, Part] = {}
    for layout in reversed(subject.layouts):
        for part in behaviour_of(subject.spec.tree_at(layout.device.version)).statements():
            known.setdefault(part.name, part)
    return list(known.values())


class _Lines:
    """Judges lines. `used` are the entries without behaviour that apply to a line."""

    def __init__(
        self, plan: Plan, index: ManualIndex, citing: Mapping[int, list[Part]], cited_lines: frozenset[int]
    ) -> None:
        self.plan, self.index, self.citing, self.cited_lines = plan, index, citing, cited_lines
        self.left_out = by_line((*plan.left_out, plan.headings))
        self.without = by_line(plan.without_behaviour)
        self.used: set[int] = set()

    def standing(self, line: int) -> str:
        """The class of a line of the manual: one of STANDINGS, left out, facts alone, or open."""
        standings = {part.standing for part in self.citing.get(line, ())}
        if standings:
            return next(standing for standing in STANDINGS if standing in standings)
        text = self.index.lines[line - 1]
        without = first_omission(self.without.get(line, ()), text)
        if without is not None and line in self.cited_lines:
            self.used.add(id(without))
            return WITHOUT
        return LEFT_OUT if first_omission(self.left_out.get(line, ()), text) is not None else OPEN

    def findings(self, standings: Mapping[int, str]) -> Iterator[Diagnostic]:
        """A finding for each open line."""
        for line, standing in standings.items():
            if standing == OPEN:
                use = (
                    "facts cite it, but no part of the behaviour does"
                    if line in self.cited_lines
                    else "nothing cites it"
                )
                text = f"line {line} of the manual, section {self.plan.section(line)}: {use}"
                help = "write the part, list the line under `audit: without_behaviour`, or state why it is left out"
                yield Diagnostic("statements_accounted", text, self.index.span(line), help=help)


def _unused(plan: Plan, used: set[int]) -> Iterator[Diagnostic]:
    for entry in plan.without_behaviour:
        if id(entry) not in used:
            text = "this applies to no line that facts cite and no part of the behaviour does"
            yield Diagnostic("audit_sound", text, entry.place.whole, help="correct its lines, or remove it")


def _figures(parts: list[Part], standings: Mapping[int, str], judged: bool) -> Iterator[Figure]:
    stated = Counter(part.standing for part in parts if part.sources)
    for standing in STANDINGS:
        yield Figure(f"statements of the manual are {standing}", stated[standing], stated.total())
    yield Figure("parts are about what the manual does not state", sum(not part.sources for part in parts))
    lines = Counter(standings.values())
    yield Figure(
        "lines with words are in parts of the behaviour", sum(map(lines.__getitem__, STANDINGS)), len(standings)
    )
    yield Figure("state facts alone", lines[WITHOUT], len(standings))
    yield Figure("are left out intentionally", lines[LEFT_OUT], len(standings))
    yield Figure("have no use and no reason", lines[OPEN], len(standings), lines[OPEN] == 0 if judged else None)


def _by_section(plan: Plan, standings: Mapping[int, str]) -> SectionTable:
    counts: dict[str, Counter[str]] = defaultdict(Counter)
    for line, standing in standings.items():
        counts[plan.section(line)][standing] += 1
    kinds = (*STANDINGS, WITHOUT, LEFT_OUT, OPEN)
    titles = {section.name: section.title for section in plan.sections}
    rows: list[tuple[Cell, ...]] = [
        (name, titles.get(name, ""), *(counter[kind] for kind in kinds)) for name, counter in counts.items()
    ]
    return SectionTable("statement_lines", "Lines by section", ("section", "title", *kinds), tuple(rows), detail=True)


def _rows(parts: list[Part]) -> SectionTable:
    rows: list[tuple[Cell, ...]] = []
    for part in parts:
        words = f"{part.subject} {part['reason']}" if part.standing == NOT_MODELLED else part.assumed
        source = part.sources[0] if part.sources else None
        rows.append((part.name, part.standing, words, source, part.place["name"]))
    marks = tuple("good" if part.standing == MODELLED else "warning" if part.assumed else "" for part in parts)
    return SectionTable(NAME, TITLE, ("part", "standing", "words", "source", "spec"), tuple(rows), marks, detail=True)


REFUSED, UNPRINTED = "refused", "not printed"


@dataclass(frozen=True, slots=True)
class Bounded:
    """A value that a request writes and whose range is narrower than its type, and the links of the request."""

    fact: Fact
    ranges: Ranges
    links: tuple[str, ...]


def beyond_ranges(layout: DeviceLayout, behaviour: Behaviour) -> tuple[list[Figure], SectionTable]:
    """A statement for each value whose range is narrower than its type, and how many there are of each kind."""
    part = next((part for part in behaviour.of_kind("refuse") if part.subject == "value_invalid"), None)
    rows: list[tuple[Cell, ...]] = []
    for bounded in _bounded_values(layout):
        fact = bounded.fact
        answers = {_answer(layout, link, part) for link in bounded.links} or {UNPRINTED}
        answer = UNPRINTED if UNPRINTED in answers else REFUSED
        source = part.sources[0] if part is not None and part.sources and answer == REFUSED else None
        rows.append((fact.place.path, bounded.ranges.text(), answer, source, fact.sources[0] if fact.sources else None))
    counts = Counter(row[2] for row in rows)
    figures = [
        Figure("values beyond their ranges are refused, as the manual says", counts[REFUSED], len(rows)),
        Figure("values beyond their ranges have no answer that the manual prints", counts[UNPRINTED], len(rows)),
    ]
    title = "How the device treats a value outside its range"
    marks = tuple("warning" if row[2] == UNPRINTED else "" for row in rows)
    return figures, SectionTable(
        "beyond", title, ("fact", "range", "answer", "says", "source"), tuple(rows), marks, True
    )


def _answer(layout: DeviceLayout, link: str, part: Part | None) -> str:
    """Whether a link has a response that refuses a value."""
    if part is None:
        return UNPRINTED
    marked = str(part.get("mark") or "").startswith(f"links/{link}/")
    excepted = "with" in part.keys and layout.links[link].link.exception_response is not None
    return REFUSED if marked or excepted else UNPRINTED


def _bounded_values(layout: DeviceLayout) -> Iterator[Bounded]:
    device = layout.device
    addressed = tuple(name for name, link in layout.links.items() if link.link.exception_response is not None)
    for register in device.registers():
        if writable(register.access) and not register.reserved:
            yield from _bounded(register, register.value, addressed)
    for table in device.tables.values():
        for field in device.records[table.record].fields:
            if writable(narrowed(table.access, field.access)) and not field.reserved:
                yield from _bounded(field, field.value, addressed)
    for parameter_set in device.parameters.values():
        for parameter in parameter_set.parameters:
            if writable(parameter.access):
                yield from _bounded(parameter, parameter.value, addressed or tuple(layout.links))
    for message in device.messages.values():
        links = tuple(name for name, link in layout.links.items() if message.name in link.carried("request"))
        for field in message.request.fields if links else ():
            if not field.reserved:
                yield from _bounded(field, field.value, links)


def _bounded(fact: Fact, value: Value | None, links: tuple[str, ...]) -> Iterator[Bounded]:
    if value is None or not is_count(value.encoding) or value.const is not None:
        return
    ranges = value.writable_ranges
    if ranges is not None and (ranges.low > value.low or ranges.high < value.high or len(ranges.intervals) > 1):
        yield Bounded(fact, ranges, links)
