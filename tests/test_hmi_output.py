"""Text lists hold every code, are read by independent readers, and carry any label as the text that it is."""

from __future__ import annotations

import csv
import io
import zipfile
from functools import cache

import openpyxl
import pytest

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.names import Name, stem
from fieldspec.foundation.spreadsheet import Workbook
from fieldspec.language.model.enums import Enum
from fieldspec.targets.controllers.enums import KINDS
from fieldspec.targets.hmi.backend import files
from fieldspec.tools.lists.workbook_writer import packed
from layouts import SPECS, TEST_SPECS, layout_at, layouts, newest
from spec_files import gadget

Rows = list[dict[str, str]]

VERSIONS = [
    pytest.param(layout, id=f"{layout.device.id}-{layout.device.version}")
    for root in (SPECS, TEST_SPECS)
    for versions in layouts(root).values()
    for layout in versions
    if any(enum.kind in KINDS for enum in layout.device.enums.values())
]
REAL = [param for param in VERSIONS if param.values[0].device.id in layouts(SPECS)]


@cache
def output_files(device: str) -> dict[str, str | Workbook]:
    root = SPECS if device in layouts(SPECS) else TEST_SPECS
    return files(layouts(root)[device])


def of_version(layout: DeviceLayout, ending: str) -> str | Workbook:
    return output_files(layout.device.id)[f"{stem(layout.device.id, layout.device.version)}_{ending}"]


def cell_rows(text: object) -> Rows:
    assert isinstance(text, str)
    assert text.startswith("\ufeff")
    return list(csv.DictReader(io.StringIO(text[1:], newline=""), strict=True))


def sheets(book: object) -> dict[str, Rows]:
    """The rows of each sheet as another reader sees them, by heading."""
    assert isinstance(book, Workbook)
    workbook = openpyxl.load_workbook(io.BytesIO(packed(book)))
    result = {}
    for sheet in workbook:
        head, *rows = sheet.iter_rows(values_only=True)
        result[sheet.title] = [dict(zip(map(str, head), map(str, row), strict=True)) for row in rows]
    return result


def coded(layout: DeviceLayout) -> list[Enum]:
    return [enum for enum in layout.device.enums.values() if enum.kind in KINDS]


@pytest.mark.parametrize("layout", VERSIONS)
def test_the_plain_table_has_every_code(layout: DeviceLayout) -> None:
    rows = cell_rows(of_version(layout, "codes.csv"))
    result = [(row["kind"], row["list"], int(row["code"]), int(row["hex"], 16), row["name"]) for row in rows]
    assert result == [
        (enum.kind, enum.name, member.value, member.value, member.name)
        for enum in coded(layout)
        for member in enum.members
    ]
    assert {row["identity"] for row in rows} == {layout.identity}
    assert all(row["text"] for row in rows)


@pytest.mark.parametrize("layout", VERSIONS)
def test_every_cause_and_every_remedy_of_the_spec_is_in_the_table(layout: DeviceLayout) -> None:
    rows = {(row["list"], int(row["code"])): row for row in cell_rows(of_version(layout, "codes.csv"))}
    for enum in coded(layout):
        for member in enum.members:
            row = rows[enum.name, member.value]
            for cause in member.causes:
                assert cause.cause.removesuffix(".") in row["cause"]
                assert all(remedy.removesuffix(".") in row["remedy"] for remedy in cause.remedies)
            assert all(remedy.removesuffix(".") in row["remedy"] for remedy in member.remedies)


@pytest.mark.parametrize("layout", VERSIONS)
def test_the_workbook_of_a_panel_has_the_sheets_and_columns_that_its_import_takes(layout: DeviceLayout) -> None:
    actual = sheets(of_version(layout, "tia_panel_en_us.xlsx"))
    assert list(actual) == ["TextList", "TextListEntry"]
    assert list(actual["TextList"][0]) == ["Name", "ListRange", "Comment [en-US]"]
    columns = ["Name", "Parent", "DefaultEntry", "Value", "Text [en-US]", "FieldInfos"]
    assert list(actual["TextListEntry"][0]) == columns
    assert {row["ListRange"] for row in actual["TextList"]} == {"Decimal"}
    assert {row["Parent"] for row in actual["TextListEntry"]} == {row["Name"] for row in actual["TextList"]}
    names = [(row["Parent"], row["Name"]) for row in actual["TextListEntry"]]
    assert len(names) == len(set(names))


@pytest.mark.parametrize("kind", ["panel", "alarms"])
@pytest.mark.parametrize("layout", VERSIONS)
def test_every_code_has_one_text_in_its_text_list(layout: DeviceLayout, kind: str) -> None:
    entries = sheets(of_version(layout, f"tia_{kind}_en_us.xlsx"))["TextListEntry"]
    texts = {(row["list"], row["code"]): row["text"] for row in cell_rows(of_version(layout, "codes.csv"))}
    for enum in coded(layout):
        name = (Name.of(layout.device.id) + Name.of(enum.name)).snake()
        column = "Value" if kind == "panel" else "From"
        result = [(row[column], row["Text [en-US]"]) for row in entries if row["Parent"] == name]
        assert result == [(str(member.value), texts[enum.name, str(member.value)]) for member in enum.members]


@pytest.mark.parametrize("layout", REAL)
def test_labels_of_the_manual_stand_under_the_culture_of_its_language(layout: DeviceLayout) -> None:
    culture = {"zh-Hans": "zh-CN", "zh-Hant": "zh-TW"}[layout.device.manual.language]
    words = culture.replace("-", "_").lower()
    entries = sheets(of_version(layout, f"tia_panel_en_us_{words}.xlsx"))["TextListEntry"]
    texts = {(row["Parent"], row["Value"]): row[f"Text [{culture}]"] for row in entries}
    for enum in coded(layout):
        name = (Name.of(layout.device.id) + Name.of(enum.name)).snake()
        for member in enum.members:
            assert texts[name, str(member.value)] != ""
            if member.label:
                assert texts[name, str(member.value)] == " ".join(member.label.split())


@pytest.mark.parametrize("layout", VERSIONS)
def test_workbooks_are_the_same_bytes_on_every_run(layout: DeviceLayout) -> None:
    book = of_version(layout, "tia_alarms_en_us.xlsx")
    again = files([layout])[f"{stem(layout.device.id, layout.device.version)}_tia_alarms_en_us.xlsx"]
    assert isinstance(book, Workbook)
    assert isinstance(again, Workbook)
    assert packed(book) == packed(again)


def parts(book: object) -> dict[str, str]:
    assert isinstance(book, Workbook)
    with zipfile.ZipFile(io.BytesIO(packed(book))) as zip_file:
        return {name: zip_file.read(name).decode() for name in zip_file.namelist()}


def test_texts_of_a_workbook_lie_in_a_table_and_no_cell_is_missing() -> None:
    book = of_version(newest(SPECS, "tc100"), "tia_panel_en_us.xlsx")
    value = parts(book)
    assert isinstance(book, Workbook)
    sheet = value["xl/worksheets/sheet2.xml"]
    assert "inlineStr" not in sheet
    assert sheet.count("<c ") == sheet.count("<v>") == sum(len(row) for row in book.sheets[1].rows)
    assert "sharedStrings" in value["[Content_Types].xml"]
    assert "sharedStrings" in value["xl/_rels/workbook.xml.rels"]


def test_the_workbook_of_alarms_says_what_it_holds() -> None:
    workbook = openpyxl.load_workbook(io.BytesIO(packed_of("tia_alarms_en_us.xlsx")))
    assert {name: workbook.custom_doc_props[name].value for name in workbook.custom_doc_props.names} == {
        "FileVersion": "1",
        "FileContent": "Alarm text lists",
    }


def packed_of(ending: str) -> bytes:
    book = of_version(newest(SPECS, "esc11"), ending)
    assert isinstance(book, Workbook)
    return packed(book)


HOSTILE = """
enums:
  - name: alarm_code
    kind: alarm
    source: 1 L1
    open: true
    members:
      - {value: 1, name: one, label: '=HYPERLINK("http://x","y")', problem: "=1+1", source: L1}
      - {value: 2, name: two, label: "+1", source: L2,
         causes: [{cause: "-2 \\"quoted\\", and\\na line", remedies: ["@SUM(A1)", "{{ x }}"]}]}
      - {value: 3, name: three, label: "</t><t>&amp; 🤖", problem: "<field ref=\\"0\\" /> \\u0007 bell", source: L3}
"""


def test_a_text_that_is_a_formula_to_a_spreadsheet_is_a_text() -> None:
    outputs = files([layout_at(gadget(HOSTILE), "1")])
    rows = cell_rows(outputs["gadget_v1_codes.csv"])
    assert [row["label"] for row in rows] == ['\'=HYPERLINK("http://x","y")', "+1", "</t><t>&amp; 🤖"]
    assert [row["text"] for row in rows] == ["One: =1+1", "Two", 'Three: <field ref="0" /> bell']
    assert (rows[1]["cause"], rows[1]["remedy"]) == ('\'-2 "quoted", and a line', "'@SUM(A1) {{ x }}")


def test_a_workbook_holds_hostile_texts_as_texts_and_no_field() -> None:
    outputs = files([layout_at(gadget(HOSTILE), "1")])
    book = outputs["gadget_v1_tia_panel_en_us.xlsx"]
    entries = sheets(book)["TextListEntry"]
    texts = {(row["Parent"], row["Value"]): row["Text [en-US]"] for row in entries}
    assert texts["gadget_alarm_code", "3"] == 'Three: < field ref="0" /> bell'
    assert texts["gadget_alarm_code_cause", "2"] == '-2 "quoted", and a line'
    assert texts["gadget_alarm_code_remedy", "2"] == "@SUM(A1) {{ x }}"
    assert "<f>" not in parts(book)["xl/worksheets/sheet2.xml"]


def test_a_device_without_codes_has_no_files() -> None:
    assert files([layout_at(gadget(""), "1")]) == {}


def test_a_cause_keeps_the_number_of_its_remedy() -> None:
    rows = cell_rows(of_version(newest(SPECS, "esc11"), "codes.csv"))
    (row,) = (row for row in rows if row["name"] == "point_data_destroyed")
    assert row["cause"].startswith("1. The feedback circuit is faulty; 2. ")
    assert row["remedy"].startswith("3. Check the surroundings for sources of noise; Switch the power on")


@pytest.mark.parametrize("device", layouts(SPECS))
def test_versions_that_share_workbooks_have_those_that_each_has_alone(device: str) -> None:
    alone = {path: value for layout in layouts(SPECS)[device] for path, value in files([layout]).items()}
    assert output_files(device) == alone
