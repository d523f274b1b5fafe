"""A folder that one process at a time writes into.

The lock is of the open folder, so that nothing lies there for it, and that it ends with the process, however that ends.
Processes that were forked hold it too: whoever waits for it also waits for them. Windows has no such lock.
"""

from __future__ import annotations

import os
import sys

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None  # type: ignore[assignment]


def lock(folder: str | os.PathLike[str], shared: bool = False, patient: bool = True) -> int | None:
    """Waits for the lock of a folder; gives the open folder, for `unlock`, or None where the system has no such lock.

    A `shared` lock keeps writers out, and no readers. Raises OSError: FileNotFoundError for a folder that is not there,
    and BlockingIOError instead of waiting where we are not `patient`.
    """
    if fcntl is None:
        return None
    while True:
        number = os.open(folder, os.O_RDONLY | os.O_CLOEXEC)
        try:
            if not _locked(number, shared, patient, folder):
                os.close(number)
                return None
            if os.path.samestat(os.fstat(number), os.stat(folder)):
                return number
        except BaseException:
            os.close(number)
            raise
        os.close(number)  # another process has removed the folder, and a third one has made it again


def unlock(number: int | None) -> None:
    """Gives the lock back."""
    if number is not None:
        os.close(number)


def _locked(number: int, shared: bool, patient: bool, folder: str | os.PathLike[str]) -> bool:
    """Whether an open folder is locked now; a file system that cannot lock says so at once."""
    kind = fcntl.LOCK_SH if shared else fcntl.LOCK_EX
    try:
        fcntl.flock(number, kind | fcntl.LOCK_NB)
    except BlockingIOError:
        if not patient:
            raise
        print(f"fieldspec: waiting for another process that uses {os.fspath(folder)}", file=sys.stderr, flush=True)
        fcntl.flock(number, kind)
    except OSError:
        return False
    return True
