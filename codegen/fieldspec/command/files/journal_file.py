"""The journal of a transfer as a file beside the list: each line is on the disk before the next request is sent."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

from fieldspec.command.console.usage import UsageError
from fieldspec.command.files import regular_file
from fieldspec.command.files.storage import sync_folder
from fieldspec.tools.live.journal import JournalError, JournalState, begun_line, head_line, journal_state, verified_line
from fieldspec.tools.live.transfer import Change

_MOST_BYTES = 64 << 20


class JournalFile:
    """A journal. `state` is what an earlier run has left in it, or None."""

    def __init__(self, list_path: Path, content: bytes, unit: Mapping[str, object]) -> None:
        """Reads what is there. Raises UsageError for a file that is not a journal, or that of another unit."""
        self.path = list_path.with_name(f"{list_path.name}.journal")
        self.unit, self.digest = unit, hashlib.sha256(content).hexdigest()
        self.state: JournalState | None = None
        self._number: int | None = None
        try:
            self.state = journal_state(regular_file.content(str(self.path), _MOST_BYTES))
        except FileNotFoundError:
            return
        except JournalError as error:
            raise UsageError(f"{self.path} {error}; move it away") from None
        except OSError as error:
            raise UsageError(f"cannot read {self.path}: {error.strerror}") from None
        if self.state is not None and dict(self.state.unit) != dict(unit):
            other = ", ".join(f"{name} {value}" for name, value in self.state.unit.items())
            raise UsageError(f"{self.path} is of an unfinished transfer to {other}; finish that, or delete the journal")

    def begin(self, change: Change) -> None:
        """Notes what is about to be written. Raises UsageError where that is impossible: then nothing is written."""
        self._append(begun_line(change))

    def verify(self, change: Change) -> None:
        """Writes that the device has a value."""
        self._append(verified_line(change))

    def _append(self, line: str) -> None:
        try:
            if self._number is None:
                self._number = self._opened()
            _write_all(self._number, line.encode())
        except OSError as error:
            raise UsageError(f"cannot write {self.path}: {error.strerror}") from None

    def _opened(self) -> int:
        """Opens the file, without a line that was cut off, and with a head."""
        number = os.open(self.path, os.O_RDWR | os.O_CREAT | getattr(os, "O_BINARY", 0), 0o666)
        length = self.state.length if self.state is not None else 0
        os.ftruncate(number, length)
        os.lseek(number, length, os.SEEK_SET)
        if not length:
            _write_all(number, head_line(self.unit, self.digest).encode())
            sync_folder(self.path.parent)
        return number

    def close(self) -> None:
        """Closes the file and keeps it."""
        if self._number is not None:
            os.close(self._number)
            self._number = None

    def remove(self) -> None:
        """Removes the file: everything that it is about is verified."""
        self.close()
        with suppress(FileNotFoundError):
            os.unlink(self.path)


def _write_all(number: int, data: bytes) -> None:
    left = memoryview(data)
    while left:
        left = left[os.write(number, left) :]
    os.fsync(number)
