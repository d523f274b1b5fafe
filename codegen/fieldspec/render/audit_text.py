"""The audit of a device for people at a terminal."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.audit.section import Figure, Report, Section, SectionTable
from fieldspec.render.audit_cells import cell_text, figure_text
from fieldspec.render.blocks import Block, Line, Table, narrowed

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
            yield table_block(table)


def _style(figure: Figure) -> str:
    return "" if figure.good is None else "green" if figure.good else "red"


def table_block(table: SectionTable) -> Table:
    """A table without its empty columns."""
    rows = tuple(tuple(cell_text(cell) for cell in row) for row in table.rows)
    return narrowed(Table(table.columns, rows, tuple(_STYLES[kind] for kind in table.kinds)))
