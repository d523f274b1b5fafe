"""CSV of registers: rows of time, address and word, as loggers and historians write them."""

from __future__ import annotations

import csv
from collections import Counter
from collections.abc import Iterator
from typing import Any

import numpy as np

from fieldspec.foundation.classes import dataclass, field
from fieldspec.tools.captures.columns import NO_TIME, gathered, numbers
from fieldspec.tools.captures.decoding import Batch, DeviceDecoder, FrameTable, ValueTable
from fieldspec.tools.captures.log_times import LogClock
from fieldspec.tools.captures.pairing import NONE
from fieldspec.tools.captures.register_columns import ADDRESSES, Accesses
from fieldspec.tools.captures.sources import Lines

HEADINGS = {
    "address": ("address", "register", "addr", "reg"),
    "value": ("value", "raw", "word", "data"),
    "time": ("time", "timestamp", "datetime", "date_time"),
    "space": ("space",),
    "unit_address": ("unit_address", "unit", "station", "slave", "device_address"),
    "operation": ("operation",),
}
"""The headings of each column, in small letters with underscores."""

ROWS = 1 << 15
"""The rows of a file in one batch."""

MOST = 125
"""The words of one access."""

Place = tuple[int, str, int, str]
"""What rows of one access have in common: time, space, unit address, operation."""


def columns_of(line: str) -> tuple[str, dict[str, int]] | None:
    """The separator of a file and the place of each column, from its headings; None for a file of another kind."""
    for separator in (",", ";", "\t"):
        cells = _cells(line, separator)
        names = [cell.strip().lower().replace(" ", "_") for cell in cells]
        places = {
            column: names.index(heading)
            for column, headings in reversed(HEADINGS.items())
            for heading in headings
            if heading in names
        }
        if "address" in places and "value" in places and places["address"] != places["value"]:
            return separator, places
    return None


def _cells(line: str, separator: str) -> list[str]:
    """The cells of a row; none where it is not CSV."""
    try:
        return next(csv.reader([line.rstrip("\r\n")], delimiter=separator), [])
    except csv.Error:
        return []


@dataclass(slots=True)
class _Access:
    """Neighbouring words with all that is equal for them. `line` is the line of the last one."""

    place: Place
    address: int
    line: int
    words: list[int] = field(default_factory=list)

    @property
    def end(self) -> int:
        """The first address after the last word."""
        return self.address + len(self.words)

    def goes_on(self, other: _Access) -> bool:
        """Whether another access is of the next word of the same moment."""
        return self.place == other.place and self.end == other.address and len(self.words) < MOST


class RegisterRows:
    """A file with a row for each access to a register."""

    def __init__(self, lines: Lines, device: DeviceDecoder, state: dict[str, Any] | None = None) -> None:
        self.lines, self.device = lines, device
        self.skipped: Counter[str] = Counter()
        self.number = state["number"] if state else 0
        self.frame = state["frame"] if state else 0
        self.clock = LogClock(state["time"] if state else None)
        self.layout: tuple[str, dict[str, int]] | None = (state["separator"], state["places"]) if state else None
        self.waiting: _Access | None = None
        if state and state["waiting"]:
            place, address, line, words = state["waiting"]
            self.waiting = _Access((place[0], place[1], place[2], place[3]), address, line, words)
        spaces = [space for space in device.spaces if space not in device.bit_spaces]
        self.first_space = spaces[0] if spaces else None

    @property
    def position(self) -> int:
        """The bytes of the file that are read."""
        return self.lines.position

    def state(self) -> dict[str, Any]:
        """What another object needs to go on after the last batch."""
        separator, places = self.layout or (",", {})
        return {
            "number": self.number,
            "position": self.position,
            "frame": self.frame,
            "time": self.clock.last,
            "separator": separator,
            "places": places,
            "waiting": self.waiting and list(_parts_of(self.waiting)),
        }

    def counters(self) -> dict[str, Counter[str]]:
        """The counts of what was skipped and of what was lost."""
        return {"skipped": self.skipped, "bytes lost": self.lines.losses}

    def batches(self) -> Iterator[list[Batch]]:
        """All rows, decoded. Neighbouring words of one moment are one access, so that values of two words are whole."""
        if self.layout is None:
            self.layout = columns_of(self._line().removeprefix("\ufeff"))
        while True:
            accesses = self._accesses()
            if not accesses:
                return
            yield self._batches(accesses)

    def _accesses(self) -> list[_Access]:
        """The accesses in the next rows. A batch ends where an access does; the row after it waits."""
        accesses = [self.waiting] if self.waiting is not None else []
        self.waiting = None
        rows = 0
        while line := self._line():
            access = self._access(line)
            if access is None:
                continue
            rows += 1
            last = accesses[-1] if accesses else None
            if last is not None and last.goes_on(access):
                last.words += access.words
                last.line = access.line
            elif rows > ROWS:
                self.waiting = access
                break
            else:
                accesses.append(access)
        return accesses

    def _line(self) -> str:
        data = self.lines.line()
        self.number += bool(data)
        return data.decode("utf-8", "replace")

    def _access(self, line: str) -> _Access | None:
        """The word of a row; None where it has none, which is counted."""
        separator, places = self.layout or (",", {})
        cells = _cells(line, separator)
        texts = {name: cells[place].strip() if place < len(cells) else "" for name, place in places.items()}
        if not line.strip():
            return None
        address, word = _parsed_number(texts.get("address", "")), _parsed_number(texts.get("value", ""))
        if address is None or word is None or not 0 <= address < ADDRESSES or not -0x8000 <= word <= 0xFFFF:
            self.skipped["rows without an address and a word"] += 1
            return None
        space = texts.get("space") or self.first_space
        if space not in self.device.spaces or space in self.device.bit_spaces:
            self.skipped["rows of an unknown address space"] += 1
            return None
        time = self.clock.time(f"{texts['time']} ") if texts.get("time") else None
        unit = _parsed_number(texts.get("unit_address", ""))
        operation = "write" if texts.get("operation", "").lower() in ("write", "w") else "read"
        place = (NO_TIME if time is None else time, space, NONE if unit is None else unit, operation)
        return _Access(place, address, self.number, [word & 0xFFFF])

    def _batches(self, accesses: list[_Access]) -> list[Batch]:
        """The tables of accesses, one batch for neighbouring ones in the same space."""
        batches = []
        for space in dict.fromkeys(access.place[1] for access in accesses):
            own = [access for access in accesses if access.place[1] == space]
            batches.append(self._batch(space, own))
            self.frame += len(own)
        return batches

    def _batch(self, space: str, accesses: list[_Access]) -> Batch:
        device, size = self.device, len(accesses)
        unit = device.layout.device.space(space).unit_size
        words = np.array([word for access in accesses for word in access.words], f">u{unit}")
        buffer = np.append(words.view(np.uint8), np.uint8(0))
        count = numbers([len(access.words) for access in accesses])
        offsets = unit * (np.cumsum(count) - count)
        address = numbers([access.address for access in accesses])
        writes = np.array([access.place[3] == "write" for access in accesses])
        rows = device.maps[space].rows(buffer, Accesses(np.arange(size), address, count, offsets, unit * count, writes))
        names, units = device.register_names(space, rows.register)
        operations = np.array([device.place("read"), device.place("write")], np.int32)
        none, space_column = np.full(size, NONE, np.int32), np.full(len(names), device.place(space), np.int32)
        values = ValueTable(
            rows.frame, operations[rows.is_write.astype(np.int8)], space_column, rows.address, names, units, rows.values
        )
        data = gathered(buffer, offsets, unit * count)
        frames = FrameTable(
            np.arange(self.frame + 1, self.frame + 1 + size), numbers([access.line for access in accesses]),
            numbers([access.place[0] for access in accesses]), none, none, none, none, none,
            numbers([access.place[2] for access in accesses]), np.full(size, device.place(space), np.int32),
            address, count, np.full(size, NONE), np.full(size, NONE), np.zeros(size, np.int8), data, data,
            np.ones(size, np.bool_),
        )  # fmt: skip
        return Batch(frames, values)


def _parts_of(access: _Access) -> tuple[object, ...]:
    """The parts of an access, of which a state has a list."""
    return access.place, access.address, access.line, access.words


def _parsed_number(text: str) -> int | None:
    try:
        return int(text, 16) if text.lower().startswith("0x") else int(text)
    except ValueError:
        return None
