"""The offsets of the fields of a record, and the byte and word order of each value."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import takewhile

from fieldspec.codec.layout.continuation import Continuation
from fieldspec.codec.layout.inner_lists import InnerList, InnerLists
from fieldspec.codec.layout.packing import Packing, packing_of
from fieldspec.codec.layout.presence import PresenceLayout, masked
from fieldspec.codec.layout.widths import Span
from fieldspec.foundation import classes
from fieldspec.foundation.classes import TYPE_CHECKING, dataclass, replace
from fieldspec.language.model.encoding import is_octets
from fieldspec.language.model.primitives import Primitive
from fieldspec.language.model.raw_numbers import orders_of
from fieldspec.language.model.record import Case, Field, Measure, Record
from fieldspec.language.model.registers import Register
from fieldspec.language.model.text_form import text_bytes
from fieldspec.language.model.value import Value

if TYPE_CHECKING:
    from typing import Any, Literal


@dataclass(frozen=True, slots=True)
class CaseLayout:
    """The type of a field if the deciding field, or its deciding bits in their place, is one of `numbers`.

    `order` and `swapped` are as in `FieldLayout`.
    """

    case: Case
    name: str
    numbers: frozenset[int]
    value: Value
    order: str
    swapped: bool


@dataclass(frozen=True, slots=True)
class FieldLayout:
    """A field at `offset` bytes from the start of its record.

    `size` is the size of one element in bytes. `count` is the number of elements, None if they go on to the end of the
    data. A field has either a `value`, or a `record`, or `cases`; `size` is then the size of the smallest case. Where
    other fields follow it, or its record is part of another one, `size` is that of the greatest case, and `forms`
    is the field as each number of the `selector`, a field before it, decides it, or of some of its bits.

    `order` is the order of the bytes; `swapped` if the order of the 16-bit words is the opposite one. For a field
    with the bytes of a parameter's value, `sizes` are the sizes of the value by the number in another field, of
    equal sizes the number to write first; it is empty if all bytes are the value. For the bit count of a write
    request, `bits_of` is the list into whose bytes the bits are packed; it is empty for other fields. `presence`
    says what decides whether it is sent, None where it always is. It `counts_sent` bytes of what differs in size. A
    `continuation` is what its elements say of the next. A text that varies in width is `in_room`, as a list is, where
    its record has lists, or bits that count it.
    """

    field: Field
    name: str
    offset: int
    size: int
    count: int | None
    value: Value | None
    record: RecordLayout | None
    order: str
    swapped: bool
    cases: tuple[CaseLayout, ...] = ()
    sizes: Mapping[int, int] = classes.field(default_factory=dict)
    bits_of: str = ""
    forms: Mapping[int, FieldLayout] = classes.field(default_factory=dict)
    selector: FieldLayout | None = None
    presence: PresenceLayout | None = None
    counts_sent: bool = False
    continuation: Continuation | None = None
    in_room: bool = False

    @property
    def measure(self) -> Measure | None:
        """Its measure in an image, where elements that differ in size are counted in place of their bytes."""
        measure = self.field.measures
        return replace(measure, of="items", plus=0) if measure is not None and self.counts_sent else measure

    @property
    def count_order(self) -> str:
        """The order of its bytes where it counts another field, or the form of its digits."""
        return self.value.digits if self.value is not None and self.value.digits else self.order

    @property
    def carries_bytes(self) -> bool:
        """Whether it has the bytes of the value of a parameter."""
        part = self.value.parameter if self.value is not None else None
        return part is not None and part.part == "value" and is_octets(self.primitive.encoding) and not self.is_list

    @property
    def primitive(self) -> Primitive:
        """The type of the value of a field that has one."""
        assert self.value is not None
        return self.value.type

    @property
    def is_list(self) -> bool:
        """Whether the field is a list of elements."""
        return self.field.count is not None or self.field.repeat is not None

    @property
    def varies(self) -> bool:
        """Whether its bytes differ from data to data."""
        size = self.record.size if self.record is not None else self.size
        is_decided = bool(self.forms) or (self.value is not None and self.value.width > 0)
        return self.count is None or size is None or is_decided or self.packing is not None

    @property
    def packing(self) -> Packing | None:
        """How its numbers are packed, None where each has whole bytes."""
        return packing_of(self.value, self.order)

    @property
    def sent_bounds(self) -> tuple[int, int]:
        """The least and the most bytes that are sent for it."""
        low, high = self.bounds
        if self.packing is not None:
            return self.packing.sent_size(low), self.packing.sent_size(high)
        return low * self.least_size, high * self.greatest_size

    @property
    def splits_record(self) -> bool:
        """Whether its record has a layout for each of its cases."""
        return bool(self.cases) and not self.forms

    @property
    def least_size(self) -> int:
        """The least bytes of an element."""
        if self.forms:
            return min(form.value.least_size for form in self.forms.values() if form.value is not None)
        return self.record.least if self.record is not None else 0 if self.in_room else self.size

    @property
    def greatest_size(self) -> int:
        """The most bytes that are sent for an element."""
        return max((form.value.size for form in self.forms.values() if form.value is not None), default=self.size)

    def form_in(self, image: bytes) -> FieldLayout | None:
        """The field as an image of its record decides it, None if that decides nothing."""
        if self.selector is None:
            return self
        order: Literal["big", "little"] = "big" if self.selector.order == "big" else "little"
        place = slice(self.selector.offset, self.selector.offset + self.selector.size)
        return self.form_of(int.from_bytes(image[place], order))

    def form_of(self, number: object) -> FieldLayout | None:
        """The field as a number of its selector decides it, None if that decides nothing; itself where it has none."""
        if self.selector is None:
            return self
        return self.forms.get(masked(number, self.deciding_bits)) if isinstance(number, int) else None

    @property
    def deciding_bits(self) -> int | None:
        """The mask of the bits of the selector that decide its type; None where all of them do."""
        return self.field.choice.mask if self.field.choice is not None else None

    def deciding(self, values: Mapping[str, Any]) -> int:
        """The number that its selector, which has a number among some values, has where it decides a type.

        It is that number, or else the first one that decides a type, with the other bits of that number.
        """
        assert self.selector is not None
        number: int = values[self.selector.name]
        if self.form_of(number) is not None:
            return number
        return self.with_case(number, min(self.forms))

    def with_case(self, number: int, case_number: int) -> int:
        """A number of its selector with the bits that decide it from another number, which decides a case."""
        return case_number | (0 if self.deciding_bits is None else number & ~self.deciding_bits)

    @property
    def bounds(self) -> tuple[int, int]:
        """How many elements it has, at least and at most."""
        return (repeat.low, repeat.high) if (repeat := self.field.repeat) is not None else (self.count or 1,) * 2

    @property
    def has_count_in_bits(self) -> bool:
        """Whether bits of an earlier field have its number of elements."""
        return self.presence is not None and not self.presence.numbers

    def least_count(self, values: Mapping[str, object]) -> int:
        """How many elements it has at least, with some raw values of the fields before it."""
        if self.presence is None or self.has_count_in_bits:
            return self.bounds[0]
        number = values.get(self.presence.by)
        return int(isinstance(number, int) and self.presence.is_met(number))

    @property
    def end(self) -> int | None:
        """The offset after the field, None if it continues to the end of the data."""
        return None if self.count is None else self.offset + self.size * self.count


@dataclass(frozen=True, slots=True)
class RecordLayout:
    """Fields that follow each other. `size` is in bytes, None if it varies, between `least` and `most`.

    `most` is None if nothing bounds the size. If the last field has cases, another field, the `selector`, decides its
    type, and `chosen` has the same record by the values of the selector, with the type that this value decides. `spans`
    are the spans of all fields if some vary in width; offsets and sizes of fields then refer to the image.
    `inner_lists` are the lists where one has fields after it. In `fields` they come last, and offsets are those in the
    image too. `rooms` are the lists of an image that another list follows.
    """

    record: Record
    name: str
    fields: tuple[FieldLayout, ...]
    size: int | None
    least: int
    most: int | None
    selector: FieldLayout | None = None
    chosen: Mapping[int, RecordLayout] = classes.field(default_factory=dict)
    spans: tuple[Span, ...] = ()
    inner_lists: InnerLists | None = None
    rooms: tuple[InnerList, ...] = ()

    @property
    def image(self) -> RecordLayout:
        """The layout of the image of the record, which codecs read and write.

        Each field that varies in width has all the bytes that it may have. Lists come last, and all but the last one of
        them have room for all elements.
        """
        if self.spans:
            size = sum(span.size for span in self.spans)
            return replace(self, spans=(), size=size, least=size, most=size)
        if self.inner_lists is None:
            return self
        *rooms, last = self.inner_lists.lists
        minimum, maximum = last.room + last.least, last.room + last.most
        return replace(self, inner_lists=None, rooms=tuple(rooms), least=minimum, most=maximum)

    @property
    def sent_fields(self) -> tuple[FieldLayout, ...]:
        """The fields in the order of the wire."""
        if self.inner_lists is None:
            return self.fields
        by_name = {field.name: field for field in self.fields}
        return tuple(by_name[field.name] for field in self.record.fields)

    @property
    def stated_fields(self) -> tuple[FieldLayout, ...]:
        """The fields that the spec states one by one, in the order of the wire: all but separators."""
        return tuple(field for field in self.sent_fields if not field.field.is_implied)

    @property
    def first_bytes(self) -> int:
        """The bytes before the first value that varies in width, or all where none does."""
        return sum(span.size for span in takewhile(lambda span: span.value is None, self.spans))

    @property
    def count_of_text(self) -> tuple[FieldLayout, int] | None:
        """The binary field with the bytes of the only value that varies, and all others less what it adds; or None."""
        varying = [span for span in self.spans if span.value is not None]
        if len(varying) != 1 or varying[0].count is None:
            return None
        count = self.fields[varying[0].count]
        if count.value is None or count.value.digits:
            return None
        other_bytes = sum(span.size for span in self.spans if span.value is None)
        return count, other_bytes - varying[0].plus

    def has_place(self, field: FieldLayout) -> bool:
        """Whether the offset of a field is its place in all data: nothing before it varies, nor is it moved."""
        if self.inner_lists is not None:
            return field.offset < self.inner_lists.lists[0].first
        varying_offset = next(
            (other.offset for other in self.fields if other.value is not None and other.value.width), None
        )
        return varying_offset is None or field.offset <= varying_offset

    @property
    def has_differing(self) -> bool:
        """Whether it has records that differ in size, texts among lists, or fields of several types before others."""
        return any(own.forms or own.in_room or (own.record and own.record.size is None) for own in self.fields)

    @property
    def has_single_list(self) -> bool:
        """Whether the number of elements of its only list, each of whole bytes, decides its size."""
        lists = [field for field in self.fields if field.count is None]
        is_open = any(field.packing or field.continuation for field in self.fields)
        return not self.has_differing and len(lists) == 1 and not is_open

    def room_of(self, field: FieldLayout) -> InnerList | None:
        """The room of a list that another list follows in an image, None for other fields."""
        return next((room for room in self.rooms if room.name == field.name), None)

    def rooms_before(self, field: FieldLayout) -> int:
        """How many lists, or records that differ in size, are sent before a field of an image."""
        return [other for other in self.fields if other.varies].index(field)

    def named(self, name: str) -> FieldLayout | None:
        """The field with a name, None if there is none."""
        return next((field for field in self.fields if field.name == name), None)

    def of_data(self, data: bytes) -> RecordLayout | None:
        """The record for some data: this one, or the one that the selector in it decides, None if it decides none."""
        if self.selector is None:
            return self
        offset = self.selector.offset
        selector_bytes = data[offset : offset + self.selector.size]
        order: Literal["big", "little"] = "big" if self.selector.order == "big" else "little"
        return (
            self.chosen.get(int.from_bytes(selector_bytes, order))
            if len(selector_bytes) == self.selector.size
            else None
        )

    def decided_by(self, values: Mapping[str, object]) -> RecordLayout:
        """The record with the types that some raw values decide, as far as they decide them."""
        if self.selector is not None:
            return self.of_number(_number_of(self.selector, values)) or self
        if not any(field.forms for field in self.fields):
            return self
        fields = (
            (field.form_of(_number_of(field.selector, values)) if field.selector is not None else None) or field
            for field in self.fields
        )
        return replace(self, fields=tuple(fields))

    def with_list_bits(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """Raw values with the bits that count lists and texts, or say that another element follows, as these are."""
        counts = [
            (own.presence, len(values[own.name])) for own in self.fields if own.presence and own.has_count_in_bits
        ]
        counts += [(bits, self._text_size(name, values)) for name, bits in self.bits_of_texts]
        numbers = {own.by: own.filled(values[own.by], size) for own, size in counts}
        lists = {own.name: own.continuation.ended(values[own.name]) for own in self.fields if own.continuation}
        return {**values, **numbers, **lists}

    @property
    def bits_of_texts(self) -> list[tuple[str, PresenceLayout]]:
        """The texts that bits count, and these bits."""
        lists = self.inner_lists.lists if self.inner_lists is not None else ()
        return [(inner.name, own) for inner in lists if (own := inner.presence) and inner.sent_plus is not None]

    def _text_size(self, name: str, values: Mapping[str, Any]) -> int:
        """The bytes that are sent for a text among some values."""
        field, text = self.named(name), values[name]
        assert field is not None
        assert field.value is not None
        data: bytes = text if isinstance(text, bytes) else text_bytes(field.value, field.order, text)
        return len(data.rstrip(b"\0"))

    def of_number(self, number: object) -> RecordLayout | None:
        """The record for a value of the selector, None if it decides none."""
        if self.selector is None:
            return self
        return self.chosen.get(number) if isinstance(number, int) else None


def _number_of(selector: FieldLayout, values: Mapping[str, object]) -> object:
    """The raw value of a selector among some values, else its constant."""
    return values.get(selector.name, selector.value.const if selector.value is not None else None)


@dataclass(frozen=True, slots=True)
class Orders:
    """The byte order and the word order of values without their own; `word` is empty where nothing has words."""

    byte: str
    word: str

    def of(self, value: Value | None) -> tuple[str, bool]:
        """The byte order of a value, and whether its words are swapped; digits that are characters are big-endian."""
        return orders_of(value, self.byte, self.word)


@dataclass(frozen=True, slots=True)
class RegisterLayout:
    """A register with its addresses, of which one element has `words`: words of 16 bits, or bytes in their spaces.

    `order` and `swapped` are as in `FieldLayout`.
    """

    register: Register
    name: str
    address: int
    words: int
    count: int
    stride: int
    order: str
    swapped: bool

    @property
    def numbers(self) -> tuple[int | str, ...]:
        """All of the layout but the register."""
        return self.name, self.address, self.words, self.count, self.stride, self.order, self.swapped

    @property
    def size(self) -> int:
        """The bytes at the addresses of one element; a value of odd size is filled up to whole words."""
        return self.register.unit_size * self.words
