"""What stands in brackets within a text of a list, or at its end: a unit, the size of a type, a remark."""

from __future__ import annotations

import re

_BRACKETS = re.compile(r"\([^()]*\)|\[[^\[\]]*\]")
_PAIRS = {")": "(", "]": "["}


def without_brackets(text: str) -> str:
    """A text with a blank for each pair of brackets and what is in it."""
    return _BRACKETS.sub(" ", text)


def parted(text: str) -> tuple[str, str]:
    """A text, and what is in the brackets at its end; the second one is empty where it ends in none."""
    bare = text.rstrip()
    closing = bare[-1:]
    if closing in _PAIRS:
        depth = 0
        for place in range(len(bare) - 1, -1, -1):
            depth += (bare[place] == closing) - (bare[place] == _PAIRS[closing])
            if not depth:
                return bare[:place].strip(), bare[place + 1 : -1].strip()
    return bare, ""
