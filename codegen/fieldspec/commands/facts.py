"""`fieldspec facts`: every fact of a device, one row each."""

from __future__ import annotations

import argparse
import sys
from decimal import Decimal

from fieldspec.commands import specs


def run(arguments: argparse.Namespace) -> int:
    """Prints the facts as CSV or JSON."""
    from fieldspec.facts import COLUMNS, Cell, rows

    layout = specs.layout(arguments.specs, arguments.device)
    found = rows(layout)
    if arguments.format == "csv":
        import csv

        writer = csv.writer(sys.stdout, lineterminator="\n")
        writer.writerow(COLUMNS)
        writer.writerows([_csv(row[column]) for column in COLUMNS] for row in found)
        return 0
    import json

    def number(cell: object) -> object:
        if isinstance(cell, Decimal):
            return int(cell) if cell == cell.to_integral_value() else float(cell)
        raise TypeError(type(cell).__name__)

    data: list[dict[str, Cell]] = found
    json.dump(data, sys.stdout, ensure_ascii=False, indent=1, default=number)
    print()
    return 0


def _csv(cell: object) -> str:
    if cell is None:
        return ""
    if isinstance(cell, list):
        return " ".join(map(str, cell))
    if isinstance(cell, dict):
        import json

        return json.dumps(cell, ensure_ascii=False, default=str)
    return str(cell)
