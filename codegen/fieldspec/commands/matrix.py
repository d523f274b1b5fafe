"""`fieldspec matrix`: the facts of all versions side by side."""

from __future__ import annotations

import argparse
import csv
import sys

from fieldspec.commands import specs
from fieldspec.commands.terminal import print_blocks
from fieldspec.commands.usage import UsageError
from fieldspec.commands.versions import each
from fieldspec.facts import rows
from fieldspec.facts.matrix import Matrix, matrix
from fieldspec.render.blocks import Line, Table


def run(arguments: argparse.Namespace) -> int:
    """Prints a row for each fact that differs between versions, or for every fact. Raises UsageError."""
    name, version = specs.split(arguments.device)
    if version:
        raise UsageError(f"the matrix shows all versions; leave out @{version}")
    spec, _ = specs.spec_at(arguments.specs, name)
    fact_matrix = matrix({version: rows(specs.layout_of(spec, version)) for version in each(spec)}, arguments.all)
    if arguments.format == "text":
        print_blocks(
            [_table(fact_matrix)] if fact_matrix.rows else [Line(f"all versions of {name} have the same facts")]
        )
    elif arguments.format == "csv":
        writer = csv.writer(sys.stdout, lineterminator="\n")
        writer.writerow(("path", "kind", *fact_matrix.versions))
        writer.writerows((row.path, row.kind, *row.cells) for row in fact_matrix.rows)
    else:
        from fieldspec.render.matrix_html import rendered

        print(rendered(spec.id, fact_matrix), end="")
    return 0


def _table(matrix: Matrix) -> Table:
    cells = tuple((row.path, *(cell or "-" for cell in row.cells)) for row in matrix.rows)
    return Table(("fact", *matrix.versions), cells)
