"""Bytes of records and values, worked out from the layout by other means than the C functions: for the self-test."""

from __future__ import annotations

import struct
from typing import Any

from fieldspec.backends.c.enums import available
from fieldspec.backends.c.fields import given, members, most
from fieldspec.layout.record import FieldLayout, RecordLayout
from fieldspec.model.device import Device
from fieldspec.model.value import Kind, Value


def low_value(device: Device, value: Value) -> Any:
    """A value that is always taken: 0 where it is in range."""
    if value.type.kind is Kind.TEXT:
        return ""
    if value.type.kind is Kind.BYTES:
        return bytes(value.size)
    if value.type.kind is Kind.FLOAT:
        return 0.0 if value.ranges is None or 0 in value.ranges else float(value.ranges.low)
    choices = legal(device, value)
    return 0 if 0 in choices else choices[0]


def high_value(device: Device, value: Value) -> Any:
    """A value that is as different from it as can be."""
    if value.type.kind is Kind.TEXT:
        return "".join(chr(0x41 + at % 26) for at in range(value.size))
    if value.type.kind is Kind.BYTES:
        return bytes((0xA1 + at) & 0xFF for at in range(value.size))
    if value.type.kind is Kind.FLOAT:
        return -1.5 if value.ranges is None else float(value.ranges.high)
    return legal(device, value)[-1]


def legal(device: Device, value: Value) -> list[int]:
    """Values that are taken, the least and the greatest of each interval among them."""
    if value.enum and not device.enums[value.enum].open:
        members = sorted(member.value for member in available(device.enums[value.enum]))
        ranges = value.writable_ranges
        inside = [number for number in members if ranges is None or number in ranges]
        return inside or members
    if value.writable_ranges is not None:
        return [bound for pair in value.writable_ranges.intervals for bound in pair]
    return [0, value.type.low, value.type.high]


def record_value(device: Device, record: RecordLayout) -> dict[str, Any]:
    """Low values for all members of a record; lists are as short as they may be, but not empty."""
    return {field.name: field_value(device, field, low_value) for field in members(record)}


def field_value(device: Device, field: FieldLayout, pick: Any) -> Any:
    """A value for a field, a list of them where it is listed."""

    def one() -> Any:
        if field.record is None:
            assert field.value is not None
            return pick(device, field.value)
        return {inner.name: field_value(device, inner, pick) for inner in members(field.record)}

    if not field.is_list:
        return one()
    repeat = field.field.repeat
    count = most(field) if repeat is None else max(repeat.low, min(1, repeat.high))
    return [one() for _ in range(count)]


def record_bytes(record: RecordLayout, values: dict[str, Any]) -> bytes:
    """The bytes of a record."""
    data = b""
    for field in record.fields:
        held: Any = values.get(field.name)
        if field.field.measures is not None:
            held = _measured(record, field, values)
        elif not given(field):
            assert field.value is not None
            default = field.value.default if isinstance(field.value.default, int) else 0
            held = field.value.const if field.value.const is not None else default
            if field.value.type.letter == "s":
                held = b""
            held = [held] * (field.count or 1) if field.is_list else held
        for item in held if field.is_list else [held]:
            data += record_bytes(field.record, item) if field.record else value_bytes(field, item)
    return data


def _measured(record: RecordLayout, field: FieldLayout, values: dict[str, Any]) -> int:
    measure = field.field.measures
    assert measure is not None
    other = record.named(measure.field)
    assert other is not None
    items = len(values[other.name]) if other.is_list else 1
    return items * other.size if measure.of == "bytes" else items


def value_bytes(field: FieldLayout, held: Any) -> bytes:
    """The bytes of one value of a field."""
    assert field.value is not None
    return raw_bytes(field.value, field.order, field.swapped, held)


def raw_bytes(value: Value, order: str, swapped: bool, held: Any) -> bytes:
    """The bytes of one value in an order."""
    kind = value.type.kind
    if kind in (Kind.TEXT, Kind.BYTES):
        data = held.encode("ascii") if isinstance(held, str) else bytes(held)
        return data.ljust(value.size, b"\0")
    number = int.from_bytes(struct.pack(">f", held), "big") if kind is Kind.FLOAT else int(held)
    words_little = (order == "little") != swapped
    data = (number & ((1 << 8 * value.size) - 1)).to_bytes(value.size, "little" if words_little else "big")
    if swapped:
        return b"".join(data[at : at + 2][::-1] for at in range(0, len(data), 2))
    return data
