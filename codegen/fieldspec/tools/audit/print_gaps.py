"""The gaps of the manual about a fact: empty cells in its row, labels elsewhere, numbers without a unit."""

from __future__ import annotations

import unicodedata
from collections.abc import Iterator
from statistics import median_low

from fieldspec.foundation.classes import dataclass
from fieldspec.language.checks.facts import facts, values
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_count
from fieldspec.language.model.enums import Bit, Member
from fieldspec.language.model.fact import Citation, Fact, Place
from fieldspec.language.model.link import Part
from fieldspec.language.model.record import Field
from fieldspec.language.model.registers import Register
from fieldspec.language.model.texts import Lookup, LookupRow
from fieldspec.tools.audit.manual_lines import CELL, ManualIndex


@dataclass(frozen=True, slots=True)
class EmptyCell:
    """A fact, or a row of a lookup, with an explanation although its printed row has an empty cell.

    A row beside it has the cell filled. `print` is the row as the index of the manual has it.
    """

    place: Place
    sources: tuple[Citation, ...]
    print: str


def empty_cells(device: Device, index: ManualIndex) -> Iterator[EmptyCell]:
    """Members, bits and rows of lookups with an empty cell, of which nothing is inferred."""
    yield from _empty_cells_of_values(device, index)
    for lookup in device.lookups:
        if not lookup.inferred:
            yield from _empty_cells_of_lookup(lookup, index)


def _empty_cells_of_values(device: Device, index: ManualIndex) -> Iterator[EmptyCell]:
    """Members and bits with an empty cell between filled ones."""
    tables: dict[str, list[tuple[Fact, str, list[str]]]] = {}
    for fact in facts(device):
        if isinstance(fact, Member | Bit) and "source" in fact.place:
            row = _cited_line(fact, index)
            if row:
                cells = [cell.strip() for cell in row.split(CELL.strip())]
                tables.setdefault(fact.place.path.rpartition("/")[0], []).append((fact, row, cells))
    for rows in tables.values():
        widest = max(len(cells) for _, _, cells in rows)
        filled = {index for index in range(widest) if any(index < len(cells) and cells[index] for _, _, cells in rows)}
        for fact, row, cells in rows:
            filled_at = [index for index, cell in enumerate(cells) if cell]
            inner_indices = range(filled_at[0], filled_at[-1]) if filled_at else range(0)
            if (
                _explained(fact)
                and not fact.inferred
                and any(not cells[index] and index in filled for index in inner_indices)
            ):
                yield EmptyCell(fact.place, fact.sources, row)


def _empty_cells_of_lookup(lookup: Lookup, index: ManualIndex) -> Iterator[EmptyCell]:
    """Rows that fill more cells than printed, by more than most rows of the table do.

    A printed row that begins with an empty cell continues the row above it, and is not checked.
    """
    missing: list[tuple[LookupRow, str, int]] = []
    for row in lookup.rows:
        line = _last_line(row, index)
        cells = [cell.strip() for cell in line.split(CELL.strip())]
        if len(cells) > 1 and cells[0]:
            missing.append((row, line, sum(cell is not None for cell in row.cells) - sum(map(bool, cells))))
    usual = median_low(count for _, _, count in missing) if missing else 0
    for row, line, count in missing:
        if count > max(usual, 0):
            yield EmptyCell(row.place, row.sources, line)


def _last_line(row: LookupRow, index: ManualIndex) -> str:
    """The last line that a row cites in the section of its first citation, as the index has it."""
    lines = row.sources[0].lines if row.sources else ()
    return index.lines[lines[-1][1] - 1] if lines and 0 < lines[-1][1] <= len(index.lines) else ""


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


def _cited_line(fact: Fact, index: ManualIndex) -> str:
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
        if isinstance(fact, Part) or fact.place.path.startswith("messages/") or not is_count(value.encoding):
            continue
        explanation = value.unit or value.enum or value.flags or value.ranges or value.parameter or value.sentinels
        if explanation or value.const is not None or fact.notes or fact.reported or getattr(fact, "reserved", False):
            continue
        if isinstance(fact, Register) and fact.same_as:
            continue
        yield fact
