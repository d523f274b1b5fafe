"""Records as construct Structs, and the exception of the reference codec."""

from __future__ import annotations

import struct
from collections.abc import Mapping
from typing import Any

from fieldspec.codec.layout.inner_lists import InnerLists
from fieldspec.codec.layout.list_places import inner_lists_of
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.codec.layout.value_texts import spec_text
from fieldspec.codec.layout.widths import WidthError, data_of, image_of, place_in_data
from fieldspec.codec.reference.bits import number_of_bits
from fieldspec.codec.reference.list_bits import counting_fields, wrong_bit_number, wrong_list_bits
from fieldspec.codec.reference.quantities import special_name
from fieldspec.codec.reference.structs import record_struct
from fieldspec.codec.reference.texts import bytes_of_text, text_of_bytes, text_refusal
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.device import Device
from fieldspec.language.model.digits import digits_text
from fieldspec.language.model.encoding import Digits, Octets, Precision, Real, Text, Truth, Whole, is_array
from fieldspec.language.model.enums import Flags
from fieldspec.language.model.text_form import encoding_title, text_form_title
from fieldspec.language.model.value import Value


class CodecError(ValueError):
    """Bytes or values that a codec refuses.

    `reason` is one of: incomplete, wrong_length, wrong_mark, wrong_checksum, not_hex, unknown_code,
    unknown_value, wrong_const, wrong_measure, out_of_range, wrong_type, missing_value, unknown_field.
    `offset` is the byte at which it shows, None for values.
    """

    def __init__(self, reason: str, detail: str, offset: int | None = None) -> None:
        place = "" if offset is None else f" at byte {offset}"
        super().__init__(f"{reason}{place}: {detail}")
        self.reason, self.detail, self.offset = reason, detail, offset


Values = dict[str, Any]


def decoded(record: RecordLayout, data: bytes, device: Device, offset: int = 0) -> Values:
    """The values of a record's bytes, which must be exactly that long.

    Raises CodecError; `offset` is where the data start in the frame.
    """
    if record.selector is not None:
        _check_length(record, len(data), offset)
        selector = record.selector
        chosen = record.of_data(data)
        if chosen is None:
            raise CodecError(
                "unknown_value", f"{selector.name} chooses nothing that may follow", offset + selector.offset
            )
        record = chosen
    if record.spans:
        return _decoded_image(record, data, device, offset)
    if record.inner_lists is not None:
        return _decoded_inner_lists(record, record.inner_lists, data, device, offset)
    _check_length(record, len(data), offset)
    parsed = record_struct(record).parse(data)
    values: Values = {}
    for field in record.fields:
        form = field if field.selector is None else field.form_of(parsed[field.selector.name])
        assert form is not None
        values[field.name] = _decoded_field(form, parsed[field.name], device, offset)
    _check_measures(record, values, offset)
    return values


def _decoded_image(record: RecordLayout, data: bytes, device: Device, offset: int) -> Values:
    """The values of a record whose fields vary in width. Raises CodecError with the place in the data."""
    try:
        image, fields = image_of(record.spans, data)
    except WidthError as error:
        raise CodecError(error.reason, _width_text(record, error), offset + error.at) from None
    try:
        values = decoded(record.image, image, device)
        for span, extent in zip(record.spans, fields, strict=True):
            if span.count is not None:
                values[record.spans[span.count].name] = extent.stop - extent.start + span.plus
        return values
    except CodecError as error:
        place = None if error.offset is None else offset + place_in_data(record.spans, fields, error.offset)
        raise CodecError(error.reason, error.detail, place) from None


def _decoded_inner_lists(record: RecordLayout, inner: InnerLists, data: bytes, device: Device, offset: int) -> Values:
    """The values of a record with fields after a list. Raises CodecError with the place in the data."""
    extents, fault = inner.extents_in(data)
    if fault is not None:
        own = inner.lists[len(extents)]
        detail = f"{own.name} has the wrong number of bytes"
        if fault.reason == "unknown_value" and own.decision is not None:
            detail = f"{own.decision.name} chooses nothing that may follow"
        raise CodecError(fault.reason, detail, offset + fault.at)
    text = inner.text_with_zero(data, extents)
    if text is not None:
        raise CodecError("unknown_value", f"{text[0]} has a zero", offset + text[1])
    try:
        values = decoded(record.image, inner.image_of(data, extents), device)
        pairs = zip(inner.lists, extents, strict=True)
        counts = [(own, extent) for own, extent in pairs if own.sent_plus is not None and own.presence is None]
        values |= {own.count: extent.size + (own.sent_plus or 0) for own, extent in counts}
        return {field.name: values[field.name] for field in record.sent_fields}
    except CodecError as error:
        place = None if error.offset is None else offset + inner.place_in_data(extents, error.offset)
        raise CodecError(error.reason, error.detail, place) from None


def _width_text(record: RecordLayout, error: WidthError) -> str:
    count = next((span.count for span in record.spans if span.name == error.name), None)
    if error.reason == "incomplete" and count is not None:
        return f"{record.spans[count].name} says more bytes of {error.name} than there are"
    texts = {
        "incomplete": "has no end",
        "wrong_length": "is followed by more bytes",
        "wrong_measure": "is not a number of bytes",
    }
    return f"{error.name} {texts.get(error.reason, 'is not in its form')}"


def _check_length(record: RecordLayout, length: int, offset: int) -> None:
    if length < record.least:
        text = f"{record.name} has at least {record.least} bytes, not {length}"
        raise CodecError("incomplete", text, offset + length)
    if record.most is not None and length > record.most:
        raise CodecError(
            "wrong_length", f"{record.name} has at most {record.most} bytes, not {length}", offset + record.most
        )
    last = record.fields[-1] if record.fields else None
    if last is not None and last.count is None and not last.cases and (length - last.offset) % last.size:
        raise CodecError(
            "wrong_length", f"{length - last.offset} bytes are not a whole number of {last.name}", offset + length
        )


def _decoded_field(field: FieldLayout, raw: Any, device: Device, offset: int) -> Any:
    start = offset + field.offset
    if field.is_list:
        return [_decode_element(field, item, device, start + n * field.size) for n, item in enumerate(raw)]
    return _decode_element(field, raw, device, start)


def _decode_element(field: FieldLayout, raw: Any, device: Device, offset: int) -> Any:
    if field.record is not None:
        if field.record.size is None:
            return decoded(field.record, inner_lists_of(field.record, is_element=True).sent_bytes(raw), device, offset)
        return {f.name: _decoded_field(f, raw[f.name], device, offset) for f in field.record.fields}
    if field.field.reserved:
        return raw
    return decoded_value(field.name, field.value, raw, device, offset)


def decoded_value(name: str, value: Value | None, raw: Any, device: Device, offset: int | None) -> Any:
    """One raw value: booleans as such, text as a str; closed enums and constants are enforced. Raises CodecError."""
    assert value is not None
    encoding = value.encoding
    match encoding:
        case Truth():
            if raw not in (0, 1):
                raise CodecError("unknown_value", f"{name} is {raw}, neither 0 nor 1", offset)
            return bool(raw)
        case Text():
            return _decoded_text(name, value, raw, offset)
        case Octets():
            return bytes(raw)
        case Real():
            return raw
        case Whole() | Digits():
            return _decoded_count(name, value, raw, device, offset)
        case _:
            assert_never(encoding)


def _decoded_count(name: str, value: Value, raw: int | None, device: Device, offset: int | None) -> int:
    """A whole number; None for bytes that are not its digits."""
    if raw is None:
        raise CodecError("unknown_value", f"{name} is not {digits_text(value)}", offset)
    if value.const is not None and raw != value.const:
        raise CodecError("wrong_const", f"{name} is {raw}, not {value.const}", offset)
    if value.enum and not _is_known(device, value, raw):
        raise CodecError("unknown_value", f"{name} is {raw}, which {value.enum} does not list", offset)
    return raw


def _decoded_text(name: str, value: Value, raw: str | bytes | None, offset: int | None) -> str:
    """The characters of a text, which the construct has read where it has a form of its own."""
    text = text_of_bytes(value, "big", raw) if isinstance(raw, bytes) else raw
    if text is None:
        raise CodecError(
            "unknown_value", f"{name} is not a text in {text_form_title(value) or encoding_title(value)}", offset
        )
    return text


def _is_known(device: Device, value: Value, raw: int) -> bool:
    enum = device.enums[value.enum]
    if enum.open or special_name(value, raw):
        return True
    member = enum.member(raw)
    return member is not None and not member.unavailable


def _check_measures(record: RecordLayout, values: Values, offset: int) -> None:
    for field in (counting := counting_fields(record)):
        measured = _measured(record, field, values)
        if measured is not None and values[field.name] != measured:
            text = f"{field.name} is {values[field.name]}, but there are {measured}"
            raise CodecError("wrong_measure", text, offset + field.offset)
        _refuse_measure(wrong_bit_number(field, values), offset)
    if counting:
        _refuse_measure(wrong_list_bits(record, values), offset)


def _refuse_measure(wrong: tuple[str, int] | None, offset: int | None) -> None:
    if wrong is not None:
        raise CodecError("wrong_measure", wrong[0], None if offset is None else offset + wrong[1])


def _measured(record: RecordLayout, field: FieldLayout, values: Mapping[str, Any]) -> int | None:
    """The number that a field must have which measures another one."""
    measure = field.measure
    other = record.named(measure.field) if measure is not None else None
    if measure is None or other is None:
        return None
    items = len(values[measure.field]) if other.is_list else 1
    return measure.number(items, other.size)


def encoded(record: RecordLayout, values: Mapping[str, Any], device: Device) -> bytes:
    """The bytes of a record. Raises CodecError for values that are missing, unknown or out of range."""
    unknown = sorted(set(values) - {field.name for field in record.fields})
    if unknown:
        raise CodecError("unknown_field", f"{record.name} has no field {unknown[0]}")
    if record.selector is not None:
        selector = record.selector
        chosen = record.of_number(_encoded_field(selector, values, device))
        if chosen is None:
            raise CodecError(
                "unknown_value", f"{selector.name} is {values[selector.name]}, which chooses nothing that may follow"
            )
        record = chosen
    raw = _encoded_fields(record, values, device)
    data: bytes = record_struct(record.image).build(raw)
    try:
        if record.inner_lists is not None:
            return record.inner_lists.data_of(data)
        return data_of(record.spans, data) if record.spans else data
    except OverflowError:
        raise CodecError("out_of_range", f"{record.name} has more bytes than a field can count") from None
    except WidthError as error:
        problem = "does not count the bytes that follow" if error.reason == "wrong_measure" else "has its own end"
        raise CodecError(error.reason, f"{error.name} {problem}") from None


def _encoded_fields(record: RecordLayout, values: Mapping[str, Any], device: Device) -> Values:
    """The raw values of all fields of a record, also of those that measure others."""
    raw: Values = {}
    for field in record.fields:
        number = raw[field.selector.name] if field.selector is not None else None
        form = field.form_of(number)
        if form is None:
            assert field.selector is not None
            text = f"{field.selector.name} is {number}, which chooses nothing that may follow"
            raise CodecError("unknown_value", text)
        if field.field.measures is None:
            raw[field.name] = _encoded_field(form, values, device)
    for field in record.fields:
        measured = _measured(record, field, raw)
        if measured is not None:
            raw[field.name] = measured if field.counts_sent else _in_range(field.name, field.value, measured)
    _refuse_measure(wrong_list_bits(record, raw), None)
    return raw


def _encoded_field(field: FieldLayout, values: Mapping[str, Any], device: Device) -> Any:
    value = values[field.name] if field.name in values else _implied(field)
    if not field.is_list:
        return _encode_element(field, value, device)
    if not isinstance(value, list | tuple):
        raise CodecError("wrong_type", f"{field.name} is a list")
    repeat = field.field.repeat
    if len(value) != field.count if repeat is None else len(value) not in repeat:
        expected = field.count if repeat is None else repeat.text()
        raise CodecError("wrong_length", f"{field.name} has {expected} elements, not {len(value)}")
    return [_encode_element(field, item, device) for item in value]


def _implied(field: FieldLayout) -> Any:
    """The value of a field that users do not set: its constant, no bytes, or a reserved field's default or zeros."""
    value = field.value
    implied: Any = None
    if value is not None and value.const is not None:
        implied = value.const
    elif value is not None and (field.field.reserved or not value.size):
        zero: Any = bytes(value.size) if is_array(value.encoding) else 0
        implied = value.default if isinstance(value.default, int) else zero
    if implied is None:
        raise CodecError("missing_value", f"{field.name} is not given")
    return [implied] * (field.count or 0) if field.is_list else implied


def _encode_element(field: FieldLayout, value: Any, device: Device) -> Any:
    if field.record is not None:
        if field.record.size is None:
            return encoded(field.record, value, device).ljust(field.size, b"\0")
        if unknown := sorted(set(value) - {inner.name for inner in field.record.fields}):
            raise CodecError("unknown_field", f"{field.record.name} has no field {unknown[0]}")
        return _encoded_fields(field.record, value, device)
    return encoded_value(field.name, field.value, value, device)


def encoded_value(name: str, value: Value | None, raw_value: Any, device: Device) -> Any:
    """One value as raw number or bytes, refused where it is out of range. Raises CodecError."""
    assert value is not None
    encoding = value.encoding
    match encoding:
        case Text():
            return _encoded_text(name, value, raw_value)
        case Octets():
            return _bytes(name, raw_value, range(value.least_size, value.size + 1))
        case Real():
            if not isinstance(raw_value, int | float):
                raise CodecError("wrong_type", f"{name} is a number, not {spec_text(raw_value)}")
            return _float(name, value, encoding.precision, raw_value)
        case Whole() | Digits() | Truth():
            if not isinstance(raw_value, int):
                raise CodecError("wrong_type", f"{name} is a whole number, not {spec_text(raw_value)}")
            return _encoded_count(name, value, int(raw_value), device)
        case _:
            assert_never(encoding)


def _encoded_text(name: str, value: Value, text: Any) -> Any:
    """A text as its construct takes it: as characters, or filled up, where ASCII has zeros after it."""
    if isinstance(text, str):
        fault = text_refusal(value, "big", text)
        if fault is not None:
            raise CodecError(fault[0], f"{name} {fault[1]}")
        return text if value.text_form is not None else bytes_of_text(value, "big", text)
    return _bytes(name, text, range(value.size + 1)).ljust(value.size, b"\0")


def _encoded_count(name: str, value: Value, number: int, device: Device) -> int:
    if value.const is not None and number != value.const:
        raise CodecError("wrong_const", f"{name} is {number}, not {value.const}")
    if value.enum and not _is_known(device, value, number):
        raise CodecError("unknown_value", f"{name} is {number}, which {value.enum} does not list")
    number = _in_range(name, value, number)
    if value.flags:
        _check_bits(name, device.flags[value.flags], value, number)
    return number


def _check_bits(name: str, word: Flags, value: Value, number: int) -> None:
    """Refuses a word with a field of bits that is out of its range, unless the word stands for a state."""
    for bit in word.bits:
        own = number_of_bits(word, bit, number)
        if bit.ranges is not None and own not in bit.ranges and not special_name(value, number):
            raise CodecError("out_of_range", f"{bit.name} of {name} is {own}, not in {bit.ranges.text()}")


def _bytes(name: str, data: Any, sizes: range) -> bytes:
    if not isinstance(data, bytes | bytearray):
        raise CodecError("wrong_type", f"{name} is a text or bytes, not {spec_text(data)}")
    if len(data) not in sizes:
        raise CodecError("wrong_length", f"{name} has {sizes[-1]} bytes, not {len(data)}")
    return bytes(data)


_PACKED = {Precision.HALF: ">e", Precision.SINGLE: ">f", Precision.DOUBLE: ">d"}


def _float(name: str, value: Value, precision: Precision, number: float) -> float:
    """A number that its bits hold and its ranges allow; without ranges infinities and NaN are allowed too."""
    try:
        struct.pack(_PACKED[precision], float(number))
    except OverflowError:
        raise CodecError("out_of_range", f"{name} is {number}, which {precision.value} bits do not hold") from None
    if value.ranges is not None and number not in value.ranges and not special_name(value, number):
        raise CodecError("out_of_range", f"{name} is {number}, not in {value.ranges.text()}")
    return number


def _in_range(name: str, value: Value | None, number: int) -> int:
    assert value is not None
    fits = value.low <= number <= value.high
    ranges = value.writable_ranges
    if not fits or (ranges is not None and number not in ranges and not special_name(value, number)):
        allowed = ranges.text() if ranges else f"{value.type.low}..{value.type.high}"
        raise CodecError("out_of_range", f"{name} is {number}, not in {allowed}")
    return number
