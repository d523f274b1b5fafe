"""The journal of a transfer: what was about to be written, and what was verified. So a break leaves a known state."""

from __future__ import annotations

import json
from collections.abc import Mapping

from fieldspec.foundation.classes import dataclass
from fieldspec.tools.live.transfer import Change


class JournalError(ValueError):
    """A journal that cannot be used. The message says why."""


@dataclass(frozen=True, slots=True)
class JournalState:
    """The content of a journal: its owner, the verified paths, and the write that was begun and not verified.

    `before` and `after` are the words of that write; `path` is empty where none is open. `length` is that of the whole
    lines, in bytes: what follows was cut off while it was written.
    """

    unit: Mapping[str, object]
    digest: str
    verified: tuple[str, ...]
    path: str
    before: tuple[int, ...]
    after: tuple[int, ...]
    length: int


def head_line(unit: Mapping[str, object], digest: str) -> str:
    """The first line: the device and its address, and the digest of the list."""
    return _line({"journal": 1, "unit": dict(unit), "digest": digest})


def begun_line(change: Change) -> str:
    """The line before a write."""
    return _line({"write": change.path, "before": list(change.before.words), "after": list(change.chosen.words)})


def verified_line(change: Change) -> str:
    """The line after a value has been read back."""
    return _line({"verified": change.path})


def _line(data: Mapping[str, object]) -> str:
    return json.dumps(data, ensure_ascii=False) + "\n"


def journal_state(content: bytes) -> JournalState | None:
    """The content of a journal; None for one that was cut off in its first line. Raises JournalError."""
    length = content.rfind(b"\n") + 1
    if not length:
        return None
    try:
        head, *lines = (json.loads(line) for line in content[:length].decode().splitlines())
        verified: list[str] = []
        path, before, after = "", (), ()
        for line in lines:
            if "verified" in line:
                verified.append(str(line["verified"]))
                path, before, after = "", (), ()
            else:
                path, before, after = str(line["write"]), tuple(line["before"]), tuple(line["after"])
        number, unit, digest = head["journal"], dict(head["unit"]), str(head["digest"])
    except (ValueError, KeyError, TypeError, AttributeError):
        raise JournalError("is not a journal") from None
    if number != 1:
        raise JournalError("is a journal of another version of this program")
    return JournalState(unit, digest, tuple(dict.fromkeys(verified)), path, before, after, length)
