"""Sources of payloads: captures and logs, read in batches, from the beginning or from where another run stopped."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator
from typing import Any, Protocol

import numpy as np

from fieldspec.captures.capture_files import CaptureReader, Read
from fieldspec.captures.columns import Bytes, numbers
from fieldspec.captures.log_times import LogClock
from fieldspec.captures.network import Network, Segments
from fieldspec.captures.payloads import DIRECTION_CODES, UNKNOWN, Names, Payloads, payloads_of
from fieldspec.captures.tcp import StreamOrder
from fieldspec.explain.log import Unreadable, log_line
from fieldspec.model.link import Link

LINES = 1 << 14
"""The lines of a log in one batch."""

LONGEST_LINE = 8192

_MAGICS = (b"\xd4\xc3\xb2\xa1", b"\xa1\xb2\xc3\xd4", b"\x4d\x3c\xb2\xa1", b"\xa1\xb2\x3c\x4d", b"\x0a\x0d\x0d\x0a")


class Source(Protocol):
    """What payloads come from. `position` counts the bytes of the file that are read; the counters say what is lost."""

    position: int

    def payloads(self) -> Iterator[Payloads]:
        """All payloads in batches."""

    def state(self) -> dict[str, Any]:
        """What another source needs to go on behind the last batch."""

    def counters(self) -> dict[str, Counter[str]]:
        """What is skipped, lost and remarkable, by kind."""


def is_capture(head: bytes) -> bool:
    """Whether a file begins like a capture."""
    return head[:4] in _MAGICS


class PacketSource:
    """A capture of packets."""

    def __init__(
        self,
        read: Read,
        names: Names,
        ports: Collection[int],
        state: dict[str, Any] | None = None,
        usual: Collection[tuple[str, int]] = (),
    ) -> None:
        self.reader = CaptureReader(read, state["reader"] if state else None)
        self.network = Network(ports, names, usual)
        self.order = StreamOrder(state["order"] if state else None)
        self.packets = state["packets"] if state else 0
        self.position = self.reader.position

    def state(self) -> dict[str, Any]:
        """What another source needs to go on behind the last batch."""
        return {"reader": self.reader.state(self.position), "order": self.order.state(), "packets": self.packets}

    def counters(self) -> dict[str, Counter[str]]:
        """What is skipped, lost and remarkable, by kind."""
        return {"skipped": self.network.skipped, "bytes lost": self.reader.losses, "events": self.order.events}

    def payloads(self) -> Iterator[Payloads]:
        """All payloads in batches. Raises CaptureError."""
        for packets in self.reader.batches():
            self.position = packets.end
            segments = self.network.segments(packets, self.reader.interfaces, self.packets + 1)
            self.packets += len(packets.at)
            yield self.order.payloads(packets.buffer, segments)
        nothing: Bytes = np.zeros(1, np.uint8)
        rest = self.order.rest(nothing, Segments(*(numbers([]) for _ in range(8))))
        if len(rest):
            yield rest


class LogSource:
    """A log of a serial line: frames or pieces of frames, one in each line, with or without times and marks."""

    def __init__(
        self, readline: Read, names: Names, links: Collection[Link], state: dict[str, Any] | None = None
    ) -> None:
        self.readline, self.links = readline, links
        self.names = names
        self.skipped: Counter[str] = Counter()
        self.number = state["number"] if state else 0
        self.position = state["position"] if state else 0
        self.clock = LogClock(state["time"] if state else None)
        self.mark = state["mark"] if state else ""

    def state(self) -> dict[str, Any]:
        """What another source needs to go on behind the last batch."""
        return {"number": self.number, "position": self.position, "time": self.clock.last, "mark": self.mark}

    def counters(self) -> dict[str, Counter[str]]:
        """What is skipped, by kind."""
        return {"skipped": self.skipped}

    def payloads(self) -> Iterator[Payloads]:
        """All payloads in batches."""
        stream = self.names.place("log")
        rows: list[tuple[bytes, int | None, int, int, int]] = []
        while line := self.readline(LONGEST_LINE):
            self.number += 1
            self.position += len(line)
            rest = line
            while len(rest) == LONGEST_LINE and not rest.endswith(b"\n"):
                rest = self.readline(LONGEST_LINE)
                self.position += len(rest)
            row = self._row(line, stream)
            if row is not None:
                rows.append(row)
            if len(rows) >= LINES:
                yield payloads_of(rows, is_datagram=False)
                rows = []
        if rows:
            yield payloads_of(rows, is_datagram=False)

    def _row(self, line: bytes, stream: int) -> tuple[bytes, int | None, int, int, int] | None:
        """The payload of a line; None where it has none."""
        if self.number == 1:
            for mark in (b"\xef\xbb\xbf", b"\xff\xfe", b"\xfe\xff"):
                line = line.removeprefix(mark)
        text = line.replace(b"\0", b"").decode("utf-8", "replace")
        if len(line) >= LONGEST_LINE:
            self.skipped[f"lines of {LONGEST_LINE} characters or more"] += 1
            return None
        try:
            record = log_line(text, self.links)
        except Unreadable:
            self.skipped["lines without bytes"] += 1
            return None
        if record is None:
            return None
        self.mark = record.direction or self.mark
        if not record.frame:
            return None
        direction = DIRECTION_CODES.get(self.mark, UNKNOWN)
        self.mark = ""
        return record.frame, self.clock.time(text), self.number, stream, direction
