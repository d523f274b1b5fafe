"""Frames that end with a delimiter which may also occur within them, and whose length nothing else determines."""

from __future__ import annotations

from ._error import CodecError
from ._framers import Framer
from ._typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from ._frames import Frames
    from ._typing import Data


class EndFramer(Framer):
    """For frames whose end delimiter alone may show where they end.

    A frame ends with the first end delimiter with which the link decodes it. `decode` is the decoder of the link. Where
    frames do not identify their message, `messages` are those to try. `first_bytes` are the possible values of the
    first bytes after the start delimiter, by their place.

    A frame whose data the link refuses is a frame too, if all other parts are right. It comes when the line is silent,
    or when no frame from there on can be longer.
    """

    def __init__(
        self,
        frames: Frames,
        *,
        decode: Callable[..., Any],
        messages: tuple[Any, ...] = (),
        first_bytes: dict[int, bytes] | None = None,
        **common: Any,
    ) -> None:
        self.decode, self.messages, self.begins = decode, messages, first_bytes or {}
        self._examined = 0
        super().__init__(frames, **common)

    def _prepare(self) -> None:
        """Prepares the possible values of the bytes at the beginning of a frame."""
        start = self.frames.start
        known = self._known()
        known.update((len(start) + place, frozenset(values)) for place, values in self.begins.items())
        self._first = sorted(known.items())

    def feed(self, data: Data) -> list[bytes]:
        """The frames that these bytes complete, each with its delimiters and checksum."""
        self._buffer.extend(data)
        return self._cut(False)

    def idle(self) -> list[bytes]:
        """The frames up to the last end delimiter, when the line has been silent; it drops the other bytes up to there.

        The bytes after that delimiter stay, as a frame that has begun may pause.
        """
        return self._cut(True)

    def reset(self) -> None:
        """Drops all bytes so far."""
        self._buffer.clear()
        self._examined = 0

    @property
    def missing(self) -> int:
        """How many bytes the next frame still needs at the least."""
        return max(1, self.shortest - len(self._buffer))

    def pause(self) -> list[bytes]:
        """The frames that `idle` would return. It drops nothing, so that a frame that has begun can still go on."""
        examined = self._examined
        frames = super().pause()
        self._examined = examined
        return frames

    def _extent(self, buffer: bytearray, offset: int) -> int:
        return -1

    def _cut(self, is_silent: bool) -> list[bytes]:
        buffer = self._buffer
        frames: list[bytes] = []
        offset = 0
        examined = self._examined
        while offset < len(buffer):
            stop = 0
            if self._may_begin(offset):
                stop = self._stop(offset, examined, self._accepts)
                if (
                    not stop
                    and len(buffer) - offset <= self.longest
                    and not (is_silent and self._next_end(offset) >= 0)
                ):
                    examined = len(buffer) - offset
                    break
                stop = stop or self._refused(offset)
            if stop:
                frames.append(bytes(buffer[offset:stop]))
            else:
                self.dropped += 1
            offset, examined = stop or offset + 1, 0
        self._examined = examined
        del buffer[:offset]
        return frames

    def _next_end(self, offset: int) -> int:
        """The place of the first end delimiter after a byte; -1 for none."""
        return self._buffer.find(self.frames.end, offset + len(self.frames.start))

    def _may_begin(self, offset: int) -> bool:
        """Whether a frame may begin at a byte, as far as the bytes are there."""
        buffer = self._buffer
        size = len(buffer) - offset
        return all(buffer[offset + place] in values for place, values in self._first if place < size)

    def _stop(self, offset: int, examined: int, fits: Callable[[bytes], bool], limit: int | None = None) -> int:
        """The end of the shortest frame that begins at a byte and fits; 0 for none.

        No end among the first `examined` bytes fits, and none after the place `limit` counts.
        """
        buffer, end = self._buffer, self.frames.end
        close = max(offset + self.shortest, offset + examined + 1) - len(end)
        limit = min(len(buffer) if limit is None else limit, offset + self.longest)
        while (close := buffer.find(end, close, limit)) >= 0:
            stop = close + len(end)
            if fits(bytes(buffer[offset:stop])):
                return stop
            close += 1
        return 0

    def _refused(self, offset: int) -> int:
        """The end of a frame whose data the link refuses; 0 for none, and where one that it accepts begins within.

        Bytes that come when this is decided do not count: frames do not depend on the pieces in which they come.
        """
        stop, limit = self._stop(offset, 0, self._holds), min(len(self._buffer), offset + self.longest + 1)
        inner_offsets = (place for place in range(offset + 1, stop) if self._may_begin(place))
        return 0 if any(self._stop(place, 0, self._accepts, limit) for place in inner_offsets) else stop

    def _accepts(self, frame: bytes) -> bool:
        return self._holds(frame) and any(self._decodes(frame, message) for message in self.messages or (None,))

    def _decodes(self, frame: bytes, message: Any) -> bool:
        try:
            if message is None:
                self.decode(frame)
            else:
                self.decode(frame, message)
        except CodecError:
            return False
        return True

    def _holds(self, frame: bytes) -> bool:
        frames = self.frames
        inner = frame[len(frames.start) : len(frame) - len(frames.end)]
        return not self._foreign(bytearray(inner), 0) and frames.agrees(inner)
