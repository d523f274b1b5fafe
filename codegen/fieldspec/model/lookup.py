"""Tables that are not on the wire by themselves."""

from __future__ import annotations

from fieldspec.classes import dataclass
from fieldspec.model.fact import Citation, Fact, Plain
from fieldspec.model.place import Place


@dataclass(frozen=True, slots=True)
class Column:
    """A column; `enum` names the enum whose members its cells name, or is empty."""

    name: str
    title: str
    label: str
    enum: str


@dataclass(frozen=True, slots=True)
class Row:
    """A cell for each column."""

    place: Place
    cells: tuple[Plain, ...]
    notes: str
    sources: tuple[Citation, ...]
    only: tuple[str, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Lookup(Fact):
    """A table of pins, lamps, priorities, or anything else that is looked up."""

    title: str
    kind: str
    columns: tuple[Column, ...]
    rows: tuple[Row, ...]
