"""The bytes of a parameter's value in a field of bytes, of which another field may say how many are the value."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.codec.layout.record import FieldLayout, Orders
from fieldspec.codec.reference.records import CodecError
from fieldspec.codec.reference.structs import value_construct
from fieldspec.foundation.classes import TYPE_CHECKING
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import Real, Whole, is_text
from fieldspec.language.model.raw_numbers import printable
from fieldspec.language.model.value import Value

if TYPE_CHECKING:
    from typing import Any

    from fieldspec.codec.layout.values import Raw


def carries(field: FieldLayout, size: int) -> bool:
    """Whether a field of bytes can have a value of `size` bytes."""
    return size in field.sizes.values() if field.sizes else size == field.size


def value_of_bytes(device: Device, field: FieldLayout, value: Value, values: Mapping[str, Any]) -> Raw:
    """The raw value that a field of bytes has. Raises CodecError if the number of bytes differs from the value's."""
    return value_of_data(value, stated_bytes(field, values), *orders_of(device, field, value))


def value_of_data(value: Value, data: bytes, order: str, swapped: bool) -> Raw:
    """The raw value that some bytes are; of a text, the zeros that fill it up may be missing. Raises CodecError."""
    if is_text(value.encoding):
        data = data.ljust(value.size, b"\0")
    if len(data) != value.size:
        raise CodecError("wrong_length", f"the value has {value.size} bytes, not {len(data)}")
    if not value.type.is_number:
        return data
    raw = value_construct(value, order, swapped).parse(data)
    encoding = value.encoding
    if isinstance(encoding, Real):
        return printable(encoding.precision, raw)
    return data if raw is None else raw


def stated_bytes(field: FieldLayout, values: Mapping[str, Any]) -> bytes:
    """The bytes of a field of bytes that are the value; none where nothing says how many they are."""
    part = field.value.parameter if field.value is not None else None
    data = bytes(values[field.name])
    if part is None or part.sizes is None:
        return data
    return data[: field.sizes.get(int(values[part.sizes.by]), 0)]


def bytes_of_value(device: Device, field: FieldLayout, value: Value, raw: Any) -> dict[str, Any]:
    """The fields that carry a raw value: its bytes with zeros after them, and what says how many count."""
    return field_of_bytes(field, data_of_value(value, raw, *orders_of(device, field, value)))


def field_of_bytes(field: FieldLayout, data: bytes) -> dict[str, Any]:
    """The fields that carry the bytes of a value: the bytes with zeros after them, and what says how many count."""
    fields: dict[str, Any] = {field.name: data.ljust(field.size, b"\0")}
    part = field.value.parameter if field.value is not None else None
    if field.sizes and part is not None and part.sizes is not None:
        fields[part.sizes.by] = next(number for number, size in field.sizes.items() if size == len(data))
    return fields


def data_of_value(value: Value, raw: Any, order: str, swapped: bool) -> bytes:
    """The bytes of a raw value."""
    if isinstance(raw, bytes):
        return raw.ljust(value.size, b"\0")
    return bytes(value_construct(value, order, swapped).build(raw))


def number_in_field(own: Value | None, value: Value, raw: Any) -> Any:
    """The number that a field of the value `own` has for the bits of a parameter's raw value.

    Both have the same number of bits, and only one of them has a sign: -2 of an `i16` is 65534 in a `u16`. Any other
    raw value is returned as it is.
    """
    if own is None or isinstance(raw, bool) or not isinstance(raw, int):
        return raw
    if own.size != value.size or not (isinstance(own.encoding, Whole) and isinstance(value.encoding, Whole)):
        return raw
    if not value.low <= raw <= value.high:
        return raw
    carrier = value_construct(own, "big", False)
    return carrier.parse(value_construct(value, "big", False).build(raw))


def orders_of(device: Device, field: FieldLayout, value: Value) -> tuple[str, bool]:
    """The byte order of a value in a field of bytes, and whether its words are swapped."""
    return Orders(field.order, device.word_order).of(value)
