"""The registers that a frame reads or writes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from fieldspec.codec.explain import sentences
from fieldspec.codec.explain.occupants import (
    Occupant,
    absent_text,
    count_of_occupant,
    element_number,
    exponent_of_occupant,
    forbidden_text,
    is_within_span,
    located_table,
    occupants,
)
from fieldspec.codec.explain.row import ExplanationRow, Spot, fact_row
from fieldspec.codec.explain.spans import Span
from fieldspec.codec.explain.values import (
    DecodedValue,
    decode_answer,
    decode_value,
    exponent_applied,
    intervals_of,
    number_of,
)
from fieldspec.codec.layout.bases import moving_tables
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import replace
from fieldspec.language.model.value import Value


class RegisterRows:
    """The rows of some spans, each with its operation; they are made once, on demand."""

    __slots__ = ("_layout", "_rows", "_spans", "_spot")

    def __init__(self, layout: DeviceLayout | None, spot: Spot | None, spans: Sequence[tuple[str, Span]]) -> None:
        self._layout, self._spot, self._spans = layout, spot, spans
        self._rows: tuple[ExplanationRow, ...] | None = None

    @property
    def rows(self) -> tuple[ExplanationRow, ...]:
        """The rows, in the order of the spans."""
        if self._rows is None:
            layout, spot = self._layout, self._spot
            self._rows = (
                ()
                if layout is None or spot is None
                else tuple(
                    row for operation, span in self._spans for row in register_rows(layout, span, spot, operation)
                )
            )
        return self._rows

    def __eq__(self, other: object) -> bool:
        return isinstance(other, RegisterRows) and self.rows == other.rows

    def __hash__(self) -> int:
        return hash(self.rows)


NO_REGISTERS = RegisterRows(None, None, ())


def register_rows(layout: DeviceLayout, span: Span, spot: Spot, operation: str) -> Iterator[ExplanationRow]:
    """The rows of all registers that share words with a span, by address, and of words that no register has.

    `operation` is `read` or `write`. Registers that do not allow it have a note.
    """
    present = sorted(occupants(layout, span), key=lambda occupant: occupant.address)
    address = span.address
    for occupant in present:
        if occupant.address > address:
            yield _unlisted(layout, span, address, occupant.address, spot)
        address = max(address, occupant.address + occupant.words)
        row = _occupant_row(layout, span, occupant, spot, operation)
        reason = forbidden_text(operation, occupant.access)
        yield replace(row, notes=(*row.notes, sentences.IT.format(statement=reason))) if reason else row
    if address < span.end:
        yield _unlisted(layout, span, address, span.end, spot)


def _occupant_row(layout: DeviceLayout, span: Span, occupant: Occupant, spot: Spot, operation: str) -> ExplanationRow:
    piece = span.piece(occupant.address, occupant.value.size, occupant.skip)
    offset, raw = (piece.at, piece.raw) if piece else (0, b"")
    if piece:
        value = _by_exponent(layout, span, occupant, occupant.value_for(operation))
        arguments = (piece.content, occupant.order, occupant.is_swapped(operation), occupant.reserved)
        if operation == "write":
            read = decode_value(layout.device, value, *arguments)
        else:
            read = decode_answer(layout.device, value, *arguments, occupant.trigger)
    else:
        is_inside = is_within_span(occupant, span)
        partial = sentences.PARTIAL_ATOMIC if occupant.atomic else sentences.PARTIAL
        notes = () if is_inside else (partial.format(unit=span.unit),)
        read = replace(DecodedValue(None), notes=notes)
    row = fact_row(layout.device, "register", occupant.path, occupant.fact, spot, offset, raw, read, occupant.outer)
    if not piece:
        row = replace(row, offset=0, can_place="")
    row = replace(row, notes=(*row.notes, *_absence(layout, span, occupant)))
    return replace(row, address=occupant.address, words=occupant.words, unit=span.unit, access=occupant.access)


def _absence(layout: DeviceLayout, span: Span, occupant: Occupant) -> tuple[str, ...]:
    """The note of a field in an element that the device has not got, where the span has the count, too."""
    count = count_of_occupant(layout, occupant)
    piece = span.piece(count.address, count.value.size) if count is not None else None
    if count is None or piece is None:
        return ()
    number = number_of(count.value, piece.content, count.order, count.swapped)
    return (absent_text(count, number),) if isinstance(number, int) and element_number(occupant) >= number else ()


def _by_exponent(layout: DeviceLayout, span: Span, occupant: Occupant, value: Value) -> Value:
    """A value with its scale, where the exponent is elsewhere, and the span has it, too."""
    exponent = exponent_of_occupant(layout, occupant)
    piece = span.piece(exponent.address, exponent.value.size, exponent.skip) if exponent is not None else None
    if exponent is None or piece is None:
        return value
    number = number_of(exponent.value, piece.content, exponent.order, exponent.swapped)
    return exponent_applied(value, exponent.value, number)


def _unlisted(layout: DeviceLayout, span: Span, first: int, end: int, spot: Spot) -> ExplanationRow:
    """The row of words that no register has, with the reasons of the gaps there."""
    reasons = (
        gap.reason
        for group in layout.device.groups
        if layout.device.space_name(group.space) == layout.device.space_name(span.space)
        for gap in group.gaps
        if any(low < end and first <= high for low, high in gap.addresses.intervals)
    )
    start, raw = span.unlisted(first, end)
    offset, length, characters = spot.place(start, len(raw)) if raw else (0, 0, "")
    return ExplanationRow(
        kind="register",
        offset=offset,
        length=length,
        raw=raw,
        characters=characters,
        can_place=spot.can_place(start) if raw else "",
        doc=sentences.UNLISTED_REGISTER,
        notes=(*reasons, *_unknown_bases(layout, span, first, end)),
        address=first,
        words=end - first,
        unit=span.unit,
    )


def _unknown_bases(layout: DeviceLayout, span: Span, first: int, end: int) -> Iterator[str]:
    """What may be at addresses: elements of tables of which the frame does not say where they begin."""
    own = layout.device.space_name(span.space)
    for name, register in moving_tables(layout).items():
        table = layout.tables[name]
        reach = (table.table.count - 1) * table.table.stride + table.words
        if layout.device.space_name(table.table.space) != own or located_table(layout, table, span) is not None:
            continue
        intervals = intervals_of(register.register.value)
        if any(low < end and first < high + reach for low, high in intervals):
            yield sentences.ELEMENTS_OF_TABLE.format(table=name, register=register.name)
