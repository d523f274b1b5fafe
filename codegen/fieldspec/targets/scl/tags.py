"""Constants as a workbook that TIA Portal imports into its tables of tags."""

from __future__ import annotations

from decimal import Decimal

from fieldspec.foundation.spreadsheet import Workbook, Worksheet
from fieldspec.targets.controllers.constants import Constant
from fieldspec.targets.controllers.routines.printer import comment_text
from fieldspec.targets.scl.project import Project

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
