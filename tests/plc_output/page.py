"""The pages about controllers, and the examples on them."""

from __future__ import annotations

import re
from pathlib import Path

DOCS = Path(__file__).resolve().parents[2] / "docs"
PAGES = {
    path.name: path.read_text("utf-8")
    for path in sorted(DOCS.glob("plc*.md"), key=lambda path: path.stem)
    if path.stem != "plc-sizes"
}
PAGE = "".join(PAGES.values())


def blocks(language: str) -> list[str]:
    """The examples in a language."""
    return re.findall(rf"^```{language}\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)
