"""How a stream of bytes is cut into frames by the rule of a link, as the reference has it: all bytes at once.

What ends a frame is the first of these that the link has: an end delimiter that does not occur within; a length; a code
whose messages have one size, or a count. Where only silence, or the decoding of the data, shows it, nothing is said.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.record import FieldLayout, RecordLayout
from fieldspec.reference.frames import FrameCodec
from fieldspec.reference.parts import part_construct
from fieldspec.reference.records import CodecError
from fieldspec.reference.structs import value_construct

WAITS, NONE = -1, 0
"""In place of a size: more bytes must come to tell it; no frame begins here."""


class Framing:
    """The frames of a link in one direction in a stream of bytes."""

    def __init__(self, layout: DeviceLayout, link: str, direction: str) -> None:
        self.layout, self.link, self.direction = layout, layout.links[link], direction
        self.codec, self.shape = FrameCodec(layout, self.link), self.link.frame(direction)
        self.around = self.shape.header_size + self.shape.trailer_size
        self.marks = len(self.shape.start) + len(self.shape.end)
        self.records = [message.data(direction) for message in self.link.carried(direction).values()]
        refusal = self.link.link.exception_response
        if refusal is not None and direction == "response":
            self.records.append(layout.records[refusal.record])

    @property
    def ending(self) -> str:
        """What ends a frame: `delimiters`, `length` or `code`; empty where the reference does not say it."""
        shape = self.shape
        is_escaped = shape.escape is not None and (shape.escape_start, shape.escape_stop) == (0, None)
        if self.link.link.encoding == "hex_ascii":
            return "delimiters" if shape.start and shape.end else ""
        if shape.escape is not None or is_escaped or any(record.most is None for record in self.records):
            return ""
        if shape.role("length") is not None:
            return "length"
        coded = shape.role("code")
        refusal = self.link.link.exception_response
        if shape.end or coded is None or refusal is not None or self.link.shared_codes(self.direction):
            return ""
        return "code" if all(map(_has_size, self.records)) else ""

    def frames(self, stream: bytes) -> list[bytes]:
        """The frames in all bytes of a stream, without any silence."""
        return list(self._between_marks(stream) if self.ending == "delimiters" else self._of_sizes(stream))

    def _between_marks(self, stream: bytes) -> Iterator[bytes]:
        """At each end delimiter, the bytes from the last start delimiter on are a frame, or none."""
        start, end = self.shape.start, self.shape.end
        shared = max(size for size in range(len(end) + 1) if start.startswith(end[len(end) - size :]))
        place = 0
        while (close := stream.find(end, place + len(start))) >= 0:
            begin = stream.rfind(start, place, close)
            frame = stream[begin : close + len(end)] if begin >= 0 else b""
            is_right = bool(frame) and self._is_right(frame)
            if is_right:
                yield frame
            place = close + len(end) - (0 if is_right else shared)

    def _of_sizes(self, stream: bytes) -> Iterator[bytes]:
        """At each place, the bytes as far as their length, or the size of their message, goes are a frame, or none."""
        place, smallest, _ = 0, *self._sizes()
        while len(stream) - place >= smallest:
            size = self._size(stream[place:])
            if size == WAITS or size > len(stream) - place:
                return
            frame = stream[place : place + size]
            is_right = size != NONE and self._is_right(frame)
            if is_right:
                yield frame
            place += size if is_right else 1

    def _sizes(self) -> tuple[int, int]:
        """The sizes of the shortest and of the longest frame."""
        width = 2 if self.link.link.encoding == "hex_ascii" else 1
        leasts = [width * (self.around + record.least) + self.marks for record in self.records]
        mosts = [width * (self.around + (record.most or 0)) + self.marks for record in self.records]
        return min(leasts), max(mosts)

    def _size(self, data: bytes) -> int:
        """The size of the frame that begins with some bytes."""
        start = self.shape.start
        if not data.startswith(start):
            return NONE
        parts = data[len(start) :]
        numbers = {
            part.role: part_construct(part).parse(parts[part.offset : part.offset + part.size])
            for part in (self.shape.role("unit_address"), self.shape.role(self.ending))
            if part is not None
        }
        if None in numbers.values() or not self._is_addressed(numbers.get("unit_address")):
            return NONE
        if self.ending == "code":
            return self._size_of_message(numbers["code"], data)
        length = self.shape.role("length")
        assert length is not None
        size = int(numbers["length"]) * length.unit_size + length.base + self.marks
        smallest, largest = self._sizes()
        return size if smallest <= size <= largest else NONE

    def _size_of_message(self, code: int, data: bytes) -> int:
        messages = self.link.messages_with_code(code, self.direction)
        if not messages:
            return NONE
        record = messages[0].data(self.direction)
        if record.size is not None:
            return self.around + record.size + self.marks
        (count,) = _counts(record)
        tail, measure = record.fields[-1], count.field.measures
        assert measure is not None
        place = len(self.shape.start) + self.shape.header_size + count.offset
        if place + count.size > len(data):
            return WAITS
        number = value_construct(count.value, count.order, count.swapped).parse(data[place : place + count.size])
        units = number - measure.plus
        size = self.around + tail.offset + units * (1 if measure.of == "bytes" else tail.size) + self.marks
        smallest, largest = self._sizes()
        return size if smallest <= size <= largest else NONE

    def _is_addressed(self, address: int | None) -> bool:
        known = self.link.link.unit_addresses
        if address is None or known is None or known.ranges is None:
            return True
        return address in known.ranges or (self.direction == "request" and address == known.broadcast)

    def _is_right(self, frame: bytes) -> bool:
        """Whether all parts around the data are right, whatever the data are."""
        smallest, largest = self._sizes()
        if not smallest <= len(frame) <= largest:
            return False
        try:
            head = self.codec.frame_head(frame, self.direction)
        except CodecError:
            return False
        part = self.shape.role("unit_address")
        return part is None or self._is_addressed(head[part.name])


def _counts(record: RecordLayout) -> list[FieldLayout]:
    """The fields that count the list at the end of a record."""
    last = record.fields[-1]
    return [field for field in record.fields if (m := field.field.measures) is not None and m.field == last.name]


def _has_size(record: RecordLayout) -> bool:
    """Whether a record has one size, or one list at its end which a field counts."""
    if record.size is not None:
        return True
    ends_with_list = not record.spans and record.inner_lists is None and record.selector is None
    return ends_with_list and len(_counts(record)) == 1
