"""What every fact of a manual has."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal

from fieldspec.classes import TYPE_CHECKING, dataclass
from fieldspec.model.place import Place
from fieldspec.model.provenance import Report, Standard

if TYPE_CHECKING:
    from typing import TypeAlias

Plain: TypeAlias = bool | int | Decimal | str | None


@dataclass(frozen=True, slots=True)
class Citation:
    """A place in the manual: a section, empty where none is given, and line intervals, both ends included."""

    section: str
    lines: tuple[tuple[int, int], ...]

    def line(self) -> int:
        """The first line."""
        return self.lines[0][0]

    def text(self) -> str:
        """`8.2 L1622` or `5.1 L1160-1163, 1170`"""
        numbers = ", ".join([f"{a}" if a == b else f"{a}-{b}" for a, b in self.lines])
        return f"{self.section} L{numbers}".strip()


@dataclass(frozen=True, slots=True)
class Claim:
    """What another place of the manual says of a fact, key by key, and that place."""

    place: Place
    sources: tuple[Citation, ...]
    values: Mapping[str, Plain]


@dataclass(frozen=True, slots=True, kw_only=True)
class Fact:
    """The name, the print, the sources and the caveats of a fact. `roles` are words of the schema.

    `inferred` has the reason, and `standard` the clause, for each key that the manual does not print; `reported` is
    what others say. `unverified` says that nobody has compared it with the manual yet. `since` and `until` have one
    version for each line that they are about.
    """

    name: str
    place: Place
    printed_name: str = ""
    label: str = ""
    doc: str = ""
    sources: tuple[Citation, ...] = ()
    notes: tuple[str, ...] = ()
    inferred: Mapping[str, str]
    standard: Mapping[str, Standard]
    reported: tuple[Report, ...] = ()
    roles: tuple[str, ...] = ()
    unverified: bool = False
    allowed: Mapping[str, str]
    restated: tuple[Claim, ...] = ()
    since: tuple[str, ...] = ()
    until: tuple[str, ...] = ()
    only: tuple[str, ...] = ()
