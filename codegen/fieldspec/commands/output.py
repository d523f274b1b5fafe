"""Printing: plain when piped, coloured on a terminal."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from functools import cache
from importlib import import_module
from typing import TYPE_CHECKING

from fieldspec.diagnostics import Diagnostic
from fieldspec.render.columns import aligned, one_line

if TYPE_CHECKING:
    from rich.console import Console

FORMATS = ("text", "json", "sarif", "github", "junit")


def on_terminal() -> bool:
    """Whether a person looks at the output and wants colours."""
    return sys.stdout.isatty() and not os.environ.get("NO_COLOR") and os.environ.get("TERM") != "dumb"


def print_findings(found: Sequence[Diagnostic], form: str, when_none: str) -> None:
    """Findings in one of FORMATS; in text, a line says so where there are none."""
    if form == "text" and not found:
        print(when_none)
        return
    renderer = import_module(f"fieldspec.render.{form}")
    if form == "text":
        print(renderer.rendered(found, coloured=on_terminal()), end="")
    else:
        print(renderer.rendered(found), end="")


def print_line(text: str, style: str = "") -> None:
    """A line; on a terminal in a style of rich, and broken between words."""
    if style and on_terminal():
        from rich.text import Text

        _console().print(Text(one_line(text), style))
    else:
        print(one_line(text))


def print_table(headings: Sequence[str], rows: Sequence[Sequence[str]], styles: Sequence[str] = ()) -> None:
    """A table: with rich on a terminal, where rows may have styles; else columns separated by two blanks."""
    if not on_terminal():
        print(aligned(headings, rows), end="")
        return
    from rich.table import Table
    from rich.text import Text

    table = Table(box=None, header_style="bold", pad_edge=False)
    for heading in headings:
        table.add_column(heading)
    for number, row in enumerate(rows):
        table.add_row(*(Text(one_line(cell)) for cell in row), style=styles[number] if styles else None)
    _console().print(table)


@cache
def _console() -> Console:
    from rich.console import Console

    return Console(highlight=False)
