"""Files that are written whole or not at all."""

from __future__ import annotations

import errno
import os
import re
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from fieldspec.commands.usage import UsageError

BESIDE = ".fieldspec-"
"""What the names of files and folders begin with that are there only while something is written."""
LEFT_OVER = re.compile(r"\.fieldspec-[0-9a-z_]{8,16}")
"""The names of those that a process has left that was killed."""

_NEW = os.O_WRONLY | os.O_CREAT | os.O_TRUNC | getattr(os, "O_BINARY", 0) | getattr(os, "O_NOFOLLOW", 0)


def write_through(path: str | os.PathLike[str], content: bytes, mode: int = 0o666) -> None:
    """Writes a file that nobody looks for yet, down to the disk. Raises OSError."""
    number = os.open(path, _NEW, mode)
    try:
        left = memoryview(content)
        while left:
            left = left[os.write(number, left) :]
        os.fsync(number)
    finally:
        os.close(number)


def sync_folder(folder: str | os.PathLike[str]) -> None:
    """Writes the names in a folder down to the disk, where the system can do that. Raises OSError."""
    if os.name == "posix":
        number = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(number)
        except OSError as error:
            if error.errno != errno.EINVAL:  # a file system that does not do that for folders
                raise
        finally:
            os.close(number)


def missing_folders(folder: Path) -> list[Path]:
    """The folders that must be made for a folder to be there, the innermost first."""
    return [above for above in (folder, *folder.parents) if not above.exists()]


@contextmanager
def exclusive_folder(folder: Path) -> Iterator[None]:
    """Makes a folder and keeps others from writing into it. A folder in which nothing was written is removed.

    Files that a killed process has left there are removed. Raises UsageError.
    """
    absent = missing_folders(folder)
    number = None
    try:
        while True:
            with suppress(FileNotFoundError):
                folder.mkdir(parents=True, exist_ok=True)
                number = lock(folder)
                break
        for entry in [*os.scandir(folder)]:
            if LEFT_OVER.fullmatch(entry.name) and entry.is_file(follow_symlinks=False):
                with suppress(OSError):  # in a folder that many write into, it may be another user's
                    os.unlink(entry.path)
    except OSError as error:
        unlock(number)
        _remove(absent)
        raise UsageError(f"cannot write {error.filename or folder}: {error.strerror}; nothing was changed") from None
    try:
        yield
    finally:
        _remove(absent)  # which fails where something is in it
        unlock(number)


def _remove(folders: list[Path]) -> None:
    for folder in folders:
        with suppress(OSError):
            folder.rmdir()


def replace(path: Path, content: bytes) -> None:
    """Puts a content in place of a file, in a folder where we are `alone`; nothing or all of it. Raises UsageError."""
    beside = path.with_name(f"{BESIDE}{os.urandom(8).hex()}")
    try:
        try:
            write_through(beside, content)
            os.replace(beside, path)
            sync_folder(path.parent)
        except BaseException:
            with suppress(OSError):
                os.unlink(beside)
            raise
    except OSError as error:
        raise UsageError(f"cannot write {path}: {error.strerror}; nothing was changed") from None


def write(path: Path, content: bytes, new: bool = False) -> None:
    """Writes a file all or nothing; with `new`, there must be none yet. Raises UsageError."""
    with exclusive_folder(path.parent):
        if new and os.path.lexists(path):
            raise UsageError(f"there is a file {path} already")
        replace(path, content)


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
