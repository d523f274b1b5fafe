"""Texts in lines for people: on terminals, in logs and beside workflow commands. Nothing in a text acts on these."""

from __future__ import annotations

import re

_COMMAND = re.compile(r"^( *)::(?=[A-Za-z].*::)|##(?=\[[A-Za-z-])")
"""What the runner of GitHub takes for a command: `::error ...::` at the start of a line, `##[error]` anywhere in it."""


def visible_text(text: str) -> str:
    """A text in one line, with escapes for what controls a terminal, a log, or the order in which letters are shown."""
    if not text.isprintable():
        text = "".join(char if char.isprintable() else ascii(char)[1:-1] for char in text)
    if "::" in text or "##[" in text:
        text = _COMMAND.sub(lambda match: "#\\x23" if match[1] is None else f"{match[1]}\\x3a:", text)
    return text
