"""Lookups, limits, notes, examples, errata and accepted changes."""

from __future__ import annotations

from fieldspec.language.model.texts import (
    Acceptance,
    Erratum,
    Example,
    Limit,
    Lookup,
    LookupColumn,
    LookupRow,
    Note,
    StatedChange,
    Statement,
)
from fieldspec.language.model.units import DeclaredUnit
from fieldspec.language.reading.building.context import Entry, free
from fieldspec.language.reading.nodes import Scalar, Sequence, identity


def lookup(entry: Entry) -> Lookup:
    """The lookup table, of what is not on the wire, that an entry states."""
    columns = tuple(inner.built(LookupColumn) for inner in entry.entries("columns"))
    return entry.built(
        Lookup,
        kind=entry.text("kind") or "table",
        columns=columns,
        rows=tuple(_lookup_row(inner, len(columns)) for inner in entry.entries("rows")),
    )


def _lookup_row(entry: Entry, width: int) -> LookupRow:
    sequence = entry.node.values.get("cells")
    items = sequence.items if isinstance(sequence, Sequence) else ()
    cells = tuple(item.value for item in items if isinstance(item, Scalar))
    if len(cells) != width:
        text = f"the row has {len(cells)} cells, the table {width} columns"
        entry.refuse("wrong_size", "cells", text, "write `~` for an empty cell")
        cells = (cells + (None,) * width)[:width]
    return entry.built(LookupRow, cells=cells)


def limit(entry: Entry) -> Limit:
    """The limit, a single number with its unit, that an entry states."""
    return entry.built(
        Limit,
        kind=entry.text("kind") or "limit",
        low=entry.decimal("min"),
        high=entry.decimal("max"),
    )


def declared_unit(entry: Entry) -> DeclaredUnit:
    """A unit that the language does not have."""
    return entry.built(DeclaredUnit)


def note(entry: Entry) -> Note:
    """The note, a caveat of the manual, that an entry states."""
    return entry.built(
        Note,
        statements=tuple(
            inner.built(Statement, sources=inner.citations("source")) for inner in entry.entries("statements", "")
        ),
    )


def example(entry: Entry) -> Example:
    """The example, a frame with its meaning, that an entry states."""
    return entry.built(
        Example,
        frame=_frame(entry),
        characters=entry.text("characters").replace("\\r", "\r").replace("\\n", "\n"),
        values=free(entry.get("values")),
        origin=entry.text("origin") or "printed",
    )


def _frame(entry: Entry) -> bytes:
    try:
        return bytes.fromhex(entry.text("frame"))
    except ValueError:
        entry.refuse("wrong_form", "frame", "these digits are not whole bytes", "write pairs of hexadecimal digits")
        return b""


def erratum(entry: Entry) -> Erratum:
    """The erratum, a departure from what the manual prints, that an entry states."""
    return entry.built(Erratum, printed=free(entry.get("printed")))


def acceptance(entry: Entry) -> Acceptance:
    """The accepted change that an entry states."""
    return entry.built(Acceptance)


def stated_change(entry: Entry) -> StatedChange:
    """The change that an entry of a version overlay states."""
    kind, path = entry.text("kind"), entry.text("fact")
    if kind == "adds":
        item, path = entry.own.get("item"), entry.text("in")
        name = identity(item) if item is not None else None
        section, _, inner = path.partition("/")
        if section == "registers" and inner:  # the path of a register does not name its group
            path = section
        path = f"{path}/{name}" if name else path
    return entry.built(StatedChange, kind=kind, path=path)
