"""Files of register lists, and the options that say how they are read."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence

from fieldspec.command.console.usage import UsageError
from fieldspec.command.files import regular_file
from fieldspec.command.files.regular_file import SizeError
from fieldspec.tools.lists.sheet import MOST_BYTES, ListError, Sheet
from fieldspec.tools.lists.text_sheet import text_sheet
from fieldspec.tools.lists.workbook_reader import MAGIC, workbook_sheet

COLUMNS = ("address", "space", "name", "words", "type", "access")
"""The columns of a register list that an option names."""


def column_options(arguments: argparse.Namespace, roles: Sequence[str] = COLUMNS) -> dict[str, str]:
    """The columns that options name, by role."""
    return {role: column for role in roles if (column := getattr(arguments, role)) is not None}


def content(name: str) -> bytes:
    """The bytes of a file, or of standard input for `-`. Raises UsageError."""
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


def sheet(data: bytes, encoding: str, sheet_name: str) -> Sheet:
    """The rows of a list. Its first bytes, not its name, decide whether it is a workbook. Raises ListError."""
    if data.startswith(MAGIC):
        return workbook_sheet(data, sheet_name)
    if sheet_name:
        raise ListError("is not a workbook, so --sheet has no effect; leave it out")
    return text_sheet(data, encoding)
