"""Electronic data sheets become devices whose objects are what the library canopen reads of the same file."""

from __future__ import annotations

import io
import json
import re
import sys
import time
from pathlib import Path

import pytest
from canopen.objectdictionary import ODVariable, datatypes, eds

from command_line import CommandLine
from layouts import newest

SHEET = """\
; A made-up motor
[FileInfo]
FileName=motor.eds
[DeviceInfo]
VendorName=Nobody
[MandatoryObjects]
SupportedObjects=3
1=0x1000
2=0x1001
3=0x1018
[OptionalObjects]
SupportedObjects=2
1=0x1008
2=0x7000
[1000]
ParameterName=Device type
ObjectType=0x7
DataType=0x0007
AccessType=const
DefaultValue=0x00020192
PDOMapping=0
[1001]
ParameterName=Error register
ObjectType=0x7
DataType=0x0005
AccessType=ro
PDOMapping=1
[1003]
ParameterName=Pre-defined error field
ObjectType=0x8
DataType=0x0007
AccessType=ro
CompactSubObj=4
[1008]
ParameterName=Manufacturer device name
ObjectType=0x7
DataType=0x0009
AccessType=const
DefaultValue=Motor
[1018]
ParameterName=Identity object
ObjectType=0x9
SubNumber=3
[1018sub0]
ParameterName=Highest subindex
DataType=0x0005
AccessType=ro
DefaultValue=2
[1018sub1]
ParameterName=Vendor
DataType=0x0007
AccessType=ro
DefaultValue=0x0000012D
[1018sub2]
ParameterName=Product code
DataType=0x0007
AccessType=ro
[1400]
ParameterName=Received data
ObjectType=0x9
SubNumber=2
[1400sub0]
ParameterName=Highest subindex
DataType=0x0005
AccessType=const
DefaultValue=1
[1400sub1]
ParameterName=Identifier
DataType=0x0007
AccessType=rw
DefaultValue=$NODEID+0x200
[1F50]
ParameterName=Program
ObjectType=0x2
DataType=0x000F
AccessType=wo
[2000]
ParameterName=Gain
ObjectType=0x7
DataType=0x0008
AccessType=rw
DefaultValue=1.5
[2001]
ParameterName=Trim
ObjectType=0x7
DataType=0x0010
AccessType=rwr
LowLimit=-100
HighLimit=0x64
DefaultValue=-5
Unit=mV
Factor=0.5
[2002]
ParameterName=Odd
ObjectType=0x7
DataType=0x0006
AccessType=sometimes
[607D]
ParameterName=Position limits
ObjectType=0x8
SubNumber=3
[607Dsub0]
ParameterName=Highest subindex
DataType=0x0005
AccessType=const
DefaultValue=2
[607Dsub1]
ParameterName=Lowest
DataType=0x0004
AccessType=rw
DefaultValue=0xFFFFFF00
LowLimit=0x80000000
HighLimit=0x7FFFFFFF
[607Dsub2]
ParameterName=Highest
DataType=0x0004
AccessType=rw
"""
REFUSED = {
    "1F50": "has the data type 0x000F, whose size such a file does not have",
    "2002": "is not an access of an object",
    "7000": "has no section [7000]",
}
NAMES = {
    datatypes.UNSIGNED8: "u8",
    datatypes.UNSIGNED16: "u16",
    datatypes.UNSIGNED32: "u32",
    datatypes.INTEGER24: "i24",
    datatypes.INTEGER32: "i32",
    datatypes.REAL32: "f32",
    datatypes.VISIBLE_STRING: "text",
}
COUNT = (0x1003, 0)
"""The number of entries of an array without sections of its own: CiA 306 has it as `ro`, the library as nothing."""

ACCESSES = {"const": "ro", "rwr": "rw"}


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> CommandLine:
    (tmp_path / "specs").mkdir()
    return CommandLine(capsys, monkeypatch, tmp_path / "specs")


def import_text(run: CommandLine, text: str, *options: str) -> str:
    """The report of an import that succeeds, and whose spec passes the check."""
    ran = run("import", "-", "--to", str(run.folder / "motor" / "device.yaml"), *options, stdin=text.encode())
    assert (ran.code, ran.err) == (0, "")
    assert run("check", "motor").code == 0
    return ran.out


def variables(text: str, node: int | None = None) -> dict[tuple[int, int | None], ODVariable]:
    """What the library reads: the variables by index and subindex."""
    result: dict[tuple[int, int | None], ODVariable] = {}
    for entry in eds.import_eds(io.StringIO(text), node).values():
        parts = {None: entry} if isinstance(entry, ODVariable) else entry.subindices
        result |= {(entry.index, subindex): part for subindex, part in parts.items()}
    return result


def test_objects_and_their_elements_are_those_of_the_library(run: CommandLine) -> None:
    import_text(run, SHEET)
    rows = newest(run.folder, "motor").device.parameters["objects"].parameters
    values = {(row.number, None): row for row in rows if not row.subindices}
    values |= {(row.number, part.indices.low): part for row in rows for part in row.subindices if not part.reserved}
    expected = variables(SHEET)
    refused = {(int(index, 16), None) for index in REFUSED}
    assert values.keys() == expected.keys() - refused
    for place, own in values.items():
        variable = expected[place]
        assert own.value.type.name == NAMES[variable.data_type], place
        access = "ro" if place == COUNT else ACCESSES.get(variable.access_type, variable.access_type)
        assert own.access == access, place
        ranges = own.value.ranges
        if variable.min is not None:
            assert (ranges.low, ranges.high) == (variable.min, variable.max), place
        if isinstance(variable.default, int):
            initial = own.value.const if variable.access_type == "const" else own.value.default
            assert initial.to_bytes(8, "big", signed=True)[-4:] == variable.default.to_bytes(8, "big", signed=True)[-4:]
    assert (values[0x2001, None].value.ranges.low, values[0x607D, 1].value.default) == (-100, -256)
    trim = values[0x2001, None].value
    assert (trim.unit, float(trim.scale)) == ("mV", expected[0x2001, None].factor)


def test_what_is_not_taken_is_named_with_its_line(run: CommandLine) -> None:
    report = import_text(run, SHEET)
    lines = SHEET.splitlines()
    refused = dict(re.findall(r"^not used: row (\d+), \w+ `.*?`: (.*)$", report, re.MULTILINE))
    expected = {
        str(lines.index(f"[{index}]") + 1): reason for index, reason in REFUSED.items() if f"[{index}]" in lines
    }
    expected[str(lines.index("2=0x7000") + 1)] = REFUSED["7000"]
    assert {
        row: next(reason for reason in REFUSED.values() if reason in text) for row, text in refused.items()
    } == expected
    assert "read as an electronic data sheet (EDS or DCF)" in report
    assert "columns not used: PDOMapping" in report
    assert "assumed: texts: up to 64 bytes" in report


def test_the_device_is_read_by_the_protocol_of_such_objects(run: CommandLine) -> None:
    import_text(run, SHEET)
    device = newest(run.folder, "motor").device
    assert "sdo" in device.links
    assert {"upload", "download_4"} <= device.messages.keys()


def test_words_of_objects_are_sent_in_the_order_of_their_bytes(run: CommandLine) -> None:
    import_text(run, SHEET)
    sent = run("encode", "motor", "write", "position_limits.lowest=0x12345678", "--link", "sdo").out
    assert "23 7D 60 01 78 56 34 12" in sent


def test_a_default_that_depends_on_the_node_is_a_note(run: CommandLine) -> None:
    import_text(run, SHEET)
    text = (run.folder / "motor" / "device.yaml").read_text("utf-8")
    assert "Default in the list: $NODEID+0x200." in text


def test_a_configuration_says_what_such_a_default_is(run: CommandLine) -> None:
    configured = SHEET + "[DeviceComissioning]\nNodeID=5\n"
    import_text(run, configured)
    rows = newest(run.folder, "motor").device.parameters["objects"].parameters
    own = next(row for row in rows if row.number == 0x1400).subindices[1]
    assert own.value.default == variables(configured, 5)[0x1400, 1].default == 0x205


def test_a_value_of_a_configuration_is_a_note(run: CommandLine) -> None:
    import_text(run, SHEET.replace("DefaultValue=1.5\n", "DefaultValue=1.5\nParameterValue=2.5\n"))
    assert "ParameterValue in the list: 2.5." in (run.folder / "motor" / "device.yaml").read_text("utf-8")


def test_an_object_that_the_library_cannot_read_hides_no_other(run: CommandLine) -> None:
    report = import_text(run, SHEET.replace("[2000]\nParameterName=Gain\n", "[2000]\n"))
    line = SHEET.splitlines().index("[2000]") + 1
    assert f"not used: row {line}: cannot be read: No option 'parametername' in section: '2000'" in report.replace(
        "ParameterName", "parametername"
    )


def test_without_the_library_the_refusal_names_the_extra(run: CommandLine, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "canopen.objectdictionary", None)
    ran = run("import", "-", "--to", "motor.yaml", stdin=SHEET.encode())
    assert (ran.code, ran.err.count("\n")) == (2, 1)
    assert "pip install 'fieldspec[lists]'" in ran.err


def test_an_import_agrees_with_its_own_sheet(run: CommandLine) -> None:
    taken = "\n[".join(part for part in SHEET.split("\n[") if part[:4] not in REFUSED).replace("2=0x7000\n", "")
    taken += "[DeviceComissioning]\nNodeID=5\n"
    assert "not used: row" not in import_text(run, taken)
    ran = run("compare", "motor", "-", stdin=taken.encode())
    assert (ran.code, ran.err) == (0, "")


def test_an_export_has_the_elements_of_objects(run: CommandLine) -> None:
    import_text(run, SHEET)
    rows = json.loads(run("export", "motor", "--to", "json").out)
    elements = {(row["address"], row["subindex"]): row for row in rows if row["subindex"]}
    names = {place: row["name"] for place, row in elements.items() if place[0] == 0x607D}
    assert names == {
        (0x607D, "0"): "position_limits.highest_subindex",
        (0x607D, "1"): "position_limits.lowest",
        (0x607D, "2"): "position_limits.highest",
    }
    assert (elements[0x607D, "1"]["default"], elements[0x607D, "1"]["type"]) == (-256, "i32")
    assert elements[0x1003, "1..4"]["type"] == "u32"


@pytest.mark.parametrize(
    "text",
    [
        "[FileInfo]\n",
        "[FileInfo]\n[1000]\n",
        "[FileInfo]\n[1000]\nDataType=0x1B0\n",
        "[FileInfo]\n[1000]\nParameterName=a\nDataType=0x0007\nAccessType=ro\nDefaultValue=0x" + "F" * 100000 + "\n",
        "[FileInfo]\n[1000sub0]\nParameterName=a\n",
        "[FileInfo]\n[2000]\nParameterName=a\nObjectType=9\nCompactSubObj=9999999\n",
    ],
)
def test_a_damaged_sheet_is_one_clean_error(run: CommandLine, text: str) -> None:
    ran = run("import", "-", "--to", str(run.folder / "motor" / "device.yaml"), "--strict", stdin=text.encode())
    assert (ran.code, ran.out, ran.err.count("\n")) == (2, "", 1)


def test_a_sheet_of_many_objects_takes_no_more_than_its_share_of_time(run: CommandLine) -> None:
    objects = "".join(
        f"[{number:04X}]\nParameterName=Object {number}\nDataType=0x0007\nAccessType=rw\n"
        for number in range(0x2000, 0x2400)
    )
    start = time.process_time()
    import_text(run, "[FileInfo]\n" + objects)
    assert time.process_time() - start < 20
