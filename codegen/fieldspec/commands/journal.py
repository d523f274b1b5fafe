"""What remains to be done to move files into place, written down so that a later run can complete it or undo it.

Files are moved one by one, and a process can be killed between two of them. So the new ones are written first, into a
folder of their own, with the old ones beside them. Then the journal is put there: from now on the new state holds, and
whoever finds the journal completes it. Where that cannot be done, the journal becomes one that says to undo.
"""

from __future__ import annotations

import errno
import json
import os
import shutil
from collections.abc import Iterable, Sequence
from pathlib import Path

from fieldspec.classes import attributes, dataclass
from fieldspec.commands.regular_file import content
from fieldspec.commands.storing import missing, put, settle

COMPLETE, UNDO = "journal", "undo"
NEW, OLD = "new", "old"
_MOST_BYTES = 64 << 20


_ITSELF: dict[str, bool] = {"follow_symlinks": False} if os.link in os.supports_follow_symlinks else {}
"""That a second name is given to a symbolic link, not to what it leads to."""


class JournalError(ValueError):
    """A journal that fieldspec has not written."""


@dataclass(frozen=True, slots=True)
class Journal:
    """The paths of files that are placed and removed, below the folder of outputs.

    `absent` are those where there was no file before, `folders` those that are made for them, the outermost first.
    """

    place: tuple[str, ...]
    remove: tuple[str, ...]
    absent: tuple[str, ...]
    folders: tuple[str, ...]


def prepared(out: Path, folder: Path, place: Sequence[str], remove: Sequence[str]) -> Journal:
    """Keeps the old files beside the new ones. Raises OSError; nothing has changed yet."""
    absent = []
    folders: dict[str, None] = {}
    for path in (*place, *remove):
        target = out / path
        if not os.path.lexists(target):
            absent.append(path)
            folders.update(dict.fromkeys(one.relative_to(out).as_posix() for one in reversed(missing(target.parent))))
            continue
        old = folder / OLD / path
        old.parent.mkdir(parents=True, exist_ok=True)
        _keep(target, old)
    return Journal(tuple(place), tuple(remove), tuple(absent), tuple(folders))


def _keep(target: Path, old: Path) -> None:
    """Gives a file a second name, or copies it where the file system has no second names."""
    try:
        os.link(target, old, **_ITSELF)
    except OSError:
        shutil.copy2(target, old, follow_symlinks=False)


def begin(folder: Path, journal: Journal) -> None:
    """Puts the journal into its folder: from now on the new state holds. Raises OSError."""
    beside = folder / f"{COMPLETE}.part"
    put(beside, json.dumps({name: getattr(journal, name) for name in attributes(Journal)}).encode())
    for inner in (NEW, OLD):
        if (folder / inner).is_dir():
            settle(folder / inner)
    os.replace(beside, folder / COMPLETE)
    settle(folder)


def complete(out: Path, folder: Path, journal: Journal) -> None:
    """Moves what is not in place yet. Raises OSError."""
    for path in journal.folders:
        (out / path).mkdir(exist_ok=True)
    for path in journal.place:
        new = folder / NEW / path
        if os.path.lexists(new):
            os.replace(new, out / path)
    for path in journal.remove:
        (out / path).unlink(missing_ok=True)
    for parent in {(out / path).parent for path in (*journal.place, *journal.remove)}:
        if parent.is_dir():
            settle(parent)
    _remove_empty(out, journal.remove)


def undo(out: Path, folder: Path, journal: Journal) -> None:
    """Puts back what was there. Raises OSError; whoever finds the journal then goes on with it."""
    if (folder / COMPLETE).exists():
        os.replace(folder / COMPLETE, folder / UNDO)
    absent = set(journal.absent)
    for path in (*journal.place, *journal.remove):
        old, target = folder / OLD / path, out / path
        if os.path.lexists(old):
            target.parent.mkdir(parents=True, exist_ok=True)
            os.replace(old, target)
        elif path in absent:
            target.unlink(missing_ok=True)
    for inner in reversed(journal.folders):
        _remove_if_empty(out / inner)


def recover(out: Path, folder: Path) -> None:
    """Completes or undoes what a run has left that was killed, and removes its folder.

    Raises OSError where neither can be done, and JournalError; everything is then left as it is.
    """
    journal = _read(folder)
    if journal is not None:
        inside(out, (*journal.place, *journal.remove, *journal.folders))
        if (folder / UNDO).exists():
            undo(out, folder, journal)
        else:
            try:
                complete(out, folder, journal)
            except OSError:
                undo(out, folder, journal)
    discard(folder)


def discard(folder: Path) -> None:
    """Removes the folder of a journal that is done, the journal first: without it, nothing of the rest counts."""
    for name in (COMPLETE, UNDO):
        (folder / name).unlink(missing_ok=True)
    shutil.rmtree(folder, ignore_errors=True)


def _read(folder: Path) -> Journal | None:
    """The journal in a folder; None where the files were not complete yet."""
    for name in (UNDO, COMPLETE):
        try:
            data = json.loads(content(folder / name, _MOST_BYTES))
            journal = Journal(**{key: tuple(map(str, data[key])) for key in attributes(Journal)})
        except FileNotFoundError:
            continue
        except (ValueError, TypeError, KeyError, RecursionError):
            raise JournalError(f"{folder / name} is no journal of a build; remove the folder {folder}") from None
        return journal
    return None


def inside(out: Path, paths: Iterable[str]) -> None:
    """Refuses paths that lead out of a folder, by themselves or by symbolic links. Raises JournalError."""
    within = os.path.join(os.path.realpath(out), "")
    known = {}
    for path in paths:
        parent = os.path.dirname(path)
        if parent not in known:
            known[parent] = os.path.join(os.path.realpath(out / parent), "").startswith(within)
        if not known[parent] or os.path.basename(path) in ("", ".", ".."):
            raise JournalError(f"{out / path} leads out of {out}; remove the link")


def _remove_empty(out: Path, paths: Iterable[str]) -> None:
    """Removes folders in which nothing is left."""
    for path in paths:
        for folder in (out / path).parents:
            if folder == out or not _remove_if_empty(folder):
                break


def _remove_if_empty(folder: Path) -> bool:
    """Removes a folder in which there is nothing; whether it is gone. Raises OSError."""
    try:
        folder.rmdir()
    except FileNotFoundError:
        return True
    except OSError as error:
        if error.errno not in (errno.ENOTEMPTY, errno.EEXIST, errno.ENOTDIR):
            raise
        return False
    return True
