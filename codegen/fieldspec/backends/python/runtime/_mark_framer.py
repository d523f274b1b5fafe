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
        """Delimiters are searched literally, so there is nothing to prepare."""

    def _extent(self, buffer: bytearray, at: int) -> int:
        return -1

    def feed(self, data: Data) -> list[bytes]:
        """The frames that these bytes complete, each with its delimiters and checksum."""
        buffer, start, end = self._buffer, self.frames.start, self.frames.end
        buffer += data
        frames: list[bytes] = []
        done = 0
        while (first := buffer.find(start, done)) >= 0:
            close = buffer.find(end, first + len(start))
            if close < 0:
                break
            open_ = buffer.rfind(start, first, close)
            frame = bytes(buffer[open_ : close + len(end)])
            if self._holds(frame):
                frames.append(frame)
                self.dropped += open_ - done
                done = close + len(end)
            else:
                # What ends bytes that are no frame may begin one, where both delimiters are the same.
                self.dropped += open_ + 1 - done
                done = open_ + 1
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
        try:
            frames.split(data)
        except CodecError:
            return False
        return True


_HEX = b"0123456789ABCDEFabcdef"


def _hexadecimal(text: bytes) -> bool:
    return not text.translate(None, _HEX)
