"""Facts that are not about bytes: lookup tables, limits, notes, examples, errata, accepted changes."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal

from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.fact import Citation, Fact, Place, ScalarValue


@dataclass(frozen=True, slots=True)
class Acceptance:
    """The rule `rule` may find a change at the fact with a path: why, and since when. `date` is as in 2026-01-31.

    `since` has the versions that bring the change, one for each line; it is empty where only the spec changed.
    """

    place: Place
    rule: str
    path: str
    reason: str
    date: str
    since: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class StatedChange:
    """An entry of a version overlay: what it does to a fact, and why.

    `kind` is `changes`, `removes`, `adds` or `renames`; `path` is that of the fact in the version that the overlay is
    based on, or of the new fact. `to` is its new name, empty but for `renames`.
    """

    place: Place
    kind: str
    path: str
    to: str
    reason: str
    sources: tuple[Citation, ...]

    @property
    def new_path(self) -> str:
        """The path in the version of the overlay."""
        return f"{self.path.rpartition('/')[0]}/{self.to}" if self.to else self.path


JUDGEMENT = "judgement"
"""The `proof` of an erratum that no check can decide."""


@dataclass(frozen=True, slots=True)
class Erratum:
    """The printed text of a fact, and how the spec differs from it. `proof` names a check, or is `judgement`.

    `illegible` is `empty` or `garbled` where nothing can be read there, else it is empty.
    """

    id: str
    place: Place
    fact: str
    printed: Mapping[str, object]
    literal: str
    illegible: str
    reason: str
    confidence: str
    effect: str
    proof: str
    sources: tuple[Citation, ...]

    @property
    def verdict(self) -> str:
        """`proven` by a check, a `judgement` of a person, or `open`: the manual does not decide it.

        A build has run the proof of every erratum that names one, and is refused where one fails to prove.
        """
        if self.proof != JUDGEMENT:
            return "proven"
        return "open" if self.confidence == "open" else "judgement"


@dataclass(frozen=True, slots=True)
class Example:
    """A frame and what it means. `values` is the meaning as the spec writes it; `refused` names why a decoder
    must refuse the frame, or is empty."""

    id: str
    place: Place
    title: str
    link: str
    direction: str
    message: str
    exception_response: bool
    refused: str
    reply_to: str
    frame: bytes
    elided: tuple[str, ...]
    characters: str
    values: Mapping[str, object]
    origin: str
    sources: tuple[Citation, ...]
    notes: tuple[str, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Limit(Fact):
    """A timing, a maximum, a supply: a value, bounds, or a text.

    `sum_of` are the paths of the limits that add up to this one, `within` is the path of a limit that it may not
    exceed. `transmits` is the direction of the longest frame that goes over the line after it, or empty.
    """

    kind: str
    value: Decimal | None
    low: Decimal | None
    high: Decimal | None
    text: str
    unit: str
    sum_of: tuple[str, ...]
    within: str
    transmits: str

    @property
    def most(self) -> Decimal | None:
        """The greatest value, None where none is stated."""
        return self.high if self.high is not None else self.value


@dataclass(frozen=True, slots=True)
class LookupColumn:
    """A column; `enum` names the enum whose members its cells name, or is empty."""

    name: str
    title: str
    label: str
    enum: str


@dataclass(frozen=True, slots=True)
class LookupRow:
    """A row of a lookup table: one cell for each column."""

    place: Place
    cells: tuple[ScalarValue, ...]
    notes: str
    sources: tuple[Citation, ...]
    only: tuple[str, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Lookup(Fact):
    """A table of pins, lamps, priorities, or anything else that is looked up."""

    title: str
    kind: str
    columns: tuple[LookupColumn, ...]
    rows: tuple[LookupRow, ...]


@dataclass(frozen=True, slots=True)
class Statement:
    """The statement of one place of the manual on a subject: it applies `always`, `sometimes` or `never`."""

    place: Place
    subject: str
    says: str
    text: str
    sources: tuple[Citation, ...]


@dataclass(frozen=True, slots=True)
class Note:
    """A caveat, the paths of the facts that it is about, and what places of the manual state of its subjects."""

    name: str
    place: Place
    title: str
    text: str
    about: tuple[str, ...]
    statements: tuple[Statement, ...]
    sources: tuple[Citation, ...]
