"""Places of the manual, as specs cite them."""

from __future__ import annotations

import re
from functools import lru_cache

from fieldspec.language.model.fact import Citation

_NUMBERS = re.compile(r"[0-9]+")
_CITED = re.compile(r"(?:([0-9A-Za-z.]+)(?: |$))??(?:([LP])([0-9].*))?$")


@lru_cache(maxsize=65536)
def citations(text: str, section: str) -> tuple[Citation, ...]:
    """`8.2 L1622-1623, 1630; 9.1 L5` as citations; a part without a section takes the one given. `P` marks pages."""
    citations = []
    for part in text.split("; ") if text else ():
        head, mark, numbers = _CITED.match(part).groups()  # type: ignore[union-attr]  # every text matches
        lines = []
        for piece in numbers.split(",") if mark else ():
            bounds = [int(number) for number in _NUMBERS.findall(piece)]
            lines.append((bounds[0], bounds[-1]))
        citations.append(Citation(head or section, tuple(lines), mark or ""))
    return tuple(citations)


def common_section(sources: tuple[Citation, ...]) -> str:
    """The section of all citations, which is that of what they enclose; empty where they cite several."""
    sections = {citation.section for citation in sources}
    return sections.pop() if len(sections) == 1 else ""
