"""Questions to all codecs of a device, and the answers of the reference."""

from __future__ import annotations

import math
import random
import struct
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.record import FieldLayout, Orders, RecordLayout
from fieldspec.codec.reference import CodecError, DeviceCodec, codec
from fieldspec.language.model.encoding import is_count, is_octets, is_real, is_text
from fieldspec.language.model.value import OUT_OF_RANGE, Value
from random_devices.inputs import (
    delimited,
    header_values,
    number_or_text,
    record_bytes,
    record_values,
    sealed,
    spoiled,
    stored_fields,
    with_another_constant,
)

UNKNOWN = None
"""What a judge does not say."""


@dataclass(frozen=True)
class Query:
    """What a codec is asked: to decode bytes and encode the result again, or to encode values.

    `kind` is frame, record, register, parameter or subindex; `path` says which. `values` are those to encode, and
    None where `data` is decoded. `shape` is the record of a body, or the value of a register.
    """

    kind: str
    path: tuple[str, ...]
    data: bytes = b""
    values: dict[str, Any] | None = None
    error: bool = False
    code: int | None = None
    shape: Any = field(default=None, repr=False, compare=False)


@dataclass
class Answer:
    """A refusal with its offset, or values and the bytes that are encoded from them; `again` may be a refusal too.

    `quantity` is that of a single value: the number in its unit and its state, or the reason why it has none.
    A judge that does not say an attribute leaves it UNKNOWN. How values that are not stable are encoded is open.
    """

    reason: str | None = ""
    offset: Any = UNKNOWN
    values: str | None = UNKNOWN
    again: str | None = UNKNOWN
    quantity: str | None = UNKNOWN
    is_stable: bool = True

    def differences(self, other: Answer) -> list[str]:
        """The attributes that both say, and that differ."""
        names = ("reason", "offset", "values", "again", "quantity")
        if self.reason and other.reason:
            names = ("reason", "offset")
        return [
            f"{name} {getattr(self, name)!r} and {getattr(other, name)!r}"
            for name in names
            if UNKNOWN not in (getattr(self, name), getattr(other, name))
            and getattr(self, name) != getattr(other, name)
        ]


EXPONENT = 1
"""The exponent of quantities whose power of ten is in another register."""
ABSENT_OFFSET = -1
"""The offset of a refusal that has none."""


def refused(error: Any) -> Answer:
    """The answer of a codec that raises."""
    return Answer(error.reason, ABSENT_OFFSET if error.offset is None else error.offset)


# Values as texts that every language can print.


def flat(record: RecordLayout, values: Mapping[str, Any]) -> str:
    """The stored values of a record: numbers in decimal, floats as their bits, texts and bytes in hexadecimal."""
    return "".join(_flat_field(f, values[f.name]) for f in stored_fields(record, record.decided_by(values)))


def _flat_field(field: FieldLayout, value: Any) -> str:
    if field.is_list:
        return f"[{''.join(_flat_element(field, item) for item in value)}]"
    return _flat_element(field, value)


def _flat_element(field: FieldLayout, value: Any) -> str:
    if field.record is not None:
        return f"({flat(field.record, value)})"
    assert field.value is not None
    return flat_value(field.value, value)


def flat_value(value: Value, raw: Any) -> str:
    """A value as a text, with a semicolon after it. Numbers of half precision are written as doubles."""
    encoding = value.encoding
    if is_real(encoding):
        return "nan;" if math.isnan(raw) else struct.pack(">f" if value.size == 4 else ">d", raw).hex() + ";"
    if is_text(encoding):
        return raw.partition("\0")[0].encode("utf-8").hex() + ";"
    if is_octets(encoding):
        return bytes(raw).hex() + ";"
    return f"{int(raw)};"


def has_quantity(value: Value) -> bool:
    """Whether codecs have a quantity of a value: of counts in a unit or with a scale, and of what may be a state."""
    is_whole = is_count(value.encoding)
    if value.const is not None or value.enum or value.flags or not (is_whole or is_real(value.encoding)):
        return False
    return bool(value.sentinels or (is_whole and (value.unit or value.scaled)))


def quantity_text(number: float | str | None, state: str | None) -> str:
    """A quantity as a text that does not depend on how a language writes numbers: None, a number, or a refusal.

    `state` is that of a special value: what is out of range is a quantity, whose state other questions ask for.
    """
    state = None if state == OUT_OF_RANGE else state
    return f"{number if number is None or isinstance(number, str) else repr(float(number))} {state}"


def is_stable(values: Any) -> bool:
    """Whether every language keeps the values whole: no NaN with bits of its own, no text that goes on after a zero."""
    if isinstance(values, Mapping):
        return all(map(is_stable, values.values()))
    if isinstance(values, list | tuple):
        return all(map(is_stable, values))
    if isinstance(values, float):
        return not math.isnan(values)
    return not (isinstance(values, str) and "\0" in values)


def to_encode(record: RecordLayout, values: Mapping[str, Any]) -> dict[str, Any]:
    """The values that an encoder takes: those that it fills itself are left out."""
    result = {}
    for inner in stored_fields(record, record.decided_by(values)):
        value = values[inner.name]
        if inner.record is not None:
            of = inner.record
            value = [to_encode(of, item) for item in value] if inner.is_list else to_encode(of, value)
        result[inner.name] = value
    return result


# Random queries


def frame_queries(layout: DeviceLayout, dice: random.Random, count: int) -> Iterator[Query]:
    """Frames of random values, spoiled ones, and frames around random bytes."""
    places = [
        (link.name, direction, message)
        for link in layout.links.values()
        for direction in ("request", "response")
        for message in queried_messages(link, direction)
    ]
    reference = codec(layout)
    for number in range(count if places else 0):
        link, direction, message = places[number % len(places)]
        yield from message_queries(layout, reference, link, direction, message, dice)


def queried_messages(link: LinkLayout, direction: str) -> list[str]:
    """The messages in one direction. Frames that no message has there are tried where their codes show them."""
    carried = link.carried(direction)
    return list(link.messages if carried and link.frame(direction).role("code") is not None else carried)


def _absent(layout: DeviceLayout, link: str, direction: str, message: str, dice: random.Random) -> Query:
    """A response to what is not answered, or a request that only the device sends, which every codec refuses."""
    shape, code = layout.links[link].frame(direction), layout.messages[message].message.code_of(direction)
    part = shape.role("code")
    assert part is not None
    assert code is not None
    parts = bytearray(dice.randbytes(shape.header_size + shape.trailer_size))
    parts[part.offset : part.offset + part.size] = part.data(code)
    return Query("frame", (link, direction, ""), sealed(layout, link, shape, bytes(parts), dice))


def message_queries(
    layout: DeviceLayout, reference: DeviceCodec, link: str, direction: str, message: str, dice: random.Random
) -> Iterator[Query]:
    shape, line = layout.links[link].frame(direction), layout.links[link].link
    coded = shape.role("code") is not None
    ambiguous = coded and layout.links[link].is_guessed(direction, message)
    asked = message if not coded or (ambiguous and dice.random() < 0.9) else ""
    if message not in layout.links[link].carried(direction):
        yield _absent(layout, link, direction, message, dice)
        return
    record = layout.messages[message].data(direction)
    is_answer = direction == "response" and message in layout.links[link].carried("request")
    error = line.exception_response if is_answer and dice.random() < 0.15 else None
    if error is not None:
        record = layout.records[error.record]
    head = header_values(layout, link, shape, dice)
    values = record_values(layout, record, dice)
    code = layout.messages[message].message.code_of(direction) if coded else None
    yield Query(
        "frame", (link, direction, message), values={**head, **values}, error=bool(error), code=code, shape=record
    )
    try:
        frame = reference.links[link].encode(direction, message, {**head, **values}, error=bool(error), code=code)
        yield Query("frame", (link, direction, asked), frame)
        yield Query("frame", (link, direction, asked), spoiled(frame, dice))
        parts = bytearray(reference.links[link].original_parts(frame, direction))
        changed = with_another_constant(shape, record, bytes(parts), dice)
        if changed is not None:
            yield Query("frame", (link, direction, asked), delimited(layout, link, direction, changed))
        parts = bytearray(spoiled(bytes(parts), dice))
    except CodecError:
        parts = bytearray(dice.randbytes(shape.header_size + shape.trailer_size))
    if dice.random() < 0.5:
        body = record_bytes(record, dice)
        head_bytes = parts[: shape.header_size].ljust(shape.header_size, b"\0")
        tail = dice.randbytes(shape.trailer_size)
        parts = bytearray(head_bytes + body + tail)
    yield Query("frame", (link, direction, asked), sealed(layout, link, shape, bytes(parts), dice))


def record_queries(layout: DeviceLayout, dice: random.Random, count: int) -> Iterator[Query]:
    """Bytes and values of the records alone, as tables have them."""
    for record in layout.records.values():
        for _ in range(count):
            yield Query("record", (record.name,), record_bytes(record, dice), shape=record)
        yield Query("record", (record.name,), values=record_values(layout, record, dice), shape=record)


def value_queries(layout: DeviceLayout, dice: random.Random, count: int) -> Iterator[Query]:
    """Bytes and values of registers and parameters."""
    for kind, path, shape in shapes(layout):
        value, size = shape[0], shape[4]
        for _ in range(count):
            data = dice.randbytes(size)
            if dice.random() < 0.3:
                data = dice.choice((bytes(size), b"\xff" * size, b"\0" * (size - 1) + b"\1"))
            elif is_text(value.encoding):
                data = bytes(byte & 0x7F for byte in data)
            yield Query(kind, path, data, shape=shape)
        if value.const is None:
            yield Query(kind, path, values={path[-1]: number_or_text(layout, value, dice)}, shape=shape)


def shapes(layout: DeviceLayout) -> Iterator[tuple[str, tuple[str, ...], Any]]:
    """What has an address or a number: its kind, its path, and its value with the order, triggering and size.

    A single bit has no bytes of its own.
    """
    for register in layout.registers:
        value = register.register.value
        if value.type.name == "bit":
            continue
        yield (
            "register",
            (register.name,),
            (value, register.order, register.swapped, register.register.trigger, register.size),
        )
    device = layout.device
    orders = Orders(device.byte_order, device.word_order)
    for parameters in device.parameters.values():
        for parameter in parameters.parameters:
            if parameter.reserved:
                continue
            value = parameter.value
            shape = (value, *orders.of(value), parameter.trigger, value.size)
            yield "parameter", (parameters.name, parameter.name), shape
            for inner in parameter.subindices:
                if not inner.reserved:
                    of_inner = (inner.value, *orders.of(inner.value), parameter.trigger, inner.value.size)
                    yield "subindex", (parameters.name, parameter.name, inner.name), of_inner


def queries(layout: DeviceLayout, seed: int, frames: int) -> list[Query]:
    """The random queries of a layout, with about so many frames."""
    dice = random.Random(seed)
    return [
        *frame_queries(layout, dice, (frames + 2) // 3),
        *record_queries(layout, dice, 3),
        *value_queries(layout, dice, 3),
    ]
