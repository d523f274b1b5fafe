"""Escaped bytes: what is sent for the bytes between delimiters, and the frames of such bytes in a stream."""

from __future__ import annotations

from ._error import CodecError
from ._framers import Framer
from ._part_frames import PartFrames
from ._typing import TYPE_CHECKING

if TYPE_CHECKING:
    from typing import Any

    from ._can import CanIdentifier
    from ._typing import Data


class Replace:
    """Two bytes are sent for each of some bytes. `pairs` are such a byte and the two bytes."""

    __slots__ = ("originals", "pairs", "special")

    def __init__(self, pairs: tuple[tuple[int, int, int], ...]) -> None:
        self.pairs = {byte: bytes((first, second)) for byte, first, second in pairs}
        self.originals = {pair: byte for byte, pair in self.pairs.items()}
        self.special = frozenset(self.pairs) | frozenset(pair[0] for pair in self.originals)

    def escaped(self, data: Data) -> bytes:
        """The sent form of some bytes."""
        pairs = self.pairs
        return b"".join(pairs[byte] if byte in pairs else bytes((byte,)) for byte in data)

    def original(self, data: Data, offset: int) -> bytes:
        """The bytes for which others were sent; `offset` is the place of these. Raises CodecError."""
        result, index = bytearray(), 0
        while index < len(data):
            byte = data[index]
            if byte in self.special:
                original = self.originals.get(bytes(data[index : index + 2]))
                if original is None:
                    raise CodecError("wrong_mark", "a byte is not escaped, or the escape means nothing", offset + index)
                result.append(original)
                index += 2
            else:
                result.append(byte)
                index += 1
        return bytes(result)

    def end(self, data: bytearray, offset: int, end: bytes) -> int:
        """The place of the end delimiter, -1 where it is not there yet: no escaped byte belongs to it."""
        while offset < len(data):
            if bytes(data[offset : offset + 2]) in self.originals:
                offset += 2
            elif data.startswith(end, offset):
                return offset
            else:
                offset += 1
        return -1


class Insert:
    """A byte is sent after each occurrence of a pattern."""

    __slots__ = ("inserted", "pattern", "stuffed")

    def __init__(self, pattern: bytes, inserted: int) -> None:
        self.pattern, self.inserted = pattern, inserted
        self.stuffed = pattern + bytes((inserted,))

    def escaped(self, data: Data) -> bytes:
        """The sent form of some bytes."""
        return bytes(data).replace(self.pattern, self.stuffed)

    def original(self, data: Data, offset: int) -> bytes:
        """The bytes for which others were sent; `offset` is the place of these. Raises CodecError."""
        data, result, index = bytes(data), bytearray(), 0
        # The inserted byte may itself begin the pattern, which is searched for after it.
        while (begin := data.find(self.pattern, index)) >= 0:
            next_offset = begin + len(self.pattern)
            if data[next_offset : next_offset + 1] != self.stuffed[-1:]:
                raise CodecError(
                    "wrong_mark", f"{self.inserted:#04x} is missing after the pattern", offset + next_offset
                )
            result += data[index:next_offset]
            index = next_offset + 1
        return bytes(result + data[index:])

    def end(self, data: bytearray, offset: int, end: bytes) -> int:
        """The place of the end delimiter, -1 where it is not there yet."""
        return data.find(end, offset)


class Add:
    """Each byte is sent plus another one, without the carry."""

    __slots__ = ("added", "taken")

    def __init__(self, byte: int) -> None:
        self.added = bytes((number + byte) & 0xFF for number in range(256))
        self.taken = bytes((number - byte) & 0xFF for number in range(256))

    def escaped(self, data: Data) -> bytes:
        """The sent form of some bytes."""
        return bytes(data).translate(self.added)

    def original(self, data: Data, offset: int) -> bytes:
        """The bytes for which others were sent; `offset` is the place of these."""
        return bytes(data).translate(self.taken)

    def end(self, data: bytearray, offset: int, end: bytes) -> int:
        """The place of the end delimiter, -1 where it is not there yet."""
        return data.find(end, offset)


class Cobs:
    """Consistent overhead byte stuffing: no zero is sent; each block begins with the distance to the next zero."""

    __slots__ = ()

    def escaped(self, data: Data) -> bytes:
        """The sent form of some bytes."""
        result, block = bytearray(), bytearray()
        for byte in data:
            if len(block) == 254:
                result += b"\xff" + block
                block.clear()
            if byte:
                block.append(byte)
            else:
                result.append(len(block) + 1)
                result += block
                block.clear()
        result.append(len(block) + 1)
        return bytes(result + block)

    def original(self, data: Data, offset: int) -> bytes:
        """The bytes for which others were sent; `offset` is the place of these. Raises CodecError."""
        result, index = bytearray(), 0
        while index < len(data) or not data:
            code = data[index] if data else 0
            block = data[index + 1 : index + code]
            if not code or len(block) < code - 1 or 0 in block:
                raise CodecError("wrong_mark", f"the block of {code} bytes is not complete", offset + index)
            result += block
            index += code
            if code < 0xFF and index < len(data):
                result.append(0)
        return bytes(result)

    def end(self, data: bytearray, offset: int, end: bytes) -> int:
        """The place of the end delimiter, -1 where it is not there yet."""
        return data.find(end, offset)


class EscapedFrames(PartFrames):
    """Frames whose parts are escaped from `first` to `last`, the bounds of a slice.

    The lengths and checksums at the places `sent_codes` apply to the sent bytes, those at `own` do not.
    """

    __slots__ = ("escape", "first", "last", "own", "sent")

    def escaping(
        self,
        escape: Replace | Insert | Add | Cobs | CanIdentifier,
        first: int,
        last: int | None,
        sent_codes: frozenset[int],
        own: frozenset[int],
    ) -> EscapedFrames:
        """The same frames with their escape."""
        self.escape, self.first, self.last, self.sent, self.own = escape, first, last, sent_codes, own
        return self

    @property
    def _own(self) -> frozenset[int]:
        return self.own

    def original(self, data: Data) -> Data:
        """The parts before they were escaped. Raises CodecError for a wrong length or checksum around them."""
        size = len(data)
        if size < self.head_size + self.tail_size:
            minimum = self.head_size + self.tail_size
            raise CodecError("incomplete", f"a frame has at least {minimum} bytes, not {size}", size)
        numbers = self._numbers(data)
        early = [place for place, *_ in self.lengths if place in self.sent and place in self.digits]
        wrong = self._no_digits(data, numbers, early)
        if wrong is not None:
            raise wrong
        self._compare_lengths(numbers, size, self.sent)
        wrong = self._wrong_checksum(data, numbers, self.sent)
        if wrong is not None:
            raise wrong
        stop = size if self.last is None else size + self.last
        inner = self.escape.original(data[self.first : stop], len(self.start) + self.first)
        return bytes(data[: self.first]) + inner + bytes(data[stop:])

    def split(self, data: Data) -> tuple[tuple[int, ...], Data]:
        """The header and the body of the parts of a frame. Raises CodecError."""
        return super().split(self.original(data))

    def _sent(self, data: bytes) -> bytes:
        stop = len(data) + (self.last or 0)
        return data[: self.first] + self.escape.escaped(data[self.first : stop]) + data[stop:]


class EscapeFramer(Framer):
    """For frames whose end delimiter does not occur among their bytes, because these are escaped.

    `shortest` and `longest` are the sizes without the bytes that escaping adds; `maximum` is the greatest size with
    them.
    """

    def __init__(self, frames: EscapedFrames, *, maximum: int, **common: Any) -> None:
        self.escaped_frames, self.most = frames, maximum
        super().__init__(frames, **common)

    def _prepare(self) -> None:
        """Delimiters are searched literally, so there is nothing to prepare."""

    def _extent(self, buffer: bytearray, offset: int) -> int:
        return -1

    def feed(self, data: Data) -> list[bytes]:
        """The frames that these bytes complete, each with its delimiters and checksum."""
        buffer, start, end = self._buffer, self.frames.start, self.frames.end
        buffer += data
        frames: list[bytes] = []
        offset = 0
        while offset < len(buffer):
            if start and not buffer.startswith(start, offset):
                next_start = buffer.find(start, offset)
                if next_start < 0:
                    next_start = max(offset, len(buffer) - len(start) + 1)
                    self.dropped += next_start - offset
                    offset = next_start
                    break
                self.dropped += next_start - offset
                offset = next_start
            close = self.escaped_frames.escape.end(buffer, offset + len(start), end)
            if close < 0:
                if len(buffer) - offset <= self.most:
                    break
                self.dropped += 1
                offset += 1
                continue
            frame = bytes(buffer[offset : close + len(end)])
            if self._holds(frame):
                frames.append(frame)
                offset = close + len(end)
            else:
                # What ends bytes that are not a frame may begin one, or the frame may begin later.
                next_offset = offset + 1 if start else close + len(end)
                self.dropped += next_offset - offset
                offset = next_offset
        del buffer[:offset]
        return frames

    def idle(self) -> list[bytes]:
        """Nothing: frames with delimiters may pause, so silence decides nothing."""
        return []

    def _holds(self, frame: bytes) -> bool:
        frames = self.escaped_frames
        try:
            data = frames.original(frames.unmarked(frame))
            frames.split(frames.unmarked(frame))
        except CodecError:
            return False
        marks = len(frames.start) + len(frames.end)
        return self.shortest <= len(data) + marks <= self.longest and not self._foreign(bytearray(data), 0)
