"""The folder in which verbs keep what they would else work out again. Whatever is in it may be lost, or spoilt.

A file there is JSON with the hash of what it holds, so that one that is half written or changed by hand is as none. It
is never executed. Where the folder cannot be written to, nothing is kept.
"""

from __future__ import annotations

import hashlib
import json
import os
import sys
from contextlib import suppress
from pathlib import Path
from typing import Any

VARIABLE = "FIELDSPEC_CACHE"
MOST = 100
"""Files of one kind that are kept; the oldest are removed."""


def folder() -> Path:
    """The folder: by the environment, or where the system keeps caches."""
    if named := os.environ.get(VARIABLE):
        return Path(named)
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA") or Path.home() / "AppData/Local", "fieldspec", "cache")
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache", "fieldspec")


def digest(content: bytes) -> str:
    """The hash by which contents are compared."""
    return hashlib.sha256(content).hexdigest()


def kept(kind: str, name: str) -> Any:
    """What is kept under a name; None where there is nothing, or nothing whole."""
    try:
        held, _, text = _path(kind, name).read_bytes().partition(b"\n")
        return json.loads(text) if held.decode("ascii") == digest(text) else None
    except (OSError, ValueError, RuntimeError):  # RuntimeError: the user has no home
        return None


def keep(kind: str, name: str, data: Any) -> None:
    """Keeps data under a name, in place of what was there."""
    text = json.dumps(data, separators=(",", ":")).encode("utf-8")
    with suppress(OSError, RuntimeError):
        path = _path(kind, name)
        path.parent.mkdir(parents=True, exist_ok=True)
        beside = path.with_suffix(f".{os.getpid()}")
        beside.write_bytes(digest(text).encode("ascii") + b"\n" + text)
        os.replace(beside, path)
        files = sorted(path.parent.iterdir(), key=lambda file: file.stat().st_mtime_ns)
        for old in files[:-MOST]:
            old.unlink()


def _path(kind: str, name: str) -> Path:
    return folder() / kind / f"{digest(name.encode('utf-8'))[:32]}.json"
