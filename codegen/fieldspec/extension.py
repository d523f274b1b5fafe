"""What outputs, checks, protocols and codecs of other packages import from fieldspec. They import nothing else of it.

Every other module may move or change in any release; the names here do not. docs/extend.md lists them. The objects are
those that the compiler works with: frozen, so do not change the mappings in them either. Offsets and sizes are in
bytes, addresses and strides in the unit of their address space, and raw values are whole numbers as on the wire; a
quantity in the unit is `raw * scale + offset`, an exact decimal or fraction. Whatever a function of a package raises
ends the verb with one line that names the package and exit code 2.
"""

from __future__ import annotations

from fieldspec.codec.layout.device import DeviceLayout, TableLayout
from fieldspec.codec.layout.frame import FrameLayout, LinkLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.part import PartLayout
from fieldspec.codec.layout.record import CaseLayout, FieldLayout, RecordLayout, RegisterLayout
from fieldspec.foundation.names import Name, stem
from fieldspec.foundation.source import Span
from fieldspec.foundation.spreadsheet import Cell, Workbook, Worksheet, csv_text
from fieldspec.language.checks.finding import Check, label
from fieldspec.language.checks.finding import finding_of as finding
from fieldspec.language.diagnostics import LEAVE_OUT, Diagnostic, Label, Severity
from fieldspec.language.model.codecs import ChecksumCodec, NumberCodec
from fieldspec.language.model.device import Device, Manual
from fieldspec.language.model.encoding import Digits, Encoding, Octets, Precision, Real, Sign, Text, Truth, Whole
from fieldspec.language.model.enums import Bit, Enum, Flags, Member
from fieldspec.language.model.fact import Citation, Fact, Place
from fieldspec.language.model.link import Link
from fieldspec.language.model.primitives import Primitive
from fieldspec.language.model.ranges import Ranges
from fieldspec.language.model.record import Field, Message, Record
from fieldspec.language.model.registers import Parameter, ParameterSet, Register, RegisterGroup, Table
from fieldspec.language.model.value import Sentinel, Value
from fieldspec.targets import Files

__all__ = [
    "LEAVE_OUT",
    "Bit",
    "CaseLayout",
    "Cell",
    "Check",
    "ChecksumCodec",
    "Citation",
    "Device",
    "DeviceLayout",
    "Diagnostic",
    "Digits",
    "Encoding",
    "Enum",
    "Fact",
    "Field",
    "FieldLayout",
    "Files",
    "Flags",
    "FrameLayout",
    "Label",
    "Link",
    "LinkLayout",
    "Manual",
    "Member",
    "Message",
    "MessageLayout",
    "Name",
    "NumberCodec",
    "Octets",
    "Parameter",
    "ParameterSet",
    "PartLayout",
    "Place",
    "Precision",
    "Primitive",
    "Ranges",
    "Real",
    "Record",
    "RecordLayout",
    "Register",
    "RegisterGroup",
    "RegisterLayout",
    "Sentinel",
    "Severity",
    "Sign",
    "Span",
    "Table",
    "TableLayout",
    "Text",
    "Truth",
    "Value",
    "Whole",
    "Workbook",
    "Worksheet",
    "csv_text",
    "finding",
    "label",
    "stem",
]
