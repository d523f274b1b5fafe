"""`fieldspec matrix`: the facts of all versions side by side."""

from __future__ import annotations

import argparse
from itertools import pairwise

from fieldspec.command.console.streams import print_document, print_rows
from fieldspec.command.console.terminal import print_blocks
from fieldspec.command.console.usage import UsageError
from fieldspec.command.rendering.blocks import Line, Table
from fieldspec.command.sources import specs
from fieldspec.command.verbs.versions import each
from fieldspec.foundation.html_text import clean
from fieldspec.language.changes.comparison import Comparison
from fieldspec.language.changes.reasons import stated_reasons
from fieldspec.language.model.device import Device
from fieldspec.targets.templates import fill
from fieldspec.tools.facts import rows
from fieldspec.tools.facts.matrix import SAME, Matrix, Renaming, matrix


def run(arguments: argparse.Namespace) -> int:
    """Prints a row for each fact that differs between versions, or for every fact. Raises UsageError."""
    name, version = specs.split(arguments.device)
    if version:
        raise UsageError(f"the matrix shows all versions; leave out @{version}")
    spec, _ = specs.spec_at(arguments.specs, name)
    layouts = {version: specs.layout_of(spec, version) for version in each(spec)}
    facts = {version: rows(layout) for version, layout in layouts.items()}
    devices = [layout.device for layout in layouts.values()]
    fact_matrix = matrix(facts, arguments.all, [_renaming(*pair) for pair in pairwise(devices)])
    if arguments.format == "text":
        print_blocks(
            [_table(fact_matrix)] if fact_matrix.rows else [Line(f"all versions of {name} have the same facts")]
        )
    elif arguments.format == "csv":
        head = ("path", "kind", *fact_matrix.versions)
        print_rows([head, *((row.path, row.kind, *row.cells) for row in fact_matrix.rows)])
    else:
        title = clean(f"{spec.id}: facts by versions")
        print_document(fill("matrix.html.j2", title=title, matrix=fact_matrix, same=SAME))
    return 0


def _renaming(old: Device, new: Device) -> Renaming:
    """The paths of a version as paths of the next version: renamed by the spec, or by evidence.

    A reserved fact that now has a meaning is not renamed.
    """
    comparison = Comparison(old, new, stated_reasons(old, new).renames)
    reserved = {pair.old.place.path for pair in comparison.reserved_changes}
    return lambda path: path if path in reserved else comparison.renamed_path(path)


def _table(matrix: Matrix) -> Table:
    cells = tuple((row.path, *(cell or "-" for cell in row.cells)) for row in matrix.rows)
    return Table(("fact", *matrix.versions), cells)
