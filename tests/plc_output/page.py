"""The page about engineering tools, and the examples on it."""

from __future__ import annotations

import re
from pathlib import Path

PAGE = (Path(__file__).resolve().parents[2] / "docs" / "plc.md").read_text("utf-8")


def blocks(language: str) -> list[str]:
    """The examples in a language."""
    return re.findall(rf"^```{language}\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)


def example(language: str, name: str) -> str:
    """The example that declares a name."""
    (text,) = (block for block in blocks(language) if re.match(rf'\w+ "?{name}\b', block))
    return text
