"""Wrong use of the command line."""

from __future__ import annotations

import re
from collections.abc import Iterable

WRONG_USE = 2
"""The exit code of wrong use and of unreadable input."""


class UsageError(Exception):
    """Wrong use: one line that says what is wrong and what to do. Exit code 2."""


def unknown(kind: str, name: str, known: Iterable[str], limit: int = 20) -> UsageError:
    """The error for an unknown name, with the nearest known one, or all if there are not more than `limit`."""
    import difflib

    names = sorted(set(known), key=_in_order)
    matches = [] if name.isdecimal() else difflib.get_close_matches(name, names, 1, 0.6)
    if matches:
        hint = f"did you mean {matches[0]}?"
    elif names and len(names) <= limit:
        hint = f"there are {', '.join(names)}"
    else:
        hint = f"there are {len(names)} of them" if names else "there are none"
    return UsageError(f"there is no {kind} {name or 'without a name'}; {hint}")


def _in_order(name: str) -> list[object]:
    """A sort key: letters as letters, digits as numbers."""
    return [int(part) if number % 2 else part for number, part in enumerate(re.split(r"([0-9]{1,9})", name))]
