"""Random raw values and random bytes for a layout, from a generator of pseudo-random numbers, which is fast."""

from __future__ import annotations

import math
import random
import string
from typing import Any, Literal

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import FrameLayout
from fieldspec.codec.layout.part import PartLayout
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.codec.reference import CodecError
from fieldspec.codec.reference.escapes import escaped
from fieldspec.language.model.encoding import (
    Precision,
    Real,
    is_octets,
    is_real,
    is_text,
    is_truth,
    real_bits,
    real_number,
)
from fieldspec.language.model.value import Value

_LONGEST = 12
"""Elements of a list that are made beyond the least number, so that frames stay short."""


_CHARACTERS = {
    "ascii": string.printable,
    "latin_1": "AZ  \t\x7f\x80\xe4\xff",
    "utf_8": "AZ  \r\xe4\u20ac\U0001f600",
    "utf_16": "AZ  \r\xe4\u0d00\u2020\ufffd\U0001f600",
    "packed_ascii": "AZ  @_?\r^a`",
}
"""Characters of texts by their encodings: such as end and fill up texts are among them."""


def is_computed(field: FieldLayout) -> bool:
    """Whether encoders fill a field themselves."""
    constant = field.value is not None and field.value.const is not None
    return constant or field.field.measures is not None or field.field.reserved


def stored_fields(record: RecordLayout, chosen: RecordLayout) -> list[FieldLayout]:
    """The fields that have values: those of the record that selectors chose, also constants of cases."""
    decided = {field.name for field in record.fields if field.cases}
    return [field for field in chosen.fields if field.name in decided or not is_computed(field)]


def record_values(layout: DeviceLayout, record: RecordLayout, dice: random.Random) -> dict[str, Any]:
    """Values for a record: mostly valid ones, and now and then one just outside a limit."""
    if record.selector is not None:
        number = dice.choice(list(record.chosen))
        fields = stored_fields(record, record.chosen[number])
        values = {field.name: _field(layout, field, dice) for field in fields}
        return values | ({} if is_computed(record.selector) else {record.selector.name: number})
    values: dict[str, Any] = {}
    for field in record.fields:
        decided = [own for own in record.fields if own.selector is not None and own.selector.name == field.name]
        if decided and not is_computed(field) and dice.random() < 0.9:
            own = dice.choice(decided)
            number = _field(layout, field, dice) if own.deciding_bits is not None else 0
            values[field.name] = own.with_case(number, dice.choice(list(own.forms)))
        elif field.cases:
            values[field.name] = _field(layout, record.decided_by(values).named(field.name), dice)
        elif not is_computed(field):
            values[field.name] = _field(layout, field, dice)
    for field in record.fields:
        if field.presence is not None and field.presence.numbers and dice.random() < 0.9:
            elements = values[field.name] or [_element(layout, field, dice)]
            values[field.name] = elements if field.least_count(values) else []
        if field.bits_of and dice.random() < 0.85:
            values[field.name] = max(0, 8 * len(values[field.bits_of]) - dice.choice((0, 0, 1, 3, 7)))
    has_list_bits = any(field.has_count_in_bits or field.continuation is not None for field in record.fields)
    return record.with_list_bits(values) if has_list_bits and dice.random() < 0.95 else values


def _element(layout: DeviceLayout, field: FieldLayout, dice: random.Random) -> Any:
    if field.record is not None:
        return record_values(layout, field.record, dice)
    if field.cases:  # its selector decides nothing
        return 0
    return number_or_text(layout, field.value, dice)


def _field(layout: DeviceLayout, field: FieldLayout, dice: random.Random) -> Any:
    if not field.is_list:
        return _element(layout, field, dice)
    repeat = field.field.repeat
    least, most = (repeat.low, repeat.high) if repeat else (field.count or 0, field.count or 0)
    count = dice.randint(least, min(most, least + _LONGEST))
    if dice.random() < 0.03:
        count = max(0, count + dice.choice((-1, 1)))
    return [_element(layout, field, dice) for _ in range(count)]


def number_or_text(layout: DeviceLayout, value: Value | None, dice: random.Random) -> Any:
    """A raw value."""
    assert value is not None
    encoding = value.encoding
    if is_text(encoding):
        length = dice.randint(0, value.size) if dice.random() < 0.95 else value.size + 1
        characters = string.printable if value.text_form is None else _CHARACTERS[value.text_form.encoding]
        return "".join(dice.choice(characters) for _ in range(length))
    if is_octets(encoding):
        return dice.randbytes(dice.randint(value.least_size, value.size))
    if is_truth(encoding):
        return dice.random() < 0.5
    if is_real(encoding):
        return _float(value, dice)
    return _whole_number(layout, value, dice)


def _whole_number(layout: DeviceLayout, value: Value, dice: random.Random) -> int:
    low, high = (value.low, value.high) if value.has_blanks else (value.type.low, value.type.high)
    if value.const is not None and dice.random() < 0.9:
        return value.const
    if value.sentinels and dice.random() < 0.1:
        first, last = dice.choice(value.sentinels).interval
        return first if first == last else dice.randint(first, last)
    if value.enum and dice.random() < 0.95:
        members = layout.device.enums[value.enum].members
        return dice.choice(members).value if members else 0
    if value.ranges is not None and dice.random() < 0.93:
        first, last = dice.choice((value.writable_ranges or value.ranges).intervals)
        return dice.choice((first, last, dice.randint(first, last)))
    if value.flags and dice.random() < 0.8:
        return layout.device.flags[value.flags].nearest(dice.randint(low, high))
    near = dice.choice(value.ranges.intervals[0] if value.ranges is not None else (low, high))
    if dice.random() < 0.2:
        return near + dice.choice((-1, 1))
    return dice.choice((low, high, dice.randint(low, high), dice.randint(low, high), 0, 1))


def _float(value: Value, dice: random.Random) -> float:
    if value.sentinels and dice.random() < 0.15:
        sentinel = dice.choice(value.sentinels)
        return float("nan") if sentinel.is_nan else float(sentinel.value)
    if value.ranges is not None and dice.random() < 0.8:
        first, last = dice.choice(value.ranges.intervals)
        number = dice.choice((float(first), float(last), dice.uniform(first, last), dice.uniform(first, last)))
    else:
        number = dice.choice((0.0, -1.5, 3.4e38, 1e-45, float("inf"), dice.uniform(-1e6, 1e6), 301.0, -0.0))
    if math.isfinite(number) and isinstance(value.type.encoding, Real):
        return _nearest(value.type.encoding.precision, number)
    return number


def _nearest(precision: Precision, number: float) -> float:
    """The nearest number of a precision; infinity where there is none."""
    try:
        return real_number(precision, real_bits(precision, number))
    except OverflowError:
        return math.copysign(math.inf, number)


def header_values(layout: DeviceLayout, link: str, frame: FrameLayout, dice: random.Random) -> dict[str, Any]:
    """Values for the parts of a header that users supply."""
    values = {}
    for part in frame.header:
        if part.is_argument:
            stations = layout.links[link].link.unit_addresses if part.role == "unit_address" else None
            if stations is not None and stations.ranges is not None and dice.random() < 0.95:
                values[part.name] = dice.choice(stations.ranges.intervals)[0]
                if stations.broadcast is not None and dice.random() < 0.2:
                    values[part.name] = stations.broadcast
            else:
                values[part.name] = number_or_text(layout, part.value, dice)
    return values


def record_bytes(record: RecordLayout, dice: random.Random) -> bytes:
    """Bytes that resemble a record: often of the right size, of small numbers, with the right size in its measures."""
    form, number = record, None
    if record.selector is not None and dice.random() < 0.8:
        number = dice.choice(list(record.chosen))
        form = record.chosen[number]
    most = form.most if form.most is not None else form.least + 40
    least = form.least
    size = dice.choice(
        (least, dice.randint(least, min(most, least + 60)), max(0, least - 1), min(most + 1, least + 99))
    )
    last = form.fields[-1] if form.fields else None
    if last is not None and last.field.repeat is not None and dice.random() < 0.7:
        repeat = last.field.repeat
        size = last.offset + last.size * dice.randint(repeat.low, min(repeat.high, repeat.low + _LONGEST))
    data = bytearray(dice.randbytes(size))
    if dice.random() < 0.5:
        data = bytearray(dice.choice((0, 0, 0, 1, 1, 2, 0x30, 0x41, 0xFF)) for _ in range(size))
    if number is not None and record.selector is not None:
        put(data, record.selector.offset, record.selector.size, record.selector.order, number)
    for field in form.fields:
        measure = field.field.measures
        other = form.named(measure.field) if measure is not None else None
        if measure is not None and other is not None and dice.random() < 0.8:
            length = len(data) - other.offset if other.count is None else other.size * other.count
            put(data, field.offset, field.size, field.order, length if measure.of == "bytes" else length // other.size)
        elif field.bits_of and dice.random() < 0.8:
            packed = len(data) - form.sent_fields[-1].offset
            put(data, field.offset, field.size, field.order, max(0, 8 * packed - dice.choice((0, 1, 7, 8))))
        elif field.selector is not None and dice.random() < 0.8:
            own = field.selector
            order: Literal["big", "little"] = "big" if own.order == "big" else "little"
            number = int.from_bytes(data[own.offset : own.offset + own.size], order)
            put(data, own.offset, own.size, own.order, field.with_case(number, dice.choice(list(field.forms))))
        elif field.value is not None and field.value.const is not None and dice.random() < 0.8 and not field.is_list:
            put(data, field.offset, field.size, field.order, field.value.const)
    return bytes(data)


def put(data: bytearray, at: int, size: int, order: str, number: int) -> None:
    """Writes a number at an offset, if there is room for it."""
    if len(data) >= at + size and 0 <= number < 1 << (8 * size):
        data[at : at + size] = number.to_bytes(size, "little" if order == "little" else "big")


def spoiled(frame: bytes, dice: random.Random) -> bytes:
    """A frame with some bytes changed, cut off or appended."""
    data = bytearray(frame)
    for _ in range(dice.randint(0, 2) if data else 0):
        at = dice.randrange(len(data))
        data[at] = dice.choice((data[at] ^ 1, data[at] ^ 0x80, 0, dice.randrange(256), dice.choice(b" 0-+.")))
    if dice.random() < 0.2:
        del data[dice.randint(0, len(data)) :]
    if dice.random() < 0.1:
        data += dice.randbytes(dice.randint(1, 3))
    return bytes(data)


def with_another_constant(frame: FrameLayout, record: RecordLayout, data: bytes, dice: random.Random) -> bytes | None:
    """The bytes of all parts with one byte of a constant changed, and the checksum as it was; None without constants.

    Only a decoder that compares the constant, or computes the checksum of what it has received, notices it.
    """
    places = [part.at(len(data)) + dice.randrange(part.size) for part in frame.constants]
    if record.selector is None:
        constants = [f for f in record.fields if f.value is not None and f.value.const is not None and not f.is_list]
        places += [frame.header_size + field.offset + dice.randrange(field.size) for field in constants]
    changed = bytearray(data)
    for place in dice.sample(places, min(1, len(places))):
        if place < len(changed):
            changed[place] ^= dice.choice((1, 2, 0x80, 0xFF))
    return bytes(changed) if bytes(changed) != data else None


def sealed(layout: DeviceLayout, link: str, frame: FrameLayout, data: bytes, dice: random.Random) -> bytes:
    """Bytes of all parts as a frame with the right length, checksum and mostly constants: the rest is decoded."""
    parts = bytearray(data)
    if len(parts) >= frame.header_size + frame.trailer_size:
        for part in frame.digits if dice.random() < 0.9 else ():
            at = part.at(len(parts))
            if part.value is not None and part.read(bytes(parts[at : at + part.size])) is None:
                _put_part(parts, part, dice.randint(0, dice.choice((9, part.value.high))))
        for part in frame.constants if dice.random() < 0.7 else ():
            _put_part(parts, part, part.constant or 0)
        _fit_identifier(parts, frame)
        sent = _complete(frame, _escaped(frame, _complete(frame, bytes(parts), False)), True)
        return _marked(layout, link, frame.direction, sent)
    return delimited(layout, link, frame.direction, bytes(parts))


def _complete(frame: FrameLayout, data: bytes, is_sent: bool) -> bytes:
    """Bytes of all parts with the lengths and the checksums of what is sent, or of the bytes before."""
    parts = bytearray(data)
    own = [part for part in frame.parts if (frame.escape is not None and not part.escaped) == is_sent]
    for length in (part for part in own if part.role == "length"):
        number = length.number(len(parts))
        if number is not None:
            _put_part(parts, length, number)
    for checksum in (part for part in frame.checksums if part in own):
        at = checksum.at(len(parts))
        parts[at : at + checksum.size] = checksum.checksum(bytes(parts))
    return bytes(parts)


def _fit_identifier(parts: bytearray, frame: FrameLayout) -> None:
    """Clears the bits of parts of an identifier that have no place in it."""
    at = 0
    for size, order, _, width in frame.escape.fields if frame.escape is not None else ():
        byte_order: Literal["big", "little"] = "little" if order == "little" else "big"
        number = int.from_bytes(parts[at : at + size], byte_order) & (1 << width) - 1
        parts[at : at + size] = number.to_bytes(size, byte_order)
        at += size


def _escaped(frame: FrameLayout, parts: bytes) -> bytes:
    """What is sent for the bytes of all parts; they are left as they are where the escape has no room for them."""
    if frame.escape is None or len(parts) < frame.header_size + frame.trailer_size:
        return parts
    start, stop = frame.escape_start, len(parts) + (frame.escape_stop or 0)
    try:
        return parts[:start] + escaped(frame.escape, parts[start:stop]) + parts[stop:]
    except CodecError:
        return parts


def delimited(layout: DeviceLayout, link: str, direction: str, parts: bytes) -> bytes:
    """The bytes of all parts as a frame, escaped, in the encoding of the link, and between its delimiters."""
    return _marked(layout, link, direction, _escaped(layout.links[link].frame(direction), parts))


def _marked(layout: DeviceLayout, link: str, direction: str, parts: bytes) -> bytes:
    """What is sent between the delimiters of a direction."""
    model = layout.links[link].link
    inner = parts.hex().upper().encode() if model.transmission == "hex_ascii" else parts
    start, end = model.delimiters(direction)
    own = model.preamble
    # A preamble is longer than the least one by what the parts happen to have, up to one byte too many.
    further = bytes((own.byte,)) * (sum(parts) % (own.spare + 2)) if own is not None else b""
    return further + start + inner + end


def _put_part(parts: bytearray, part: PartLayout, number: int) -> None:
    at = part.at(len(parts))
    if len(parts) >= at + part.size:
        parts[at : at + part.size] = part.data(number)
