"""Values for self-tests and their bytes, worked out from the layout by other means than the C functions."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any

from fieldspec.codec.layout.bit_counts import fitting_bit_count
from fieldspec.codec.layout.bits import packed_size
from fieldspec.codec.layout.decision import MARK
from fieldspec.codec.layout.presence import masked
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.codec.layout.widths import data_of
from fieldspec.foundation.classes import dataclass, replace
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.device import Device
from fieldspec.language.model.digits import digits_bytes
from fieldspec.language.model.encoding import (
    Digits,
    Octets,
    Real,
    Text,
    Truth,
    Whole,
    bounds_of,
    is_array,
    real_bits,
    whole_bits,
)
from fieldspec.language.model.text_form import UTF_16, text_bytes
from fieldspec.language.model.value import Value
from fieldspec.targets.c.enums import available_members
from fieldspec.targets.c.fields import case_member, count_member, greatest_count, is_set_by_user, members
from fieldspec.targets.c.naming import member

ValuePicker = Callable[[Device, Value], Any]


# Records whose selector has a value


@dataclass(frozen=True, slots=True)
class RecordForm:
    """A record without cases, and the record with cases of which it is a form: that one has the struct.

    `cases` are the members of unions, by the names of the fields that are unions; empty for one of a constant.
    """

    record: RecordLayout
    struct: RecordLayout
    cases: Mapping[str, str]

    @property
    def case(self) -> str:
        """The cases in a description."""
        return ".".join(filter(None, self.cases.values()))

    def member_names(self, field: FieldLayout) -> tuple[str, ...]:
        """The member that has a field's values, and the member in that one where it is a union."""
        name, case = member(field.name), self.cases.get(field.name)
        return (name, case) if case else (name,)

    def count_name(self, field: FieldLayout) -> str:
        """The member that has the number of elements."""
        return count_member(self.struct, field)


def all_forms(device: Device, record: RecordLayout) -> Iterator[tuple[RecordForm, dict[str, Any]]]:
    """Each form of a record, and the value of the selector that chooses it, if the selector may have it."""
    if record.selector is None:
        for selection in _selections(device, record):
            values = record_value(device, record, selection)
            yield form_of_values(record, values), {name: values[name] for name in selection if name in values}
        return
    in_struct = record.selector in members(record)
    selector = record.selector.value
    enum = device.enums[selector.enum] if selector is not None and selector.enum else None
    for number in record.chosen:
        chosen_by = enum.member(number) if enum is not None and not enum.open else None
        if chosen_by is not None and chosen_by.unavailable:
            continue
        values = {record.selector.name: number}
        yield form_of_values(record, values), values if in_struct else {}


def form_of_values(record: RecordLayout, values: Mapping[str, Any]) -> RecordForm:
    """The form of a record that has some values."""
    if record.selector is None:
        cases = {
            field.name: case_member(case)
            for field in record.fields
            for case in field.cases
            if masked(_number(field, values), field.deciding_bits) in case.numbers
        }
        fields = tuple(_decided(field, values) for field in record.fields)
        return RecordForm(replace(record, fields=fields) if cases else record, record, cases)
    constant = record.selector.value.const if record.selector.value is not None else None
    number = values[record.selector.name] if constant is None else constant
    case = next(case for case in record.fields[-1].cases if number in case.numbers)
    return RecordForm(record.chosen[number], record, {record.fields[-1].name: case_member(case)})


def _number(field: FieldLayout, values: Mapping[str, Any]) -> Any:
    """The number of the selector of a field among some values, or its constant."""
    assert field.selector is not None
    assert field.selector.value is not None
    constant = field.selector.value.const
    return values[field.selector.name] if constant is None else constant


def _decided(field: FieldLayout, values: Mapping[str, Any]) -> FieldLayout:
    """A field as the values of its record decide it."""
    form = field if field.selector is None else field.form_of(_number(field, values))
    assert form is not None
    return form


def _selections(device: Device, record: RecordLayout) -> Iterator[dict[str, int]]:
    """Numbers of all selectors of a record, so that each case of each field is in one of them."""
    numbers = {
        field.selector.name: selecting_numbers(device, record, field.selector)
        for field in record.fields
        if field.selector is not None
    }
    usual = {name: own[0] for name, own in numbers.items()}
    selections = [{**usual, name: number} for name, own in numbers.items() for number in own]
    yield from selections or [{}]


def selecting_numbers(device: Device, record: RecordLayout, selector: FieldLayout) -> list[int]:
    """The numbers of a selector with which each field that it decides has a type, and which may be sent."""
    deciding = [own for own in record.fields if own.selector is not None and own.selector.name == selector.name]
    value = selector.value
    if not deciding or value is None:
        return []
    word = device.flags.get(value.flags)
    numbers = {value.const if value.const is not None else word.nearest(word.initial) if word is not None else 0}
    for field in deciding:
        numbers = {field.with_case(number, own) for number in numbers for own in field.forms}
    enum = device.enums.get(value.enum)
    barred = {member.value for member in enum.members if member.unavailable} if enum and not enum.open else set()
    ranges = value.writable_ranges
    return [
        number
        for number in sorted(numbers - barred)
        if (value.const is None or number == value.const)
        and (ranges is None or number in ranges)
        and (word is None or word.refused_bit(number) is None)
        and all(field.form_of(number) is not None for field in deciding)
    ]


# Values


def low_value(device: Device, value: Value) -> Any:
    """A value that is always taken: 0 where it is in range."""
    match value.encoding:
        case Text():
            return ""
        case Octets():
            return bytes(value.size)
        case Real():
            return 0.0 if value.ranges is None or 0 in value.ranges else float(value.ranges.low)
        case Whole() | Digits() | Truth():
            numbers = legal_numbers(device, value)
            return 0 if 0 in numbers else numbers[0]
        case _:
            assert_never(value.encoding)


def high_value(device: Device, value: Value) -> Any:
    """A value that is as different from it as can be."""
    encoding = value.encoding
    match encoding:
        case Text():
            if encoding.form is not None:
                return text_sample(value)
            return "".join(chr(0x41 + index % 26) for index in range(encoding.size))
        case Octets():
            return bytes((0xA1 + index) & 0xFF for index in range(encoding.size))
        case Real():
            return -1.5 if value.ranges is None else float(value.ranges.high)
        case Whole() | Digits() | Truth():
            return legal_numbers(device, value)[-1]
        case _:
            assert_never(encoding)


def text_sample(value: Value) -> str:
    """The longest text of a form, of characters that are not ASCII where the encoding has them."""
    form = value.text_form
    assert form is not None
    letters, size = {"latin_1": ("\xc4", 1), "utf_8": ("\xc4", 2), UTF_16: ("\u03a9", 2)}.get(form.encoding, ("A", 1))
    return letters * (form.room(value.size) // size)


def legal_numbers(device: Device, value: Value) -> list[int]:
    """Numbers that are taken, the least and the greatest of each interval among them."""
    ranges = value.writable_ranges
    if value.enum and not device.enums[value.enum].open:
        numbers = sorted(member.value for member in available_members(device.enums[value.enum]))
        permitted = [number for number in numbers if ranges is None or number in ranges]
        return permitted or numbers
    numbers = [0, *bounds_of(value.encoding)]
    if ranges is not None:
        numbers = [bound for pair in ranges.intervals for bound in pair]
    if value.flags:
        words = [device.flags[value.flags].nearest(number) for number in numbers]
        numbers = [word for word in words if ranges is None or word in ranges] or numbers
    return numbers


def record_value(
    device: Device, record: RecordLayout, selection: Mapping[str, int] | None = None, pick: ValuePicker = low_value
) -> dict[str, Any]:
    """Values for all members of a record, low ones usually; lists are as short as they may be, but not empty.

    `selection` are the numbers of some selectors.
    """
    values: dict[str, Any] = {}
    for field in members(record):
        numbers = selecting_numbers(device, record, field)
        if numbers:
            values[field.name] = (selection or {}).get(field.name, numbers[0] if pick is low_value else numbers[-1])
        else:
            values[field.name] = field_sample(device, _decided(field, values), pick)
    return fitting(device, values, record)


def _with_presences(device: Device, values: dict[str, Any], record: RecordLayout, changed: str) -> dict[str, Any]:
    """The values with the optional fields of which others say that they are sent, with that one if it is `changed`; and
    with the bits that count lists.
    """
    decided = record.named(changed)
    if decided is not None and decided.presence is not None and decided.presence.numbers:
        presence = decided.presence
        decider = record.named(presence.by)
        assert decider is not None
        assert decider.value is not None
        number = values[decider.name] & ~presence.mask | presence.numbers[0]
        ranges = decider.value.writable_ranges
        numbers = [number] if ranges is None or number in ranges else legal_numbers(device, decider.value)
        values = {**values, decider.name: next((own for own in numbers if presence.is_met(own)), values[decider.name])}
    for field in record.fields:
        if field.presence is not None and field.presence.numbers:
            elements = values[field.name] or field_sample(device, field, low_value)
            values = {**values, field.name: elements[:1] if field.least_count(values) else []}
    return record.with_list_bits(values)


def fitting(device: Device, values: dict[str, Any], record: RecordLayout, changed: str = "") -> dict[str, Any]:
    """The values with the packed bytes of their bit count if that is the field `changed`, and with a different bit
    count otherwise; and with the optional fields that others say.
    """
    values = _with_presences(device, values, record, changed)
    for field in record.fields:
        if field.bits_of and field.name == changed:
            packed = record.named(field.bits_of)
            assert packed is not None
            assert packed.field.repeat is not None
            size = min(packed_size(values[field.name]), packed.field.repeat.high)
            values = {**values, field.bits_of: [0] * size, field.name: fitting_bit_count(field, size)}
        elif field.bits_of:
            values = {**values, field.name: fitting_bit_count(field, len(values[field.bits_of]))}
    return values


def field_sample(device: Device, field: FieldLayout, pick: ValuePicker) -> Any:
    """A value for a field, a list of them where it is a list."""

    def sample() -> Any:
        if field.record is None:
            assert field.value is not None
            return pick(device, field.value)
        return record_value(device, field.record, pick=pick)

    if not field.is_list:
        return sample()
    repeat = field.field.repeat
    count = greatest_count(field) if repeat is None else max(repeat.low, min(1, repeat.high))
    return [sample() for _ in range(count)]


# Bytes


def sample_bytes(record: RecordLayout, values: dict[str, Any]) -> bytes:
    """The same as `record_bytes`; none if a field cannot count the bytes of the elements that it measures."""
    try:
        return record_bytes(record, values)
    except OverflowError:
        return b""


def record_bytes(record: RecordLayout, values: dict[str, Any]) -> bytes:
    """The bytes of a record on the wire for some values of its fields."""
    record = record.decided_by(values)
    data = b""
    for field in record.fields:
        if field.field.measures is not None:
            value: Any = _measured_size(record, field, values)
        elif is_set_by_user(field):
            value = values.get(field.name)
        else:
            value = _fixed_value(field)
        for item in value if field.is_list else [value]:
            element = record_bytes(field.record, item) if field.record else _element_bytes(field, item)
            data += element.ljust(field.size, b"\0") if field.varies and field.record is not None else element
        room = record.image.room_of(field)
        data = data if room is None else data.ljust(room.room + room.most, b"\0")
    if record.inner_lists is not None:
        return record.inner_lists.data_of(data)
    return data_of(record.spans, data) if record.spans else data


def _fixed_value(field: FieldLayout) -> Any:
    """The value of a field that users do not set."""
    if field.record is not None:
        return [{}] * (field.count or 1) if field.is_list else {}
    assert field.value is not None
    default = field.value.default if isinstance(field.value.default, int) else 0
    value: Any = field.value.const if field.value.const is not None else default
    if is_array(field.value.encoding):
        value = b""
    return [value] * (field.count or 1) if field.is_list else value


def _measured_size(record: RecordLayout, field: FieldLayout, values: dict[str, Any]) -> int:
    measure = field.measure
    assert measure is not None
    other = record.named(measure.field)
    assert other is not None
    items = len(values[other.name]) if other.field.repeat is not None else other.count or 1
    return measure.number(items, other.size)


def _element_bytes(field: FieldLayout, item: Any) -> bytes:
    assert field.value is not None
    if field.value.is_marked:
        return (bytes(item) + MARK).ljust(field.size, b"\0")
    if isinstance(item, bytes):  # also the zeros of a reserved text
        return _filled(field.value, item)
    return value_bytes(field.value, field.order, field.swapped, item)


def value_bytes(value: Value, order: str, swapped: bool, item: Any) -> bytes:
    """The bytes of a value on the wire, in an order of bytes and of words."""
    encoding = value.encoding
    match encoding:
        case Text():
            return text_bytes(value, order, item) if encoding.form is not None else _filled(value, item.encode("ascii"))
        case Octets():
            return _filled(value, bytes(item))
        case Digits():
            data = digits_bytes(value, int(item))
        case Whole():
            data = whole_bits(encoding, int(item)).to_bytes(value.size, "big")
        case Real():
            data = real_bits(encoding.precision, item).to_bytes(value.size, "big")
        case Truth():
            data = int(item).to_bytes(value.size, "big")
        case _:
            assert_never(encoding)
    data = data[::-1] if (order == "little") != swapped else data
    return b"".join(data[offset : offset + 2][::-1] for offset in range(0, len(data), 2)) if swapped else data


def _filled(value: Value, data: bytes) -> bytes:
    return data.ljust(value.size, b"\0")
