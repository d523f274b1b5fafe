"""Reads a register dump of a real device and holds it beside the spec: `fieldspec audit DEVICE --dump FILE`."""

from __future__ import annotations

import argparse
from collections.abc import Mapping
from typing import TYPE_CHECKING

from fieldspec.audit.dump import compared, judged, section
from fieldspec.commands import lists
from fieldspec.commands.usage import UsageError
from fieldspec.diagnostics import Diagnostic, in_order
from fieldspec.layout.device import DeviceLayout
from fieldspec.lists.dump import dump, object_sheet
from fieldspec.lists.sheet import ListError, Sheet
from fieldspec.lists.text_sheet import decoded
from fieldspec.lists.workbook import MAGIC
from fieldspec.source import SourceFile

if TYPE_CHECKING:
    from fieldspec.audit.section import Section

COLUMNS = ("address", "value", "words", "space")
"""The columns that an option names."""


def dumped(arguments: argparse.Namespace, layout: DeviceLayout) -> tuple[Section, tuple[Diagnostic, ...]]:
    """The section of a dump, and what is wrong with it. Raises UsageError for a file that cannot be used."""
    given = {role: text for role in COLUMNS if (text := getattr(arguments, role)) is not None}
    encoding = arguments.encoding or ""
    held = lists.content(arguments.dump)
    try:
        sheet = object_sheet(held, encoding) or lists.sheet(held, encoding, arguments.sheet or "")
        found = dump(sheet, given, arguments.base or "")
        file, rows = _file(arguments.dump, held, encoding, sheet)
    except ListError as error:
        raise UsageError(f"{_shown(arguments.dump)} {error}") from None
    told = compared(layout, found, arguments.offset or 0)
    if told.unknown and not (told.read or told.holes or told.too_great):
        raise UsageError(
            f"{_shown(arguments.dump)} has no address that {layout.device.name} has; if it is a dump of this device, "
            "say with --base or --offset how its addresses are counted"
        )
    wrong = tuple(in_order(judged(told, file, rows)))
    return section(told, wrong, len(found.skipped)), wrong


def _shown(name: str) -> str:
    return "standard input" if name == "-" else name


def _file(name: str, held: bytes, encoding: str, sheet: Sheet) -> tuple[SourceFile, Mapping[int, int]]:
    """The text that findings show, with the offset of each row: the file itself, or its rows where it is no text."""
    shown = _shown(name)
    if not held.startswith(MAGIC):
        text = decoded(held, encoding)
        lines = text.splitlines(keepends=True)
        if len(lines) == sheet.lines:
            starts = [0]
            for line in lines:
                starts.append(starts[-1] + len(line))
            return SourceFile(shown, text), dict(enumerate(starts, 1))
    rows: dict[int, int] = {}
    parts = []
    at = 0
    for row in sheet.rows:
        rows[row.number] = at
        parts.append("\t".join(row.cells) + "\n")
        at += len(parts[-1])
    return SourceFile(shown, "".join(parts)), rows
