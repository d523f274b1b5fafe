"""Puts files into place, all or none."""

from __future__ import annotations

import errno
import os
import tempfile
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

from fieldspec.commands.usage import UsageError


def place(out: Path, files: Mapping[str, bytes], gone: list[str]) -> None:
    """Writes all files beside their folder first, then moves them into place; on failure nothing has changed."""
    made = _missing(out)
    try:
        out.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix=".fieldspec-", dir=out) as beside:
            new, old = Path(beside, "new"), Path(beside, "old")
            for path, content in files.items():
                target = new / path
                target.parent.mkdir(parents=True, exist_ok=True)
                target.write_bytes(content)
            _move(out, new, old, list(files), gone)
    except OSError as error:
        for folder in made:
            with suppress(OSError):
                folder.rmdir()
        place = error.filename or out
        raise UsageError(f"cannot write {place}: {error.strerror}; nothing was changed") from None


def _move(out: Path, new: Path, old: Path, paths: list[str], gone: list[str]) -> None:
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
