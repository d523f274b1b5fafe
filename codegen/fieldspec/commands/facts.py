"""`fieldspec facts`: all facts of a device, one in each row."""

from __future__ import annotations

import argparse
import json
from decimal import Decimal

from fieldspec.commands import layout_cache
from fieldspec.commands.streams import print_json, print_rows


def run(arguments: argparse.Namespace) -> int:
    """Prints the facts as CSV or JSON. Raises UsageError."""
    from fieldspec.facts import COLUMNS, rows

    fact_rows = rows(layout_cache.requested_layout(arguments))
    if arguments.format == "csv":
        print_rows([COLUMNS, *([_csv(row[column]) for column in COLUMNS] for row in fact_rows)])
    else:
        print_json(fact_rows, indent=1, default=_json_number)
    return 0


def _json_number(cell: object) -> int | float:
    """An exact decimal as a JSON number, which prints as in the spec."""
    if isinstance(cell, Decimal):
        return int(cell) if cell == cell.to_integral_value() else float(cell)
    raise TypeError(type(cell).__name__)


def _csv(cell: object) -> str:
    if cell is None:
        return ""
    if isinstance(cell, list):
        return " ".join(map(str, cell))
    if isinstance(cell, dict):
        return json.dumps(cell, ensure_ascii=False, default=_json_number)
    return format(cell, "f") if isinstance(cell, Decimal) else str(cell)
