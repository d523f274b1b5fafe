"""The bytes of a parameter's value in a field of bytes, of which another field may say how many are the value."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.classes import TYPE_CHECKING
from fieldspec.explain.values import number_of
from fieldspec.layout.record import FieldLayout, Orders
from fieldspec.model.device import Device
from fieldspec.model.value import Value
from fieldspec.reference.records import CodecError
from fieldspec.reference.structs import value_construct

if TYPE_CHECKING:
    from typing import Any

    from fieldspec.layout.values import Raw


def carries(field: FieldLayout, size: int) -> bool:
    """Whether a field of bytes can have a value of `size` bytes."""
    return size in field.sizes.values() if field.sizes else size == field.size


def value_of_bytes(device: Device, field: FieldLayout, value: Value, values: Mapping[str, Any]) -> Raw:
    """The raw value that a field of bytes has. Raises CodecError where its bytes are not as many as the value's."""
    data = stated_bytes(field, values)
    if len(data) != value.size:
        raise CodecError("wrong_length", f"the value has {value.size} bytes, not {len(data)}")
    return number_of(value, data, *_order(device, field, value))


def stated_bytes(field: FieldLayout, values: Mapping[str, Any]) -> bytes:
    """The bytes of a field of bytes that are the value; none where nothing says how many they are."""
    part = field.value.parameter if field.value is not None else None
    data = bytes(values[field.name])
    if part is None or part.sizes is None:
        return data
    return data[: field.sizes.get(int(values[part.sizes.by]), 0)]


def bytes_of_value(device: Device, field: FieldLayout, value: Value, raw: Any) -> dict[str, Any]:
    """The fields that carry a raw value: its bytes with zeros behind them, and what says how many count."""
    if isinstance(raw, bytes):
        data = raw.ljust(value.size, b"\0")
    else:
        data = value_construct(value, *_order(device, field, value)).build(raw)
    fields: dict[str, Any] = {field.name: data.ljust(field.size, b"\0")}
    part = field.value.parameter if field.value is not None else None
    if field.sizes and part is not None and part.sizes is not None:
        fields[part.sizes.by] = next(number for number, size in field.sizes.items() if size == len(data))
    return fields


def _order(device: Device, field: FieldLayout, value: Value) -> tuple[str, bool]:
    return Orders(field.order, device.word_order).of(value)
