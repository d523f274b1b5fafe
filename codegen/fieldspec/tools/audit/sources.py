"""How many places of the manual support each fact, and the section of the report about it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

from fieldspec.foundation.classes import dataclass
from fieldspec.language.checks.facts import facts
from fieldspec.language.checks.facts import facts as facts_of
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import COMPUTED, Citation, Place
from fieldspec.language.model.task import Task
from fieldspec.tools.audit.print_gaps import empty_cells, labels_elsewhere, without_unit
from fieldspec.tools.audit.section import Cell, Figure, Section, SectionTable, Subject

NO_SECTION = "no section"

NOWHERE, SINGLE_PLACE, TOGETHER, AGREEING, DIFFERING = "nowhere", "one_place", "together", "agreeing", "differing"
STANDINGS = {
    SINGLE_PLACE: "one place",
    TOGETHER: "several places, taken together",
    AGREEING: "several places, which agree",
    DIFFERING: "several places, which differ",
    NOWHERE: "no place",
}
"""The standings of facts, by how many places print them, with the words for them."""


@dataclass(frozen=True, slots=True)
class SourcedFact:
    """A fact with its citations; they are `inherited` from the fact that contains it where it has none of its own.

    `restated` are other places that state it again, `errata` the corrections of what such places print.
    """

    path: str
    place: Place
    sources: tuple[Citation, ...]
    inherited: bool
    restated: tuple[Citation, ...]
    errata: tuple[str, ...]
    unverified: bool

    @property
    def section(self) -> str:
        """The section of the manual that prints it first."""
        return next((citation.section for citation in self.sources if citation.section), NO_SECTION)

    @property
    def standing(self) -> str:
        """How the fact is founded, one of STANDINGS."""
        if not self.sources:
            return NOWHERE
        if not self.restated:
            return SINGLE_PLACE if len(self.sources) == 1 else TOGETHER
        return DIFFERING if self.errata else AGREEING


@dataclass(frozen=True, slots=True)
class InferredKey:
    """A key of a fact that the manual implies and does not print, with the reason."""

    path: str
    place: Place
    key: str
    reason: str
    section: str
    sources: tuple[Citation, ...]


def sourced_facts(device: Device) -> list[SourcedFact]:
    """All facts with their citations, in the order of the spec; facts of a protocol have the citations
    of the device.
    """
    corrected: dict[str, list[str]] = {}
    for erratum in device.errata:
        corrected.setdefault(erratum.fact.partition("/restated/")[0], []).append(erratum.id)
    by_path: dict[str, tuple[Citation, ...]] = {}
    result = []
    for fact in facts(device):
        if isinstance(fact, Task) and not fact.steps:
            continue  # no manual prints a question or a reason
        path = fact.place.path
        own = fact.sources
        sources = own or by_path.get(path.rpartition("/")[0], ())
        by_path.setdefault(path, sources)
        restated = tuple(citation for claim in fact.restated for citation in claim.sources)
        errata = tuple(corrected.get(path, ())) if restated else ()
        own_place = "source" in fact.place or bool(own and own != by_path.get(path.rpartition("/")[0]))
        result.append(SourcedFact(path, fact.place, sources, not own_place, restated, errata, fact.unverified))
    return result


def inferred_keys(device: Device) -> Iterator[InferredKey]:
    """Every key that is inferred, with its reason."""
    for fact in facts(device):
        for key, reason in fact.inferred.items():
            section = next((citation.section for citation in fact.sources if citation.section), NO_SECTION)
            yield InferredKey(fact.place.path, fact.place, key, reason, section, fact.sources)


def section_order(section: str) -> tuple[tuple[int, int, str], ...]:
    """A key that sorts sections as a manual has them: `9.2` before `10`, words after numbers."""
    return tuple((0, int(part), "") if part.isdigit() else (1, 0, part) for part in section.split("."))


_INTRODUCTION = (
    "The number of places in the manual that print each fact. A fact with two equal places is more "
    "certain than a fact with one place; if they differ, an erratum states the right value. Values that "
    "the manual only implies are inferred, with the reason. Values from standards, reports and our own "
    "computations are not printed at all."
)


def sources(subject: Subject) -> Section:
    """The section about sources."""
    facts = sourced_facts(subject.device)
    keys = list(inferred_keys(subject.device))
    count = Counter(fact.standing for fact in facts)
    unverified = [fact for fact in facts if fact.unverified]
    figures = [
        Figure("facts without a source", count[NOWHERE], len(facts), count[NOWHERE] == 0),
        Figure("facts that several places print and that agree", count[AGREEING], len(facts)),
        Figure("facts that several places print and that differ", count[DIFFERING], len(facts)),
        Figure("facts that follow from several places together", count[TOGETHER], len(facts)),
        Figure("facts that only one place prints", count[SINGLE_PLACE], len(facts)),
        Figure("values that are inferred, with a reason", len(keys)),
        *_elsewhere_figures(subject.device),
    ]
    if unverified:
        figures.append(Figure("facts that are not verified", len(unverified), len(facts), False))
    tables = (
        _by_section(facts, keys),
        _source_table(
            "unsourced", "Facts without a source", [fact for fact in facts if fact.standing == NOWHERE], "bad"
        ),
        _source_table("unverified", "Facts that are not verified", unverified, "bad"),
        _differing([fact for fact in facts if fact.standing == DIFFERING]),
        _reasons(keys),
        _standards(subject.device),
        _reported(subject.device),
        _computed(subject.device),
        _without_unit(subject.device),
        _empty_cells(subject),
        _labels_elsewhere(subject),
        _source_table(
            "one_place", "Facts that only one place prints", [f for f in facts if f.standing == SINGLE_PLACE], ""
        ),
        _agreeing([fact for fact in facts if fact.standing == AGREEING]),
    )
    return Section("sources", "Sources", (_INTRODUCTION,), tuple(figures), tables)


def _by_section(facts: Sequence[SourcedFact], keys: Sequence[InferredKey]) -> SectionTable:
    standings: dict[str, Counter[str]] = {}
    for fact in facts:
        standings.setdefault(fact.section, Counter())[fact.standing] += 1
    implied = Counter(inferred_key.section for inferred_key in keys)
    rows: list[tuple[Cell, ...]] = []
    for section in sorted({*standings, *implied}, key=section_order):
        counts = standings.get(section, Counter())
        numbers = [counts[standing] or None for standing in STANDINGS]
        rows.append((section, sum(counts.values()), *numbers, implied[section] or None))
    return SectionTable("by_section", "By section", ("section", "facts", *STANDINGS, "inferred"), tuple(rows))


def _source_table(name: str, title: str, facts: Sequence[SourcedFact], kind: str) -> SectionTable:
    rows = tuple(
        (fact.path, fact.sources[0] if fact.sources else None, "of its holder" if fact.inherited else "", _spec(fact))
        for fact in facts
    )
    return SectionTable(
        name, title, ("fact", "source", "whose", "spec"), rows, (kind,) * len(rows), detail=len(rows) > 20
    )


def _differing(facts: Sequence[SourcedFact]) -> SectionTable:
    rows = tuple((fact.path, _places(fact), ", ".join(fact.errata), _spec(fact)) for fact in facts)
    columns = ("fact", "places", "errata", "spec")
    return SectionTable("differing", "Facts that differ between places", columns, rows, detail=len(rows) > 20)


def _agreeing(facts: Sequence[SourcedFact]) -> SectionTable:
    rows = tuple((fact.path, _places(fact), _spec(fact)) for fact in facts)
    return SectionTable("agreeing", "Facts that agree between places", ("fact", "places", "spec"), rows, detail=True)


def _places(fact: SourcedFact) -> str:
    return "; ".join(dict.fromkeys(citation.text() for citation in (*fact.sources, *fact.restated)))


def _reasons(keys: Sequence[InferredKey]) -> SectionTable:
    """The inferred keys; facts with the same reason share a row."""
    keys_by_reason: dict[tuple[str, str], list[InferredKey]] = {}
    for inferred_key in keys:
        keys_by_reason.setdefault((inferred_key.key, inferred_key.reason), []).append(inferred_key)
    rows: list[tuple[Cell, ...]] = []
    for (key, reason), inferred_keys in keys_by_reason.items():
        first = inferred_keys[0]
        rest_text = f" and {len(inferred_keys) - 1} more" if len(inferred_keys) > 1 else ""
        place = first.place["inferred"] if "inferred" in first.place else first.place["name"]
        rows.append((key, f"{first.path}{rest_text}", len(inferred_keys), reason, place))
    columns = ("key", "facts", "number", "reason", "spec")
    return SectionTable("inferred", "Inferred values", columns, tuple(rows), detail=len(rows) > 20)


def _elsewhere_figures(device: Device) -> list[Figure]:
    """The numbers of values that are not from the manual; none that are 0."""
    figures = (
        Figure("values that a standard defines", sum(len(fact.standard) for fact in facts_of(device))),
        Figure("reports of others, which no codec uses", sum(len(fact.reported) for fact in facts_of(device))),
        Figure("examples that were computed", sum(example.origin == COMPUTED for example in device.examples.values())),
    )
    return [figure for figure in figures if figure.number]


def _standards(device: Device) -> SectionTable:
    rows = tuple(
        (key, fact.place.path, standard.name, standard.clause, fact.place["standard"])
        for fact in facts_of(device)
        for key, standard in fact.standard.items()
    )
    columns = ("key", "fact", "standard", "clause", "spec")
    return SectionTable("standards", "Values from standards", columns, rows)


def _reported(device: Device) -> SectionTable:
    rows = tuple(
        (
            fact.place.path,
            ", ".join(f"{key} {value}" for key, value in report.values.items()),
            report.by,
            report.how,
            report.place["by"],
        )
        for fact in facts_of(device)
        for report in fact.reported
    )
    columns = ("fact", "says", "by", "how", "spec")
    return SectionTable("reported", "What others report", columns, rows, ("warning",) * len(rows))


def _computed(device: Device) -> SectionTable:
    rows = tuple(
        (example.id, example.title, " ".join(example.notes), example.place["id"])
        for example in device.examples.values()
        if example.origin == COMPUTED
    )
    return SectionTable("computed", "Computed values", ("example", "title", "how", "spec"), rows, detail=len(rows) > 20)


def _without_unit(device: Device) -> SectionTable:
    """Numbers without a printed unit, and without an explanation in the spec."""
    rows = tuple(
        (fact.place.path, fact.sources[0] if fact.sources else None, fact.place["name"])
        for fact in without_unit(device)
    )
    title = "Numbers without a unit"
    return SectionTable(
        "without_unit", title, ("fact", "source", "spec"), rows, ("warning",) * len(rows), detail=len(rows) > 20
    )


def _labels_elsewhere(subject: Subject) -> SectionTable:
    """Labels that are not on the lines that their facts cite; empty where the text itself is not at hand."""
    manual = subject.manual
    same = manual is not None and manual.offset == 0 and manual.sha256 == subject.device.manual.sha256
    elsewhere = labels_elsewhere(subject.device, manual.file.text) if manual is not None and same else ()
    rows = tuple((fact.place.path, fact.label, fact.sources[0], fact.place["label"]) for fact in elsewhere)
    title = "Labels that are not in the lines that their facts cite"
    columns = ("fact", "label", "source", "spec")
    return SectionTable("labels_elsewhere", title, columns, rows, ("warning",) * len(rows), detail=len(rows) > 20)


def _empty_cells(subject: Subject) -> SectionTable:
    """Facts whose row has an empty cell that the spec fills without an inference."""
    index = subject.manual or subject.recorded
    cells = empty_cells(subject.device, index) if index is not None else ()
    rows = tuple((cell.place.path, cell.print, cell.sources[0], cell.place["source"]) for cell in cells)
    title = "Facts with an empty cell in their row and nothing inferred"
    columns = ("fact", "row", "source", "spec")
    return SectionTable("empty_cells", title, columns, rows, ("warning",) * len(rows), detail=len(rows) > 20)


def _spec(fact: SourcedFact) -> Cell:
    return fact.place["source"] if "source" in fact.place else fact.place["name"]
