"""Prints findings, lines and tables: styled on a terminal, as bare text elsewhere."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Sequence
from functools import cache
from itertools import zip_longest

from fieldspec.command.rendering.blocks import Block, Line, Table, aligned, bare_text, split
from fieldspec.foundation.classes import TYPE_CHECKING
from fieldspec.foundation.line_text import visible_text
from fieldspec.language.diagnostics import Diagnostic

if TYPE_CHECKING:
    from rich.console import Console


def on_terminal() -> bool:
    """Whether the output is a terminal and colours are welcome."""
    return sys.stdout.isatty() and not os.environ.get("NO_COLOR") and os.environ.get("TERM") != "dumb"


def print_findings(findings: Sequence[Diagnostic], form: str, when_none: str) -> None:
    """Prints findings in a format of `check`. As text, `when_none` is printed where there are none."""
    if form == "text" and not findings:
        print(when_none)
    elif form == "text":
        from fieldspec.command.rendering.finding_text import rendered

        if not on_terminal():
            print(rendered(findings), end="")
            return
        from rich.text import Text

        _console().print(Text.from_ansi(rendered(findings, coloured=True)), soft_wrap=True)
    else:
        from fieldspec.command.rendering.finding_formats import format_findings

        print(format_findings(findings, form), end="")


def print_blocks(blocks: Iterable[Block]) -> None:
    """Prints lines and tables: on a terminal styled and wrapped, else as bare text."""
    pretty = on_terminal()
    for block in blocks:
        if pretty:
            _print_pretty(block)
        else:
            print(bare_text(block), end="")


def _print_pretty(block: Block) -> None:
    from rich.table import Table as RichTable
    from rich.text import Text

    if isinstance(block, Line):
        _console().print(Text(visible_text(block.text), block.style), soft_wrap=block.drawn)
        return
    stay, below = split(block, _console().width)
    if below:
        _print_split(block, stay, below)
        return
    table = RichTable(box=None, header_style="bold", pad_edge=False)
    for heading in block.headings:
        table.add_column(heading)
    for row, style in zip_longest(block.rows, block.styles, fillvalue=""):
        table.add_row(*(Text(visible_text(cell)) for cell in row), style=style)
    _console().print(table)


def _print_split(block: Table, stay: Sequence[int], below: Sequence[int]) -> None:
    """Prints a table that is wider than the terminal: cells that do not fit are printed below each row, by column."""
    from rich.padding import Padding
    from rich.text import Text

    text = aligned([block.headings[index] for index in stay], [[row[index] for index in stay] for row in block.rows])
    head, *lines = text.splitlines()
    console = _console()
    console.print(Text(head, "bold"))
    for row, line, style in zip_longest(block.rows, lines, block.styles, fillvalue=""):
        if line:
            console.print(Text(line, style))
        for index in below:
            if row[index]:
                name = f"{block.headings[index]}: " if line and block.headings[index] else ""
                console.print(Padding(Text.assemble((name, "dim"), (visible_text(row[index]), style)), (0, 0, 0, 4)))


@cache
def _console() -> Console:
    from rich.console import Console

    return Console(highlight=False)
