"""Times two calls side by side: both in turns within one process, so that what else the machine does hits both."""

from __future__ import annotations

import gc
import sys
import timeit
from collections.abc import Callable
from pathlib import Path
from statistics import median

from rows import Row

ROOT = Path(__file__).resolve().parent.parent
GENERATED = ROOT / "generated" / "python"
ROUNDS = 15
LEAST = 0.004
"""Seconds that one side takes in one round, at least."""


def interleaved(ours: Callable[[], object], peer: Callable[[], object]) -> tuple[float, float]:
    """Nanoseconds of ours and of the peer: the peer's median over the rounds, and ours by the median of the ratios."""
    first, second = timeit.Timer(ours), timeit.Timer(peer)
    numbers = {timer: max(1, int(LEAST / max(timer.timeit(3) / 3, 1e-9))) for timer in (first, second)}
    collecting = gc.isenabled()
    gc.disable()
    try:
        ratios, theirs = [], []
        for turn in range(ROUNDS):
            order = (first, second) if turn % 2 else (second, first)
            took = {timer: timer.timeit(numbers[timer]) / numbers[timer] for timer in order}
            ratios.append(took[first] / took[second])
            theirs.append(took[second] * 1e9)
    finally:
        if collecting:
            gc.enable()
    return median(ratios) * median(theirs), median(theirs)


def timed(
    name: str,
    ours: Callable[[], object],
    peer: str,
    theirs: Callable[[], object],
    *,
    version: str = "",
    at_most: float | None = None,
    at_least: float | None = None,
    note: str = "",
) -> Row:
    """The row of two calls that do the same work.

    The goal is that ours takes `at_most` so many times what the peer takes, or that the peer takes `at_least` so many
    times ours.
    """
    mine, its = interleaved(ours, theirs)
    goal = 1 / at_least if at_least else at_most
    return Row(name, mine, "ns", its, peer, version, goal, note)


def use_generated() -> None:
    """Makes the generated package importable, as a copy of its folder beside a program would be."""
    sys.path.insert(0, str(GENERATED))
