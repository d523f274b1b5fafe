"""The files for TIA Portal, and the workbook of constants that it imports into its tables of tags."""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal
from functools import partial

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.spreadsheet import BYTE_ORDER_MARK, Cell, Workbook, Worksheet, csv_text
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.targets.controllers.adapters.programs import siemens
from fieldspec.targets.controllers.constants import Constant
from fieldspec.targets.controllers.layout.table import table
from fieldspec.targets.controllers.routines.printer import comment_text
from fieldspec.targets.controllers.structured.usages import usage_rows, version_usages
from fieldspec.targets.scl.project import Project, declared_for_portal, project
from fieldspec.targets.scl.sources import blocks, clashes, functions, source, types
from fieldspec.targets.usages import VersionUsages, cache_spelling


def files(versions: Sequence[DeviceLayout]) -> dict[str, str | Workbook]:
    """A folder for a device's newest version: sources, programs among them, its constants, and its offsets."""
    tia_project = project(versions[-1])
    world, spelling = tia_project.declared.world, tia_project.declared.dialect.spelling
    outputs: dict[str, str | Workbook] = {"types.udt": source(tia_project, types(tia_project))}
    if tia_project.blocks:
        outputs["data.db"] = source(tia_project, blocks(tia_project))
    outputs["functions.scl"] = source(tia_project, functions(tia_project))
    for text in siemens(world, spelling, tia_project.routines):
        remarks = [f"// {line}" for line in text.remarks]
        outputs[f"{text.name}.scl"] = source(tia_project, [remarks, text.text.splitlines()])
    outputs["constants.xlsx"] = tag_tables(tia_project)
    cache_spelling("scl", versions[-1], partial(usage_rows, versions[-1], declared_for_portal))
    outputs["layout.csv"] = BYTE_ORDER_MARK + csv_text(_layout(tia_project))
    return {f"{tia_project.stem}/{tia_project.stem}_{name}": content for name, content in outputs.items()}


def usages(versions: Sequence[DeviceLayout]) -> dict[str, VersionUsages]:
    """How programs use the newest version of a device."""
    return version_usages("scl", "SCL", versions[-1], declared_for_portal)


def refusals(versions: Sequence[DeviceLayout]) -> list[Diagnostic]:
    """The refusals of names, sizes and places that TIA Portal cannot express."""
    tia_project = project(versions[-1])
    return [*tia_project.findings, *clashes(tia_project)]


def _layout(project: Project) -> list[Sequence[Cell]]:
    declared = project.declared
    rows = table(declared.placed(struct) for struct in (*declared.images, *declared.structs))
    return [(*row, "identity" if number == 0 else project.layout.identity) for number, row in enumerate(rows)]


_TAGS = (
    *("Name", "Path", "Data Type", "Logical Address", "Comment"),
    *("Hmi Visible", "Hmi Accessible", "Hmi Writeable", "Typeobject ID", "Version ID"),
)
_PROPERTIES = ("Path", "BelongsToUnit", "Accessibility")
_CONSTANTS = ("Name", "Path", "Data Type", "Value", "Comment")

_TYPES = {
    "BYTE": "Byte",
    "WORD": "Word",
    "DWORD": "DWord",
    "USINT": "USInt",
    "SINT": "SInt",
    "UINT": "UInt",
    "INT": "Int",
    "UDINT": "UDInt",
    "DINT": "DInt",
    "ULINT": "ULInt",
    "LINT": "LInt",
    "LWORD": "LWord",
    "REAL": "Real",
    "LREAL": "LReal",
}
"""How TIA Portal writes the names of types in its tables."""


def tag_tables(project: Project) -> Workbook:
    """The workbook: no tags, a table for each list of constants, and the constants. All cells are texts."""
    lists = project.declared.constants
    constants = [
        (constant.name, constant_list.name, _TYPES[constant.type.name], value(constant), comment_text(constant.remark))
        for constant_list in lists
        for constant in constant_list.constants
    ]
    return Workbook(
        (
            Worksheet("PLC Tags", (_TAGS,)),
            Worksheet("TagTable Properties", (_PROPERTIES, *((constant_list.name, "", "") for constant_list in lists))),
            Worksheet("Constants", (_CONSTANTS, *constants)),
        )
    )


def value(constant: Constant) -> str:
    """The number as TIA Portal writes it: `16#2000`, `-5`, `0.5`"""
    number = constant.value
    if isinstance(number, Decimal) or constant.type.family == "real":
        text = f"{Decimal(number):f}"
        return text if "." in text else f"{text}.0"
    if (constant.hexadecimal or constant.type.family == "bits") and number >= 0:
        return f"16#{number:0{2 * constant.type.size}X}"
    return str(number)
