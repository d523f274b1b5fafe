"""The audit of a device for people at a terminal."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import zip_longest

from fieldspec.audit.section import Figure, Report, Section, SectionTable
from fieldspec.render.audit_cells import cell_text, figure_text
from fieldspec.render.blocks import Block, Line, Table, narrowed
from fieldspec.render.columns import width

_WIDEST = 240
_NAMING = 2
"""How many columns, the first ones, tell a row from the others."""
_STYLES = {"good": "green", "bad": "red", "warning": "yellow", "": ""}


def blocks(report: Report, everything: bool) -> Iterator[Block]:
    """The numbers of all sections, then each section with its tables; long tables where `everything` is wanted."""
    yield Line(f"{report.title}, version {report.version}, identity {report.identity}", "bold")
    for section in report.sections:
        yield Line("")
        yield from _section(section, everything)


def _section(section: Section, everything: bool) -> Iterator[Block]:
    yield Line(section.title, "bold")
    for text in section.says:
        yield Line(text)
    for figure in section.figures:
        yield Line(figure_text(figure), _style(figure))
    for table in section.tables:
        if table.rows and (everything or not table.detail):
            yield Line("")
            yield Line(table.title)
            yield from table_blocks(table)


def _style(figure: Figure) -> str:
    return "" if figure.good is None else "green" if figure.good else "red"


def table_blocks(table: SectionTable) -> Iterator[Block]:
    """A table without its empty columns; one that no line could hold, row by row."""
    rows = tuple(tuple(cell_text(cell) for cell in row) for row in table.rows)
    block = narrowed(Table(table.columns, rows, tuple(_STYLES[kind] for kind in table.kinds)))
    lines = (block.headings, *block.rows)
    if sum(max(map(width, column)) + 2 for column in zip(*lines, strict=True)) <= _WIDEST:
        yield block
        return
    for row, style in zip_longest(block.rows, block.styles, fillvalue=""):
        yield Line(", ".join(row[:_NAMING]), style)
        for heading, text in zip(block.headings[_NAMING:], row[_NAMING:], strict=True):
            if text:
                yield Line(f"    {heading}: {text}")
