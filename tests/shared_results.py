"""Results that take long, computed once for all workers of a run of the tests.

Each worker collects all tests, and so needs what tests are named after. The first that asks computes it, others wait
and read what it has written.
"""

from __future__ import annotations

import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

try:
    import fcntl
except ImportError:  # where files cannot be locked, each worker computes
    fcntl = None  # type: ignore[assignment]

Result = TypeVar("Result")

FOLDERS: list[Path] = []
"""The folder of the run that this process is a worker of. No environment has it: a run within a test has its own."""


def shared(name: str, compute: Callable[[], Result]) -> Result:
    """What `compute` returns, which must be data that can be pickled; `name` is that of no other result.

    A process that is not a worker computes it.
    """
    if not FOLDERS or fcntl is None:
        return compute()
    path = FOLDERS[0] / name
    with path.with_suffix(".lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if path.exists():
            stored: Any = pickle.loads(path.read_bytes())
            result: Result = stored
        else:
            result = compute()
            path.write_bytes(pickle.dumps(result, pickle.HIGHEST_PROTOCOL))
    return result
