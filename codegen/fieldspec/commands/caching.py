"""The folder in which verbs keep what they would else work out again. Whatever is in it may be lost, or spoilt.

A file there begins with the hash of what it holds, so that one that is half written or changed by hand is as none. So
is one that another user owns or could write to. What it holds is data that is never executed. Where the folder cannot
be written to, nothing is kept.
"""

from __future__ import annotations

import os
import stat
import sys

try:
    from _blake2 import blake2b  # `hashlib` loads OpenSSL first, which takes as long as to read a compiled device
except ImportError:
    from hashlib import blake2b

VARIABLE = "FIELDSPEC_CACHE"
MOST = 100
"""Files of one kind that are kept; the oldest are removed."""


def folder() -> str:
    """The folder: by the environment, or where the system keeps caches. Raises OSError for a user without a home."""
    if named := os.environ.get(VARIABLE):
        return named
    home = os.path.expanduser("~")
    if home == "~":
        raise FileNotFoundError("this user has no home")
    if sys.platform == "win32":
        local = os.environ.get("LOCALAPPDATA") or os.path.join(home, "AppData", "Local")
        return os.path.join(local, "fieldspec", "cache")
    return os.path.join(os.environ.get("XDG_CACHE_HOME") or os.path.join(home, ".cache"), "fieldspec")


def checksum(*contents: bytes) -> str:
    """A hash of contents one after the other, and of where each of them ends."""
    made = blake2b(digest_size=24)
    for content in contents:
        made.update(b"%d\n" % len(content))
        made.update(content)
    return made.hexdigest()


def kept(kind: str, name: str) -> bytes | None:
    """What is kept under a name; None where there is nothing, or nothing whole."""
    try:
        with open(_path(kind, name), "rb") as file:
            if not _ours(os.fstat(file.fileno())):
                return None
            held, _, content = file.read().partition(b"\n")
    except OSError:
        return None
    return content if held == checksum(content).encode() else None


def keep(kind: str, name: str, content: bytes) -> None:
    """Keeps a content under a name, in place of what was there."""
    try:
        _write(_path(kind, name), checksum(content).encode() + b"\n" + content)
    except OSError:
        return


_NEW = os.O_WRONLY | os.O_CREAT | os.O_TRUNC | getattr(os, "O_BINARY", 0) | getattr(os, "O_NOFOLLOW", 0)


def _write(path: str, content: bytes) -> None:
    within = os.path.dirname(path)
    os.makedirs(within, mode=0o700, exist_ok=True)
    beside = f"{path}.{os.getpid()}"
    with open(os.open(beside, _NEW, 0o600), "wb") as file:
        file.write(content)
    os.replace(beside, path)
    files = sorted(os.scandir(within), key=lambda one: one.stat().st_mtime_ns)
    for old in files[:-MOST]:
        os.unlink(old)


def _ours(state: os.stat_result) -> bool:
    """Whether nobody else can have written a file."""
    if os.name != "posix":
        return True
    return state.st_uid == os.geteuid() and not state.st_mode & (stat.S_IWGRP | stat.S_IWOTH)


def _path(kind: str, name: str) -> str:
    return os.path.join(folder(), kind, checksum(name.encode())[:32])
