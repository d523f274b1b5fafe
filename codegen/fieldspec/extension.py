"""What outputs, checks and protocols of other packages import from fieldspec. They import nothing else of it.

Every other module may move or change in any release; the names here do not. docs/extend.md lists them. The objects are
those that the compiler works with: frozen, so do not change the mappings in them either. Offsets and sizes are in
bytes, addresses and strides in the unit of their address space, and raw values are whole numbers as on the wire; a
quantity in the unit is `raw * scale + offset`, an exact decimal or fraction. Whatever a function of a package raises
ends the verb with one line that names the package and exit code 2.
"""

from __future__ import annotations

from fieldspec.backends import Files
from fieldspec.checks.finding import Check, finding, label
from fieldspec.diagnostics import LEAVE_OUT, Diagnostic, Label, Severity
from fieldspec.layout.device import DeviceLayout, TableLayout
from fieldspec.layout.frame import FrameLayout, LinkLayout, MessageLayout
from fieldspec.layout.part import PartLayout
from fieldspec.layout.record import CaseLayout, FieldLayout, RecordLayout, RegisterLayout
from fieldspec.model.device import Device, Manual
from fieldspec.model.enums import Bit, Enum, Flags, Member
from fieldspec.model.fact import Citation, Fact, Place
from fieldspec.model.link import Link
from fieldspec.model.ranges import Ranges
from fieldspec.model.record import Field, Message, Record
from fieldspec.model.registers import Parameter, ParameterSet, Register, RegisterGroup, Table
from fieldspec.model.value import Kind, Primitive, Sentinel, Value
from fieldspec.names import Name, stem
from fieldspec.source import Span
from fieldspec.spreadsheet import Cell, Workbook, Worksheet, csv_text

__all__ = [
    "LEAVE_OUT",
    "Bit",
    "CaseLayout",
    "Cell",
    "Check",
    "Citation",
    "Device",
    "DeviceLayout",
    "Diagnostic",
    "Enum",
    "Fact",
    "Field",
    "FieldLayout",
    "Files",
    "Flags",
    "FrameLayout",
    "Kind",
    "Label",
    "Link",
    "LinkLayout",
    "Manual",
    "Member",
    "Message",
    "MessageLayout",
    "Name",
    "Parameter",
    "ParameterSet",
    "PartLayout",
    "Place",
    "Primitive",
    "Ranges",
    "Record",
    "RecordLayout",
    "Register",
    "RegisterGroup",
    "RegisterLayout",
    "Sentinel",
    "Severity",
    "Span",
    "Table",
    "TableLayout",
    "Value",
    "Workbook",
    "Worksheet",
    "csv_text",
    "finding",
    "label",
    "stem",
]
