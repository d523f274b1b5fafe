"""Moves the files of a build into place, all or none, even if the process is killed halfway.

Files are moved one by one. So the new ones are first written into a folder of their own, beside the old ones. Then a
journal is put there: from now on the new state holds, and the next build that finds the journal completes it. Where
that fails, the journal becomes one that says to undo.
"""

from __future__ import annotations

import errno
import json
import os
import re
import shutil
from collections.abc import Iterable, Sequence
from contextlib import suppress
from pathlib import Path

from fieldspec.command.console.usage import UsageError
from fieldspec.command.files.regular_file import content
from fieldspec.command.files.storage import (
    BESIDE,
    lock,
    locked_folder,
    missing_folders,
    sync_folder,
    unlock,
    write_through,
)
from fieldspec.foundation.classes import attributes, dataclass

_FOLDER = re.compile(re.escape(BESIDE) + "[0-9a-f]{16}")


class Staging:
    """A folder of new files beside the outputs, until all of them are moved into place.

    Any process of the build may write files, so that only one output is in memory at a time. The folder of outputs is
    locked against other builds; a build that was killed is first completed or undone. With `look`, nothing is written,
    and `unfinished` describes such builds. Raises UsageError.
    """

    def __init__(self, output_folder: Path, look: bool = False) -> None:
        self.out = output_folder
        self.unfinished: list[str] = []
        self._look = look
        self._absent: list[Path] = []
        self._lock: int | None = None
        self._folder = output_folder / f"{BESIDE}{os.urandom(8).hex()}"
        self._placed = False
        self._pending = False

    def __enter__(self) -> Staging:
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
        self._absent = missing_folders(self.out)
        self._lock = locked_folder(self.out)
        for folder in _left_over(self.out):
            self._recover(folder)

    def _recover(self, folder: Path) -> None:
        """Completes or undoes a build that was killed. Raises UsageError."""
        try:
            recover(self.out, folder)
        except JournalError as error:
            raise UsageError(f"an earlier build did not finish: {error}") from None
        except OSError as error:
            raise UsageError(
                f"an earlier build was interrupted, and cannot be completed: cannot write "
                f"{error.filename or self.out}: {error.strerror}; fix that, and build again"
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
            write_through(target, content)
        except OSError as error:
            raise self._unwritten(error) from None

    def staged(self, path: str) -> bytes:
        """A file that was written here, by its path in the folder of outputs. Raises OSError."""
        return (self._folder / NEW / path).read_bytes()

    def place(self, paths: Sequence[str], removed: Sequence[str]) -> None:
        """Moves written files into place and removes others; on failure nothing has changed. Raises UsageError."""
        journal = None
        try:
            inside(self.out, (*paths, *removed))
            for path in (*paths, *removed):
                if (self.out / path).is_dir():
                    raise IsADirectoryError(errno.EISDIR, "a folder is in the way", str(self.out / path))
            journal = prepared(self.out, self._folder, paths, removed)
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
        """Restores the old files, where any was moved. Raises UsageError where the next build must do that."""
        try:
            if journal is not None and self._pending and (self._folder / COMPLETE).exists():
                undo(self.out, self._folder, journal)
            self._pending = False
        except OSError as error:
            raise UsageError(
                f"cannot write {error.filename or self.out}: {error.strerror}; some files are old and some are "
                f"new: fix that, and build again"
            ) from None

    def _unwritten(self, error: OSError) -> UsageError:
        return UsageError(f"cannot write {error.filename or self.out}: {error.strerror}; nothing was changed")


def _left_over(output_folder: Path) -> list[Path]:
    """The folders left by builds that were killed; no process writes into them while this process has the lock."""
    with os.scandir(output_folder) as entries:
        return sorted(
            output_folder / entry.name
            for entry in entries
            if entry.name.startswith(BESIDE) and _FOLDER.fullmatch(entry.name) and entry.is_dir(follow_symlinks=False)
        )


def _described(folder: Path) -> str:
    """A folder left by a build that was killed, as `build --check` reports it."""
    if any((folder / name).exists() for name in (COMPLETE, UNDO)):
        return f"unfinished: {folder.name} (a build was interrupted while it moved files into place)"
    return f"left over: {folder.name} (a build was interrupted before it moved any file)"


COMPLETE, UNDO = "journal", "undo"
NEW, OLD = "new", "old"
_MOST_BYTES = 64 << 20


_ITSELF: dict[str, bool] = {"follow_symlinks": False} if os.link in os.supports_follow_symlinks else {}
"""Link symbolic links themselves, not their targets."""


class JournalError(ValueError):
    """A journal that fieldspec did not write."""


@dataclass(frozen=True, slots=True)
class Journal:
    """The paths of files to place and to remove, below the folder of outputs.

    `absent` are those without an old file, `folders` the folders to create for them, the outermost first.
    """

    place: tuple[str, ...]
    remove: tuple[str, ...]
    absent: tuple[str, ...]
    folders: tuple[str, ...]


def prepared(output_folder: Path, folder: Path, place: Sequence[str], remove: Sequence[str]) -> Journal:
    """Saves the old files beside the new ones. Raises OSError; nothing has changed then."""
    absent = []
    folders: dict[str, None] = {}
    for path in (*place, *remove):
        target = output_folder / path
        if not os.path.lexists(target):
            absent.append(path)
            above = reversed(missing_folders(target.parent))
            folders.update(dict.fromkeys(parent.relative_to(output_folder).as_posix() for parent in above))
            continue
        old = folder / OLD / path
        old.parent.mkdir(parents=True, exist_ok=True)
        _keep(target, old)
    return Journal(tuple(place), tuple(remove), tuple(absent), tuple(folders))


def _keep(target: Path, old: Path) -> None:
    """Links a file, or copies it where the file system has no hard links."""
    try:
        os.link(target, old, **_ITSELF)
    except OSError:
        shutil.copy2(target, old, follow_symlinks=False)


def begin(folder: Path, journal: Journal) -> None:
    """Puts the journal in place: from now on the new state holds. Raises OSError."""
    part_file = folder / f"{COMPLETE}.part"
    write_through(part_file, json.dumps({name: getattr(journal, name) for name in attributes(Journal)}).encode())
    for inner in (NEW, OLD):
        if (folder / inner).is_dir():
            sync_folder(folder / inner)
    os.replace(part_file, folder / COMPLETE)
    sync_folder(folder)


def complete(output_folder: Path, folder: Path, journal: Journal) -> None:
    """Moves the files that are not in place yet. Raises OSError."""
    for path in journal.folders:
        (output_folder / path).mkdir(exist_ok=True)
    for path in journal.place:
        new = folder / NEW / path
        if os.path.lexists(new):
            os.replace(new, output_folder / path)
    for path in journal.remove:
        (output_folder / path).unlink(missing_ok=True)
    for parent in {(output_folder / path).parent for path in (*journal.place, *journal.remove)}:
        if parent.is_dir():
            sync_folder(parent)
    _remove_empty(output_folder, journal.remove)


def undo(output_folder: Path, folder: Path, journal: Journal) -> None:
    """Restores the old files. Raises OSError; the next build that finds the journal then continues."""
    if (folder / COMPLETE).exists():
        os.replace(folder / COMPLETE, folder / UNDO)
    absent = set(journal.absent)
    for path in (*journal.place, *journal.remove):
        old, target = folder / OLD / path, output_folder / path
        if os.path.lexists(old):
            target.parent.mkdir(parents=True, exist_ok=True)
            os.replace(old, target)
        elif path in absent:
            target.unlink(missing_ok=True)
    for inner in reversed(journal.folders):
        _remove_if_empty(output_folder / inner)


def recover(output_folder: Path, folder: Path) -> None:
    """Completes or undoes a build that was killed, and removes its folder.

    Raises OSError where neither is possible, and JournalError; nothing has changed then.
    """
    journal = _read_journal(folder)
    if journal is not None:
        inside(output_folder, (*journal.place, *journal.remove, *journal.folders))
        if (folder / UNDO).exists():
            undo(output_folder, folder, journal)
        else:
            try:
                complete(output_folder, folder, journal)
            except OSError:
                undo(output_folder, folder, journal)
    discard(folder)


def discard(folder: Path) -> None:
    """Removes a folder with its journal, the journal first: without it the rest is meaningless."""
    for name in (COMPLETE, UNDO):
        (folder / name).unlink(missing_ok=True)
    shutil.rmtree(folder, ignore_errors=True)


def _read_journal(folder: Path) -> Journal | None:
    """The journal in a folder; None where the build was killed before it wrote one. Raises JournalError."""
    for name in (UNDO, COMPLETE):
        try:
            data = json.loads(content(folder / name, _MOST_BYTES))
            journal = Journal(**{key: tuple(map(str, data[key])) for key in attributes(Journal)})
        except FileNotFoundError:
            continue
        except (ValueError, TypeError, KeyError, RecursionError):
            raise JournalError(f"{folder / name} is not a journal of a build; remove the folder {folder}") from None
        return journal
    return None


def inside(output_folder: Path, paths: Iterable[str]) -> None:
    """Refuses paths that lead out of a folder, directly or by symbolic links. Raises JournalError."""
    root = os.path.join(os.path.realpath(output_folder), "")
    known = {}
    for path in paths:
        parent = os.path.dirname(path)
        if parent not in known:
            known[parent] = os.path.join(os.path.realpath(output_folder / parent), "").startswith(root)
        if not known[parent] or os.path.basename(path) in ("", ".", ".."):
            raise JournalError(f"{output_folder / path} leads out of {output_folder}; remove the link")


def _remove_empty(output_folder: Path, paths: Iterable[str]) -> None:
    """Removes the empty folders around some paths."""
    for path in paths:
        for folder in (output_folder / path).parents:
            if folder == output_folder or not _remove_if_empty(folder):
                break


def _remove_if_empty(folder: Path) -> bool:
    """Removes a folder if it is empty; returns whether it is gone. Raises OSError."""
    try:
        folder.rmdir()
    except FileNotFoundError:
        return True
    except OSError as error:
        if error.errno not in (errno.ENOTEMPTY, errno.EEXIST, errno.ENOTDIR):
            raise
        return False
    return True
