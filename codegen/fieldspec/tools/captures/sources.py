"""Sources of payloads: captures and logs, read in batches, from the beginning or from where another run stopped."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Iterator
from typing import Any, Protocol

import numpy as np

from fieldspec.codec.explain.lines import Unreadable, log_line
from fieldspec.language.model.link import Link
from fieldspec.tools.captures.capture_files import BATCH, CaptureReader, Read
from fieldspec.tools.captures.columns import Bytes
from fieldspec.tools.captures.log_times import LogClock
from fieldspec.tools.captures.network import Network
from fieldspec.tools.captures.payloads import DIRECTION_CODES, UNKNOWN, Names, Payloads, payloads_of
from fieldspec.tools.captures.tcp import StreamOrder

LINES = 1 << 14
"""The lines of a log in one batch."""

LONGEST_LINE = 8192


class Source(Protocol):
    """What payloads come from. The counters say what is lost."""

    @property
    def position(self) -> int:
        """The bytes of the file that are read."""

    def payloads(self) -> Iterator[Payloads]:
        """All payloads of the source, batch by batch."""

    def state(self) -> dict[str, Any]:
        """What another source needs to go on after the last batch."""

    def counters(self) -> dict[str, Counter[str]]:
        """The skipped, lost and remarkable payloads, by kind."""


class Lines:
    """The lines of a file, of which it keeps at most LONGEST_LINE bytes each. A line that does not end is the last one.

    `position` counts the bytes that are read, `losses` those after such a line, which `rest` counts.
    """

    def __init__(self, readline: Read, position: int = 0, rest: Callable[[], int] = lambda: 0) -> None:
        self.readline, self.position, self.rest = readline, position, rest
        self.losses: Counter[str] = Counter()

    def line(self) -> bytes:
        """The beginning of the next line; nothing at the end."""
        line = b"" if self.losses else self.readline(LONGEST_LINE)
        self.position += len(line)
        if len(line) == LONGEST_LINE and not line.endswith(b"\n"):
            line_rest = self.readline(BATCH)
            self.position += len(line_rest)
            if len(line_rest) == BATCH and not line_rest.endswith(b"\n"):
                self.losses[f"after {BATCH} bytes without the end of a line"] += self.rest()
        return line


class PacketSource:
    """A source that reads a capture of packets."""

    def __init__(
        self,
        read: Read,
        names: Names,
        ports: Collection[int],
        state: dict[str, Any] | None = None,
        usual: Collection[tuple[str, int]] = (),
        rest: Callable[[], int] | None = None,
    ) -> None:
        self.reader = CaptureReader(read, state["reader"] if state else None, rest)
        self.network = Network(ports, names, usual)
        self.order = StreamOrder(state["order"] if state else None)
        self.packets = state["packets"] if state else 0
        self.position = self.reader.position

    def state(self) -> dict[str, Any]:
        """What another source needs to go on after the last batch."""
        return {"reader": self.reader.state(self.position), "order": self.order.state(), "packets": self.packets}

    def counters(self) -> dict[str, Counter[str]]:
        """The skipped, lost and remarkable payloads, by kind."""
        return {"skipped": self.network.skipped, "bytes lost": self.reader.losses, "events": self.order.events}

    def payloads(self) -> Iterator[Payloads]:
        """All payloads in batches. Raises CaptureError."""
        for packets in self.reader.batches():
            self.position = packets.end
            segments = self.network.segments(packets, self.reader.interfaces, self.packets + 1)
            self.packets += len(packets.at)
            yield self.order.payloads(packets.buffer, segments)
        nothing: Bytes = np.zeros(1, np.uint8)
        rest = self.order.rest(nothing)
        if len(rest):
            yield rest


class LogSource:
    """A log of a serial line: frames or pieces of frames, one in each line, with or without times and marks."""

    def __init__(
        self, lines: Lines, names: Names, links: Collection[Link], state: dict[str, Any] | None = None
    ) -> None:
        self.lines, self.names, self.links = lines, names, links
        self.skipped: Counter[str] = Counter()
        self.number = state["number"] if state else 0
        self.clock = LogClock(state["time"] if state else None)
        self.mark = state["mark"] if state else ""

    @property
    def position(self) -> int:
        """The bytes of the file that are read."""
        return self.lines.position

    def state(self) -> dict[str, Any]:
        """What another source needs to go on after the last batch."""
        return {"number": self.number, "position": self.position, "time": self.clock.last, "mark": self.mark}

    def counters(self) -> dict[str, Counter[str]]:
        """The counts of what was skipped and of what was lost, by kind."""
        return {"skipped": self.skipped, "bytes lost": self.lines.losses}

    def payloads(self) -> Iterator[Payloads]:
        """All payloads of the log, batch by batch."""
        stream = self.names.place("log")
        rows: list[tuple[bytes, int | None, int, int, int]] = []
        while line := self.lines.line():
            self.number += 1
            row = self._payload_of_line(line, stream)
            if row is not None:
                rows.append(row)
            if len(rows) >= LINES:
                yield payloads_of(rows, is_datagram=False)
                rows = []
        if rows:
            yield payloads_of(rows, is_datagram=False)

    def _payload_of_line(self, line: bytes, stream: int) -> tuple[bytes, int | None, int, int, int] | None:
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
