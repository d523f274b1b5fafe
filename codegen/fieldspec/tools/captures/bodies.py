"""The bodies of frames of one message and direction: judged as the codecs do, and their fields as columns."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby, takewhile

import numpy as np

from fieldspec.codec.layout.inner_lists import InnerList
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.codec.layout.widths import WidthError, extents, image_of, image_with_counts
from fieldspec.foundation.classes import dataclass
from fieldspec.tools.captures.columns import Bytes, Mask, Numbers, Verdicts, spread
from fieldspec.tools.captures.decoders import Decoders, ValueColumns
from fieldspec.tools.captures.part_numbers import field_numbers
from fieldspec.tools.captures.presences import counts_at, has_element, is_met, presence_bits
from fieldspec.tools.captures.slots import Slot, deepened, slots, with_deep_rooms
from fieldspec.tools.captures.verdicts import (
    INCOMPLETE,
    OK,
    REFUSED,
    UNKNOWN_VALUE,
    VERDICT_NUMBERS,
    WRONG_LENGTH,
    WRONG_MEASURE,
)

_UNFIT = {
    "incomplete": INCOMPLETE,
    "unknown_value": UNKNOWN_VALUE,
    "wrong_length": WRONG_LENGTH,
    "wrong_measure": WRONG_MEASURE,
}
"""The verdicts of bodies whose values vary in width."""


@dataclass(frozen=True, slots=True)
class Rooms:
    """For bodies with fields after lists, by the lists' names: the elements, and the verdict of a list without bytes.

    Instead of a number of elements there may be one of the numbers below zero.
    """

    items: dict[str, Numbers]
    verdicts: dict[str, Verdicts]


UNKNOWN, MISCOUNT = -2, -1
"""A list with an unknown start, or with less bytes than its count; a list whose count is impossible."""


@dataclass(frozen=True, slots=True)
class FieldRows:
    """Decoded values: the row of the frame of each, the text of its path, and its unit."""

    frame: Numbers
    path: str
    unit: str
    values: ValueColumns


class BodyReader:
    """Reads bodies that one record describes. `emits` is whether its fields are values of the tables.

    Fields of messages that access registers are not: what they carry are the registers.
    """

    def __init__(self, record: RecordLayout, decoders: Decoders, emits: bool) -> None:
        record = with_deep_rooms(record)
        self.record, self.decoders, self.emits = record, decoders, emits
        self.has_lists: bool = False
        """Whether it reads the images of bodies with fields after lists."""
        self.counts_of_texts: frozenset[str] = frozenset()
        """The fields with the bytes of a text that varies in width, which no image has."""
        self.slots = list(slots(record)) if record.selector is None else []
        self.image = BodyReader(record.image, decoders, emits) if record.spans or record.inner_lists else None
        if self.image is not None:
            self.image.has_lists = record.inner_lists is not None
            counts = (span.count for span in record.spans if span.count is not None)
            self.image.counts_of_texts = frozenset(record.spans[number].name for number in counts)
            self.image.slots = self.slots  # in the order of the wire, in which the first fault counts
        self.chosen = {id(choice): BodyReader(choice, decoders, emits) for choice in record.chosen.values()}

    def read(
        self, buffer: Bytes, offsets: Numbers, size: Numbers, verdict: Verdicts
    ) -> Iterator[tuple[Numbers, FieldRows]]:
        """Judges bodies of `size` bytes from `at` on, and yields their fields with the rows of the bodies.

        A verdict without a fault becomes the verdict of the first fault.
        """
        if self.image is not None:
            images = self._list_images if self.record.inner_lists is not None else self._images
            image, starts, sizes, rooms = images(buffer, offsets, size, verdict)
            yield from self.image._fields(image, starts, sizes, verdict, rooms)
            return
        if self.record.selector is None:
            yield from self._fields(buffer, offsets, size, verdict)
            return
        selector = self.record.selector
        short = selector.offset + selector.size > size
        number = field_numbers(selector, buffer, offsets)
        blame(verdict, short | (size < self.record.least), INCOMPLETE)
        decided = short.copy()
        for key in np.unique(number[~short]).tolist():
            record = self.record.chosen.get(key)
            if record is not None:
                rows = np.flatnonzero(~short & (number == key))
                decided[rows] = True
                own = verdict[rows]
                for frames, fields in self.chosen[id(record)].read(buffer, offsets[rows], size[rows], own):
                    yield rows[frames], fields
                verdict[rows] = own
        long = np.zeros(len(offsets), np.bool_) if self.record.most is None else size > self.record.most
        blame(verdict, ~decided & long, WRONG_LENGTH)
        blame(verdict, ~decided, UNKNOWN_VALUE)

    def _images(
        self, buffer: Bytes, offsets: Numbers, size: Numbers, verdict: Verdicts
    ) -> tuple[Bytes, Numbers, Numbers, Rooms | None]:
        """The images of bodies whose values vary in width, where each begins, and how far it goes."""
        images: list[bytes] = []
        sizes = np.zeros(len(offsets), np.int64)
        for row, (first, length) in enumerate(zip(offsets.tolist(), size.tolist(), strict=True)):
            data = buffer[first : first + max(length, 0)].tobytes()
            try:
                image = image_with_counts(self.record.spans, data, image_of(self.record.spans, data)[1])
            except WidthError as error:
                known = list(takewhile(lambda extent: extent.image is not None, extents(self.record.spans, data)))
                image = image_with_counts(self.record.spans, data, known)
                blame_rows(verdict, np.array([row]), _UNFIT[error.reason])
            sizes[row] = len(image)
            images.append(image.ljust(self.record.image.least, b"\0"))
        return *_joined(images), sizes, None

    def _list_images(
        self, buffer: Bytes, offsets: Numbers, size: Numbers, verdict: Verdicts
    ) -> tuple[Bytes, Numbers, Numbers, Rooms | None]:
        """The same of bodies with fields after lists; and what is known of these."""
        images: list[bytes] = []
        sizes = np.zeros(len(offsets), np.int64)
        inner = self.record.inner_lists
        assert inner is not None
        is_open = self.record.fields[-1].count is None and inner.last.sent_plus is None
        ending = inner.lists[:-1] if is_open else inner.lists
        rooms = {own.name: np.full(len(offsets), UNKNOWN) for own in ending}
        verdicts = {own.name: np.full(len(offsets), OK, np.int8) for own in inner.lists}
        for row, (first, length) in enumerate(zip(offsets.tolist(), size.tolist(), strict=True)):
            data = buffer[first : first + max(length, 0)].tobytes()
            list_extents, fault = inner.extents_in(data)
            image = deepened(self.record.image, inner.image_of(data, list_extents))
            for own, extent in zip(inner.lists, list_extents, strict=False):
                if own.sent_plus is not None:
                    image = own.with_number(image, extent.size + own.sent_plus)
            images.append(image)
            sizes[row] = len(images[-1])
            for own, extent in zip(ending, list_extents, strict=False):
                is_single = own.parts is not None or own.decision is not None
                items = extent.size // own.element if own.packing is None else extent.numbers
                rooms[own.name][row] = len(extent.elements) if is_single else items
            if fault is None:
                continue
            own = inner.lists[len(list_extents)]
            sizes[row] = min(own.first, len(data) - sum(extent.size for extent in list_extents))
            if own.count and (fault.reason, fault.at) == (
                "wrong_measure",
                inner.place_in_data(list_extents, own.count_at),
            ):
                rooms[own.name][row] = MISCOUNT
            elif own.parts is not None or own.decision is not None or own.packing is not None:
                verdicts[own.name][row] = VERDICT_NUMBERS[fault.reason]
        return *_joined(images), sizes, Rooms(rooms, verdicts)

    def _fields(
        self, buffer: Bytes, offsets: Numbers, size: Numbers, verdict: Verdicts, rooms: Rooms | None = None
    ) -> Iterator[tuple[Numbers, FieldRows]]:
        counts = {field.name: self._count(field, size) for field in self.record.fields}
        counts |= rooms.items if rooms is not None else {}
        last = self.record.fields[-1] if self.record.fields else None
        for _, own_slots in groupby(self.slots, lambda slot: id(slot.field)):
            elements: list[tuple[int, Numbers, FieldRows]] = []
            for slot in own_slots:
                field = slot.field
                if rooms is not None and field.name in rooms.verdicts:
                    own_verdicts = rooms.verdicts[field.name]
                    verdict[verdict == OK] = own_verdicts[verdict == OK]
                if field.count is None:
                    items = np.maximum(counts[field.name], 0)
                    rows, index = spread(items)
                elif field.varies and self.has_lists:
                    rows, index = np.flatnonzero(counts[field.name] == field.count), None
                else:
                    rows, index = np.flatnonzero(field.offset + field.size * field.count <= size), None
                    blame(verdict, field.offset + field.size * field.count > size, INCOMPLETE)
                value = slot.layout.value
                assert value is not None
                judged = value.const is not None or bool(value.enum or value.digits)
                if len(rows) and (self.emits or judged):
                    elements += self._slot(slot, buffer, offsets, rows, index, verdict)
                self._measure(slot, buffer, offsets, size, counts, verdict)
            # All values of an element come before those of the next one, as they are sent.
            for _, frames, columns in sorted(elements, key=lambda element: element[0]):
                yield frames, columns
            if slot.field is last:
                self._end(size, counts, verdict)
        self._end(size, counts, verdict)

    def _end(self, size: Numbers, counts: dict[str, Numbers], verdict: Verdicts) -> None:
        """Judges the size of bodies, when their last field has been read."""
        end = np.zeros(len(size), np.int64)
        for field in self.record.fields:
            room = size < field.offset + counts[field.name] * field.size
            minimum = field.field.repeat.low if field.field.repeat else 0
            blame(verdict, room | (counts[field.name] < minimum), INCOMPLETE)
            end = field.offset + counts[field.name] * field.size
        blame(verdict, size > end, WRONG_LENGTH)

    @staticmethod
    def _count(field: FieldLayout, size: Numbers) -> Numbers:
        """The number of elements of a field: all that fit if their number is free."""
        repeat = field.field.repeat
        if repeat is None or not field.size:
            return np.full(len(size), field.count or 0)
        return np.minimum((size - field.offset) // field.size, repeat.high)

    def _slot(
        self, slot: Slot, buffer: Bytes, offsets: Numbers, rows: Numbers, index: Numbers | None, verdict: Verdicts
    ) -> Iterator[tuple[int, Numbers, FieldRows]]:
        """The values of a slot, each with the number of its element in a list of free length."""
        layout, value = slot.layout, slot.layout.value
        assert value is not None
        key = self.decoders.place(value, layout.order, layout.swapped, layout.field.reserved)
        place = offsets[rows] + (0 if index is None else index * slot.field.size)
        for start, field, numbers in slot.numbers:
            is_chosen = np.isin(_deciding(field, buffer, place + start), sorted(numbers))
            rows, place = rows[is_chosen], place[is_chosen]
            index = index if index is None else index[is_chosen]
            if not len(rows):
                return
        for start, inner, number in slot.places:
            is_there = has_element(buffer, place + start, inner, number)
            rows, place = rows[is_there], place[is_there]
            index = index if index is None else index[is_there]
            if not len(rows):
                return
        place = place + slot.offset
        values = self.decoders.items[key].decode(buffer, place)
        if slot.text is not None:
            self._refuse_zeros(slot.text, buffer, place, values)
        for number in REFUSED:
            blame_rows(verdict, rows[values.verdict == number], number)
        if not self.emits:
            return
        if index is None:
            yield 0, rows, FieldRows(rows, slot.path, value.unit, values)
            return
        name = slot.field.name
        for number in range(int(index.max()) + 1):
            own = np.flatnonzero(index == number)
            path = slot.path.replace(name, f"{name}[{number}]", 1)
            yield number, rows[own], FieldRows(rows[own], path, value.unit, values_at(values, own))

    def _refuse_zeros(self, text: InnerList, buffer: Bytes, place: Numbers, values: ValueColumns) -> None:
        """Refuses texts at the end of records, which begin at a `place`, that have a zero among their bytes."""
        count = counts_at(buffer, place - text.room, text)
        count = (count if text.presence is None else presence_bits(text.presence, count)) - text.plus
        for row, (first, size) in enumerate(zip(place.tolist(), count.tolist(), strict=True)):
            data = buffer[first : first + size].tobytes()
            if 0 in data:
                values.text[row] = self.decoders.texts.place(data.hex(" ").upper())
                values.verdict[row] = UNKNOWN_VALUE

    def _measure(
        self, slot: Slot, buffer: Bytes, offsets: Numbers, size: Numbers, counts: dict[str, Numbers], verdict: Verdicts
    ) -> None:
        """Judges a field that measures another one, or is the number of bits that are packed into it; and one
        whose bits say how many elements others have.
        """
        self._judge_presence(slot, buffer, offsets, size, counts, verdict)
        if slot.layout is slot.field and slot.layout.bits_of:
            number = field_numbers(slot.layout, buffer, offsets)
            wrong = (number + 7) // 8 != np.maximum(counts[slot.layout.bits_of], 0)
            blame(verdict, wrong & (slot.offset + slot.layout.size <= size), WRONG_MEASURE)
            return
        measure = slot.layout.field.stated_measure if slot.layout is slot.field else None
        other = self.record.named(measure.field) if measure else None
        if measure is None or other is None or other.splits_record or slot.path in self.counts_of_texts:
            return
        room = self.record.room_of(other)
        if slot.layout.counts_sent or other.in_room or (room is not None and room.count == slot.path):
            blame(verdict, counts[other.name] == MISCOUNT, WRONG_MEASURE)
            return
        if measure.bits is not None:
            return
        items = np.clip((size - other.offset) // max(other.size, 1), 0, counts[other.name])
        items = np.maximum(items, 0) if other.is_list else np.ones(len(offsets), np.int64)
        expected = (items * other.size if measure.of == "bytes" else items) + measure.plus
        number = field_numbers(slot.layout, buffer, offsets)
        if room is not None:
            expected = counts[other.name] * (other.size if measure.of == "bytes" else 1) + measure.plus
            blame(verdict, (number != expected) & (counts[other.name] >= 0), WRONG_MEASURE)
            return
        if self.has_lists:
            blame(verdict, (number != expected) & (other.offset <= size), WRONG_MEASURE)
            return
        blame(verdict, (number != expected) & (slot.offset + slot.layout.size <= size), WRONG_MEASURE)

    def _judge_presence(
        self, slot: Slot, buffer: Bytes, offsets: Numbers, size: Numbers, counts: dict[str, Numbers], verdict: Verdicts
    ) -> None:
        for other in self.record.fields if slot.layout is slot.field else ():
            presence = other.presence
            if presence is not None and presence.by == slot.field.name:
                bits = field_numbers(slot.layout, buffer, offsets) & presence.mask
                items = counts[other.name]
                wrong = is_met(presence, bits) != (items > 0)
                if other.has_count_in_bits:
                    wrong = presence_bits(presence, bits) != items * presence.unit + presence.plus
                is_known = (items >= 0) & (slot.offset + slot.layout.size <= size) & (other.offset <= size)
                blame(verdict, (wrong & is_known) | (items == MISCOUNT), WRONG_MEASURE)


def _deciding(field: FieldLayout, buffer: Bytes, offsets: Numbers) -> Numbers:
    """The numbers that decide the type of a field of such records."""
    assert field.selector is not None
    number = field_numbers(field.selector, buffer, offsets)
    return number if field.deciding_bits is None else number & field.deciding_bits


def _joined(images: Sequence[bytes]) -> tuple[Bytes, Numbers]:
    """Images one after the other, and where each begins."""
    starts = np.cumsum([0, *map(len, images)])[:-1]
    # One more byte, since nothing is taken from a buffer without any.
    return np.frombuffer(b"".join([*images, b"\0"]), np.uint8), starts


def values_at(values: ValueColumns, rows: Numbers | Mask) -> ValueColumns:
    """Some rows of decoded values."""
    names = ("raw", "has_raw", "quantity", "has_quantity", "text", "verdict")
    return ValueColumns(*(getattr(values, name)[rows] for name in names))


def blame(verdict: Verdicts, rows: Mask, number: int) -> None:
    """Gives frames a verdict that have none other yet."""
    verdict[rows & (verdict == OK)] = number


def blame_rows(verdict: Verdicts, rows: Numbers, number: int) -> None:
    """The same for rows."""
    verdict[rows[verdict[rows] == OK]] = number
