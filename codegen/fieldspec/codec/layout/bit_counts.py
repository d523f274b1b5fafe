"""Requests that write packed bits: the field with the number of bits, which decides how many bytes they take."""

from __future__ import annotations

from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.foundation.classes import replace
from fieldspec.language.model.device import Device
from fieldspec.language.model.record import Message


def fitting_bit_count(field: FieldLayout, size: int) -> int:
    """A number that a field with `bits_of` may have, of bits that take `size` bytes; 0 where there is none."""
    assert field.value is not None
    ranges = field.value.writable_ranges
    numbers = range(min(8 * size, field.value.high), max(8 * size - 8, -1), -1)
    return next((number for number in numbers if ranges is None or number in ranges), 0)


def with_bit_count(device: Device, message: Message, request: RecordLayout) -> RecordLayout:
    """The layout of a request, whose number of bits knows the list with them where the message writes packed bits."""
    access = device.bit_access(message)
    count = request.named(access.count) if access is not None else None
    if access is None or access.operation != "write" or access.set is not None or count is None:
        return request
    if count.value is None or count.value.const is not None:
        return request  # a constant fits the only number of bytes that there is
    fields = tuple([replace(field, bits_of=access.values) if field is count else field for field in request.fields])
    return replace(request, fields=fields)
