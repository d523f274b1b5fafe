"""How whole processes are timed side by side: the time of the processor that they and what they start take.

What else the machine does counts for little in that; where several processors share the work, the time on the clock is
given besides.
"""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import median

from rows import Row

BIN = Path(sys.executable).parent
PYTHON = (sys.executable,)
FIELDSPEC = (sys.executable, str(BIN / "fieldspec"))
QUIET = [(os.POSIX_SPAWN_OPEN, 1, os.devnull, os.O_WRONLY, 0)]


@dataclass(frozen=True, slots=True)
class Took:
    """What a process took: milliseconds of processors and of the clock, and bytes of memory at most."""

    work: float
    clock: float
    memory: int


def run(command: Sequence[str], **variables: str) -> Took:
    """Runs a command that must succeed; what it prints is dropped."""
    environment = {**os.environ, **variables}
    start = time.perf_counter()
    process = os.posix_spawn(command[0], command, environment, file_actions=QUIET)
    _, status, used = os.wait4(process, 0)
    clock = (time.perf_counter() - start) * 1e3
    if os.waitstatus_to_exitcode(status):
        raise SystemExit(f"this has failed: {' '.join(command)}")
    return Took((used.ru_utime + used.ru_stime) * 1e3, clock, used.ru_maxrss * 1024)


def work_of(process: int) -> float:
    """Milliseconds of the processor that a process has taken until now."""
    fields = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) * 1e3 / os.sysconf("SC_CLK_TCK")


def in_turns(commands: Mapping[str, Sequence[str]], rounds: int, **variables: str) -> dict[str, list[Took]]:
    """What each of some commands took in each round, all of them in turns; what they need lies in memory before."""
    for command in commands.values() if rounds > 1 else ():
        run(command, **variables)
    took: dict[str, list[Took]] = {name: [] for name in commands}
    for turn in range(rounds):
        names = list(commands)
        for name in names[turn % len(names) :] + names[: turn % len(names)]:
            took[name].append(run(commands[name], **variables))
    return took


def compared(group: str, name: str, took: Mapping[str, list[Took]], ours: str, peer: str, **goal: float) -> Row:
    """The row of two of the commands: the medians, and the median of the ratios of the rounds."""
    pairs = list(
        zip((measured.work for measured in took[ours]), (measured.work for measured in took[peer]), strict=True)
    )
    ratio = median(a / b for a, b in pairs)
    mine, its = median(a for a, _ in pairs), median(b for _, b in pairs)
    return Row(group, name, peer, round(mine, 1), round(its, 1), "ms", round(ratio, 3), **goal)


def limited(group: str, name: str, measured: float, unit: str, most: float) -> Row:
    """The row of something that has a limit of its own: the ratio is that of what was measured to the limit."""
    return Row(group, name, "the limit", round(measured, 1), most, unit, round(measured / most, 3), at_most=1.0)
