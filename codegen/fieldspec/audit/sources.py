"""The section of the report about sources: how well each fact is supported by the manual."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from fieldspec.audit.section import Cell, Figure, Section, SectionTable
from fieldspec.audit.sourcing import (
    AGREEING,
    DIFFERING,
    NOWHERE,
    ONE_PLACE,
    STANDINGS,
    TOGETHER,
    Inferred,
    Sourced,
    inferred,
    section_order,
    sourced,
)
from fieldspec.audit.subject import Subject
from fieldspec.audit.unsaid import empty_cells, labels_elsewhere, without_unit
from fieldspec.checks.walking import facts as facts_of
from fieldspec.model.device import Device
from fieldspec.model.provenance import COMPUTED

_SAYS = (
    "How many places of the manual print each fact. What two places print and agree in is surer than what only one "
    "prints; where they differ, an erratum says which one is right. What the manual only implies is inferred, with the "
    "reason. What a standard gives, what others report and what we have computed is not printed at all."
)


def sources(subject: Subject) -> Section:
    """Facts by the places that print them."""
    facts = sourced(subject.device)
    keys = list(inferred(subject.device))
    count = Counter(fact.standing for fact in facts)
    unverified = [fact for fact in facts if fact.unverified]
    figures = [
        Figure("facts without a source", count[NOWHERE], len(facts), count[NOWHERE] == 0),
        Figure("facts that several places print, which agree", count[AGREEING], len(facts)),
        Figure("facts that several places print, which differ", count[DIFFERING], len(facts)),
        Figure("facts that follow from several places together", count[TOGETHER], len(facts)),
        Figure("facts that only one place prints", count[ONE_PLACE], len(facts)),
        Figure("values that are inferred, with a reason", len(keys)),
        *_elsewhere_figures(subject.device),
    ]
    if unverified:
        figures.append(Figure("facts that nobody has verified", len(unverified), len(facts), False))
    tables = (
        _by_section(facts, keys),
        _listed("unsourced", "Facts without a source", [fact for fact in facts if fact.standing == NOWHERE], "bad"),
        _listed("unverified", "Facts that nobody has verified", unverified, "bad"),
        _differing([fact for fact in facts if fact.standing == DIFFERING]),
        _reasons(keys),
        _standards(subject.device),
        _reported(subject.device),
        _computed(subject.device),
        _without_unit(subject.device),
        _empty_cells(subject),
        _labels_elsewhere(subject),
        _listed("one_place", "Facts that only one place prints", [f for f in facts if f.standing == ONE_PLACE], ""),
        _agreeing([fact for fact in facts if fact.standing == AGREEING]),
    )
    return Section("sources", "Sources", (_SAYS,), tuple(figures), tables)


def _by_section(facts: Sequence[Sourced], keys: Sequence[Inferred]) -> SectionTable:
    standings: dict[str, Counter[str]] = {}
    for fact in facts:
        standings.setdefault(fact.section, Counter())[fact.standing] += 1
    implied = Counter(one.section for one in keys)
    rows: list[tuple[Cell, ...]] = []
    for section in sorted({*standings, *implied}, key=section_order):
        held = standings.get(section, Counter())
        numbers = [held[standing] or None for standing in STANDINGS]
        rows.append((section, sum(held.values()), *numbers, implied[section] or None))
    return SectionTable("by_section", "By section", ("section", "facts", *STANDINGS, "inferred"), tuple(rows))


def _listed(name: str, title: str, facts: Sequence[Sourced], kind: str) -> SectionTable:
    rows = tuple(
        (fact.path, fact.sources[0] if fact.sources else None, "of its holder" if fact.inherited else "", _spec(fact))
        for fact in facts
    )
    return SectionTable(
        name, title, ("fact", "source", "whose", "spec"), rows, (kind,) * len(rows), detail=len(rows) > 20
    )


def _differing(facts: Sequence[Sourced]) -> SectionTable:
    rows = tuple((fact.path, _places(fact), ", ".join(fact.errata), _spec(fact)) for fact in facts)
    columns = ("fact", "places", "errata", "spec")
    return SectionTable("differing", "Facts in which places differ", columns, rows, detail=len(rows) > 20)


def _agreeing(facts: Sequence[Sourced]) -> SectionTable:
    rows = tuple((fact.path, _places(fact), _spec(fact)) for fact in facts)
    return SectionTable("agreeing", "Facts in which places agree", ("fact", "places", "spec"), rows, detail=True)


def _places(fact: Sourced) -> str:
    return "; ".join(dict.fromkeys(one.text() for one in (*fact.sources, *fact.restated)))


def _reasons(keys: Sequence[Inferred]) -> SectionTable:
    """What is inferred, the facts that share a reason in one row."""
    together: dict[tuple[str, str], list[Inferred]] = {}
    for one in keys:
        together.setdefault((one.key, one.reason), []).append(one)
    rows: list[tuple[Cell, ...]] = []
    for (key, reason), held in together.items():
        first = held[0]
        more = f" and {len(held) - 1} more" if len(held) > 1 else ""
        place = first.place["inferred"] if "inferred" in first.place else first.place["name"]
        rows.append((key, f"{first.path}{more}", len(held), reason, place))
    columns = ("key", "facts", "number", "reason", "spec")
    return SectionTable("inferred", "What is inferred", columns, tuple(rows), detail=len(rows) > 20)


def _elsewhere_figures(device: Device) -> list[Figure]:
    """How much comes from elsewhere than the manual; what there is none of is left out."""
    figures = (
        Figure("values that a standard gives", sum(len(fact.standard) for fact in facts_of(device))),
        Figure("reports of others, which no codec uses", sum(len(fact.reported) for fact in facts_of(device))),
        Figure("examples that were computed", sum(one.origin == COMPUTED for one in device.examples.values())),
    )
    return [figure for figure in figures if figure.number]


def _standards(device: Device) -> SectionTable:
    rows = tuple(
        (key, fact.place.path, standard.name, standard.clause, fact.place["standard"])
        for fact in facts_of(device)
        for key, standard in fact.standard.items()
    )
    columns = ("key", "fact", "standard", "clause", "spec")
    return SectionTable("standards", "What a standard gives", columns, rows)


def _reported(device: Device) -> SectionTable:
    rows = tuple(
        (
            fact.place.path,
            ", ".join(f"{key} {said}" for key, said in one.values.items()),
            one.by,
            one.how,
            one.place["by"],
        )
        for fact in facts_of(device)
        for one in fact.reported
    )
    columns = ("fact", "says", "by", "how", "spec")
    return SectionTable("reported", "What others report", columns, rows, ("warning",) * len(rows))


def _computed(device: Device) -> SectionTable:
    rows = tuple(
        (one.id, one.title, " ".join(one.notes), one.place["id"])
        for one in device.examples.values()
        if one.origin == COMPUTED
    )
    return SectionTable(
        "computed", "What was computed", ("example", "title", "how", "spec"), rows, detail=len(rows) > 20
    )


def _without_unit(device: Device) -> SectionTable:
    """Numbers that the print leaves without a unit, and the spec without a word about it."""
    rows = tuple(
        (fact.place.path, fact.sources[0] if fact.sources else None, fact.place["name"])
        for fact in without_unit(device)
    )
    title = "Numbers of which nothing says what they count"
    return SectionTable(
        "without_unit", title, ("fact", "source", "spec"), rows, ("warning",) * len(rows), detail=len(rows) > 20
    )


def _labels_elsewhere(subject: Subject) -> SectionTable:
    """Labels that are not on the lines that their facts cite; none where the text itself is not at hand."""
    manual = subject.manual
    same = manual is not None and manual.offset == 0 and manual.sha256 == subject.device.manual.sha256
    elsewhere = labels_elsewhere(subject.device, manual.file.text) if manual is not None and same else ()
    rows = tuple((fact.place.path, fact.label, fact.sources[0], fact.place["label"]) for fact in elsewhere)
    title = "Labels that do not stand where their facts are cited"
    columns = ("fact", "label", "source", "spec")
    return SectionTable("labels_elsewhere", title, columns, rows, ("warning",) * len(rows), detail=len(rows) > 20)


def _empty_cells(subject: Subject) -> SectionTable:
    """Facts whose row has an empty cell, which somebody has filled without saying so."""
    index = subject.manual or subject.recorded
    cells = empty_cells(subject.device, index) if index is not None else ()
    rows = tuple((cell.fact.place.path, cell.print, cell.fact.sources[0], cell.fact.place["name"]) for cell in cells)
    title = "Facts with an empty cell in their row, and nothing inferred"
    columns = ("fact", "row", "source", "spec")
    return SectionTable("empty_cells", title, columns, rows, ("warning",) * len(rows), detail=len(rows) > 20)


def _spec(fact: Sourced) -> Cell:
    return fact.place["source"] if "source" in fact.place else fact.place["name"]
