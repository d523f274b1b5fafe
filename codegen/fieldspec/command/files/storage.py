"""Files that are written all or nothing, in folders that one process at a time writes into."""

from __future__ import annotations

import errno
import os
import re
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from fieldspec.command.console.streams import print_document, print_error
from fieldspec.command.console.usage import UsageError

BESIDE = ".fieldspec-"
"""The prefix of temporary files and folders."""
LEFT_OVER = re.compile(r"\.fieldspec-[0-9a-z_]{8,16}")
"""The names of temporary files left by a process that was killed."""

_NEW = os.O_WRONLY | os.O_CREAT | os.O_TRUNC | getattr(os, "O_BINARY", 0) | getattr(os, "O_NOFOLLOW", 0)


def write_through(path: str | os.PathLike[str], content: bytes, mode: int = 0o666) -> None:
    """Writes a file through to the disk. Raises OSError."""
    number = os.open(path, _NEW, mode)
    try:
        left = memoryview(content)
        while left:
            left = left[os.write(number, left) :]
        os.fsync(number)
    finally:
        os.close(number)


def sync_folder(folder: str | os.PathLike[str]) -> None:
    """Writes the entries of a folder through to the disk, where the system can do that. Raises OSError."""
    if os.name == "posix":
        number = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(number)
        except OSError as error:
            if error.errno != errno.EINVAL:  # a file system that cannot do that for folders
                raise
        finally:
            os.close(number)


def missing_folders(folder: Path) -> list[Path]:
    """The folders that must be created so that a folder exists, the innermost first."""
    return [above for above in (folder, *folder.parents) if not above.exists()]


@contextmanager
def exclusive_folder(folder: Path) -> Iterator[None]:
    """Creates and locks a folder. If it stays empty, it is removed again.

    Temporary files left by a killed process are removed. Raises UsageError.
    """
    absent = missing_folders(folder)
    number = None
    try:
        number = locked_folder(folder)
        for entry in [*os.scandir(folder)]:
            if LEFT_OVER.fullmatch(entry.name) and entry.is_file(follow_symlinks=False):
                with suppress(OSError):  # it may belong to another user
                    os.unlink(entry.path)
    except OSError as error:
        unlock(number)
        _remove(absent)
        raise UsageError(f"cannot write {error.filename or folder}: {error.strerror}; nothing was changed") from None
    try:
        yield
    finally:
        _remove(absent)  # fails for a folder that is not empty
        unlock(number)


def _remove(folders: list[Path]) -> None:
    for folder in folders:
        with suppress(OSError):
            folder.rmdir()


def replace(path: Path, content: bytes) -> None:
    """Replaces a file in an `exclusive_folder`, all or nothing. Raises UsageError."""
    new_file = path.with_name(f"{BESIDE}{os.urandom(8).hex()}")
    try:
        try:
            write_through(new_file, content)
            os.replace(new_file, path)
            sync_folder(path.parent)
        except BaseException:
            with suppress(OSError):
                os.unlink(new_file)
            raise
    except OSError as error:
        raise UsageError(f"cannot write {path}: {error.strerror}; nothing was changed") from None


def write(path: Path, content: bytes, new: bool = False) -> None:
    """Writes a file all or nothing. Raises UsageError, with `new` also for a file that exists."""
    with exclusive_folder(path.parent):
        if new and os.path.lexists(path):
            raise UsageError(f"the file {path} already exists")
        replace(path, content)


def write_or_print(content: bytes, form: str, path: str | None) -> None:
    """Writes a list in a format to a file, or prints it where none is named. Raises UsageError."""
    if path is not None:
        write(Path(path), content)
    elif form != "xlsx":
        print_document(content.decode("utf-8"))
    elif sys.stdout.isatty():
        raise UsageError("a workbook cannot be printed; name a file with --out")
    else:
        sys.stdout.buffer.write(content)


def require_writable(path: Path) -> None:
    """Raises UsageError for a file that cannot be written, because of its folder."""
    with exclusive_folder(path.parent):
        pass


try:
    import fcntl
except ImportError:  # Windows
    fcntl = None  # type: ignore[assignment]


def lock(folder: str | os.PathLike[str], shared: bool = False, patient: bool = True) -> int | None:
    """Waits for the lock of a folder. Returns the open folder, for `unlock`, or None where the system has no such lock.

    A `shared` lock keeps out writers, not readers. Raises OSError: FileNotFoundError for a missing folder, and
    BlockingIOError instead of waiting where it is not `patient`.
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
        os.close(number)  # the folder was removed and created again


def locked_folder(folder: Path, attempts: int = 100) -> int | None:
    """Creates a folder and waits for its lock, as `lock` does. Raises OSError where the folder cannot exist."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        return lock(folder)
    except FileNotFoundError:  # another process has removed the folder again, or nobody can create it
        if not attempts:
            raise
    return locked_folder(folder, attempts - 1)


def unlock(number: int | None) -> None:
    """Releases a lock."""
    if number is not None:
        os.close(number)


def _locked(number: int, shared: bool, patient: bool, folder: str | os.PathLike[str]) -> bool:
    """Locks an open folder; False for a file system without locks."""
    kind = fcntl.LOCK_SH if shared else fcntl.LOCK_EX
    try:
        fcntl.flock(number, kind | fcntl.LOCK_NB)
    except BlockingIOError:
        if not patient:
            raise
        print_error(f"waiting for another process that uses {os.fspath(folder)}")
        fcntl.flock(number, kind)
    except OSError:
        return False
    return True
