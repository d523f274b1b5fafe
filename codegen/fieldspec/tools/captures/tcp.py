"""Puts the segments of TCP streams in order: drops what is sent again, and notices what the capture lacks."""

from __future__ import annotations

from collections import Counter
from typing import Any

import numpy as np

from fieldspec.foundation.classes import dataclass, field
from fieldspec.tools.captures.columns import Bytes, Mask, Numbers, numbers, runs
from fieldspec.tools.captures.network import NO_SEGMENTS, Segments
from fieldspec.tools.captures.payloads import PIECE, STREAM, Payloads

SYN, ACK = 2, 16
NUMBERS = 1 << 32
MOST_WAITING = 64
"""The segments that wait for an earlier one. With one more, the missing bytes count as lost."""

FARTHEST = 1 << 24
"""The bytes between two segments of a connection. Farther away, another connection has the same ports."""


@dataclass(frozen=True, slots=True)
class Waiting:
    """A segment that came before its turn. `length` is the size of its data before the capture cut it short."""

    sequence: int
    data: bytes
    length: int
    time: int
    packet: int


@dataclass(slots=True)
class _Late:
    """A segment that has waited. It comes after the packet `order`; `after_loss`: bytes before it lack."""

    key: int
    segment: Waiting
    order: int
    after_loss: bool


class StreamOrder:
    """The order of all streams of a source. `events` counts what is not as it should be.

    By stream and direction, `expected` has the number of the next byte, and `waiting` the segments that are too early.
    `captured` has the number after the last byte that the capture has, where that is not the number of the next one.
    """

    def __init__(self, state: dict[str, Any] | None = None) -> None:
        self.events: Counter[str] = Counter()
        self.expected: dict[int, int] = {}
        self.captured: dict[int, int] = {}
        self.waiting: dict[int, list[Waiting]] = {}
        if state:
            self.expected = {int(key): number for key, number in state["expected"].items()}
            self.captured = {int(key): number for key, number in state["captured"].items()}
            for key, segments in state["waiting"].items():
                own = [Waiting(sequence, bytes.fromhex(data), *rest) for sequence, data, *rest in segments]
                self.waiting[int(key)] = own

    def state(self) -> dict[str, Any]:
        """The state from which another object continues."""
        waiting = {
            key: [
                (segment.sequence, segment.data.hex(), segment.length, segment.time, segment.packet)
                for segment in segments
            ]
            for key, segments in self.waiting.items()
            if segments
        }
        return {"expected": self.expected, "captured": self.captured, "waiting": waiting}

    def payloads(self, buffer: Bytes, segments: Segments) -> Payloads:
        """The payloads in the order of their streams. Datagrams stay as they are.

        Segments that follow one another are taken as columns; only the others are processed one by one.
        """
        step = _Step(buffer, segments, segments.size > 0, np.zeros(len(segments.at), np.bool_))
        cut_short = int(np.count_nonzero(segments.length > segments.size))
        if cut_short:
            self.events["payloads that the capture cut short"] += cut_short
        keys = np.where(segments.carrier == STREAM, segments.stream * 2 + segments.direction, -1)
        rows = {key: own for key, own in runs(keys) if key >= 0}
        for key, own in rows.items():
            self._stream(key, own, step)
        for key in self.waiting:
            self._acknowledge(key, rows.get(key ^ 1), step)
        if cut_short or self.captured:
            for stream, own in runs(np.where(segments.carrier == PIECE, segments.stream, -1)):
                self._line(stream, own, step)
        return step.payloads()

    def rest(self, buffer: Bytes) -> Payloads:
        """The payloads that still wait at the end of a source."""
        step = _Step(buffer, NO_SEGMENTS, np.zeros(0, np.bool_), np.zeros(0, np.bool_))
        for key in self.waiting:
            while self.waiting[key]:
                self._give_up(key, step)
        return step.payloads()

    def _stream(self, key: int, own: Numbers, step: _Step) -> None:
        segments = step.segments
        starts = (segments.flags[own] & SYN) != 0
        sequence = (segments.sequence[own] + starts) % NUMBERS
        size, length = segments.size[own], segments.length[own]
        after = (sequence + length) % NUMBERS
        breaks = np.flatnonzero((sequence[1:] != after[:-1]) | starts[1:] | (length > size)[:-1]) + 1
        expected, index = self.expected.get(key), 0
        while index < len(own):
            first = int(sequence[index])
            if (
                not self.waiting.get(key)
                and not starts[index]
                and expected in (None, first)
                and key not in self.captured
            ):
                following = int(np.searchsorted(breaks, index, "right"))
                index = int(breaks[following]) if following < len(breaks) else len(own)
                expected, step.last[key] = int(after[index - 1]), int(segments.packet[own[index - 1]])
                if size[index - 1] < length[index - 1]:
                    self.captured[key] = int(sequence[index - 1] + size[index - 1]) % NUMBERS
            else:
                self.expected[key] = first if expected is None else expected
                self._single(key, int(own[index]), first, bool(starts[index]), step)
                expected = self.expected[key]
                index += 1
        assert expected is not None
        self.expected[key] = expected

    def _single(self, key: int, row: int, sequence: int, starts: bool, step: _Step) -> None:
        """Takes one segment: in its turn, again, or too early."""
        segments = step.segments
        size, length, packet = int(segments.size[row]), int(segments.length[row]), int(segments.packet[row])
        if starts or (length and abs(_ahead(sequence, self.expected[key])) > FARTHEST):
            while self.waiting.get(key):
                self._give_up(key, step)
            self.expected[key] = sequence
            self.captured[key] = (sequence - 1) % NUMBERS  # nothing before it belongs to it
        ahead = _ahead(sequence, self.expected[key])
        if not length:
            return
        if ahead > 0:
            step.keep[row] = False
            start = int(segments.at[row])
            data = step.buffer[start : start + size].tobytes()
            self.waiting.setdefault(key, []).append(Waiting(sequence, data, length, int(segments.time[row]), packet))
            self.events["segments out of order"] += 1
            if len(self.waiting[key]) > MOST_WAITING:
                self._give_up(key, step)
            return
        repeated = min(max(_ahead(self.captured.get(key, self.expected[key]), sequence), 0), length)
        if repeated:
            self.events["segments sent again"] += 1
            segments.at[row] += repeated
            segments.size[row] = max(size - repeated, 0)
            step.keep[row] = size > repeated
        if length > repeated:
            new_size = max(size - repeated, 0)
            step.loss[row] = self._take(key, (sequence + repeated) % NUMBERS, new_size, length - repeated)
            step.last[key] = packet
            self._in_turn(key, step)

    def _take(self, key: int, sequence: int, size: int, length: int) -> bool:
        """Goes on after a segment that is in its turn. Returns whether bytes before it lack."""
        before = self.captured.pop(key, sequence)
        end = (sequence + length) % NUMBERS
        if _ahead(end, self.expected[key]) > 0:
            self.expected[key] = end
        captured = (sequence + size) % NUMBERS if size else before
        if captured != self.expected[key]:
            self.captured[key] = captured
        return before != sequence

    def _line(self, stream: int, own: Numbers, step: _Step) -> None:
        """Records where a line continues after a payload that the capture cut short."""
        if stream < 0:
            return
        is_cut = step.segments.length[own] > step.segments.size[own]
        key = -1 - stream
        step.loss[own] = np.append(key in self.captured, is_cut[:-1])
        self.captured.pop(key, None)
        if is_cut[-1]:
            self.captured[key] = 0

    def _in_turn(self, key: int, step: _Step) -> None:
        """Takes the waiting segments whose turn has come."""
        while self.waiting.get(key):
            ready = self._next(key)
            ahead = _ahead(ready.sequence, self.expected[key])
            if ahead > 0:
                return
            self.waiting[key].remove(ready)
            if ready.length + ahead > 0:
                self._take_late(key, ready, -ahead, False, step)

    def _take_late(self, key: int, ready: Waiting, repeated: int, after_loss: bool, step: _Step) -> None:
        """Takes a segment that has waited, without the bytes that came before it."""
        data, sequence = ready.data[repeated:], (ready.sequence + repeated) % NUMBERS
        after_loss |= self._take(key, sequence, len(data), ready.length - repeated)
        order = step.last[key] = max(ready.packet, step.last.get(key, 0))
        if data:
            step.late.append(
                _Late(key, Waiting(sequence, data, len(data), ready.time, ready.packet), order, after_loss)
            )

    def _next(self, key: int) -> Waiting:
        """The first of the waiting segments in the order of their stream."""
        return min(self.waiting[key], key=lambda segment: _ahead(segment.sequence, self.expected[key]))

    def _give_up(self, key: int, step: _Step) -> None:
        """Takes the first waiting segment although the bytes before it are missing."""
        ready = self._next(key)
        self.waiting[key].remove(ready)
        self.events["gaps in streams"] += 1
        self.expected[key] = ready.sequence
        self.captured.pop(key, None)
        self._take_late(key, ready, 0, True, step)
        self._in_turn(key, step)

    def _acknowledge(self, key: int, opposite: Numbers | None, step: _Step) -> None:
        """Gives up the bytes that the other side has at the end of a batch: if the capture had them, they were here."""
        if opposite is None or not self.waiting[key]:
            return
        answers = opposite[(step.segments.flags[opposite] & ACK) != 0]
        while len(answers) and self.waiting[key]:
            if _ahead(int(step.segments.acknowledged[answers[-1]]), self._next(key).sequence) < 0:
                return
            self._give_up(key, step)


def _ahead(number: int, other: int) -> int:
    """How far a number of a stream is ahead of another one; less than 0 after it."""
    return (number - other + NUMBERS // 2) % NUMBERS - NUMBERS // 2


@dataclass(frozen=True, slots=True)
class _Step:
    """One batch of segments while it is put in order: those to keep, those after a loss, and those that waited.

    `last` has by stream and direction the packet after which a segment that has waited comes.
    """

    buffer: Bytes
    segments: Segments
    keep: Mask
    loss: Mask
    late: list[_Late] = field(default_factory=list)
    last: dict[int, int] = field(default_factory=dict)

    def payloads(self) -> Payloads:
        """The payloads of the batch."""
        own = self.segments
        rows = np.flatnonzero(self.keep)
        columns = [column[rows] for column in (own.at, own.size, own.time, own.packet, own.stream, own.direction)]
        if not self.late:
            return Payloads.of_columns(self.buffer, columns, own.carrier[rows], self.loss[rows])
        data = b"".join(late.segment.data for late in self.late)
        buffer = np.concatenate([self.buffer, np.frombuffer(data, np.uint8)])
        sizes = numbers([len(late.segment.data) for late in self.late])
        late_columns = [
            len(self.buffer) + np.cumsum(sizes) - sizes,
            sizes,
            numbers([late.segment.time for late in self.late]),
            numbers([late.segment.packet for late in self.late]),
            numbers([late.key // 2 for late in self.late]),
            numbers([late.key % 2 for late in self.late]),
        ]
        places = np.concatenate([columns[3], numbers([late.order for late in self.late])])
        order = np.argsort(places, kind="stable")
        joined = [np.concatenate([left, right])[order] for left, right in zip(columns, late_columns, strict=True)]
        carrier = np.concatenate([own.carrier[rows], np.full(len(self.late), STREAM, np.int8)])[order]
        loss = np.concatenate([self.loss[rows], np.array([late.after_loss for late in self.late])])[order]
        return Payloads.of_columns(buffer, joined, carrier, loss)
