"""The files for TIA Portal."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.backends.scl.project import Project, project
from fieldspec.backends.scl.sources import blocks, clashes, functions, source, types
from fieldspec.backends.scl.tags import tag_tables
from fieldspec.diagnostics import Diagnostic
from fieldspec.layout.device import DeviceLayout
from fieldspec.plc.layout.table import table
from fieldspec.spreadsheet import BYTE_ORDER_MARK, Cell, Workbook, csv_text


def files(versions: Sequence[DeviceLayout]) -> dict[str, str | Workbook]:
    """Of a device's newest version the sources of types, data blocks and functions, its constants, and its offsets."""
    held = project(versions[-1])
    made: dict[str, str | Workbook] = {f"{held.stem}_types.udt": source(held, types(held))}
    if held.blocks:
        made[f"{held.stem}_data.db"] = source(held, blocks(held))
    made[f"{held.stem}_functions.scl"] = source(held, functions(held))
    made[f"{held.stem}_constants.xlsx"] = tag_tables(held)
    made[f"{held.stem}_layout.csv"] = BYTE_ORDER_MARK + csv_text(_layout(held))
    return made


def shared() -> dict[str, str | Workbook]:
    """Nothing belongs to no device."""
    return {}


def refusals(versions: Sequence[DeviceLayout]) -> list[Diagnostic]:
    """What TIA Portal cannot have of a device: names, sizes and places."""
    held = project(versions[-1])
    return [*held.findings, *clashes(held)]


def _layout(held: Project) -> list[Sequence[Cell]]:
    declared = held.declared
    rows = table(declared.placed(struct) for struct in (*declared.images, *declared.structs))
    return [(*row, "identity" if number == 0 else held.layout.identity) for number, row in enumerate(rows)]
