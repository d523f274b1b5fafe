"""Which sections and lines of the manual the facts come from."""

from __future__ import annotations

import re

from fieldspec.backends.docs.context import Context
from fieldspec.backends.docs.document import Column, Paragraph, Row, Section, cell, plain, table
from fieldspec.model.fact import Citation

COLUMNS = (
    Column("Section", kept=True),
    Column("Facts", "number", kept=True),
    Column("Lines", "wide", kept=True),
)
_PARTS = re.compile(r"[0-9]+|[^0-9.]+")


def places(context: Context) -> Section:
    """The sections of the manual with the lines that are cited, and how many facts cite them."""
    facts: dict[str, int] = {}
    lines: dict[str, set[tuple[int, int]]] = {}
    for holder in context.holders.values():
        for citation in holder.sources:
            facts[citation.section] = facts.get(citation.section, 0) + 1
            lines.setdefault(citation.section, set()).update(citation.lines)
    rows = [
        Row((cell(section or "none"), cell(str(facts[section])), cell(_merged(lines[section]))))
        for section in sorted(facts, key=_order)
    ]
    manual = context.device.manual
    text = f"Sections of {manual.file}, with the lines that the facts on this page cite."
    return Section("sources", (plain("Sources"),), (Paragraph((plain(text),)), table("Sources", COLUMNS, rows)))


def _order(section: str) -> list[tuple[int, str]]:
    """A key that puts 9.2 before 9.10."""
    return [(int(part), "") if part.isdigit() else (-1, part) for part in _PARTS.findall(section)]


def _merged(lines: set[tuple[int, int]]) -> str:
    """Intervals of lines, those that touch in one."""
    found: list[tuple[int, int]] = []
    for first, last in sorted(lines):
        if found and first <= found[-1][1] + 1:
            found[-1] = (found[-1][0], max(found[-1][1], last))
        else:
            found.append((first, last))
    return Citation("", tuple(found)).text()
