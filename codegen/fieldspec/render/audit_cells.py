"""The cells of an audit's tables as texts."""

from __future__ import annotations

from fieldspec.audit.section import Cell, Figure
from fieldspec.model.fact import Citation
from fieldspec.source import Span

SIGNS = {"good": ("✓", "right"), "bad": ("✗", "wrong"), "warning": ("!", "to be looked at"), "": ("", "")}
"""How something stands, as a sign and in words."""


def cell_text(cell: Cell) -> str:
    """A cell for people: nothing is empty, a place in a file is `path:line`, one in the manual as specs cite it."""
    if cell is None:
        return ""
    if isinstance(cell, Span):
        return f"{cell.file.path}:{cell.position()[0]}"
    return cell.text() if isinstance(cell, Citation) else str(cell)


def figure_text(figure: Figure) -> str:
    """`812 of 820 facts of the manual are covered`."""
    whole = "" if figure.whole is None else f" of {figure.whole}"
    return f"{figure.number}{whole} {figure.what}"
