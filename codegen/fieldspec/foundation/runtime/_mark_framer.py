"""Frames of characters between delimiters."""

from __future__ import annotations

from ._error import CodecError
from ._framers import Framer
from ._typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ._typing import Data


class MarkFramer(Framer):
    """For frames of characters between a start and an end delimiter, neither of which occurs within."""

    def _prepare(self) -> None:
        """Delimiters are searched literally. The last bytes of one that ends no frame may begin one."""
        start, end = self.frames.start, self.frames.end
        self._common = next(size for size in range(len(end), -1, -1) if start.startswith(end[len(end) - size :]))

    def _extent(self, buffer: bytearray, offset: int) -> int:
        return -1

    def feed(self, data: Data) -> list[bytes]:
        """The frames that these bytes complete, each with its delimiters and checksum."""
        buffer, start, end = self._buffer, self.frames.start, self.frames.end
        buffer += data
        frames: list[bytes] = []
        done = 0
        while (close := buffer.find(end, done + len(start))) >= 0:
            open_ = buffer.rfind(start, done, close)
            if open_ >= 0:
                frame = bytes(buffer[open_ : close + len(end)])
                if self._holds(frame):
                    frames.append(frame)
                    self.dropped += open_ - done
                    done = close + len(end)
                    continue
            next_offset = close + len(end) - self._common
            self.dropped += next_offset - done
            done = next_offset
        # Only the bytes after the last start delimiter, or a part of a delimiter, can still become a frame.
        open_ = buffer.rfind(start, done)
        keep = open_ if open_ >= 0 and len(buffer) - open_ < self.longest else max(done, len(buffer) - len(start) + 1)
        self.dropped += keep - done
        del buffer[:keep]
        return frames

    def idle(self) -> list[bytes]:
        """Nothing: frames with delimiters may pause, so silence decides nothing."""
        return []

    def _holds(self, frame: bytes) -> bool:
        frames = self.frames
        inner = frame[len(frames.start) : len(frame) - len(frames.end)]
        if not self.shortest <= len(frame) <= self.longest or len(inner) % 2 or not _hexadecimal(inner):
            return False
        data = bytearray.fromhex(inner.decode("ascii"))
        if self._foreign(data, 0):
            return False
        if frames.length < 0:
            return frames.agrees(data)
        try:
            frames.split(data)
        except CodecError:
            return False
        return True


_HEX = b"0123456789ABCDEFabcdef"


def _hexadecimal(text: bytes) -> bool:
    return not text.translate(None, _HEX)
