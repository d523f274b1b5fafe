"""A fact of a manual, and its place in the spec."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal

from fieldspec.foundation.classes import TYPE_CHECKING, dataclass

if TYPE_CHECKING:
    from typing import TypeAlias

    from fieldspec.foundation.source import Span, Spanned


@dataclass(frozen=True, slots=True, eq=False)
class Place:
    """The place of a fact: its path, its node, and the nodes of the values of its keys.

    A node is anything with a span. Spans are computed on demand.
    """

    path: str
    stated: Spanned
    values: Mapping[str, Spanned]

    @property
    def whole(self) -> Span:
        """The span of the whole fact, as opposed to one of its keys."""
        return self.stated.span

    @property
    def spans(self) -> dict[str, Span]:
        """The spans of the values of its keys."""
        return {key: value.span for key, value in self.values.items()}

    def __getitem__(self, key: str) -> Span:
        """The span of a key's value; where the key is missing, the span of the fact's name."""
        values = self.values
        value = values.get(key) or values.get("name") or values.get("id") or self.stated
        return value.span

    def __contains__(self, key: object) -> bool:
        return key in self.values


ScalarValue: TypeAlias = bool | int | Decimal | str | None


LINES, PAGES = "L", "P"
"""The marks of the numbers in a citation: lines of a text, or pages."""


@dataclass(frozen=True, slots=True)
class Citation:
    """A place in the manual: a section, empty where none is stated, and intervals of lines, both ends included.

    With the `mark` of pages, the intervals are of pages; a page on the web has sections alone, without a mark.
    """

    section: str
    lines: tuple[tuple[int, int], ...]
    mark: str = LINES

    def first(self) -> int:
        """The first line or page; 0 where there are sections alone."""
        return self.lines[0][0] if self.lines else 0

    def line(self) -> int | None:
        """The first line, None in a manual without lines."""
        return self.first() if self.mark == LINES else None

    def text(self) -> str:
        """`8.2 L1622`, `5.1 L1160-1163, 1170`, `8.2 P17` or `8.2`"""
        numbers = ", ".join([f"{a}" if a == b else f"{a}-{b}" for a, b in self.lines])
        return f"{self.section} {self.mark}{numbers}".strip()


@dataclass(frozen=True, slots=True)
class Claim:
    """The statement of a fact at another place of the manual, by key, and that place."""

    place: Place
    sources: tuple[Citation, ...]
    values: Mapping[str, ScalarValue]


PRINTED, INFERRED, STANDARD, COMPUTED, REPORTED = "printed", "inferred", "standard", "computed", "reported"
"""The provenances of a fact: the manual prints or implies it, a standard has it, we compute it, somebody reports it."""


@dataclass(frozen=True, slots=True)
class Standard:
    """A standard, by title and edition, and the clause that states a fact."""

    name: str
    clause: str

    def text(self) -> str:
        """The standard and the clause in one line."""
        return ", ".join(part for part in (self.name, self.clause) if part)


@dataclass(frozen=True, slots=True)
class Report:
    """What somebody reports of a fact, by key, who reports it and how they know. No codec uses it."""

    place: Place
    by: str
    how: str
    values: Mapping[str, ScalarValue]


@dataclass(frozen=True, slots=True, kw_only=True)
class Fact:
    """The name, the printed form, the sources and the caveats of a fact. `roles` are words of the schema.

    `inferred` has the reason, and `standard` the clause, for each key that the manual does not print; `reported` is
    what others say. `unverified` says that not compared with the manual yet. `since` and `until` have one
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
