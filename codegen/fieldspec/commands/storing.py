"""Files that are written whole or not at all."""

from __future__ import annotations

import errno
import os
import re
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from fieldspec.commands.locking import lock, unlock
from fieldspec.commands.usage import UsageError

BESIDE = ".fieldspec-"
"""What the names of files and folders begin with that are there only while something is written."""
LEFT_OVER = re.compile(r"\.fieldspec-[0-9a-z_]{8,16}")
"""The names of those that a process has left that was killed."""

_NEW = os.O_WRONLY | os.O_CREAT | os.O_TRUNC | getattr(os, "O_BINARY", 0) | getattr(os, "O_NOFOLLOW", 0)


def put(path: str | os.PathLike[str], content: bytes, mode: int = 0o666) -> None:
    """Writes a file that nobody looks for yet, down to the disk. Raises OSError."""
    number = os.open(path, _NEW, mode)
    try:
        left = memoryview(content)
        while left:
            left = left[os.write(number, left) :]
        os.fsync(number)
    finally:
        os.close(number)


def settle(folder: str | os.PathLike[str]) -> None:
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


def missing(folder: Path) -> list[Path]:
    """The folders that must be made for a folder to be there, the innermost first."""
    return [above for above in (folder, *folder.parents) if not above.exists()]


@contextmanager
def alone(folder: Path) -> Iterator[None]:
    """Makes a folder and keeps others from writing into it. A folder in which nothing was written is removed.

    Files that a killed process has left there are removed. Raises UsageError.
    """
    absent = missing(folder)
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
            put(beside, content)
            os.replace(beside, path)
            settle(path.parent)
        except BaseException:
            with suppress(OSError):
                os.unlink(beside)
            raise
    except OSError as error:
        raise UsageError(f"cannot write {path}: {error.strerror}; nothing was changed") from None


def write(path: Path, content: bytes, new: bool = False) -> None:
    """Writes a file all or nothing; with `new`, there must be none yet. Raises UsageError."""
    with alone(path.parent):
        if new and os.path.lexists(path):
            raise UsageError(f"there is a file {path} already")
        replace(path, content)
