"""Where each field of a record lies."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from fieldspec.model.primitive import Primitive
from fieldspec.model.record import Field, Record
from fieldspec.model.value import Value


@dataclass(frozen=True, slots=True)
class FieldLayout:
    """A field at `offset` bytes from the start of its record.

    `size` is that of one element in bytes. `count` is how many elements there are, None where they go on to
    the end of the data. Exactly one of `value` and `record` is given. `order` is the order of the bytes;
    `swapped` says that the 16-bit words of the value lie the least significant one first.
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

    @property
    def primitive(self) -> Primitive:
        """The type of its value; for fields that hold one."""
        assert self.value is not None
        return self.value.type

    @property
    def listed(self) -> bool:
        """Whether the field holds a list of elements."""
        return self.field.count is not None or self.field.repeat is not None

    @property
    def end(self) -> int | None:
        """The offset behind it, None where it goes on to the end of the data."""
        return None if self.count is None else self.offset + self.size * self.count


@dataclass(frozen=True, slots=True)
class RecordLayout:
    """Fields one behind the other. `size` is in bytes, None where the last field is repeated to the end.

    `least` and `most` bound the size; `most` is None where nothing bounds it.
    """

    record: Record
    name: str
    fields: tuple[FieldLayout, ...]
    size: int | None
    least: int
    most: int | None

    def named(self, name: str) -> FieldLayout | None:
        """The field with a name."""
        return next((field for field in self.fields if field.name == name), None)


@dataclass(frozen=True, slots=True)
class Orders:
    """The byte order and the word order around a value."""

    byte: str
    word: str

    def of(self, value: Value | None) -> tuple[str, bool]:
        """The byte order of a value, and whether its words are swapped."""
        byte = value.byte_order if value and value.byte_order else self.byte
        return byte, bool(value and value.size > 2 and value.type.letter not in "s" and self.word != byte)


def record_layout(record: Record, records: Mapping[str, RecordLayout], orders: Orders) -> RecordLayout:
    """The layout of a record whose inner records are laid out already."""
    at = 0
    fields = []
    repeated: FieldLayout | None = None
    for field in record.fields:
        inner = records[field.record] if field.record else None
        size = field.value.size if field.value else (inner.size or 0) if inner else 0
        count = None if field.repeat else field.count or 1
        order, swapped = orders.of(field.value)
        laid = FieldLayout(field, field.name, at, size, count, field.value, inner, order, swapped)
        fields.append(laid)
        if count is None:
            repeated = laid
        else:
            at += size * count
    if repeated is None:
        return RecordLayout(record, record.name, tuple(fields), at, at, at)
    repeat = repeated.field.repeat
    assert repeat is not None
    most = at + repeat.high * repeated.size
    return RecordLayout(record, record.name, tuple(fields), None, at + repeat.low * repeated.size, most)
