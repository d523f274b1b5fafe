"""Standard output and standard error of the command line, which a shell may close and whose reader may end first."""

from __future__ import annotations

import errno
import os
import sys
from contextlib import suppress
from io import TextIOWrapper

from fieldspec.commands.usage import WRONG_USE
from fieldspec.line_text import visible_text

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


def print_error(reason: object) -> None:
    """Says in one line why a verb ends."""
    print(f"fieldspec: {visible_text(str(reason))}", file=sys.stderr, flush=True)


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
