"""Plain text in columns, by the width that characters take on a terminal."""

from __future__ import annotations

import unicodedata
from collections.abc import Sequence


def width(text: str) -> int:
    """How many columns a text takes: wide characters take two, combining ones none."""
    return len(text) if text.isascii() else sum(map(_char_width, text))


def _char_width(char: str) -> int:
    if unicodedata.combining(char) or unicodedata.category(char) in ("Cf", "Mn"):
        return 0
    return 2 if unicodedata.east_asian_width(char) in "WF" else 1


def one_line(text: str) -> str:
    """A text with its control characters made visible."""
    if text.isprintable():
        return text
    return "".join(char if char.isprintable() else ascii(char)[1:-1] for char in text)


def aligned(headings: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A table whose columns are two blanks apart."""
    lines = [[one_line(cell) for cell in row] for row in (headings, *rows)]
    widths = [max(width(line[at]) for line in lines) for at in range(len(headings))]
    text = ""
    for line in lines:
        padded = (cell + " " * (widths[at] - width(cell)) for at, cell in enumerate(line))
        text += "  ".join(padded).rstrip() + "\n"
    return text
