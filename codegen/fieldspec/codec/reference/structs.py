"""Records and values as the classes of construct that read and write them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import construct

from fieldspec.codec.layout.decision import MARK
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.codec.reference.digits import digits_of_number, number_of_digits
from fieldspec.codec.reference.texts import bytes_of_text, text_of_bytes
from fieldspec.foundation.caches import ByIdentity
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.encoding import Digits, Octets, Real, Sign, Text, Truth, Whole
from fieldspec.language.model.value import Value

_STRUCTS: ByIdentity[RecordLayout, construct.Struct] = ByIdentity(1024)
"""The newest structs: making one takes longer than using it."""


def record_struct(record: RecordLayout) -> construct.Struct:
    """A record as a construct Struct; its values are raw integers, bytes, lists and containers."""
    return _STRUCTS.get_or_compute(record, _struct)


def is_sequence(record: RecordLayout) -> bool:
    """Whether a struct can read a record: all fields have fixed sizes, and no end depends only on the data."""
    measured = {other.field.measures.field for other in record.fields if other.field.measures is not None}
    measured |= {field.name for field in record.fields if field.presence is not None}
    has_ends = all(not field.varies or field.name in measured for field in record.sent_fields[:-1])
    is_open = any(field.packing or field.continuation for field in record.fields)
    return has_ends and not record.has_differing and not is_open


def _struct(record: RecordLayout) -> construct.Struct:
    return construct.Struct(*(field.name / _construct(record, field) for field in record.sent_fields))


def _list_of_count(record: RecordLayout, field: FieldLayout) -> construct.Construct:
    """A list with fields after it: the number of elements in another field, in its room in an image."""
    continuation, element = field.continuation, _element(record, field)
    if continuation is None:
        elements = construct.Array(_number_of(record, field), element)
    else:
        ended = construct.RepeatUntil(lambda own, elements, context: not continuation.follows(own), element)
        elements = construct.IfThenElse(_is_sent(field), ended, element[0])
    room = record.room_of(field)
    return elements if room is None else construct.Padded(room.most, elements)


def _is_sent(field: FieldLayout) -> Callable[[Any], bool] | bool:
    """Whether a list whose elements say which is the last has a first element."""
    presence = field.presence
    return True if presence is None else lambda context: presence.is_met(context[presence.by])


def _number_of(record: RecordLayout, field: FieldLayout) -> Callable[[Any], int]:
    """The number of elements of a list, from the fields before it."""
    presence = field.presence
    if presence is not None:
        return lambda context: presence.elements(context[presence.by]) or 0
    pairs = ((other.name, other.measure) for other in record.fields)
    name, measure = next((name, own) for name, own in pairs if own is not None and own.field == field.name)
    unit = field.size if measure.of == "bytes" else 1
    return lambda context: int(context[name] - measure.plus) // unit


def _construct(record: RecordLayout, field: FieldLayout) -> construct.Construct:
    element = _element(record, field)
    if field.field.repeat is not None and record.room_of(field) is not None:
        return _list_of_count(record, field)
    if field.field.repeat is not None:
        is_last = field.field is record.record.fields[-1] or record.inner_lists is None
        return construct.GreedyRange(element) if is_last else _list_of_count(record, field)
    return element[field.count] if field.is_list else element


def _element(record: RecordLayout, field: FieldLayout) -> construct.Construct:
    """One element of a field; a record that differs in size is bytes of its greatest size."""
    if field.record is not None and field.record.size is None:
        return construct.Bytes(field.size)
    if field.record:
        return record_struct(field.record)
    if not field.cases:
        return value_construct(field.value, field.order, field.swapped)
    choice = field.field.choice
    assert choice is not None
    cases = {
        number: value_construct(case.value, case.order, case.swapped) for case in field.cases for number in case.numbers
    }
    if field.forms:
        cases = {number: construct.Padded(field.size, case) for number, case in cases.items()}
    number = construct.this[choice.by] if choice.mask is None else construct.this[choice.by] & choice.mask
    return construct.Switch(number, cases, default=construct.Error)


def value_construct(value: Value | None, order: str, swapped: bool) -> construct.Construct:
    """The construct that parses and builds one value."""
    assert value is not None
    if value.text_form is not None:
        return _Text(value, order)
    suffix = "b" if (order == "big") != swapped else "l"
    size, encoding = value.size, value.encoding
    match encoding:
        case Octets() if value.is_marked:
            return _Marked(construct.Bytes(value.image_size))
        case Text() | Octets():
            return construct.Bytes(size)
        case Digits():
            return _Digits(value, order, swapped)
        case Real():
            number = getattr(construct, f"Float{encoding.bits}{suffix}")
        case Truth():
            number = construct.BytesInteger(size, swapped=suffix == "l")
        case Whole():
            number = _whole(encoding, suffix == "l")
        case _:
            assert_never(encoding)
    if swapped:
        # Words in the other order than bytes: turn the bytes of each word, then read in the words' order.
        return construct.Transformed(number, _words_turned, size, _words_turned, size)
    return number


def _whole(whole: Whole, is_little: bool) -> construct.Construct:
    """The construct of a whole number, in two's complement or with a bit for its sign."""
    size = whole.bits // 8
    match whole.sign:
        case Sign.NONE | Sign.COMPLEMENT:
            return construct.BytesInteger(size, signed=whole.sign is Sign.COMPLEMENT, swapped=is_little)
        case Sign.MAGNITUDE:
            bits = construct.Sequence(construct.Flag, construct.BitsInteger(whole.bits - 1))
            pair = construct.Bitwise(_SignAndMagnitude(bits))
            return construct.ByteSwapped(pair) if is_little else pair
        case _:
            assert_never(whole.sign)


class _SignAndMagnitude(construct.Adapter):  # type: ignore[misc]
    """A number of a flag that is set below zero, and of the number without its sign."""

    def _decode(self, parts: Any, context: Any, path: str) -> int:
        is_negative, magnitude = parts
        return -int(magnitude) if is_negative else int(magnitude)

    def _encode(self, number: int, context: Any, path: str) -> list[Any]:
        return [number < 0, abs(number)]


class _Digits(construct.Adapter):  # type: ignore[misc]
    """A number that is sent as digits; invalid digits are parsed as None."""

    def __init__(self, value: Value, order: str, swapped: bool) -> None:
        super().__init__(construct.Bytes(value.size))
        self.value, self.swapped, self.is_reversed = value, swapped, (order == "big") == swapped

    def _decode(self, data: bytes, context: Any, path: str) -> int | None:
        return number_of_digits(self.value, self._turned(data))

    def _encode(self, number: int, context: Any, path: str) -> bytes:
        return self._turned(digits_of_number(self.value, number))

    def _turned(self, data: bytes) -> bytes:
        data = data[::-1] if self.is_reversed else data
        return _words_turned(data) if self.swapped else data


class _Marked(construct.Adapter):  # type: ignore[misc]
    """Bytes of varying length, with a mark after them."""

    def _decode(self, data: bytes, context: Any, path: str) -> bytes:
        return data[: data.rindex(MARK)]

    def _encode(self, data: bytes, context: Any, path: str) -> bytes:
        return (data + MARK).ljust(self.subcon.length, b"\0")


class _Text(construct.Adapter):  # type: ignore[misc]
    """A text in a special form; invalid bytes are parsed as None, and bytes are built unchanged."""

    def __init__(self, value: Value, order: str) -> None:
        super().__init__(construct.Bytes(value.size))
        self.value, self.order = value, order

    def _decode(self, data: bytes, context: Any, path: str) -> str | None:
        return text_of_bytes(self.value, self.order, data)

    def _encode(self, text: str | bytes, context: Any, path: str) -> bytes:
        return bytes_of_text(self.value, self.order, text) if isinstance(text, str) else text


def _words_turned(data: bytes) -> bytes:
    return b"".join(data[offset : offset + 2][::-1] for offset in range(0, len(data), 2))
