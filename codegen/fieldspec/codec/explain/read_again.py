"""Reads the bytes of a field as another value."""

from __future__ import annotations

from fieldspec.codec.layout.record import FieldLayout, Orders
from fieldspec.codec.layout.values import Raw
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_exact, is_octets, is_real, is_text
from fieldspec.language.model.raw_numbers import bytes_of_number
from fieldspec.language.model.value import Value


def read_again(
    device: Device, value: Value, field: FieldLayout, raw: bytes, number: Raw | None, size: int
) -> tuple[Value, bytes, str, bool] | None:
    """Another value with the bytes of a field as its own, and their order; None if they cannot be read as it."""
    own = field.primitive
    if field.carries_bytes:
        return (value, raw[:size], *Orders(field.order, device.word_order).of(value)) if size == value.size else None
    encodings = own.encoding, value.encoding
    alike = any(all(map(question, encodings)) for question in (is_exact, is_real, is_text, is_octets))
    is_binary = field.value is not None and not field.value.digits
    if is_binary and value.size == field.size and (alike or not any(map(is_real, encodings))):
        return value, raw, field.order, field.swapped
    if alike and isinstance(number, int) and value.type.low <= number <= value.type.high:
        return value, bytes_of_number(value, int(number)), "big", False
    return None
