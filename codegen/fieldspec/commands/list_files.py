"""Files of register lists: reading, encoding and writing them."""

from __future__ import annotations

import sys

from fieldspec.commands import regular_file
from fieldspec.commands.regular_file import SizeError
from fieldspec.commands.usage import UsageError
from fieldspec.lists.sheet import MOST_BYTES, ListError, Sheet
from fieldspec.lists.text_sheet import text_sheet
from fieldspec.lists.workbook import MAGIC, workbook_sheet


def content(name: str) -> bytes:
    """The bytes of a file, or of standard input for `-`."""
    try:
        if name == "-":
            read = sys.stdin.buffer.read(MOST_BYTES + 1)
            if len(read) > MOST_BYTES:
                raise SizeError
            return read
        return regular_file.content(name, MOST_BYTES)
    except SizeError:
        raise UsageError(f"{name} has more than {MOST_BYTES >> 20} MiB; a list of registers is smaller") from None
    except OSError as error:
        raise UsageError(f"cannot read {name}: {error.strerror}") from None


def sheet(held: bytes, encoding: str, named: str) -> Sheet:
    """The rows of a list; what it is, its first bytes say and not its name."""
    if held.startswith(MAGIC):
        return workbook_sheet(held, named)
    if named:
        raise ListError("is no workbook, so there is no sheet to choose")
    return text_sheet(held, encoding)
