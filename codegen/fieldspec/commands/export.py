"""`fieldspec export`: the registers and parameters of a device as a list for people and other programs."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from fieldspec.classes import replace
from fieldspec.commands import layout_cache
from fieldspec.commands.storage import write
from fieldspec.commands.terminal import print_findings
from fieldspec.commands.usage import UsageError
from fieldspec.layout.bases import base_refusals


def run(arguments: argparse.Namespace) -> int:
    """Writes the list to a file or to standard output. Exit code 1 where it cannot be right. Raises UsageError."""
    from fieldspec.lists.export import as_csv, as_json, as_xlsx
    from fieldspec.lists.item import items

    layout = layout_cache.requested_layout(arguments)
    refused = [
        replace(finding, help="name these values in `fieldspec live`, which reads where they are")
        for finding in base_refusals([layout], "a list")
    ]
    if refused:
        print_findings(refused, "text", "")
        return 1
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
        print(data.decode("utf-8"), end="")
    elif sys.stdout.isatty():
        raise UsageError("a workbook cannot be printed; name a file with --out")
    else:
        sys.stdout.buffer.write(data)
    return 0
