"""Files of register lists: reading, encoding and writing them."""

from __future__ import annotations

import os
import sys
import tempfile
from contextlib import suppress
from pathlib import Path

from fieldspec.commands.usage import UsageError
from fieldspec.lists.sheet import MOST_BYTES, ListError, Sheet
from fieldspec.lists.text_sheet import text_sheet
from fieldspec.lists.workbook import MAGIC, workbook_sheet


def content(name: str) -> bytes:
    """The bytes of a file, or of standard input for `-`."""
    try:
        if name == "-":
            read = sys.stdin.buffer.read(MOST_BYTES + 1)
        else:
            with Path(name).open("rb") as file:
                read = file.read(MOST_BYTES + 1)
    except OSError as error:
        raise UsageError(f"cannot read {name}: {error.strerror}") from None
    if len(read) > MOST_BYTES:
        raise UsageError(f"{name} has more than {MOST_BYTES >> 20} MiB; a list of registers is smaller")
    return read


def sheet(held: bytes, encoding: str, named: str) -> Sheet:
    """The rows of a list; what it is, its first bytes say and not its name."""
    if held.startswith(MAGIC):
        return workbook_sheet(held, named)
    if named:
        raise ListError("is no workbook, so there is no sheet to choose")
    return text_sheet(held, encoding)


def write(path: Path, data: bytes) -> None:
    """Writes a file all or nothing."""
    beside = ""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        number, beside = tempfile.mkstemp(prefix=".fieldspec-", dir=path.parent)
        with os.fdopen(number, "wb") as file:
            file.write(data)
        os.chmod(beside, 0o666 & ~_mask())
        os.replace(beside, path)
    except OSError as error:
        with suppress(OSError):
            os.unlink(beside)
        raise UsageError(f"cannot write {path}: {error.strerror}; nothing was changed") from None


def _mask() -> int:
    """The permissions that the user does not give to new files."""
    mask = os.umask(0)
    os.umask(mask)
    return mask
