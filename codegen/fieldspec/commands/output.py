"""Printing: plain when piped, coloured on a terminal."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from importlib import import_module

from fieldspec.diagnostics import Diagnostic

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


def print_table(headings: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
    """A table: with rich on a terminal, else columns separated by two blanks."""
    if on_terminal():
        from rich.console import Console
        from rich.table import Table
        from rich.text import Text

        table = Table(box=None, header_style="bold", pad_edge=False)
        for heading in headings:
            table.add_column(heading)
        for row in rows:
            table.add_row(*(Text(cell) for cell in row))
        Console().print(table)
        return
    from fieldspec.render.columns import aligned

    print(aligned(headings, rows), end="")
