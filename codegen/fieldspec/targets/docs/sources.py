"""Where the facts come from: everything with a source, and what is inferred."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import TypeAlias

from fieldspec.language.model.attributes import descendants
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Claim, Fact
from fieldspec.language.model.link import Link, UnitAddresses
from fieldspec.language.model.record import Field
from fieldspec.language.model.registers import PrintedElement, Table
from fieldspec.language.model.texts import Example, Lookup, LookupRow, Note, Statement
from fieldspec.targets.docs.document import Footnote, Line, Piece, code, joined, styled, text_piece

Holder: TypeAlias = Fact | Claim | Example | Note | Statement | UnitAddresses | PrintedElement | LookupRow


def holders(device: Device) -> dict[str, Holder]:
    """The facts of a device by path, in the order of the spec's sections."""
    return {holder.place.path: holder for holder in _all_holders(device)}


def _all_holders(device: Device) -> Iterator[Holder]:
    for item in descendants(device):
        if isinstance(item, Fact) and not (isinstance(item, Field) and item.is_implied):
            yield item
            yield from item.restated
        if isinstance(item, Link) and item.unit_addresses is not None:
            yield item.unit_addresses
        elif isinstance(item, Table):
            yield from item.elements
        elif isinstance(item, Lookup):
            yield from item.rows
        elif isinstance(item, Note):
            yield item
            yield from item.statements
        elif isinstance(item, Example):
            yield item


# Which cell of a row shows a key of the spec. All other keys are marked at the name.
CELLS = {
    "type": "type",
    "length": "type",
    "const": "type",
    "unit": "unit",
    "scale": "unit",
    "offset": "unit",
    "range": "range",
    "unit_range": "range",
    "default": "default",
    "unit_default": "default",
    "access": "access",
    "restart": "restart",
}


class Inferences:
    """The inferred keys of one table. Each reason is written once, however many rows share it."""

    def __init__(self, anchor: str) -> None:
        self.anchor = anchor
        self._marks: dict[tuple[str, str], int] = {}

    def marks(self, inferred: Mapping[str, str], cell: str = "") -> Line:
        """The marks of the inferred keys that one cell of a row shows; `cell` is empty for that of the name."""
        return tuple(self._mark(key, reason) for key, reason in inferred.items() if CELLS.get(key, "") == cell)

    def all_marks(self, inferred: Mapping[str, str]) -> Line:
        """The marks of all inferred keys, for rows that have no cells of their own for them."""
        return tuple(self._mark(key, reason) for key, reason in inferred.items())

    def _mark(self, key: str, reason: str) -> Piece:
        number = self._marks.setdefault((key, reason), len(self._marks) + 1)
        return Piece(f"i{number}", "mark", f"#{self.anchor}/i{number}")

    def footnotes(self) -> tuple[Footnote, ...]:
        """The reasons, in the order of their marks."""
        return tuple(
            Footnote(f"i{number}", f"{self.anchor}/i{number}", _reason(key, reason))
            for (key, reason), number in self._marks.items()
        )


def reasons(inferred: Mapping[str, str]) -> Iterable[Line]:
    """Inferred keys and their reasons as lines, where there is no table to put marks in."""
    for key, reason in inferred.items():
        yield _reason(key, reason)


def _reason(key: str, reason: str) -> Line:
    return (styled(f"{key} is inferred: ", "strong"), text_piece(reason))


def provenance_lines(fact: Fact) -> Iterable[Line]:
    """A line for each key that a standard gives, and for each report, with their marks."""
    for key, standard in fact.standard.items():
        yield (
            styled("standard", "badge"),
            text_piece(" "),
            code(key),
            text_piece(f" is from {standard.text()}; the manual does not print it."),
        )
    for report in fact.reported:
        values = joined((text_piece(f"{key} "), code(str(value))) for key, value in report.values.items())
        yield (styled("reported", "badge"), text_piece(" "), *values, text_piece(f" by {report.by}: {report.how}"))
