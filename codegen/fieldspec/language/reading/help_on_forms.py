"""What to write instead of a text of another form: the same name or the same range as the language has it."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import lru_cache

from fieldspec.language.schema import schema

_BETWEEN = r"\s*(?:\.{2,3}|\u2026|~|-|\u2013|\u2014|\bto\b)\s*"
"""What stands between the ends of an interval in prints, dashes and an ellipsis among it."""
_INTERVAL = re.compile(rf"(-?\w+(?:\.\d+)?)(?:{_BETWEEN}(-?\w+(?:\.\d+)?))?", re.ASCII)
_HEXADECIMAL = re.compile(r"(-?)(?:0[xX])?([0-9A-Fa-f]+)[hH]?")
_LARGEST = 200
"""The length of the longest text that is examined."""


def form_help(text: str, pattern: str) -> str:
    """`write it as `servo_id``, or empty where nothing says what is meant. `pattern` is that of the schema."""
    if len(text) > _LARGEST or pattern not in _patterns():
        return ""
    own = _patterns()[pattern](text)
    return f"write it as `{own}`" if own and re.fullmatch(pattern, own) else ""


def _name(text: str) -> str:
    """A name in lower case, its words joined by underscores."""
    words = re.sub(r"([a-z0-9])([A-Z])", r"\1_\2", text)
    return re.sub(r"[^a-z0-9]+", "_", words.lower()).strip("_") if text.isascii() else ""


def _ranges(text: str) -> str:
    """Intervals with two points between numbers, which are hexadecimal where one of them has such digits."""
    intervals = []
    for item in text.split(","):
        piece = _INTERVAL.fullmatch(item.strip())
        if piece is None:
            return ""
        numbers = [number for number in piece.groups() if number]
        if any(re.fullmatch(r"-?(?:[0-9]*[A-Fa-f][0-9A-Fa-f]*|[0-9A-Fa-f]+[hH])", number) for number in numbers):
            digits = [_HEXADECIMAL.fullmatch(number) for number in numbers]
            numbers = [f"{own[1]}0x{own[2].upper()}" if own and own[2].strip("0") else "0" for own in digits]
        intervals.append("..".join(numbers))
    return ", ".join(intervals)


@lru_cache(maxsize=1)
def _patterns() -> dict[str, Callable[[str], str]]:
    """The help for a text that does not match a pattern."""
    parts = schema()["$defs"]
    return {parts["name"]["pattern"]: _name, parts["ranges"]["pattern"]: _ranges}
