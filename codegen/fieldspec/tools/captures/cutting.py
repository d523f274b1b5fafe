"""Cuts streams of bytes into frames with the framers of the generated code, and keeps track of the bytes between."""

from __future__ import annotations

from typing import Any

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.tools.captures.columns import NO_TIME
from fieldspec.tools.captures.payloads import REQUEST, RESPONSE, UNKNOWN
from fieldspec.tools.simulator.codecs import Framer, device_module, framer

SILENCE = 10**9
"""The nanoseconds without bytes on a line after which a frame that has begun does not go on."""


@dataclass(frozen=True, slots=True)
class Piece:
    """A frame or a run of other bytes, with the time and the packet of its last byte.

    `is_payload`: it is all that one payload has.
    """

    data: bytes
    is_frame: bool
    is_payload: bool
    direction: int
    time: int
    packet: int
    stream: int


@dataclass(frozen=True, slots=True)
class _Span:
    start: int
    end: int
    direction: int


class Cutter:
    """Cuts the payloads of one link. Bytes that may still become a frame wait in `pending`, by stream and direction.

    A stream whose direction is unknown carries both; a frame that may be either is a response after a request.
    """

    def __init__(self, layout: DeviceLayout, link: str) -> None:
        self.layout, self.link = layout, link
        self._framers: dict[int, Framer] | None = None
        self.pending: dict[tuple[int, int], tuple[bytes, list[tuple[int, int, int]]]] = {}

    @property
    def framers(self) -> dict[int, Framer]:
        """The framers by direction, imported when the first payload needs them."""
        if self._framers is None:
            module = device_module(self.layout)
            ways = ((REQUEST, "request"), (RESPONSE, "response"))
            framers = ((direction, framer(module, self.link, name)) for direction, name in ways)
            self._framers = {
                direction: direction_framer for direction, direction_framer in framers if direction_framer is not None
            }
        return self._framers

    def another(self) -> Cutter:
        """Another one for the same link, to which no byte has come. It shares the framers, which keep none."""
        other = Cutter(self.layout, self.link)
        other._framers = self.framers
        return other

    @property
    def cuts(self) -> bool:
        """Whether the link has framers. The frames of one without come whole."""
        return bool(self.framers)

    def state(self) -> list[Any]:
        """The state from which another cutter continues."""
        return [[*key, data.hex(), marks] for key, (data, marks) in self.pending.items()]

    def restore(self, state: list[Any]) -> None:
        """Continues from the state of another cutter."""
        for stream, direction, data, marks in state:
            self.pending[stream, direction] = bytes.fromhex(data), [(mark[0], mark[1], mark[2]) for mark in marks]

    def is_waiting(self, stream: int, direction: int) -> bool:
        """Whether bytes of a stream are pending until the rest of their frame comes."""
        return (stream, direction) in self.pending

    def feed(
        self, stream: int, direction: int, data: bytes, time: int, packet: int, follows_loss: bool, is_stream: bool
    ) -> list[Piece]:
        """The frames and other bytes that a payload completes. In a stream of TCP no silence ends a frame."""
        key = stream, direction
        pieces: list[Piece] = []
        waiting, marks = self.pending.pop(key, (b"", []))
        if waiting and (follows_loss or (not is_stream and _is_silent(marks[-1][1], time))):
            pieces = self._cut(key, waiting, marks, True)
            waiting, marks = b"", []
        joined = waiting + data
        return pieces + self._cut(key, joined, [*marks, (len(joined), time, packet)], False)

    def finish(self) -> list[Piece]:
        """The pieces of the pending bytes at the end of a source."""
        waiting, self.pending = self.pending, {}
        return [piece for key, (data, marks) in waiting.items() for piece in self._cut(key, data, marks, True)]

    def _cut(self, key: tuple[int, int], data: bytes, marks: list[tuple[int, int, int]], is_last: bool) -> list[Piece]:
        spans: list[_Span] = []
        settled = len(data)
        for direction, own in self.framers.items():
            if key[1] not in (direction, UNKNOWN):
                continue
            own.reset()
            own.dropped = 0
            frames = own.feed(data)
            settled = min(settled, own.dropped + sum(map(len, frames)))
            if is_last:
                frames += own.idle()
            own.reset()
            position = 0
            for frame in frames:
                position = data.index(frame, position)
                spans.append(_Span(position, position + len(frame), direction))
                position += len(frame)
        if is_last:
            settled = len(data)
        pieces, position = [], 0
        for span in _chosen(spans):
            if span.start > settled or (span.start == settled and not is_last and span.end > settled):
                break
            if span.start > position:
                pieces.append(self._piece(key, data, _Span(position, span.start, UNKNOWN), marks, False))
            pieces.append(self._piece(key, data, span, marks, True))
            position = span.end
        if settled > position:
            pieces.append(self._piece(key, data, _Span(position, settled, UNKNOWN), marks, False))
            position = settled
        if position < len(data):
            self.pending[key] = data[position:], [(end - position, *rest) for end, *rest in marks if end > position]  # type: ignore[misc]
        return pieces

    @staticmethod
    def _piece(
        key: tuple[int, int], data: bytes, span: _Span, marks: list[tuple[int, int, int]], is_frame: bool
    ) -> Piece:
        _, time, packet = next(mark for mark in marks if mark[0] >= span.end)
        direction = span.direction if is_frame else key[1]
        is_payload = len(marks) == 1 and span.end - span.start == len(data)
        return Piece(data[span.start : span.end], is_frame, is_payload, direction, time, packet, key[0])


def _is_silent(before: int, after: int) -> bool:
    return NO_TIME not in (before, after) and after - before > SILENCE


def _chosen(spans: list[_Span]) -> list[_Span]:
    """Spans that do not overlap: the first that begins, then the next. Among equals, the response to a request."""
    chosen: list[_Span] = []
    ordered = sorted(spans, key=lambda span: (span.start, -span.end, span.direction))
    position = 0
    for number, span in enumerate(ordered):
        if span.start < position:
            continue
        other = ordered[number + 1] if number + 1 < len(ordered) else None
        if other is not None and (other.start, other.end) == (span.start, span.end):
            is_answer = bool(chosen) and chosen[-1].direction == REQUEST
            span = next(
                candidate for candidate in (span, other) if candidate.direction == (RESPONSE if is_answer else REQUEST)
            )
        chosen.append(span)
        position = span.end
    return chosen
