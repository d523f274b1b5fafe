"""The clocks that a simulation can run by."""

from __future__ import annotations

import time
from typing import Protocol


class Clock(Protocol):
    """A clock: seconds since any moment, and a way to wait for a time to pass."""

    def now(self) -> float:
        """The present time in seconds."""

    def sleep(self, seconds: float) -> None:
        """Waits until this number of seconds of this clock has passed."""


class SystemClock:
    """The time of the machine, `rate` times as fast."""

    def __init__(self, rate: float = 1.0) -> None:
        self.rate = rate

    def now(self) -> float:
        """The time of the machine in seconds, `rate` times as fast."""
        return time.monotonic() * self.rate

    def sleep(self, seconds: float) -> None:
        """Waits for some seconds of simulated time."""
        if seconds > 0:
            time.sleep(seconds / self.rate)


class ManualClock:
    """A clock that stands still until it is advanced. Waiting advances it, so that no real time passes."""

    def __init__(self) -> None:
        self.seconds = 0.0

    def now(self) -> float:
        """The time to which the clock was advanced, in seconds."""
        return self.seconds

    def sleep(self, seconds: float) -> None:
        """Advances the clock."""
        self.seconds += max(0.0, seconds)
