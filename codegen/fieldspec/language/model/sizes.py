"""Sizes of records, of the parts of frames and of frames in bytes, as far as the spec determines them."""

from __future__ import annotations

from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.checksums import checksum_size
from fieldspec.language.model.counts import list_count, text_count
from fieldspec.language.model.device import Device
from fieldspec.language.model.link import Link, Part
from fieldspec.language.model.record import Field, Message, Record

MOST_LEVELS = 64
"""How deep records may be nested."""


class RecordSizes:
    """The sizes of a device's records, also where the device has findings; no method recurses."""

    def __init__(self, device: Device) -> None:
        self._bounds: dict[str, tuple[int, int] | None] = {}
        self._open: set[str] = set()
        self._records = device.records
        waiting = dict(device.records)
        for _ in range(MOST_LEVELS):
            ready = [name for name, record in waiting.items() if all(f.record not in waiting for f in record.fields)]
            for name in ready:
                record = waiting.pop(name)
                self._bounds[name] = self.bounds(record)
                if any(not self.is_fixed(field) or field.record in self._open for field in record.fields):
                    self._open.add(name)
            if not ready:
                break
        self.endless = frozenset(waiting)
        """Records that contain themselves, are nested more than `MOST_LEVELS` deep, or contain such a record."""

    def element(self, field: Field) -> int | None:
        """The bytes of one element of a field, None where they are not fixed."""
        sizes = self.elements(field)
        return sizes[0] if len(sizes) == 1 else None

    def elements(self, field: Field) -> tuple[int, ...]:
        """The sizes in bytes that the elements of a field may have, the least first; none where they are not fixed."""
        if field.choice is not None:
            values = [case.value for case in field.choice.cases]
            return tuple(sorted({value.least_size for value in values} | {value.size for value in values}))
        if field.value is not None:
            return () if field.value.width or field.value.packed_bits else (field.value.size,)
        bounds = self._bounds.get(field.record)
        return (bounds[0],) if bounds is not None and bounds[0] == bounds[1] and field.record not in self._open else ()

    def field(self, field: Field) -> tuple[int, int] | None:
        """The least and the most bytes of a field, None where nothing decides them."""
        if field.value is not None and field.value.width:
            return field.value.least_width, field.value.width
        if field.value is not None and field.value.packed_bits:
            low, high = (field.repeat.low, field.repeat.high) if field.repeat is not None else (field.count or 1,) * 2
            return (low * field.value.packed_bits + 7) // 8, (high * field.value.packed_bits + 7) // 8
        sizes = self.elements(field)
        bounds = (sizes[0], sizes[-1]) if sizes else self._bounds.get(field.record)
        if bounds is None:
            return None
        if field.repeat is not None:
            return field.repeat.low * bounds[0], field.repeat.high * bounds[1]
        return (field.count or 1) * bounds[0], (field.count or 1) * bounds[1]

    def bounds(self, record: Record) -> tuple[int, int] | None:
        """The least and the most bytes of a record, None where nothing decides them."""
        minimum = maximum = 0
        for field in record.fields:
            field_bounds = self.field(field)
            if field_bounds is None:
                return None
            minimum, maximum = minimum + field_bounds[0], maximum + field_bounds[1]
        return minimum, maximum

    def fixed(self, record: Record) -> int | None:
        """The bytes of a record that always has the same size, else None."""
        bounds = self.bounds(record)
        return bounds[0] if bounds is not None and bounds[0] == bounds[1] else None

    def tells_size(self, name: str) -> bool:
        """Whether a record has no fixed size, but its bytes determine its end."""
        record = self._records.get(name)
        if record is None or name in self.endless or all(self.is_fixed(field) for field in record.fields):
            return False
        return self.untold(record) is None

    def is_fixed(self, field: Field) -> bool:
        """Whether a field has the same number of bytes in all data, and no other field decides its type."""
        return field.repeat is None and field.choice is None and self.element(field) is not None

    def untold(self, record: Record) -> Field | None:
        """The first field of a record whose end is not determined by earlier fields, None if there is none."""
        for field in record.fields:
            if self.is_fixed(field):
                continue
            has_end = field.repeat is None or list_count(record, field) is not None or field.tells_end
            is_packed = field.value is not None and field.value.packed_bits > 0
            is_decided = is_packed or field.choice is not None
            has_end &= self.element(field) is not None or self.tells_size(field.record) or is_decided
            if field.value is not None and field.value.width:
                has_end = text_count(record, field) is not None and not field.is_list
            if not has_end:
                return field
        return None

    def named(self, name: str) -> int | None:
        """The bytes of the record with a name, None unless it always has the same size."""
        bounds = self._bounds.get(name)
        return bounds[0] if bounds is not None and bounds[0] == bounds[1] else None

    def offsets(self, record: Record) -> list[tuple[Field, int]]:
        """The fields of a record with their offsets in bytes, as far as the fields before them are fixed."""
        offset = 0
        placed = []
        for field in record.fields:
            placed.append((field, offset))
            bounds = self.field(field)
            if bounds is None or bounds[0] != bounds[1]:
                break
            offset += bounds[0]
        return placed


@dataclass(frozen=True, slots=True)
class Shape:
    """The bytes around the data, before they are encoded as characters and put between delimiters."""

    link: Link
    direction: str
    around: int
    has_length: bool

    def length(self, data: int) -> int:
        """The size of a whole frame with `data` bytes of data, on the wire; for a CAN frame, the size of its data."""
        if self.link.is_can:
            return data
        parts = self.around + data
        coded = 2 * parts if self.link.transmission == "hex_ascii" else parts
        further = len(self.link.preamble.further) if self.link.preamble is not None else 0
        return sum(map(len, self.link.delimiters(self.direction))) + further + coded

    def span_size(self, part: Part, data: int) -> int:
        """The bytes that a length part counts in a frame with `data` bytes of data."""
        parts = self.link.parts(self.direction)
        first, last = self.link.span(self.direction, part) or (0, len(parts) - 1)
        has_body = any(part.role == "body" for part in parts[first : last + 1])
        return sum(part_size(part) for part in parts[first : last + 1]) + has_body * data


def coded(link: Link) -> bool:
    """Whether the requests of a link carry the code of their message."""
    return any(part.role == "code" for part in link.request)


def sent_on(link: Link, message: Message) -> bool:
    """Whether a message is sent on a link."""
    return not message.links or link.name in message.links


def messages_on(device: Device, link: Link) -> list[Message]:
    """The messages that are sent on a link."""
    return [message for message in device.messages.values() if sent_on(link, message)]


def messages_sent(device: Device, link: Link, direction: str) -> list[Message]:
    """The messages on a link with a frame in one direction: only the device sends some, and others have no answer."""
    return [
        message
        for message in messages_on(device, link)
        if (message.is_requested if direction == "request" else message.is_answered_on(link.name))
    ]


def shapes(device: Device, direction: str) -> list[Shape]:
    """The frames in one direction; only those with a length part, where a link has one."""
    all_shapes = []
    for link in device.links.values():
        parts = link.parts(direction)
        has_length = any(part.role == "length" for part in parts)
        all_shapes.append(Shape(link, direction, sum(part_size(part) for part in parts), has_length))
    return [shape for shape in all_shapes if shape.has_length] or all_shapes


def part_size(part: Part) -> int:
    """The bytes of a part of a frame, besides those that it shares with the part before it.

    They are 0 for the body, whose data have sizes of their own.
    """
    if part.is_shared:
        return 0
    if part.algorithm:
        return checksum_size(part.algorithm, part.digits)
    return part.value.size if part.value is not None else 0
