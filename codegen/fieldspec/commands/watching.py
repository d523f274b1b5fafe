"""`fieldspec build --watch`: builds again whenever a spec is saved, until it is interrupted."""

from __future__ import annotations

import argparse
import gc
import os
import sys
import time

from fieldspec.commands import build, sources
from fieldspec.commands.usage import UsageError

PAUSE = 0.05
"""Seconds between two looks at the files."""
SETTLED = 0.02
"""Seconds for which nothing changes once a file is written whole."""

State = dict[str, tuple[int, int]]


def run(arguments: argparse.Namespace) -> int:
    """Builds, then waits for a spec to change. It ends with an interrupt, or where the first build is wrong use."""
    path = sources.folder(arguments.specs)
    built: State | None = None
    while True:
        now = _state(path)
        if now != built:
            time.sleep(SETTLED)
            if _state(path) == now:
                _build(arguments, first=built is None)
                built = now
        else:
            time.sleep(PAUSE)


def _build(arguments: argparse.Namespace, first: bool) -> None:
    """Builds once. What is wrong use may be put right while we wait, but for what was given to us."""
    start = time.perf_counter()
    try:
        code = build.build(arguments)
    except UsageError as error:
        if first:
            raise
        print(f"fieldspec: {error}", file=sys.stderr, flush=True)
        code = 2
    done = "built" if code == 0 else "not built"
    print(f"{done} in {time.perf_counter() - start:.2f} s, waiting for a spec to change", flush=True)
    gc.collect()  # nobody else does, and this runs for long
    if first:
        from fieldspec.backends.templates import prepare

        prepare()


def _state(path: str) -> State:
    """The time and size of every spec file."""
    found = {}
    for folder, _, names in os.walk(path):
        for name in names:
            if name.endswith(".yaml") and not name.startswith("."):
                try:
                    held = os.stat(os.path.join(folder, name))
                except OSError:
                    continue  # it has gone in the meantime
                found[os.path.join(folder, name)] = held.st_mtime_ns, held.st_size
    return found
