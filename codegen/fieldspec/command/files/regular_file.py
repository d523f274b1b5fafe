"""Reads regular files of a bounded size.

A pipe can block, a device may never end, and a sparse file can claim to be larger than the memory. So a file is opened
without waiting, and its type and size are checked before it is read.
"""

from __future__ import annotations

import errno
import os
import stat
from collections.abc import Iterator
from contextlib import contextmanager

from fieldspec.command.console.usage import UsageError

_READ = (
    os.O_RDONLY
    | getattr(os, "O_NONBLOCK", 0)  # a pipe does not wait
    | getattr(os, "O_NOCTTY", 0)
    | getattr(os, "O_BINARY", 0)
    | getattr(os, "O_CLOEXEC", 0)
)
NO_LINK = getattr(os, "O_NOFOLLOW", 0)
"""The flag of `content` for a path whose last step must not be a symbolic link."""

_KINDS = (
    (stat.S_ISDIR, "a folder"),
    (stat.S_ISFIFO, "a pipe"),
    (stat.S_ISSOCK, "a socket"),
    (stat.S_ISLNK, "a symbolic link"),
)


class IrregularError(OSError):
    """A file that is not read: `strerror` says what it is instead of a regular file."""


class SizeError(OSError):
    """A file that is too large; `size` is its number of bytes, as far as that is known."""

    size = 0


def content(path: str | os.PathLike[str], limit: int, flags: int = 0) -> bytes:
    """The bytes of a regular file with at most `limit` bytes.

    Raises IrregularError, SizeError, and any other OSError of the system; each names the file.
    """
    try:
        number = os.open(path, _READ | flags)
    except OSError as error:
        if error.errno in (errno.ELOOP, errno.ENXIO):  # a link, and a socket
            regular(os.lstat(path), path, limit)
        raise
    try:
        size = regular(os.fstat(number), path, limit)
        parts = []
        left = limit + 1
        while left > 0 and (part := os.read(number, min(size + 1, left))):
            parts.append(part)
            left -= len(part)
    finally:
        os.close(number)
    if not left:
        raise _too_large(path, limit, limit + 1)
    return b"".join(parts) if len(parts) != 1 else parts[0]


@contextmanager
def reading(name: object, limit: int = 0, kind: str = "") -> Iterator[None]:
    """Raises UsageError where a file cannot be read. A `kind` says which files have at most `limit` bytes."""
    try:
        yield
    except OSError as error:
        if kind and isinstance(error, SizeError):
            raise UsageError(f"{name} has more than {limit >> 20} MiB; {kind} is smaller") from None
        raise UsageError(f"cannot read {name}: {error.strerror}") from None


def regular(state: os.stat_result, path: str | os.PathLike[str], limit: int) -> int:
    """The size of a file in bytes. Raises IrregularError, or SizeError where it is above `limit`."""
    if not stat.S_ISREG(state.st_mode):
        raise _irregular(state.st_mode, path)
    if state.st_size > limit:
        raise _too_large(path, limit, state.st_size)
    return state.st_size


def _irregular(mode: int, path: str | os.PathLike[str]) -> IrregularError:
    kind = next((name for has, name in _KINDS if has(mode)), "a device")
    return IrregularError(errno.EINVAL, f"it is {kind}, not a regular file", os.fspath(path))


def _too_large(path: str | os.PathLike[str], limit: int, size: int) -> SizeError:
    error = SizeError(errno.EFBIG, f"it has more than {limit} bytes", os.fspath(path))
    error.size = size
    return error
