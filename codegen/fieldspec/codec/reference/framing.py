"""How a stream of bytes is cut into frames by the rule of a link, as the reference has it: all bytes up to a silence.

What ends a frame is the first of these that the link has: an end delimiter that does not occur within, as bytes are
characters or escaped; a length; a code whose messages have one size, a subcode or a count; an end delimiter with which
the link decodes it; silence.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.first_bytes import first_bytes
from fieldspec.codec.reference.frame_sizes import NONE, OPEN, WAITS, FrameSize, frame_size
from fieldspec.codec.reference.frames import FrameCodec
from fieldspec.codec.reference.parts import part_construct
from fieldspec.codec.reference.records import CodecError

_UNBOUNDED = 0xFFFF
"""The bytes of data that nothing bounds."""

Cut = tuple[list[bytes], int]
"""The frames in some bytes, and how many bytes these and what is not a frame have."""


class Framing:
    """The frames of a link in one direction in a stream of bytes."""

    def __init__(self, layout: DeviceLayout, link: str, direction: str) -> None:
        self.layout, self.link, self.direction = layout, layout.links[link], direction
        self.codec, self.shape = FrameCodec(layout, self.link), self.link.frame(direction)
        shape, refusal = self.shape, self.link.link.exception_response
        self.refusal = refusal if direction == "response" else None
        self.records = [message.data(direction) for message in self.link.carried(direction).values()]
        if self.refusal is not None:
            self.records.append(layout.records[self.refusal.record])
        marks, width = len(shape.start) + len(shape.end), 2 if self.link.link.transmission == "hex_ascii" else 1
        framing_size = shape.header_size + shape.trailer_size
        self.least = marks + width * (framing_size + min((record.least for record in self.records), default=0))
        mosts = (_UNBOUNDED if record.most is None else record.most for record in self.records)
        self.most = marks + width * (framing_size + max(mosts, default=0))
        self.is_escaped = shape.escape is not None and (shape.escape_start, shape.escape_stop) == (0, None)
        self.longest = self.most
        if shape.escape is not None:
            self.longest = shape.escape.most(self.most - marks) + marks
        self.first_bytes = first_bytes(self.link, direction)

    @property
    def ending(self) -> str:
        """What ends a frame: `delimiters`, `escape`, `length`, `code` or `end`; empty where nothing does."""
        shape, encoding = self.shape, self.link.link.transmission
        if not self.records or encoding not in ("binary", "hex_ascii"):
            return ""
        if encoding == "hex_ascii":
            return "delimiters" if shape.start and shape.end else ""
        if self.is_escaped:
            return "escape" if shape.end else ""
        length = shape.role("length")
        if shape.escape is not None and (length is None or length.before_escape):
            return ""
        if length is not None:
            return "length"
        has_code = shape.role("code") is not None
        if shape.end and not (has_code and all(size is not None for size in self._all_sizes())):
            return "end"
        return "code" if has_code else ""

    def cut(self, blocks: Iterable[bytes]) -> Iterator[tuple[list[bytes], list[bytes]]]:
        """The frames of each block of bytes, and those that the silence after it shows."""
        cuts: dict[str, Callable[[bytes, bool], Cut]] = {
            "delimiters": self._between_marks,
            "escape": self._escaped,
            "end": self._to_end,
        }
        cut, rest = cuts.get(self.ending, self._of_sizes), b""
        for block in blocks:
            rest += block
            before, place = cut(rest, False)
            rest = rest[place:]
            with_silence, place = cut(rest, True)
            rest = rest[place:]
            yield before, with_silence

    def _between_marks(self, stream: bytes, is_silent: bool) -> Cut:
        """At each end delimiter, the bytes from the last start delimiter on are a frame, or none. Frames may pause."""
        start, end = self.shape.start, self.shape.end
        shared = max(size for size in range(len(end) + 1) if start.startswith(end[len(end) - size :]))
        frames: list[bytes] = []
        place = 0
        while (close := stream.find(end, place + len(start))) >= 0:
            begin = stream.rfind(start, place, close)
            frame = stream[begin : close + len(end)] if begin >= 0 else b""
            is_right = bool(frame) and self._is_right(frame)
            frames += [frame] * is_right
            place = close + len(end) - (0 if is_right else shared)
        return frames, place

    def _escaped(self, stream: bytes, is_silent: bool) -> Cut:
        """From each start delimiter, the bytes up to the next end delimiter are a frame, or none. Frames may pause."""
        start, end = self.shape.start, self.shape.end
        frames: list[bytes] = []
        place = 0
        while (begin := stream.find(start, place)) >= 0:
            place, close = begin, self._unescaped_end(stream, begin + len(start))
            if close < 0 and len(stream) - begin <= self.longest:
                break
            frame = stream[begin : close + len(end)] if close >= 0 else b""
            is_right = bool(frame) and self._is_right(frame)
            frames += [frame] * is_right
            place = close + len(end) if is_right or (close >= 0 and not start) else begin + 1
        return frames, place

    def _unescaped_end(self, stream: bytes, place: int) -> int:
        """Where the next end delimiter is that is not in an escaped byte; -1 for none."""
        escape = self.shape.escape
        assert escape is not None
        pairs = {bytes(pair) for _, *pair in escape.pairs}
        while place < len(stream):
            if stream[place : place + 2] in pairs:
                place += 2
            elif stream.startswith(self.shape.end, place):
                return place
            else:
                place += 1
        return -1

    def _of_sizes(self, stream: bytes, is_silent: bool) -> Cut:
        """At each place, the bytes as far as their length, or the size of their message, goes are a frame, or none.

        Silence ends a frame that nothing else does, and what waits for more bytes is not a frame.
        """
        frames: list[bytes] = []
        place = stop = 0
        while len(stream) - place >= self.least:
            rest = stream[place:]
            size = self._size(rest)
            if size == OPEN and is_silent and self._is_right(rest):
                return [*frames, rest], len(stream)
            is_waiting = size == WAITS or size > len(rest) or (size == OPEN and len(rest) <= self.longest)
            if is_waiting and not is_silent:
                break
            is_right = not is_waiting and size > NONE and self._is_right(rest[:size])
            if is_right:
                frames.append(stream[place - self._lead(stream[stop:place]) : place + size])
                stop = place + size
            place += size if is_right else 1
        return frames, len(stream) if is_silent else place - self._lead(stream[stop:place])

    def _lead(self, before: bytes) -> int:
        """How many of the bytes before a place belong to the preamble of a frame there, beside its least ones."""
        preamble = self.shape.preamble
        if preamble is None:
            return 0
        return min(len(before) - len(before.rstrip(bytes((preamble.byte,)))), preamble.spare)

    def _to_end(self, stream: bytes, is_silent: bool) -> Cut:
        """From each place, the shortest frame that the link decodes; one that is only right when no other can come."""
        end = self.shape.end
        frames: list[bytes] = []
        place = 0
        while place < len(stream):
            frame = b""
            if self._may_begin(stream[place:]):
                frame = self._shortest(stream, place, self._is_decoded)
                has_end = stream.find(end, place + len(self.shape.start)) >= 0
                is_over = len(stream) - place > self.longest or (is_silent and has_end)
                if not frame and not is_over:
                    break
                frame = frame or self._refused_frame(stream, place)
            frames += [frame] * bool(frame)
            place += len(frame) or 1
        return frames, place

    def _refused_frame(self, stream: bytes, place: int) -> bytes:
        """The shortest right frame whose data the link refuses; none where one that it decodes begins within.

        That is told when one byte more than the longest frame has come, whatever comes later.
        """
        frame = self._shortest(stream, place, self._is_right)
        following = range(place + 1, place + len(frame))
        stream = stream[: place + self.longest + 1]
        decoded = (self._shortest(stream, n, self._is_decoded) for n in following if self._may_begin(stream[n:]))
        return b"" if any(decoded) else frame

    def _shortest(self, stream: bytes, place: int, condition: Callable[[bytes], bool]) -> bytes:
        """The shortest frame at a place that ends with the end delimiter and meets a condition; else no bytes."""
        ends = range(place + self.least, min(len(stream), place + self.longest) + 1)
        frames = (stream[place:stop] for stop in ends if stream.endswith(self.shape.end, place, stop))
        return next(filter(condition, frames), b"")

    def _may_begin(self, data: bytes) -> bool:
        """Whether a frame may begin with some bytes, as far as they are there."""
        start = self.shape.start
        parts = data[len(start) :]
        known = all(parts[place] in values for place, values in self.first_bytes.items() if place < len(parts))
        return known and start.startswith(data[: len(start)])

    def _is_decoded(self, frame: bytes) -> bool:
        """Whether a frame is right, and that of a message."""
        if not self._is_right(frame):
            return False
        for message in ("", *self.link.carried(self.direction)):
            try:
                self.codec.decode(frame, self.direction, message)
            except CodecError:
                continue
            return True
        return False

    def _size(self, data: bytes) -> int:
        """The size of the frame that begins with some bytes."""
        preamble = self.shape.preamble
        goes_on = preamble is not None and data[preamble.least] == preamble.byte
        if not data.startswith(self.shape.start) or goes_on:
            return NONE
        parts = data[len(self.shape.start) :]
        numbers = {
            part.role: part_construct(part).parse(parts[part.offset : part.offset + part.size])
            for part in (self.shape.role("unit_address"), self.shape.role(self.ending))
            if part is not None
        }
        if None in numbers.values() or not self._is_addressed(numbers.get("unit_address")):
            return NONE
        length = self.shape.role("length")
        if length is None:
            size = self._size_of_code(numbers["code"], data)
        else:
            marks = len(self.shape.start) + len(self.shape.end)
            size = max(NONE, int(numbers["length"]) * length.unit_size + length.base + marks)
        return size if size < NONE or self.least <= size <= self.longest else NONE

    def _size_of_code(self, code: int, data: bytes) -> int:
        """The size that a code, the subcode in the data or a count determines."""
        sizes = self._sizes(code)
        shared = self.link.subcodes(self.direction).get(code)
        has_part = self.refusal is not None and bool(self.refusal.part)
        if len(sizes) > 1 and shared is not None and not has_part:
            place = len(self.shape.start) + self.shape.header_size
            number = shared.number(data[place:])
            if number is None:
                return WAITS
            message = shared.messages.get(number)
            sizes = set() if message is None else {frame_size(self.shape, message.data(self.direction))}
        if not sizes:
            return NONE
        size = next(iter(sizes)) if len(sizes) == 1 else None
        return OPEN if size is None else size.of_frame(data)

    def _sizes(self, code: int) -> set[FrameSize | None]:
        """The sizes that frames with a code may have."""
        refusal, messages = self.refusal, self.link.messages_with_code(code, self.direction)
        sizes = {frame_size(self.shape, message.data(self.direction)) for message in messages}
        if refusal is None:
            return sizes
        refused = frame_size(self.shape, self.layout.records[refusal.record])
        if code & refusal.flag or code == refusal.code:
            return {refused}
        return sizes | {refused} if sizes and refusal.part else sizes

    def _all_sizes(self) -> Iterator[FrameSize | None]:
        """The sizes of all frames; None for those that go on as long as bytes come."""
        subcodes = self.link.subcodes(self.direction)
        refusal, codes = self.refusal, set(self.link.codes(self.direction))
        if refusal is not None and (refusal.flag or refusal.code is not None):
            codes.add(refusal.flag or refusal.code or 0)
        for code in codes:
            sizes = self._sizes(code)
            has_subcode = code in subcodes and not (refusal is not None and refusal.part)
            yield from sizes if len(sizes) < 2 or has_subcode else (None,)

    def _is_addressed(self, address: int | None) -> bool:
        known = self.link.link.unit_addresses
        if address is None or known is None or known.ranges is None:
            return True
        return address in known.ranges or (self.direction == "request" and address == known.broadcast)

    def _is_right(self, frame: bytes) -> bool:
        """Whether all parts around the data are right, whatever the data are."""
        try:
            numbers = self.codec.frame_numbers(frame, self.direction)
            size = len(frame)
            if self.is_escaped:
                marks = len(self.shape.start) + len(self.shape.end)
                size = marks + len(self.codec.original_parts(frame, self.direction))
        except CodecError:
            return False
        if not self.least <= size <= (self.most if self.is_escaped else self.longest):
            return False
        part = self.shape.role("unit_address")
        return part is None or self._is_addressed(numbers[part.name])
