"""The files for TIA Portal."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.spreadsheet import BYTE_ORDER_MARK, Cell, Workbook, csv_text
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.targets.controllers.layout.table import table
from fieldspec.targets.scl.project import Project, project
from fieldspec.targets.scl.sources import blocks, clashes, functions, source, types
from fieldspec.targets.scl.tags import tag_tables
from fieldspec.targets.scl.usages import usages as usages


def files(versions: Sequence[DeviceLayout]) -> dict[str, str | Workbook]:
    """Of a device's newest version the sources of types, data blocks and functions, its constants, and its offsets."""
    tia_project = project(versions[-1])
    outputs: dict[str, str | Workbook] = {f"{tia_project.stem}_types.udt": source(tia_project, types(tia_project))}
    if tia_project.blocks:
        outputs[f"{tia_project.stem}_data.db"] = source(tia_project, blocks(tia_project))
    outputs[f"{tia_project.stem}_functions.scl"] = source(tia_project, functions(tia_project))
    outputs[f"{tia_project.stem}_constants.xlsx"] = tag_tables(tia_project)
    outputs[f"{tia_project.stem}_layout.csv"] = BYTE_ORDER_MARK + csv_text(_layout(tia_project))
    return outputs


def shared() -> dict[str, str | Workbook]:
    """No files: every file of this output belongs to one device."""
    return {}


def refusals(versions: Sequence[DeviceLayout]) -> list[Diagnostic]:
    """The refusals of names, sizes and places that TIA Portal cannot express."""
    tia_project = project(versions[-1])
    return [*tia_project.findings, *clashes(tia_project)]


def _layout(project: Project) -> list[Sequence[Cell]]:
    declared = project.declared
    rows = table(declared.placed(struct) for struct in (*declared.images, *declared.structs))
    return [(*row, "identity" if number == 0 else project.layout.identity) for number, row in enumerate(rows)]
