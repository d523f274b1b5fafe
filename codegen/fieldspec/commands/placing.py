"""Puts files into place, all or none."""

from __future__ import annotations

import errno
import os
import shutil
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path

from fieldspec.commands.usage import UsageError


class Beside:
    """Files that lie beside a folder of outputs until all of them are moved into place. None is left when this ends.

    Whoever makes a file writes it, in whichever process, so that no more than one output is held at a time.
    """

    def __init__(self, out: Path) -> None:
        self.out = out
        self._made = _missing(out)
        self._folder = out / f".fieldspec-{os.urandom(8).hex()}"
        self._placed = False

    def __enter__(self) -> Beside:
        return self

    def __exit__(self, *raised: object) -> None:
        shutil.rmtree(self._folder, ignore_errors=True)
        for folder in () if self._placed else self._made:
            with suppress(OSError):
                folder.rmdir()

    def write(self, path: str, content: bytes) -> None:
        """Writes a file, by its path in the folder of outputs. Raises UsageError."""
        try:
            self.out.mkdir(parents=True, exist_ok=True)
            self._folder.mkdir(mode=0o700, exist_ok=True)
            target = self._folder / "new" / path
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(content)
        except OSError as error:
            raise self._unwritten(error) from None

    def place(self, paths: Sequence[str], gone: Sequence[str]) -> None:
        """Moves files that were written into place, and removes others; on failure nothing has changed."""
        try:
            _move(self.out, self._folder / "new", self._folder / "old", paths, gone)
        except OSError as error:
            raise self._unwritten(error) from None
        self._placed = True

    def _unwritten(self, error: OSError) -> UsageError:
        return UsageError(f"cannot write {error.filename or self.out}: {error.strerror}; nothing was changed")


def _move(out: Path, new: Path, old: Path, paths: Sequence[str], gone: Sequence[str]) -> None:
    """Moves new files into place, keeping what was there until all are moved."""
    kept: list[str] = []
    placed: list[str] = []
    made: list[Path] = []
    try:
        for path in [*paths, *gone]:
            target = out / path
            if target.is_dir():
                raise IsADirectoryError(errno.EISDIR, "a folder is in the way", str(target))
            if target.exists():
                (old / path).parent.mkdir(parents=True, exist_ok=True)
                os.replace(target, old / path)
                kept.append(path)
            if path not in gone:
                made = [*_missing(target.parent), *made]
                target.parent.mkdir(parents=True, exist_ok=True)
                os.replace(new / path, target)
                placed.append(path)
    except BaseException:  # an interrupt, too, leaves what was there
        for path in placed:
            (out / path).unlink(missing_ok=True)
        for path in kept:
            os.replace(old / path, out / path)
        for folder in made:
            with suppress(OSError):
                folder.rmdir()
        raise
    for path in gone:
        _remove_empty(out, (out / path).parent)


def _missing(folder: Path) -> list[Path]:
    """The folders that must be made for a folder to be there, the innermost first."""
    return [above for above in (folder, *folder.parents) if not above.exists()]


def _remove_empty(out: Path, folder: Path) -> None:
    while folder != out and folder.is_dir() and not any(folder.iterdir()):
        folder.rmdir()
        folder = folder.parent
