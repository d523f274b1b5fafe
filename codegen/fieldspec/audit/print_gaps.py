"""What the print does not say about a fact: empty cells in its row, labels elsewhere, numbers without a unit."""

from __future__ import annotations

import unicodedata
from collections.abc import Iterator

from fieldspec.audit.manual_lines import CELL, ManualIndex
from fieldspec.checks.facts import facts, values
from fieldspec.classes import dataclass
from fieldspec.model.device import Device
from fieldspec.model.enums import Bit, Member
from fieldspec.model.fact import Fact
from fieldspec.model.link import Part
from fieldspec.model.record import Field
from fieldspec.model.registers import Register
from fieldspec.model.value import Kind


@dataclass(frozen=True, slots=True)
class EmptyCell:
    """A fact that the spec explains although its row has an empty cell where another row of the table has a text."""

    fact: Fact
    print: str


def empty_cells(device: Device, index: ManualIndex) -> Iterator[EmptyCell]:
    """Members and bits with an empty cell between filled ones, and without an inferred key."""
    tables: dict[str, list[tuple[Fact, str, list[str]]]] = {}
    for fact in facts(device):
        if isinstance(fact, Member | Bit) and "source" in fact.place:
            row = _row(fact, index)
            if row:
                cells = [cell.strip() for cell in row.split(CELL.strip())]
                tables.setdefault(fact.place.path.rpartition("/")[0], []).append((fact, row, cells))
    for rows in tables.values():
        widest = max(len(cells) for _, _, cells in rows)
        filled = {at for at in range(widest) if any(at < len(cells) and cells[at] for _, _, cells in rows)}
        for fact, row, cells in rows:
            filled_at = [at for at, cell in enumerate(cells) if cell]
            inside = range(filled_at[0], filled_at[-1]) if filled_at else range(0)
            if _explained(fact) and not fact.inferred and any(not cells[at] and at in filled for at in inside):
                yield EmptyCell(fact, row)


def labels_elsewhere(device: Device, text: str) -> Iterator[Fact]:
    """Facts whose label is on none of the lines that they cite. `text` is that of the manual; blanks do not count."""
    lines = [_bare(line) for line in text.split("\n")]
    corrected: dict[str, list[str]] = {}
    for erratum in device.errata:
        prints = (erratum.literal, str(erratum.printed.get("label", "")))
        corrected.setdefault(erratum.fact, []).extend(_bare(printed) for printed in prints if printed)
    for fact in facts(device):
        if not fact.label or "label" not in fact.place or "source" not in fact.place:
            continue
        if isinstance(fact, Field) and fact.signal:
            continue  # the label is that of the signal
        cited = "".join(
            line for source in fact.sources for first, last in source.lines for line in lines[first - 1 : last]
        )
        prints = (_bare(fact.label), *corrected.get(fact.place.path, ()))
        if not any(text in cited for text in prints):
            yield fact


def _bare(text: str) -> str:
    """A text in compatibility form, without blanks and without bars between cells."""
    return "".join(unicodedata.normalize("NFKC", text).replace("|", "").split())


def _row(fact: Fact, index: ManualIndex) -> str:
    """The index line of a fact that cites a single line; else empty."""
    lines = [interval for source in fact.sources for interval in source.lines]
    if len(lines) != 1 or lines[0][0] != lines[0][1] or not 0 < lines[0][0] <= len(index.lines):
        return ""
    return index.lines[lines[0][0] - 1]


def _explained(fact: Fact) -> bool:
    """Whether the spec explains a fact in its own words."""
    return bool(fact.doc) or (isinstance(fact, Bit) and bool(fact.zero or fact.one))


def without_unit(device: Device) -> Iterator[Fact]:
    """Numbers without any explanation: no unit, names, range, constant, note or report.

    Numbers in messages are left out: they are addresses, numbers of words and their like, or signals.
    """
    for fact, value in values(device):
        if isinstance(fact, Part) or fact.place.path.startswith("messages/") or value.type.kind is not Kind.INTEGER:
            continue
        explanation = value.unit or value.enum or value.flags or value.ranges or value.parameter or value.sentinels
        if explanation or value.const is not None or fact.notes or fact.reported or getattr(fact, "reserved", False):
            continue
        if isinstance(fact, Register) and fact.same_as:
            continue
        yield fact
