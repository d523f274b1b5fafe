"""Texts in lines for people: on terminals, in logs and beside workflow commands. Nothing in a text acts on these."""

from __future__ import annotations

import re

from fieldspec.foundation.classes import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable

_COMMAND = re.compile(r"^( *)::(?=[A-Za-z].*::)|##(?=\[[A-Za-z-])")
"""A text that the GitHub runner reads as a command: `::error ...::` at the start of a line, `##[error]` anywhere in it.
"""


def visible_text(text: str) -> str:
    """A text in one line, with escapes for what controls a terminal, a log, or the order in which letters are shown."""
    if not text.isprintable():
        text = "".join(char if char.isprintable() else ascii(char)[1:-1] for char in text)
    if "::" in text or "##[" in text:
        text = _COMMAND.sub(lambda match: "#\\x23" if match[1] is None else f"{match[1]}\\x3a:", text)
    return text


def visible_lines(text: str) -> str:
    """A text of several lines, each as `visible_text` has it."""
    return "\n".join(map(visible_text, text.split("\n")))


_INVISIBLE = re.compile(r"[^\n -~]|(?<=#)#(?=\[)")


def visible_json(data: object, indent: int | None = None, default: Callable[[object], object] | None = None) -> str:
    """Data as JSON, in which invisible characters, and those that start commands, are escaped."""
    import json

    text = json.dumps(data, ensure_ascii=False, indent=indent, default=default)

    def escape(match: re.Match[str]) -> str:
        char = match[0]
        return "\\u0023" if char == "#" else char if char.isprintable() else json.dumps(char)[1:-1]

    return _INVISIBLE.sub(escape, text)


def wrapped(text: str, width: int, first: str = "", rest: str = "") -> list[str]:
    """Words with single blanks between them in lines of at most `width` characters; a longer word has its own line.

    `first` is the indentation of the first line, and `rest` is the indentation of the others.
    """
    lines = []
    line, start = first + text, len(first)
    while len(line) > width:
        end = line.rfind(" ", start, width + 1)
        if end < 0:
            end = line.find(" ", start)
        if end < 0:
            break
        lines.append(line[:end])
        line, start = rest + line[end + 1 :], len(rest)
    return [*lines, line]


def plural(number: int, noun: str) -> str:
    """`1 word`, `2 words`"""
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"
