"""`fieldspec export`: the registers and parameters of a device as a list for people and other programs."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from fieldspec.codec.layout.bases import base_refusals
from fieldspec.codec.layout.omissions import expressed
from fieldspec.command.console.streams import print_document
from fieldspec.command.console.usage import UsageError
from fieldspec.command.files.storage import write
from fieldspec.command.sources import layout_cache
from fieldspec.foundation.classes import replace


def run(arguments: argparse.Namespace) -> int:
    """Writes the list to a file or to standard output, and what it leaves out to standard error. Raises UsageError."""
    from fieldspec.tools.lists.export import as_csv, as_json, as_xlsx
    from fieldspec.tools.lists.item import items

    stated = layout_cache.requested_layout(arguments)
    remaining = expressed(stated, base_refusals(stated, "a list"))
    if remaining.findings:
        from fieldspec.command.rendering.finding_text import rendered

        help = "it is left out; name its values in `fieldspec live`, which reads where they are"
        print_document(rendered([replace(finding, help=help) for finding in remaining.findings]), sys.stderr)
    layout = remaining.layout
    entries = items(layout)
    if not entries:
        raise UsageError(f"{layout.device.id} has no registers and no parameters")
    if arguments.to == "xlsx":
        data = as_xlsx(entries, layout.device.id)
    else:
        data = (as_csv(entries) if arguments.to == "csv" else as_json(entries)).encode("utf-8")
    if arguments.out is not None:
        write(Path(arguments.out), data)
    elif arguments.to != "xlsx":
        print_document(data.decode("utf-8"))
    elif sys.stdout.isatty():
        raise UsageError("a workbook cannot be printed; name a file with --out")
    else:
        sys.stdout.buffer.write(data)
    return 0
