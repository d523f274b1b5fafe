"""Standard output and standard error of the command line, which a shell may close and whose reader may end first."""

from __future__ import annotations

import errno
import os
import sys
from contextlib import suppress
from io import TextIOWrapper

from fieldspec.command.console.usage import WRONG_USE
from fieldspec.foundation.classes import TYPE_CHECKING
from fieldspec.foundation.line_text import visible_json, visible_lines, visible_text

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable
    from typing import TextIO

UNREAD = 141
"""The exit code where the reader ended before another code was known: as a shell reports SIGPIPE."""


def prepare() -> None:
    """Writes UTF-8 with line feeds on every system, and nothing to a stream that is closed."""
    for name in ("stdout", "stderr"):
        stream = getattr(sys, name)
        if stream is None:  # the next file that is opened would get its number
            setattr(sys, name, os.fdopen(os.open(os.devnull, os.O_WRONLY), "w", encoding="utf-8"))
        elif isinstance(stream, TextIOWrapper):
            stream.reconfigure(encoding="utf-8", errors="replace", newline="\n")


def print_line(text: str) -> None:
    """Prints a line to standard output. Nothing in it acts on a terminal or a log, whatever names it has."""
    print(visible_text(text))


def print_note(text: str) -> None:
    """Prints a line to standard error, as `print_line` does to standard output."""
    print(visible_text(text), file=sys.stderr)


def print_error(reason: object) -> None:
    """Says in one line why a verb ends, or what it leaves out."""
    print_note(f"fieldspec: {reason}")


def print_json(data: object, indent: int | None = None, default: Callable[[object], object] | None = None) -> None:
    """Prints data as JSON."""
    print(visible_json(data, indent, default))


def print_rows(rows: Iterable[Iterable[object]]) -> None:
    """Prints rows as CSV, exact in all but what cannot be seen."""
    import csv

    texts = ([visible_lines(cell) if isinstance(cell, str) else cell for cell in row] for row in rows)
    csv.writer(sys.stdout, lineterminator="\n").writerows(texts)


def print_document(text: str, stream: TextIO | None = None) -> None:
    """Prints the text of a format that has its own escapes, to standard output or to another stream."""
    print(text, end="", file=stream, flush=stream is not None)


def finished(code: int) -> int:
    """Writes what is still to be written, and returns the exit code after a run with a code."""
    for stream in (sys.stdout, sys.stderr):
        try:
            stream.flush()
        except OSError as error:  # noqa: PERF203 - the other stream may still be read
            code = unwritten(error, code)
    return code


def unwritten(error: OSError, code: int | None) -> int:
    """The exit code after an output that could not be written; says so where somebody can still read it.

    `code` is that of the run, None where the output failed before the verb knew it.
    """
    # Nothing more may be written, not even by Python when it shuts down.
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    if isinstance(error, BrokenPipeError) or (os.name == "nt" and error.errno == errno.EINVAL):
        return UNREAD if code is None else code  # the reader has seen enough, as `head` has
    vanished = isinstance(error, FileNotFoundError)
    with suppress(OSError):
        print_error(
            "the current folder no longer exists; change to another one"
            if vanished
            else f"cannot write the output: {error.strerror}"
        )
    return WRONG_USE
