"""Where the facts come from: how many places of the manual print each, and what is inferred or has no place at all."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.walking import facts
from fieldspec.classes import dataclass
from fieldspec.model.device import Device
from fieldspec.model.fact import Citation
from fieldspec.model.place import Place
from fieldspec.model.task import Task

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
        if isinstance(fact, Task) and not fact.steps:
            continue  # a question, or a reason, is printed nowhere
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
