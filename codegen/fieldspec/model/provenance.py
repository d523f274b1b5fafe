"""Where a fact comes from when the manual does not print it: a standard, or somebody's report."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal

from fieldspec.classes import TYPE_CHECKING, dataclass
from fieldspec.model.place import Place

if TYPE_CHECKING:
    from typing import TypeAlias

Reported: TypeAlias = bool | int | Decimal | str | None

PRINTED, INFERRED, STANDARD, COMPUTED, REPORTED = "printed", "inferred", "standard", "computed", "reported"
PROVENANCES: Mapping[str, str] = {
    PRINTED: "the manual prints it, in a section and on a line",
    INFERRED: "the manual implies it, and a reason says how",
    STANDARD: "a standard gives it in a clause, and the manual does not print it",
    COMPUTED: "we have computed it from other facts",
    REPORTED: "somebody reports it, and the manual does not print it",
}
"""Every provenance of a fact, with what it means."""


@dataclass(frozen=True, slots=True)
class Standard:
    """A standard, by title and edition, and the clause that gives a fact."""

    name: str
    clause: str

    def text(self) -> str:
        """The standard and the clause in one line."""
        return ", ".join(part for part in (self.name, self.clause) if part)


@dataclass(frozen=True, slots=True)
class Report:
    """What somebody reports of a fact, key by key, who that is and how they know it. No codec uses it."""

    place: Place
    by: str
    how: str
    values: Mapping[str, Reported]
