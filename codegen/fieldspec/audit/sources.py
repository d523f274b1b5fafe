"""How well the manual supports each fact, and the section of the report about it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

from fieldspec.audit.section import Cell, Figure, Section, SectionTable, Subject
from fieldspec.checks.facts import facts
from fieldspec.classes import dataclass
from fieldspec.model.device import Device
from fieldspec.model.fact import Citation, Place

NO_SECTION = "no section"

NOWHERE, ONE_PLACE, TOGETHER, AGREEING, DIFFERING = "nowhere", "one_place", "together", "agreeing", "differing"
STANDINGS = {
    ONE_PLACE: "one place",
    TOGETHER: "several places, taken together",
    AGREEING: "several places, which agree",
    DIFFERING: "several places, which differ",
    NOWHERE: "no place",
}
"""How many places print a fact, with the words for it."""


@dataclass(frozen=True, slots=True)
class Sourced:
    """A fact with the places that print it, those of what holds it where it has none of its own.

    `restated` are the other places that state it again, `errata` the corrections of what some of these places print.
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
        return next((one.section for one in self.sources if one.section), NO_SECTION)

    @property
    def standing(self) -> str:
        """One of STANDINGS."""
        if not self.sources:
            return NOWHERE
        if not self.restated:
            return ONE_PLACE if len(self.sources) == 1 else TOGETHER
        return DIFFERING if self.errata else AGREEING


@dataclass(frozen=True, slots=True)
class Inferred:
    """A key of a fact that the manual implies and does not print, with the reason."""

    path: str
    place: Place
    key: str
    reason: str
    section: str
    sources: tuple[Citation, ...]


def sourced(device: Device) -> list[Sourced]:
    """All facts with their places, in the order of the spec; what a protocol defines has those of the device."""
    corrected: dict[str, list[str]] = {}
    for erratum in device.errata:
        corrected.setdefault(erratum.fact.partition("/restated/")[0], []).append(erratum.id)
    held: dict[str, tuple[Citation, ...]] = {}
    found = []
    for fact in facts(device):
        path = fact.place.path
        own = fact.sources
        sources = own or held.get(path.rpartition("/")[0], ())
        held.setdefault(path, sources)
        again = tuple(one for claim in fact.restated for one in claim.sources)
        errata = tuple(corrected.get(path, ())) if again else ()
        own_place = "source" in fact.place or bool(own and own != held.get(path.rpartition("/")[0]))
        found.append(Sourced(path, fact.place, sources, not own_place, again, errata, fact.unverified))
    return found


def inferred(device: Device) -> Iterator[Inferred]:
    """Every key that is inferred, with its reason."""
    for fact in facts(device):
        for key, reason in fact.inferred.items():
            section = next((one.section for one in fact.sources if one.section), NO_SECTION)
            yield Inferred(fact.place.path, fact.place, key, reason, section, fact.sources)


def section_order(section: str) -> tuple[tuple[int, int, str], ...]:
    """A key that sorts sections as a manual has them: `9.2` before `10`, words behind numbers."""
    return tuple((0, int(part), "") if part.isdigit() else (1, 0, part) for part in section.split("."))


_SAYS = (
    "How many places of the manual print each fact. What two places print and agree in is surer than what only one "
    "prints; where they differ, an erratum says which one is right. What the manual only implies is inferred, with the "
    "reason."
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
    ]
    if unverified:
        figures.append(Figure("facts that nobody has verified", len(unverified), len(facts), False))
    tables = (
        _by_section(facts, keys),
        _source_table(
            "unsourced", "Facts without a source", [fact for fact in facts if fact.standing == NOWHERE], "bad"
        ),
        _source_table("unverified", "Facts that nobody has verified", unverified, "bad"),
        _differing([fact for fact in facts if fact.standing == DIFFERING]),
        _reasons(keys),
        _source_table(
            "one_place", "Facts that only one place prints", [f for f in facts if f.standing == ONE_PLACE], ""
        ),
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


def _source_table(name: str, title: str, facts: Sequence[Sourced], kind: str) -> SectionTable:
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


def _spec(fact: Sourced) -> Cell:
    return fact.place["source"] if "source" in fact.place else fact.place["name"]
