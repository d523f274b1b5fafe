"""Wrong use of the command line."""

from __future__ import annotations

import re
from collections.abc import Iterable

WRONG_USE = 2
"""The exit code of wrong use and of unreadable input."""


_NEAREST = 3
"""The nearest names that an error lists."""


class UsageError(Exception):
    """Wrong use: one line that says what is wrong and what to do. Exit code 2."""


def unknown(kind: str, name: str, known: Iterable[str], limit: int = 20) -> UsageError:
    """The error for an unknown name, with the nearest known one, or all if there are not more than `limit`."""
    import difflib

    names = sorted(set(known), key=_in_order)
    parts = {name.casefold(), *re.split(r"[/\\@]", name)}
    exact = [known_name for known_name in names if known_name.casefold() in parts]
    matches = exact or ([] if name.isdecimal() else difflib.get_close_matches(name, names, 1, 0.6))
    longer = sorted((known_name for known_name in names if name and name in known_name.split("_")), key=len)[:_NEAREST]
    if matches and not longer:
        hint = f"did you mean {matches[0]}?"
    elif longer:
        hint = f"did you mean {' or '.join(longer)}?"
    elif names and len(names) <= limit:
        hint = f"choose from {', '.join(names)}"
    elif names:
        nearest_names = difflib.get_close_matches(name, names, _NEAREST, 0.0) or names[:_NEAREST]
        hint = f"the nearest of {len(names)} are {', '.join(nearest_names)}"
    else:
        hint = "there are none"
    return UsageError(f"there is no {kind} {name or 'without a name'}; {hint}")


def not_at(kind: str, number: int, known: Iterable[tuple[int, str]]) -> UsageError:
    """The error for an address or a number that nothing has, with the nearest ones that something has."""
    nearest = sorted(dict(sorted(known)).items(), key=lambda pair: (abs(pair[0] - number), pair[0]))[:_NEAREST]
    names = ", ".join(f"{name} at 0x{address:04X}" for address, name in sorted(nearest))
    return UsageError(f"there is no {kind} at 0x{number:04X} ({number}); the nearest are {names}")


def _in_order(name: str) -> list[object]:
    """A sort key: letters as letters, digits as numbers."""
    return [int(part) if number % 2 else part for number, part in enumerate(re.split(r"([0-9]{1,9})", name))]
