"""Faults at the n-th operation on files: what a full disk, a defect, an interrupt or `kill -9` does there.

The functions of `os` that change files count their calls. At the n-th one, a fault takes place instead of it, or in the
middle of it; what follows goes on as usual, or fails too where the fault lasts.

A process with all tests in its memory takes a tenth of a second to fork. A small one, this module, forks in its place.
"""

from __future__ import annotations

import atexit
import errno
import gc
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from functools import cache, partial
from pathlib import Path
from typing import Any

import pytest

import parsed_once
from faulty_works import WORKS
from fieldspec.command.builds import workers

assert parsed_once  # as in the tests
CACHE = "FIELDSPEC_CACHE"

CHANGING = ("open", "write", "fsync", "replace", "rename", "link", "unlink", "remove", "mkdir", "rmdir")


@dataclass
class Fault:
    """A fault by name. `error` is what the operation raises, none for `kill`; it `lasts` for all operations after."""

    name: str
    error: BaseException | None = None
    lasts: bool = False
    half: bool = False
    only: tuple[str, ...] = CHANGING

    def strike(self, call: Callable[..., Any], arguments: tuple[Any, ...]) -> None:
        """Carries out the fault in place of an operation."""
        if self.half and call.__name__ == "write":
            call(arguments[0], arguments[1][: len(arguments[1]) // 2])
        if self.error is None:
            os.kill(os.getpid(), signal.SIGKILL)
        else:
            raise self.error


def failure(number: int) -> OSError:
    return OSError(number, os.strerror(number))


FAULTS = (
    Fault("kill"),
    Fault("kill in the middle of a write", half=True),
    Fault("defect", failure(errno.EIO)),
    Fault("full disk", failure(errno.ENOSPC), half=True, lasts=True, only=("write", "mkdir", "link", "fsync")),
    Fault("read-only", failure(errno.EROFS), lasts=True),
    Fault("interrupt", KeyboardInterrupt()),
    Fault("interrupted call", failure(errno.EINTR)),
)


@dataclass
class Operations:
    """The operations so far; at the one with number `at`, counting from 1, a fault strikes."""

    fault: Fault | None = None
    at: int = 0
    seen: list[str] = field(default_factory=list)

    def replaced(self, name: str) -> Callable[..., Any]:
        call = getattr(os, name)

        def counting(*arguments: Any, **named: Any) -> Any:
            if name == "open" and not arguments[1] & (os.O_WRONLY | os.O_RDWR | os.O_CREAT):
                return call(*arguments, **named)
            if name == "write" and arguments[0] <= 2:
                return call(*arguments, **named)
            if self.fault is not None and name in self.fault.only:
                self.seen.append(name)
                if len(self.seen) == self.at or (self.fault.lasts and len(self.seen) > self.at > 0):
                    self.fault.strike(call, arguments)
            elif self.fault is None:
                self.seen.append(name)
            return call(*arguments, **named)

        counting.__name__ = name
        return counting


@contextmanager
def operations(fault: Fault | None = None, at: int = 0) -> Iterator[Operations]:
    """Counts operations and raises a fault at one of them."""
    counter = Operations(fault, at)
    with pytest.MonkeyPatch.context() as patch:
        for name in CHANGING:
            patch.setattr(os, name, counter.replaced(name))
        yield counter


def struck(work: Callable[[Path], object], folder: Path, fault: Fault, at: int) -> bool:
    """Does some work in a process of its own, with a fault at operation `at`; returns whether the work got that far."""
    process = _small_process()
    assert process.stdin is not None
    assert process.stdout is not None
    job = [work.__name__, str(folder), FAULTS.index(fault), at, os.environ[CACHE]]
    process.stdin.write(json.dumps(job) + "\n")
    process.stdin.flush()
    return bool(json.loads(process.stdout.readline()))


@cache
def _small_process() -> subprocess.Popen[str]:
    process = subprocess.Popen(
        [sys.executable, __file__],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
    )
    atexit.register(process.communicate)
    return process


def serve() -> None:
    """Strikes the works that are asked for, each after it was done once: what it loads and keeps is there then."""
    workers.WORTH_IT = 10**9  # a build stays in the process with the fault
    known: set[tuple[str, str]] = set()
    for line in sys.stdin:
        name, folder, fault, at, cache_folder = json.loads(line)
        os.environ[CACHE] = cache_folder
        if (name, folder) not in known:
            known.add((name, folder))
            _rehearse(name, Path(folder))
        answer = _struck_here(partial(WORKS[name], Path(folder)), FAULTS[fault], at)
        print(json.dumps(answer), flush=True)


def _rehearse(name: str, folder: Path) -> None:
    with (
        tempfile.TemporaryDirectory() as place,
        open(os.devnull, "w") as nowhere,
        pytest.MonkeyPatch.context() as patch,
    ):
        shutil.copytree(folder, f"{place}/copy", symlinks=True)
        patch.setenv(CACHE, f"{place}/cache")
        patch.setattr(sys, "stdout", nowhere)
        patch.setattr(sys, "stderr", nowhere)
        WORKS[name](Path(place, "copy"))
    gc.collect()
    gc.freeze()


def _struck_here(work: Callable[[], object], fault: Fault, at: int) -> bool:
    """Does some work in a forked process, with a fault at operation `at`; returns whether the work got that far."""
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        gc.disable()
        reached = False
        try:
            with open(os.devnull, "w") as nowhere:
                os.dup2(nowhere.fileno(), 1)
                os.dup2(nowhere.fileno(), 2)
            with operations(fault, at) as counter:
                with suppress(KeyboardInterrupt, Exception):
                    work()
                reached = len(counter.seen) >= at
        finally:
            os.write(writing, b"1" if reached else b"0")
            os._exit(0)
    os.close(writing)
    output = os.read(reading, 1)
    os.close(reading)
    _, status = os.waitpid(child, 0)
    return os.WIFSIGNALED(status) or output == b"1"


if __name__ == "__main__":
    serve()
