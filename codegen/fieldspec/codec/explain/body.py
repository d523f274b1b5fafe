"""The body of a frame, field by field."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from fieldspec.codec.explain import sentences
from fieldspec.codec.explain.errata import errata_at
from fieldspec.codec.explain.parameters import with_parameter
from fieldspec.codec.explain.percentages import with_percentages
from fieldspec.codec.explain.row import ExplanationRow, Spot, fact_row, surplus_row, wrong_row
from fieldspec.codec.explain.values import ACCEPTED, DecodedValue, decoded_row, exponent_applied, repeated_value
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.inner_lists import InnerList
from fieldspec.codec.layout.list_extents import ListExtent
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.codec.layout.values import Raw
from fieldspec.codec.layout.widths import extents
from fieldspec.codec.program.interpreter import Place, Row, run_each
from fieldspec.codec.program.lowering import field_program
from fieldspec.foundation.classes import dataclass, replace
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.record import Message


@dataclass(frozen=True, slots=True)
class _TracedField:
    """The result of reading the bytes of a field."""

    name: str
    rows: list[Row]


class Body:
    """The body of a frame: the bytes of `data` from `start` to `end`, which `record` describes.

    `rows` and `values` go as far as the bytes do. `request_values` are the values of the request that the frame
    answers. `outer` is the message or the record; its sources stand in for fields without their own.
    """

    def __init__(
        self,
        layout: DeviceLayout,
        record: RecordLayout,
        outer: Fact,
        data: bytes,
        start: int,
        end: int,
        spot: Spot,
        request_values: Mapping[str, Raw],
    ) -> None:
        self.layout, self.outer, self.spot, self.asked = layout, outer, spot, request_values
        self.data, self.start, self.end = data, start, end
        self.record = record.of_data(data[start:end]) or record
        self.is_request = isinstance(outer, Message) and record.record is outer.request
        self.values: dict[str, Raw] = {}
        inner = self.record.inner_lists
        self.extents, self.fault = ([], None) if inner is None else inner.extents_in(data[start:end])
        self._rows_by_name: dict[str, Row] = {}
        # A scale may be after the value that it applies to, so all bytes are read before any row is written.
        traced = self._traced_varying() if self.record.spans else self._traced()
        self.rows = list(self._explained(list(traced)))

    def _explained(self, traced: list[_TracedField | ExplanationRow]) -> Iterator[ExplanationRow]:
        known = dict(self.asked)
        for part in traced:
            if isinstance(part, ExplanationRow):
                yield part
                continue
            for row in part.rows:
                yield self._row(row, known)
            if part.name in self.values:
                known[part.name] = self.values[part.name]

    def _traced(self) -> Iterator[_TracedField | ExplanationRow]:
        """The parts of a record in the order of the wire."""
        inner, fields = self.record.inner_lists, self.record.sent_fields
        offset, list_number = self.start, 0
        for number, field in enumerate(fields):
            if field.splits_record:
                yield self._undecided(field, offset)
                return
            if inner is not None and field.varies:
                if list_number == len(self.extents):
                    yield self._unknown_list(fields[number:], inner.lists[list_number], offset)
                    return
                extent = self.extents[list_number]
                list_number += 1
                yield from self._list(field, extent, offset)
                offset += extent.size
                continue
            count = self._count(field)
            room = max(0, min(count, (self.end - offset) // field.size)) if field.size else 0
            yield self._field(field, offset, [field.size] * room)
            offset += room * field.size
            if room < count:
                yield self._missing(fields[number:], offset)
                return
        if offset < self.end:
            yield surplus_row(self.spot, offset, self.data[offset : self.end])

    def _list(self, field: FieldLayout, extent: ListExtent, offset: int) -> Iterator[_TracedField | ExplanationRow]:
        """The parts of a list that has other fields after it."""
        stop, count = offset + extent.size, self._items(field)
        sizes = extent.elements or [field.size] * count
        form = self.record.decided_by(self.values).named(field.name)
        assert form is not None
        yield self._field(form, offset, sizes)
        end = stop if field.packing is not None else offset + sum(sizes)
        if field.field.repeat is not None and count < field.field.repeat.low:
            yield self._missing([field], end, stop)
        elif end < stop:
            yield surplus_row(self.spot, end, self.data[end:stop])

    def _unknown_list(self, fields: Sequence[FieldLayout], inner: InnerList, offset: int) -> ExplanationRow:
        """The row from the first list on whose bytes are not known."""
        assert self.fault is not None
        name, reason = fields[0].name, self.fault.reason
        if self._has_wrong_count(inner):
            text = sentences.WRONG_COUNT.format(count=inner.count, name=name)
        elif inner.decision is not None and reason == "unknown_value":
            text = self._undecided_text(inner.decision.name, name)
        elif (inner.decision is not None or inner.continuation is not None) and reason == "wrong_length":
            text = sentences.MORE_FOLLOW.format(name=inner.name, count=self.fault.at - (offset - self.start))
        elif inner.parts is not None and not inner.parts.lists and reason == "wrong_measure":
            text = sentences.MORE_ELEMENTS.format(name=inner.name, count=inner.most // inner.element)
        elif inner.packing is not None and reason == "wrong_length":
            text = sentences.MORE_THAN_BITS.format(name=inner.name, bits=inner.packing.number.bits)
        elif inner.parts is not None:
            place = self.spot.byte_text(self.start + self.fault.at)
            text = sentences.ELEMENTS_WITHOUT_END.format(name=name, place=place)
        elif self.end - self.start < self.record.least:
            return self._missing(fields, offset)
        elif inner.decision is not None:
            text = sentences.DECIDES_MORE.format(selector=inner.decision.name, name=name)
        elif inner.presence is not None and inner.presence.numbers:
            reason, text = "incomplete", sentences.SENT_WITHOUT_BYTES.format(count=inner.count, name=name)
        else:
            reason, text = "incomplete", sentences.COUNTS_MORE.format(count=inner.count, name=name)
        return self._wrong(fields[0], offset, reason, text)

    def _has_wrong_count(self, inner: InnerList) -> bool:
        """Whether the first list whose bytes are not known has an impossible count."""
        place = self.record.inner_lists.place_in_data(self.extents, inner.count_at) if self.record.inner_lists else 0
        fault = self.fault
        return bool(inner.count) and fault is not None and fault.reason == "wrong_measure" and fault.at == place

    def _items(self, field: FieldLayout) -> int:
        """How many elements of a list of a record with fields after a list there are."""
        inner = self.record.inner_lists
        assert inner is not None
        number = next(number for number, inner_list in enumerate(inner.lists) if inner_list.name == field.name)
        extent = self.extents[number]
        if inner.lists[number].packing is not None:
            return extent.numbers
        return (
            len(extent.elements)
            if extent.elements or inner.lists[number].parts is not None
            else min(extent.size // field.size, field.bounds[1])
        )

    def _traced_varying(self) -> Iterator[_TracedField | ExplanationRow]:
        """The parts of a record whose values vary in width."""
        fields = self.record.fields
        offset = self.start
        known = extents(self.record.spans, self.data[self.start : self.end])
        for field, span, extent in zip(fields, self.record.spans, known, strict=False):
            sizes = [field.size] * (field.count or 0) if span.value is None else [extent.stop - extent.start]
            yield self._field(field, self.start + extent.start, sizes)
            offset = self.start + extent.stop
        if len(known) < len(fields):
            reason, text = self._endless(len(known), offset)
            yield self._wrong(fields[len(known)], offset, reason, text)
        elif offset < self.end:
            yield surplus_row(self.spot, offset, self.data[offset : self.end])

    def _endless(self, number: int, offset: int) -> tuple[str, str]:
        """The reason why the end of a field is not known, as the reason of a codec and in words."""
        span = self.record.spans[number]
        if span.count is None or span.value is None:
            return "incomplete", sentences.WITHOUT_END.format(name=span.name)
        count = self.values[self.record.spans[span.count].name]
        if isinstance(count, int) and 0 <= count - span.plus <= span.value.width:
            rest = self.end - offset
            return "incomplete", sentences.FEWER_FOLLOW.format(name=span.name, count=count - span.plus, rest=rest)
        text = sentences.WRONG_SIZE.format(count=self.record.spans[span.count].name, name=span.name)
        return "wrong_measure", text

    def _count(self, field: FieldLayout) -> int:
        """The number of elements that the field should have: all that fit if their number is free."""
        repeat = field.field.repeat
        if repeat is None:
            return field.count or 0
        room = (self.end - self.start - field.offset) // field.size
        return min(max(room, repeat.low), repeat.high)

    def _missing(self, fields: Sequence[FieldLayout], offset: int, stop: int | None = None) -> ExplanationRow:
        """The row of the place where the body, or the bytes up to `stop`, are not enough for fields."""
        missing = self.record.least - (self.end - self.start)
        later = ", ".join(other.name for other in fields)
        return self._wrong(fields[0], offset, "incomplete", sentences.missing_text(missing, later), stop)

    def _undecided(self, field: FieldLayout, offset: int) -> ExplanationRow:
        """The row of a field whose type is open, because the field that decides it has a value without a case."""
        size, selector = self.end - self.start, self.record.selector
        assert selector is not None
        if size < self.record.least:
            return self._missing(self.record.fields[-1:], offset)
        if self.record.most is None or size <= self.record.most:
            return self._wrong(field, offset, "unknown_value", self._undecided_text(selector.name, field.name))
        text = sentences.UNDECIDED_TOO_LONG.format(
            selector=selector.name,
            number=repr(self.values[selector.name]),
            name=field.name,
            count=size - self.record.most,
        )
        return self._wrong(field, offset, "wrong_length", text)

    def _undecided_text(self, selector: str, name: str) -> str:
        """That a field whose value has no case does not decide the type of another one."""
        return sentences.UNDECIDED.format(selector=selector, number=repr(self.values[selector]), name=name)

    def _wrong(self, field: FieldLayout, start: int, reason: str, text: str, stop: int | None = None) -> ExplanationRow:
        """The row of the rest of the body, or of the bytes up to `stop`, where a field is expected."""
        path = field.field.place.path
        data = self.data[start : self.end if stop is None else stop]
        row = wrong_row(self.spot, start, data, reason, text, field.name, path)
        return replace(row, errata=errata_at(self.layout.device, path))

    def _field(self, field: FieldLayout, start: int, sizes: Sequence[int]) -> _TracedField:
        """The result of reading the elements of one field, which have the given sizes. Adds their values
        to `values`.
        """
        rows: list[Row] = []
        program = field_program(self.layout.device, self.record, field)
        values = run_each(program, Place(self.data, start, self.end), sizes, rows, self._rows_by_name)
        if field.is_list:
            self.values[field.name] = values
        elif values:
            self.values[field.name] = values[0]
        return _TracedField(field.name, rows)

    def _row(self, row: Row, known: Mapping[str, Raw]) -> ExplanationRow:
        """The row of what some bytes gave; `known` are the values of the fields before it and of the request."""
        device, field, value = self.layout.device, row.variable.field, row.variable.value
        assert field is not None
        exponent = row.rows_beside.get(row.variable.exponent)
        if exponent is not None:
            value = exponent_applied(value, exponent.variable.value, exponent.number)
        read = decoded_row(device, row, value)
        if row.rows_beside is self._rows_by_name:
            read = self._deciding(field, self._measured(field, self._repeated(field, read)))
        explained = fact_row(device, "field", row.path, field.field, self.spot, row.offset, row.raw, read, self.outer)
        explained = with_parameter(device, explained, field, row.index, known, self.outer, self.is_request)
        return with_percentages(device, explained, field, row.number)

    def _measured(self, field: FieldLayout, read: DecodedValue) -> DecodedValue:
        """The value of a field that measures another one, judged by the size of that field."""
        measure = field.field.measures
        other = self.record.named(field.bits_of or (measure.field if measure is not None else ""))
        if other is None or other.splits_record:
            return read
        inner = self.record.inner_lists
        span = next((span for span in self.record.spans if span.name == other.name and span.count is not None), None)
        room = self.end - self.start - other.offset
        if field.bits_of:
            size = max(0, min(self._count(other), room))
            low, high = (8 * size - 7, 8 * size) if size else (0, 0)
        elif measure is None:
            return read
        elif span is not None and span.value is not None:
            low, high = span.plus, span.value.width + span.plus
        elif inner is not None and other.varies:
            number = next(number for number, inner_list in enumerate(inner.lists) if inner_list.name == other.name)
            if number >= len(self.extents):
                return self._wrong_count(inner.lists[number], field, read)
            size = self.extents[number].size if field.counts_sent else self._items(other) * other.size
            low = size + measure.plus if measure.of == "bytes" else measure.number(self._items(other), 1)
            high = low
        else:
            items = self._items_at_end(other) if other.is_list else 1
            items = (other.count or 0) if self.record.spans else items
            low = measure.number(items, other.size)
            high = low
        is_right = isinstance(read.number, int) and low <= read.number <= high
        expected = low if low == high else sentences.BOUNDS.format(low=low, high=high)
        return read.judged(is_right, expected, "wrong_measure")

    def _items_at_end(self, field: FieldLayout) -> int:
        """How many elements of a list that ends the body there are."""
        return max(0, min(self._count(field), (self.end - self.start - field.offset) // field.size))

    def _deciding(self, field: FieldLayout, read: DecodedValue) -> DecodedValue:
        """The value of a field whose bits say how many elements others have, or bytes of a text, judged by these."""
        if self.record.inner_lists is not None and self.fault is not None:
            inner = self.record.inner_lists.lists[len(self.extents)]
            if inner.presence is not None and inner.sent_plus is not None:
                read = self._wrong_count(inner, field, read)
        for other in self.record.fields:
            presence, number = other.presence, read.number
            if presence is None or presence.by != field.name:
                continue
            if read.reason not in ACCEPTED or not isinstance(number, int):
                continue
            items = self._items_at_end(other) if self.record.inner_lists is None else self._items_if_known(other)
            if items is None and self.record.inner_lists is not None:
                unknown = self.record.inner_lists.lists[len(self.extents)]
                read = self._wrong_count(unknown, field, read) if unknown.name == other.name else read
            elif items is not None and not presence.fits(number, items):
                expected = presence.bits_text(items * presence.unit + presence.plus)
                if presence.numbers:
                    is_sent = sentences.NUMBER_IF_SENT if items else sentences.NUMBER_IF_ABSENT
                    expected = is_sent.format(name=other.name)
                return read.judged(False, expected, "wrong_measure")
        return read

    def _items_if_known(self, field: FieldLayout) -> int | None:
        """How many elements a list with fields after it has, None where its end is not known."""
        assert self.record.inner_lists is not None
        names = [inner.name for inner in self.record.inner_lists.lists[: len(self.extents)]]
        return self._items(field) if field.name in names else None

    def _wrong_count(self, inner: InnerList, field: FieldLayout, read: DecodedValue) -> DecodedValue:
        """The value of a field, which is wrong if the bytes of the list are not known because of its number."""
        if inner.count != field.name or not self._has_wrong_count(inner):
            return read
        low, high = inner.least // inner.unit + inner.plus, inner.most // inner.unit + inner.plus
        expected = sentences.BOUNDS.format(low=low, high=high)
        if inner.sent_plus is not None:
            expected = sentences.SIZE_OF_LIST.format(name=inner.name)
        expected = expected if inner.presence is None else inner.presence.bits_text(expected)
        return read.judged(False, expected, "wrong_measure")

    def _repeated(self, field: FieldLayout, read: DecodedValue) -> DecodedValue:
        """The value of a field that repeats one of the request, judged by the value there."""
        expected = self.asked.get(field.field.same_as)
        if read.reason or expected is None:
            return read
        return repeated_value(read, expected, field.value)
