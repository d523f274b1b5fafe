"""A line of a simulated device: bytes in, bytes out, with faults between. It opens nothing and waits for nothing."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from fieldspec.foundation.classes import dataclass
from fieldspec.tools.simulator.codecs import Framer
from fieldspec.tools.simulator.faults import Faults
from fieldspec.tools.simulator.server import Server

Listener = Callable[[float, str, str, bytes, str], None]
"""Called with the time, the link, `request` or `response`, the bytes, and what they are."""


@dataclass(frozen=True, slots=True)
class Sending:
    """Bytes to send after some seconds. With `hang_up`, the connection is closed instead."""

    seconds: float
    data: bytes
    hang_up: bool = False


_MOST_RECENT = 65536
"""The bytes without a frame that are kept: no frame has more."""


class Line:
    """One connection to a device. `message` names the message of frames that do not name it.

    `framing` makes framers of the link; it gives None where the frames come whole.
    """

    def __init__(
        self,
        server: Server,
        link: str,
        framing: Callable[[], Framer | None],
        faults: Faults,
        listener: Listener,
        message: str = "",
    ) -> None:
        self.server, self.link, self.faults, self.listener = server, link, faults, listener
        self.message, self.framing, self.framer = message, framing, framing()
        self.delay = timing(server, "response_delay")
        """The seconds from a request to its response."""
        self._paused = False
        """Whether there was a pause since the last byte."""
        self._recent = bytearray()
        """The bytes since the last frame or silence."""
        self._unframed = 0
        """How many bytes the framer has taken that were not a part of a frame, with those that it has dropped."""

    def feed(self, now: float, data: bytes) -> Iterator[Sending]:
        """What to send after some bytes have come: the answers to the frames that they complete."""
        if self.framer is None:
            yield from self._answered(now, data)
            return
        if self._paused and self._is_whole(data):
            self._give_up(now)
        self._paused = False
        self._recent += data
        del self._recent[:-_MOST_RECENT]
        self._unframed += len(data)
        frames = self.framer.feed(data)
        if frames:
            self._recent = self._recent.rpartition(frames[-1])[2]
            self._unframed -= sum(map(len, frames))
        for frame in frames:
            yield from self._answered(now, frame)

    def idle(self, now: float) -> Iterator[Sending]:
        """What to send after the line has been silent: a frame may end with a silence."""
        if self.framer is None or not self._recent:
            return
        whole = bytes(self._recent)
        self._recent.clear()
        frames = self.framer.idle()
        self._unframed -= sum(map(len, frames))
        if not frames and self.server.codecs[self.link].has_right_checksum(whole, "request"):
            frames = [whole]  # a request with a code that no message has
        for frame in frames:
            yield from self._answered(now, frame)
        if not frames:
            self.listener(now, self.link, "request", whole, "no frame")

    def pause(self, now: float) -> Iterator[Sending]:
        """What to send after a pause in a stream, in which a frame that has begun can still go on.

        The bytes so far are a frame where only silence ends it, or where they have the right checksum and no
        frame can begin with them, as with a code that no message has.
        """
        if self.framer is None or not self._recent:
            return
        self._paused = True
        whole = bytes(self._recent)
        if self.is_damaged and self.server.codecs[self.link].has_right_checksum(whole, "request"):
            self.framer.reset()
            self._unframed = self.framer.dropped
        elif self.is_damaged or self.framer.pause() != [whole]:
            return
        yield from self.idle(now)

    def _is_whole(self, data: bytes) -> bool:
        """Whether bytes after a pause are a frame by themselves and do not continue an earlier frame."""
        alone = self.framing() if self._recent else None
        return alone is not None and alone.feed(data) == [data]

    def _give_up(self, now: float) -> None:
        """Drops the bytes of a frame that has begun and does not go on, as where its length is damaged."""
        self.listener(now, self.link, "request", bytes(self._recent), "no frame")
        self._recent.clear()
        self._unframed = 0
        self.framer = self.framing()

    @property
    def waiting(self) -> bool:
        """Whether bytes have come that are not a frame yet."""
        return bool(self._recent)

    @property
    def is_damaged(self) -> bool:
        """Whether some of the bytes since the last frame or silence cannot belong to a frame."""
        return self.framer is not None and len(self._recent) > self._unframed - self.framer.dropped

    def _answered(self, now: float, frame: bytes) -> Iterator[Sending]:
        engine = self.server.engine
        engine.advance(now)
        fault = self.faults.next(now)
        answer = self.server.answer(self.link, frame, self.message, fault.refusal(self.server) if fault else "")
        self.listener(now, self.link, "request", frame, answer.text)
        if fault is not None and fault.kind == "power_cycle":
            engine.power_on()
            return
        if fault is not None and fault.kind == "connection_lost":
            yield Sending(0.0, b"", hang_up=True)
            return
        if not answer.frame:
            return
        sent_frame, late = answer.frame, 0.0
        if fault is not None:
            sent_frame, late = self.faults.damaged(fault, self.server, self.link, sent_frame)
        text = f"{answer.text}, {fault.kind}" if fault is not None else answer.text
        if sent_frame:
            self.listener(now, self.link, "response", sent_frame, text)
            yield Sending(self.delay + late, sent_frame)
        else:
            self.listener(now, self.link, "response", b"", text)


def timing(server: Server, name: str) -> float:
    """A time of the behaviour in seconds: the least that its limit permits; 0 where the behaviour has none."""
    engine = server.engine
    part = next((part for part in engine.behaviour.of_kind("timing") if part.subject == name), None)
    if part is None:
        return 0.0
    limit = next((limit for limit in engine.layout.device.limits if limit.place.path == part["limit"]), None)
    bound = None if limit is None else limit.low if limit.low is not None else limit.most
    if limit is None or bound is None:
        return 0.0
    return float(bound) * {"ms": 0.001, "µs": 0.000001}.get(limit.unit, 1.0)
