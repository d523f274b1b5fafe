"""A row of the benchmarks, and how two calls are timed side by side.

Every benchmark is a file that prints its rows as JSON, one a line; `python benchmarks/<file>.py`. Both sides of a row
are timed in turns within one process, so that what else the machine does hits both, and the median of the ratios of
the rounds is taken.
"""

from __future__ import annotations

import gc
import json
import sys
import timeit
from collections.abc import Callable, Iterable
from dataclasses import asdict, dataclass
from pathlib import Path
from statistics import median
from time import process_time

ROOT = Path(__file__).resolve().parent.parent
GENERATED = ROOT / "generated" / "python"
ROUNDS = 25
LEAST = 0.004
"""Seconds that one side takes in one round, at least."""


@dataclass(frozen=True, slots=True)
class Row:
    """Ours against a peer. `ratio` is ours over the peer's, or the peer's over ours where `at_least` is given.

    `at_most` or `at_least` is the goal; neither where a row only informs. `unit` is that of `ours` and `peers`.
    """

    group: str
    name: str
    peer: str
    ours: float
    peers: float
    unit: str
    ratio: float
    at_most: float | None = None
    at_least: float | None = None

    @property
    def met(self) -> bool:
        """Whether the goal is met; true where there is none."""
        if self.at_most is not None:
            return self.ratio <= self.at_most
        return self.at_least is None or self.ratio >= self.at_least


def interleaved(ours: Callable[[], object], peer: Callable[[], object]) -> tuple[float, float, float]:
    """Nanoseconds of ours and of the peer, and the ratio of the two: medians over the rounds."""
    # The time of the processor: what else runs on the machine does not count.
    first, second = (timeit.Timer(call, timer=process_time) for call in (ours, peer))
    numbers = [_enough(timer) for timer in (first, second)]
    collecting = gc.isenabled()
    gc.disable()
    try:
        pairs = []
        for turn in range(ROUNDS):
            runs = [(first, numbers[0]), (second, numbers[1])]
            if turn % 2:
                runs.reverse()
            took = {timer: timer.timeit(number) / number for timer, number in runs}
            pairs.append((took[first] * 1e9, took[second] * 1e9))
    finally:
        if collecting:
            gc.enable()
    return median(a for a, _ in pairs), median(b for _, b in pairs), median(a / b for a, b in pairs)


def _enough(timer: timeit.Timer) -> int:
    """How many calls take long enough to be timed; the first ones may have to prepare something."""
    number = 1
    while timer.timeit(number) < LEAST:
        number *= 2
    return number


def timed(
    group: str, name: str, ours: Callable[[], object], peer: str, theirs: Callable[[], object], **goal: float
) -> Row:
    """The row of two calls that do the same work; the goal is `at_most` or `at_least`."""
    mine, its, ratio = interleaved(ours, theirs)
    figure = 1 / ratio if "at_least" in goal else ratio
    return Row(group, name, peer, round(mine, 1), round(its, 1), "ns", round(figure, 3), **goal)


def printed(rows: Iterable[Row]) -> None:
    """Prints rows as JSON, one a line, as soon as each is there."""
    for row in rows:
        print(json.dumps(asdict(row)), flush=True)


def use_generated() -> None:
    """Makes the generated package importable, as a copy of its folder beside a program would be."""
    sys.path.insert(0, str(GENERATED))
