"""Puts files into place, all or none, also where the process is killed in the middle of it."""

from __future__ import annotations

import errno
import os
import re
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path

from fieldspec.commands.journal import (
    COMPLETE,
    NEW,
    UNDO,
    Journal,
    JournalError,
    begin,
    complete,
    discard,
    inside,
    prepared,
    recover,
    undo,
)
from fieldspec.commands.locking import lock, unlock
from fieldspec.commands.storing import BESIDE, missing, put
from fieldspec.commands.usage import UsageError

_FOLDER = re.compile(re.escape(BESIDE) + "[0-9a-f]{16}")


class Beside:
    """Files that lie beside a folder of outputs until all of them are moved into place. None is left when this ends.

    Whoever makes a file writes it, in whichever process, so that no more than one output is in memory at a time. While
    this lasts, no other build writes into the folder; what one has left that was killed is completed or undone first.
    With `look`, nothing is written, and `unfinished` says what was left.
    """

    def __init__(self, out: Path, look: bool = False) -> None:
        self.out = out
        self.unfinished: list[str] = []
        self._look = look
        self._absent: list[Path] = []
        self._lock: int | None = None
        self._folder = out / f"{BESIDE}{os.urandom(8).hex()}"
        self._placed = False
        self._pending = False

    def __enter__(self) -> Beside:
        try:
            if self._look:
                with suppress(FileNotFoundError, NotADirectoryError):
                    self._lock = lock(self.out, shared=True)
                    self.unfinished = [_described(folder) for folder in _left_over(self.out)]
            else:
                self._enter()
        except BaseException as error:
            self._leave()
            if isinstance(error, OSError):
                raise self._unwritten(error) from None
            raise
        return self

    def _enter(self) -> None:
        self._absent = missing(self.out)
        while self._lock is None:
            with suppress(FileNotFoundError):  # another build has removed the folder that it made
                self.out.mkdir(parents=True, exist_ok=True)
                self._lock = lock(self.out)
                break
        for folder in _left_over(self.out):
            self._recover(folder)

    def _recover(self, folder: Path) -> None:
        """Completes or undoes what a build has left that was killed. Raises UsageError."""
        try:
            recover(self.out, folder)
        except JournalError as error:
            raise UsageError(f"an earlier build did not end: {error}") from None
        except OSError as error:
            raise UsageError(
                f"an earlier build was interrupted, and cannot be completed: cannot write "
                f"{error.filename or self.out}: {error.strerror}; build again when that is mended"
            ) from None

    def __exit__(self, *raised: object) -> None:
        self._leave()

    def _leave(self) -> None:
        if not self._look and not self._pending and self._folder.is_dir():
            with suppress(OSError):
                discard(self._folder)
        for folder in () if self._placed or self._pending else self._absent:
            with suppress(OSError):
                folder.rmdir()
        unlock(self._lock)
        self._lock = None

    def write(self, path: str, content: bytes) -> None:
        """Writes a file, by its path in the folder of outputs. Raises UsageError."""
        try:
            self._folder.mkdir(mode=0o700, exist_ok=True)
            target = self._folder / NEW / path
            target.parent.mkdir(parents=True, exist_ok=True)
            put(target, content)
        except OSError as error:
            raise self._unwritten(error) from None

    def place(self, paths: Sequence[str], gone: Sequence[str]) -> None:
        """Moves files that were written into place, and removes others; on failure nothing has changed."""
        journal = None
        try:
            inside(self.out, (*paths, *gone))
            for path in (*paths, *gone):
                if (self.out / path).is_dir():
                    raise IsADirectoryError(errno.EISDIR, "a folder is in the way", str(self.out / path))
            journal = prepared(self.out, self._folder, paths, gone)
            self._pending = True  # an interrupt may come at any time
            begin(self._folder, journal)
            complete(self.out, self._folder, journal)
            self._pending, self._placed = False, True
        except JournalError as error:
            raise UsageError(f"{error}; nothing was changed") from None
        except BaseException as error:
            self._revert(journal)
            if isinstance(error, OSError):
                raise self._unwritten(error) from None
            raise

    def _revert(self, journal: Journal | None) -> None:
        """Puts back what was there, where anything was moved. Raises UsageError: the next build does the rest."""
        try:
            if journal is not None and self._pending and (self._folder / COMPLETE).exists():
                undo(self.out, self._folder, journal)
            self._pending = False
        except OSError as error:
            raise UsageError(
                f"cannot write {error.filename or self.out}: {error.strerror}; some files are old and some are new: "
                "build again when that is mended"
            ) from None

    def _unwritten(self, error: OSError) -> UsageError:
        return UsageError(f"cannot write {error.filename or self.out}: {error.strerror}; nothing was changed")


def _left_over(out: Path) -> list[Path]:
    """The folders that builds have left that were killed; nobody writes into them while we have the lock."""
    with os.scandir(out) as entries:
        return sorted(
            out / entry.name
            for entry in entries
            if entry.name.startswith(BESIDE) and _FOLDER.fullmatch(entry.name) and entry.is_dir(follow_symlinks=False)
        )


def _described(folder: Path) -> str:
    """What a build has left that was killed, for `build --check`."""
    if any((folder / name).exists() for name in (COMPLETE, UNDO)):
        return f"unfinished: {folder.name} (a build was interrupted while it moved files into place)"
    return f"left over: {folder.name} (a build was interrupted before it moved any file)"
