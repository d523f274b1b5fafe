"""The pages about controllers, and the examples on them."""

from __future__ import annotations

import re
from pathlib import Path

DOCS = Path(__file__).resolve().parents[2] / "docs"
PAGES = {
    name: (DOCS / name).read_text("utf-8") for name in ("plc.md", "plc-codesys.md", "plc-twincat.md", "plc-tia.md")
}
PAGE = "".join(PAGES.values())


def blocks(language: str) -> list[str]:
    """The examples in a language."""
    return re.findall(rf"^```{language}\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)
