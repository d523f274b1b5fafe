"""Frames and words of a device without what identifies a unit.

Only described values are copied. Values with the role `serial_number`, texts, and whatever the spec does not describe
are replaced.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from typing import Any, Literal

from fieldspec.codec.explain.occupants import Occupant
from fieldspec.codec.layout.bits import packed_bits, unpacked_bits
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.list_places import inner_lists_of
from fieldspec.codec.layout.record import FieldLayout, Orders, RecordLayout
from fieldspec.codec.layout.widths import Extent, Span, WidthError, data_of, image_of
from fieldspec.codec.layout.word_digits import field_bytes, word_bytes
from fieldspec.codec.reference.frames import Decoded, codec
from fieldspec.codec.reference.parameters import stated_bytes
from fieldspec.codec.reference.structs import value_construct
from fieldspec.language.model.encoding import is_array, is_count, is_text
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.record import Message, RegisterAccess
from fieldspec.language.model.registers import Parameter
from fieldspec.language.model.text_form import text_bytes
from fieldspec.language.model.value import Value
from fieldspec.tools.evidence.secrets import Secrets
from fieldspec.tools.live.reading import all_occupants, is_bit
from fieldspec.tools.simulator.memory import element_value, numbers_of
from fieldspec.tools.simulator.parameters import part_of

IDENTITY = "serial_number"
"""The role of what identifies a unit."""

_HARMLESS = "firmware_version"
_FIRST = ""
"""The name of no field: the number of the first element of a parameter that a request is about."""


class Redaction:
    """Replaces values of one device. `spared` are paths of facts with texts that say nothing of the unit.

    `replaced` counts the values that were replaced, by the path of their fact, or as `unlisted` or `reserved`.
    """

    def __init__(self, layout: DeviceLayout, secrets: Secrets, spared: Collection[str] = ()) -> None:
        self.layout, self.secrets, self.spared = layout, secrets, spared
        self.codec = codec(layout)
        self.replaced: dict[str, int] = {}
        self.occupants: dict[tuple[str, int], list[Occupant]] = {}
        for space, occupant in all_occupants(layout):
            for address in range(occupant.address, occupant.address + occupant.words):
                self.occupants.setdefault((space, address), []).append(occupant)

    def is_secret(self, fact: Fact, value: Value | None) -> bool:
        """Whether a value is replaced: what identifies the unit, and texts, which may."""
        if IDENTITY in fact.roles:
            return True
        is_text = value is not None and is_array(value.encoding)
        return is_text and _HARMLESS not in fact.roles and fact.place.path not in self.spared

    def _replace(self, fact: Fact | None, data: bytes) -> None:
        """Counts a value that is replaced, and learns it where it identifies the unit."""
        if fact is not None and IDENTITY in fact.roles:
            self.secrets.learn(data)
        name = fact.place.path if fact is not None else "unlisted"
        self.replaced[name] = self.replaced.get(name, 0) + 1

    def _drop(self, data: bytes) -> None:
        """Counts what a reserved place has, where it has something."""
        if any(data):
            self.replaced["reserved"] = self.replaced.get("reserved", 0) + 1

    def frame(
        self, link: str, direction: str, frame: bytes, decoded: Decoded, request_values: Mapping[str, Any]
    ) -> bytes:
        """A frame with right checksums in which nothing identifies the unit. `request_values` are the values of its
        request.

        Raises CodecError for a frame that is not a frame of the link.
        """
        codec_of_link = self.codec.links[link]
        shape = codec_of_link.link.frame(direction)
        parts = codec_of_link.original_parts(frame, direction)
        end = len(parts) - shape.trailer_size
        head, tail = bytearray(parts[: shape.header_size]), bytearray(parts[end:])
        for part in (*shape.header, *shape.trailer):
            if part.reserved and part.constant is not None:
                own, offset = (head, part.offset) if part in shape.header else (tail, part.at(len(parts)) - end)
                place = slice(offset, offset + part.size)
                own[place] = part.bytes_with(bytes(own[place]), part.constant)
        body = self._body(decoded, direction, parts[shape.header_size : end], request_values)
        clean = codec_of_link.with_checksum(direction, bytes(head) + body + bytes(tail))
        return codec_of_link.joined_parts(direction, clean)

    def _body(self, decoded: Decoded, direction: str, data: bytes, request_values: Mapping[str, Any]) -> bytes:
        record = decoded.body
        if record is None:
            return bytes(len(data))
        access = (
            _access(decoded.message.message, direction) if decoded.message is not None and not decoded.error else None
        )
        values = {**request_values, **decoded.values}
        if decoded.message is not None and (indexed := part_of(decoded.message.request, "subindex")) is not None:
            values[_FIRST] = values.get(indexed.name)
        return self._sent(record, data, values, access)

    def _sent(
        self, record: RecordLayout, data: bytes, values: Mapping[str, Any], access: RegisterAccess | None
    ) -> bytes:
        """What remains of the bytes of a record."""
        inner = record.inner_lists
        if inner is not None:
            extents, fault = inner.extents_in(data)
            if fault is not None:
                return bytes(len(data))
            data = inner.image_of(data, extents)
        fields: list[Extent] = []
        size = len(data)
        if record.spans:
            try:
                data, fields = image_of(record.spans, data)
            except WidthError:
                return bytes(size)
        result = bytearray(len(data))
        self._record(record.image, data, result, 0, values, access)
        if fields:
            return _data_of(record.spans, fields, result, size)
        return bytes(result) if inner is None else inner.data_of(bytes(result))

    def _record(
        self,
        record: RecordLayout,
        data: bytes,
        result: bytearray,
        start: int,
        values: Mapping[str, Any],
        access: RegisterAccess | None,
    ) -> None:
        """Takes over the fields of a record from `start` on."""
        for own_field in (record.of_data(data[start:]) or record).fields:
            field = own_field.form_in(data[start:]) or own_field
            offset = start + field.offset
            own_room = record.room_of(field)
            room = len(data) - offset if own_room is None else own_room.size_in(data[start:]) or 0
            count = field.count if field.count is not None else room // field.size if field.size else 0
            if access is not None and field.name == access.values:
                end = offset + min(field.size * count, room)
                result[offset:end] = self._content(access, field, data[offset:end], values)
                continue
            for index in range(count):
                own = offset + index * field.size
                piece = data[own : own + field.size]
                if field.record is not None and field.record.size is None:
                    sent_bytes = inner_lists_of(field.record, is_element=True).sent_bytes(piece)
                    result[own : own + len(sent_bytes)] = self._sent(field.record, sent_bytes, values, None)
                elif field.record is not None:
                    self._record(field.record, data, result, own, values, None)
                elif own + field.size <= len(data):
                    result[own : own + field.size] = self._field(field, piece, index, values)

    def _field(self, field: FieldLayout, piece: bytes, index: int, values: Mapping[str, Any]) -> bytes:
        fact: Fact = field.field
        value = field.value
        constant = value is not None and value.const is not None
        if field.field.reserved and not constant:
            self._drop(piece)
            return bytes(len(piece))
        if value is not None and value.parameter is not None and value.parameter.part in ("value", "values"):
            own = self._parameter(field, index, values)
            if own is None:
                self._replace(None, piece)
                return bytes(len(piece))
            fact, value = own
            if field.carries_bytes:
                return self._carried(field, fact, value, piece, values)
        if self.is_secret(fact, value):
            self._replace(fact, piece)
            return _filler(value, len(piece), field.order, field.swapped)
        return piece

    def _carried(
        self, field: FieldLayout, fact: Fact, value: Value | None, piece: bytes, values: Mapping[str, Any]
    ) -> bytes:
        """The bytes of a parameter's value, and zeros for those that do not count."""
        data = stated_bytes(field, {**values, field.name: piece})
        self._drop(piece[len(data) :])
        if self.is_secret(fact, value):
            self._replace(fact, data)
            order = Orders(field.order, self.layout.device.word_order).of(value)
            data = _filler(value, len(data), *order)
        return data.ljust(len(piece), b"\0")

    def _parameter(self, field: FieldLayout, index: int, values: Mapping[str, Any]) -> tuple[Fact, Value] | None:
        """The fact and the value of an element of a parameter; None where the spec has no such parameter."""
        part, device = field.value.parameter if field.value is not None else None, self.layout.device
        if part is None:
            return None
        if part.part == "values":
            rows = list(numbers_of(device.sets(part.set)))
            parameter = rows[index][2] if index < len(rows) else None
            return None if parameter is None or parameter.reserved else (parameter, parameter.value)
        number = values.get(part.number)
        match = device.parameter_at(part.set, number) if isinstance(number, int) else None
        parameter = match[0].numbered(match[1]) if match is not None else None
        if parameter is None or parameter.reserved:
            return None
        first = values.get(_FIRST)
        return _element(parameter, index + (first if isinstance(first, int) else 0))

    def _content(self, access: RegisterAccess, field: FieldLayout, data: bytes, values: Mapping[str, Any]) -> bytes:
        """The words or bits of registers that a frame carries."""
        start = values.get(access.start)
        space = self.layout.device.space_name(access.space)
        if not isinstance(start, int):
            self._replace(None, data)
            return bytes(len(data))
        if self.layout.device.space(space).unit == "bit":
            if access.set is not None:
                return data if (space, start) in self.occupants else bytes(len(data))
            bits = list(unpacked_bits(data))
            count = values.get(access.count)
            known = bits[: count if isinstance(count, int) else len(bits)]
            clean = [bit if (space, start + offset) in self.occupants else 0 for offset, bit in enumerate(known)]
            return bytes(packed_bits(clean)).ljust(len(data), b"\0")[: len(data)]
        content = self.words(space, start, word_bytes(field, data), access.operation)
        return field_bytes(field, content).ljust(len(data), b"0")

    def words(self, space: str, start: int, data: bytes, operation: str = "read") -> bytes:
        """The bytes of the words, or of the bytes, from an address on."""
        result = bytearray(len(data))
        replaced: set[int] = set()
        size = self.layout.device.space(space).unit_size
        for offset in range(0, len(data) - size + 1, size):
            own = self.occupants.get((space, start + offset // size), [])
            known = [
                occupant for occupant in own if not (occupant.reserved or getattr(occupant.fact, "reserved", False))
            ]
            secret = [occupant for occupant in known if self.is_secret(occupant.fact, occupant.value)]
            if known and not secret:
                result[offset : offset + size] = data[offset : offset + size]
            elif not own:
                self._replace(None, data[offset : offset + size])
            elif not known:
                self._drop(data[offset : offset + size])
            for occupant in secret:
                first = size * (occupant.address - start) + occupant.skip
                if id(occupant) in replaced:
                    continue
                replaced.add(id(occupant))
                low, high = max(first, 0), min(first + occupant.value.size, len(data))
                self._replace(occupant.fact, data[low:high])
                swapped = occupant.is_swapped(operation)
                filler = _filler(occupant.value, occupant.value.size, occupant.order, swapped)
                result[low:high] = filler[low - first : high - first]
        return bytes(result)

    def counts(self, space: str, number: int, counts: Sequence[int]) -> list[int]:
        """The counts at an address or of the elements of a parameter, as dumps and scans have them."""
        device = self.layout.device
        match = (
            device.parameter_at(space, number) if space in {own.space for own in device.parameters.values()} else None
        )
        if match is None:
            bits = [own for own in self.occupants.get((space, number), []) if is_bit(own)]
            if bits:
                return [int(bool(count)) for count in counts]
            size = device.space(space).unit_size
            order: Literal["big", "little"] = "big" if device.byte_order == "big" else "little"
            data = b"".join((count & (1 << 8 * size) - 1).to_bytes(size, order) for count in counts)
            clean = self.words(space, number, data)
            return [int.from_bytes(clean[offset : offset + size], order) for offset in range(0, len(clean), size)]
        parameter = match[0].numbered(match[1])
        result = []
        for index, count in enumerate(counts):
            own = _element(parameter, index) if parameter is not None and not parameter.reserved else None
            if own is None or self.is_secret(*own):
                self._replace(own[0] if own else None, _signed_bytes(count))
                count = 0
            result.append(count)
        return result


def _element(parameter: Parameter, index: int) -> tuple[Fact, Value] | None:
    """The fact and the value of an element; None for a reserved one."""
    own = parameter.element(index)
    if own is not None and own.reserved:
        return None
    return own or parameter, element_value(parameter, index)


def _signed_bytes(count: int) -> bytes:
    size = (count.bit_length() + 8) // 8
    return count.to_bytes(size, "big", signed=True)


def _filler(value: Value | None, size: int, order: str, swapped: bool) -> bytes:
    """What stands for a value: zeros, or the least number that the spec permits; a text of the letter X."""
    if value is None or value.size != size:
        return bytes(size)
    if is_text(value.encoding):
        return text_bytes(value, order, "X" * size)
    filler_number = min((low for low, _ in _intervals(value)), key=abs, default=0)
    if is_count(value.encoding) and filler_number:
        return bytes(value_construct(value, order, swapped).build(filler_number))
    return bytes(size)


def _intervals(value: Value) -> Iterable[tuple[int, int]]:
    if value.ranges is None or 0 in value.ranges:
        return ()
    return value.ranges.intervals


def _access(message: Message, direction: str) -> RegisterAccess | None:
    """How a frame of a message carries registers; None where it carries none."""
    operation = "write" if direction == "request" else "read"
    steps = (step for step in message.access_steps if step.operation == operation and step.values)
    return message.single_access or next(steps, None)


def _data_of(spans: tuple[Span, ...], fields: Sequence[Extent], image: bytearray, size: int) -> bytes:
    """The data of a redacted image, in which no text is longer than it was; zeros where another size would be sent."""
    offset = 0
    for span, extent in zip(spans, fields, strict=True):
        if span.value is not None and is_text(span.value.encoding):
            image[offset + extent.stop - extent.start : offset + span.size] = bytes(
                span.size - (extent.stop - extent.start)
            )
        offset += span.size
    try:
        data = data_of(spans, bytes(image))
    except WidthError:
        return bytes(size)
    return data if len(data) == size else bytes(size)
