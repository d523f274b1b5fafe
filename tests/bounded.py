"""Bounds that hold however busy a machine is: on processor time and memory. The wall clock only shows what hangs."""

from __future__ import annotations

import time
from collections.abc import Callable

HANGING = 600.0
"""The seconds after which something hangs that should have ended. Nothing takes nearly as long."""


def limits(seconds: int, memory: int | None = None) -> Callable[[], None]:
    """What a process calls that may take so many seconds of a processor, and so many bytes of addresses."""

    def limited() -> None:
        import resource  # Windows has none

        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
        if memory is not None:
            resource.setrlimit(resource.RLIMIT_AS, (memory, memory))

    return limited


def wait_until(condition: Callable[[], bool]) -> None:
    """Waits for something that happens by itself."""
    end = time.monotonic() + HANGING
    while not condition():
        assert time.monotonic() < end, "it hangs"
        time.sleep(0.01)
