"""The result of a run of bulk decoding, in numbers."""

from __future__ import annotations

from collections import Counter
from typing import Any

import numpy as np

from fieldspec.foundation.classes import dataclass, field
from fieldspec.tools.captures.columns import NO_TIME
from fieldspec.tools.captures.decoding import Batch
from fieldspec.tools.captures.pairing import NONE
from fieldspec.tools.captures.verdicts import NO_FRAME, OK, VERDICTS

JUMP = 3600 * 10**9
"""The nanoseconds between two frames from which the time counts as a jump forward."""


@dataclass(slots=True)
class Totals:
    """Counts by kind. `bytes_of` has the bytes of frames by verdict; `counters` what sources have skipped or lost."""

    frames: Counter[str] = field(default_factory=Counter)
    bytes_of: Counter[str] = field(default_factory=Counter)
    values: Counter[str] = field(default_factory=Counter)
    units: Counter[str] = field(default_factory=Counter)
    clock: Counter[str] = field(default_factory=Counter)
    counters: Counter[str] = field(default_factory=Counter)

    def add(self, batch: Batch) -> None:
        """Adds the counts of a batch."""
        frames = batch.frames
        sizes = np.diff(frames.bytes[1])
        for number, count in enumerate(np.bincount(frames.verdict, minlength=len(VERDICTS)).tolist()):
            if count:
                self.frames[VERDICTS[number]] += count
                self.bytes_of[VERDICTS[number]] += int(sizes[frames.verdict == number].sum())
        for number, count in enumerate(np.bincount(batch.values.values.verdict, minlength=len(VERDICTS)).tolist()):
            if count:
                self.values[VERDICTS[number]] += count
        valid = (frames.verdict != NO_FRAME) & (frames.unit_address != NONE)
        addresses, counts = np.unique(frames.unit_address[valid & (frames.verdict == OK)], return_counts=True)
        for address, count in zip(addresses.tolist(), counts.tolist(), strict=True):
            self.units[str(address)] += count
        times = frames.time[frames.time != NO_TIME]
        steps = np.diff(times)
        self.clock["jumps back"] += int(np.count_nonzero(steps < 0))
        self.clock["jumps forward of an hour or more"] += int(np.count_nonzero(steps >= JUMP))

    @property
    def whole(self) -> tuple[int, int]:
        """The bytes of valid frames, and all bytes of payloads."""
        return self.bytes_of["ok"], sum(self.bytes_of.values())

    def as_data(self) -> dict[str, Any]:
        """The counts as data, by kind."""
        return {name: dict(sorted(getattr(self, name).items())) for name in _KINDS}

    @staticmethod
    def of_data(data: dict[str, Any]) -> Totals:
        """The totals that `as_data` has returned."""
        return Totals(*(Counter(data[name]) for name in _KINDS))


_KINDS = ("frames", "bytes_of", "values", "units", "clock", "counters")
