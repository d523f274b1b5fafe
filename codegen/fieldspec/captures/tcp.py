"""Puts the segments of TCP streams in order: drops what is sent again, and notices what the capture lacks."""

from __future__ import annotations

from collections import Counter
from typing import Any

import numpy as np

from fieldspec.captures.columns import Bytes, Mask, Numbers, numbers, runs
from fieldspec.captures.network import DATAGRAM, Segments
from fieldspec.captures.payloads import Payloads
from fieldspec.classes import dataclass

SYN = 2
NUMBERS = 1 << 32
MOST_WAITING = 3
"""The segments that wait for an earlier one. With one more, the missing bytes count as lost: in a capture they are."""


@dataclass(frozen=True, slots=True)
class Waiting:
    """A segment that came before its turn."""

    sequence: int
    data: bytes
    time: int
    packet: int


@dataclass(slots=True)
class _Late:
    """A segment that has waited: `order` is its place among the others, `after_loss` whether bytes before it lack."""

    key: int
    segment: Waiting
    order: int
    after_loss: bool


class StreamOrder:
    """The order of all streams of a source. `events` counts what is not as it should be.

    `expected` has the number of the next byte by stream and direction, `waiting` the segments that are too early.
    """

    def __init__(self, state: dict[str, Any] | None = None) -> None:
        self.events: Counter[str] = Counter()
        self.expected: dict[int, int] = {}
        self.waiting: dict[int, list[Waiting]] = {}
        if state:
            self.expected = {int(key): number for key, number in state["expected"].items()}
            for key, segments in state["waiting"].items():
                own = [Waiting(sequence, bytes.fromhex(data), *rest) for sequence, data, *rest in segments]
                self.waiting[int(key)] = own

    def state(self) -> dict[str, Any]:
        """What another object needs to go on."""
        waiting = {
            key: [(each.sequence, each.data.hex(), each.time, each.packet) for each in segments]
            for key, segments in self.waiting.items()
            if segments
        }
        return {"expected": self.expected, "waiting": waiting}

    def payloads(self, buffer: Bytes, segments: Segments) -> Payloads:
        """The payloads in the order of their streams. Datagrams stay as they are.

        Segments that follow one another are taken as columns; only the others are looked at one by one.
        """
        is_tcp = segments.sequence >= 0
        step = _Step(buffer, segments, segments.size > 0, np.zeros(len(is_tcp), np.bool_), [])
        for key, own in runs(np.where(is_tcp, segments.stream * 2 + segments.direction, -1)):
            if key >= 0:
                self._stream(key, own, step)
        return step.payloads(segments.sequence == DATAGRAM)

    def rest(self, buffer: Bytes, nothing: Segments) -> Payloads:
        """The payloads that still wait at the end of a source."""
        step = _Step(buffer, nothing, np.zeros(0, np.bool_), np.zeros(0, np.bool_), [])
        for key in list(self.waiting):
            while self.waiting[key]:
                self._give_up(key, step)
        return step.payloads(np.zeros(0, np.bool_))

    def _stream(self, key: int, own: Numbers, step: _Step) -> None:
        segments = step.segments
        starts = (segments.flags[own] & SYN) != 0
        sequence = (segments.sequence[own] + starts) % NUMBERS
        after = (sequence + segments.size[own]) % NUMBERS
        breaks = np.flatnonzero((sequence[1:] != after[:-1]) | starts[1:]) + 1
        expected, at = self.expected.get(key), 0
        while at < len(own):
            first = int(sequence[at])
            if not self.waiting.get(key) and not starts[at] and expected in (None, first):
                following = int(np.searchsorted(breaks, at, "right"))
                at = int(breaks[following]) if following < len(breaks) else len(own)
                expected = int(after[at - 1])
            else:
                self.expected[key] = first if expected is None or starts[at] else expected
                self._single(key, int(own[at]), first, step)
                expected = self.expected[key]
                at += 1
        assert expected is not None
        self.expected[key] = expected

    def _single(self, key: int, row: int, sequence: int, step: _Step) -> None:
        """Takes one segment: in its turn, again, or too early."""
        segments = step.segments
        size, packet = int(segments.size[row]), int(segments.packet[row])
        ahead = (sequence - self.expected[key] + NUMBERS // 2) % NUMBERS - NUMBERS // 2
        if segments.flags[row] & SYN and self.waiting.get(key):
            while self.waiting[key]:
                self._give_up(key, step)
            self.expected[key] = sequence
        elif ahead > 0 and size:
            step.keep[row] = False
            start = int(segments.at[row])
            data = step.buffer[start : start + size].tobytes()
            self.waiting.setdefault(key, []).append(Waiting(sequence, data, int(segments.time[row]), packet))
            self.events["segments out of order"] += 1
            if len(self.waiting[key]) > MOST_WAITING:
                self._give_up(key, step)
            return
        elif ahead < 0 and size:
            self.events["segments sent again"] += 1
            again = min(-ahead, size)
            segments.at[row] += again
            segments.size[row] -= again
            step.keep[row] = size > again
            size, sequence = size - again, (sequence + again) % NUMBERS
        if size:
            self.expected[key] = (sequence + size) % NUMBERS
            self._in_turn(key, packet, step)

    def _in_turn(self, key: int, packet: int, step: _Step) -> None:
        """Takes the waiting segments whose turn has come with a packet."""
        waiting = self.waiting.get(key)
        while waiting:
            ready = min(waiting, key=lambda each: (each.sequence - self.expected[key] + NUMBERS // 2) % NUMBERS)
            ahead = (ready.sequence - self.expected[key] + NUMBERS // 2) % NUMBERS - NUMBERS // 2
            if ahead > 0:
                return
            waiting.remove(ready)
            data = ready.data[-ahead:]
            if data:
                step.late.append(_Late(key, Waiting(ready.sequence, data, ready.time, ready.packet), packet, False))
                self.expected[key] = (self.expected[key] + len(data)) % NUMBERS

    def _give_up(self, key: int, step: _Step) -> None:
        """Takes the first waiting segment although the bytes before it lack."""
        waiting = self.waiting[key]
        ready = min(waiting, key=lambda each: (each.sequence - self.expected[key]) % NUMBERS)
        waiting.remove(ready)
        self.events["gaps in streams"] += 1
        step.late.append(_Late(key, ready, ready.packet, True))
        self.expected[key] = (ready.sequence + len(ready.data)) % NUMBERS
        self._in_turn(key, ready.packet, step)


@dataclass(frozen=True, slots=True)
class _Step:
    """One batch of segments while it is put in order: those to keep, those behind a loss, and those that waited."""

    buffer: Bytes
    segments: Segments
    keep: Mask
    loss: Mask
    late: list[_Late]

    def payloads(self, is_datagram: Mask) -> Payloads:
        """The payloads of the batch."""
        own = self.segments
        rows = np.flatnonzero(self.keep)
        columns = [column[rows] for column in (own.at, own.size, own.time, own.packet, own.stream, own.direction)]
        if not self.late:
            return Payloads.of_columns(self.buffer, columns, is_datagram[rows], self.loss[rows])
        data = b"".join(each.segment.data for each in self.late)
        buffer = np.concatenate([self.buffer, np.frombuffer(data, np.uint8)])
        sizes = numbers([len(each.segment.data) for each in self.late])
        more = [
            len(self.buffer) + np.cumsum(sizes) - sizes,
            sizes,
            numbers([each.segment.time for each in self.late]),
            numbers([each.segment.packet for each in self.late]),
            numbers([each.key // 2 for each in self.late]),
            numbers([each.key % 2 for each in self.late]),
        ]
        places = np.concatenate([columns[3], numbers([each.order for each in self.late])])
        order = np.argsort(places, kind="stable")
        joined = [np.concatenate([left, right])[order] for left, right in zip(columns, more, strict=True)]
        datagram = np.concatenate([is_datagram[rows], np.zeros(len(self.late), np.bool_)])[order]
        loss = np.concatenate([self.loss[rows], np.array([each.after_loss for each in self.late])])[order]
        return Payloads.of_columns(buffer, joined, datagram, loss)
