"""Files of register lists, and the options that say how they are read."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence

from fieldspec.command.console.usage import UsageError, unknown
from fieldspec.command.files import regular_file
from fieldspec.command.files.regular_file import SizeError
from fieldspec.tools.lists.assumption import Options
from fieldspec.tools.lists.sheet import MOST_BYTES
from fieldspec.tools.lists.words import words

COLUMNS = ("address", "space", "name", "words", "type", "access")
"""The columns of a register list that have an option of their own; `--column` names columns of all roles."""


def column_options(arguments: argparse.Namespace, roles: Sequence[str] = COLUMNS) -> dict[str, str]:
    """The columns that options name, by role. Raises UsageError for a role that no column has."""
    columns = {role: column for role in roles if (column := getattr(arguments, role)) is not None}
    for text in getattr(arguments, "column", None) or ():
        role, separator, column = text.partition("=")
        if role not in words("headings"):
            raise unknown("role of a column", role, words("headings"))
        if not separator or not column:
            raise UsageError(f"--column {text} names no column; write {role}=HEADING, a letter or a number")
        columns[role] = column
    return columns


def reading_options(arguments: argparse.Namespace) -> Options:
    """What options say of a whole list."""
    return Options(
        base=arguments.base or "",
        decimal=arguments.decimal or "",
        gain=arguments.gain or "",
        bounds=arguments.bounds or "",
        length=arguments.length or "",
        address_unit=arguments.address_unit or "",
        order=arguments.order or "",
        node=arguments.node or "",
    )


def content(name: str) -> bytes:
    """The bytes of a file, or of standard input for `-`. Raises UsageError."""
    with regular_file.reading(name, MOST_BYTES, "a list of registers"):
        if name == "-":
            read = sys.stdin.buffer.read(MOST_BYTES + 1)
            if len(read) > MOST_BYTES:
                raise SizeError
            return read
        return regular_file.content(name, MOST_BYTES)
