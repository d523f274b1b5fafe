"""Workbooks that programs import: openpyxl reads the packed values, and XML parsers accept every part."""

from __future__ import annotations

import io
import zipfile
from xml.etree import ElementTree

import openpyxl
import pytest

from fieldspec.foundation.spreadsheet import Cell, Workbook, Worksheet
from fieldspec.tools.lists.workbook_writer import LONGEST, packed

CELLS: list[tuple[Cell, str | int]] = [
    ("plain", "plain"),
    (-12, -12),
    ("-12", "-12"),
    ("", ""),
    (None, ""),
    ("\u200b\u2028", ""),
    ("=HYPERLINK(1)", "=HYPERLINK(1)"),
    ("@SUM(A1)", "@SUM(A1)"),
    ("'=1", "=1"),
    ("</t></si><f>1</f>", "</t></si><f>1</f>"),
    ("&amp; ]]> \"quoted\" 'too'", "&amp; ]]> \"quoted\" 'too'"),
    ("two\nlines\x07 \ud800 and blanks", "two lines and blanks"),
    ("\ufffe位置\uffff 🤖", "位置 🤖"),
    ("x" * (LONGEST + 1), "x" * LONGEST),
]
BOOK = Workbook(
    (
        Worksheet("First", tuple((f"heading {number}", cell) for number, (cell, _) in enumerate(CELLS))),
        Worksheet("Second sheet", (tuple(f"column {number}" for number in range(30)),)),
    ),
    {"FileVersion": "1", "FileContent": "<texts> & more"},
)


@pytest.mark.parametrize(("number", "content"), list(enumerate(content for _, content in CELLS)))
def test_a_cell_shows_its_text_or_its_number_and_is_no_formula(number: int, content: str | int) -> None:
    cell = openpyxl.load_workbook(io.BytesIO(packed(BOOK)))["First"].cell(number + 1, 2)
    assert (cell.value or "", cell.data_type) == (content, "n" if isinstance(content, int) else "s")
    assert bool(cell.quotePrefix) is (isinstance(content, str) and content.startswith(("=", "+", "-", "@")))


def test_all_sheets_and_columns_are_present() -> None:
    workbook = openpyxl.load_workbook(io.BytesIO(packed(BOOK)))
    assert workbook.sheetnames == ["First", "Second sheet"]
    assert workbook["First"].dimensions == f"A1:B{len(CELLS)}"
    assert workbook["Second sheet"].dimensions == "A1:AD1"
    assert workbook["Second sheet"]["AD1"].value == "column 29"


def test_a_workbook_has_its_properties() -> None:
    properties = openpyxl.load_workbook(io.BytesIO(packed(BOOK))).custom_doc_props  # type: ignore[attr-defined]
    assert {name: properties[name].value for name in properties.names} == BOOK.properties


@pytest.mark.parametrize("book", [BOOK, Workbook(BOOK.sheets[1:])])
def test_every_part_is_xml_and_every_named_part_exists(book: Workbook) -> None:
    with zipfile.ZipFile(io.BytesIO(packed(book))) as archive:
        parts = {name: ElementTree.fromstring(archive.read(name)) for name in archive.namelist()}
    declared_parts = {element.get("PartName", "").lstrip("/") for element in parts["[Content_Types].xml"]} - {""}
    assert declared_parts == {name for name in parts if not name.endswith(".rels")} - {"[Content_Types].xml"}
    assert {
        f"xl/{element.get('Target', '').removeprefix('/xl/')}" for element in parts["xl/_rels/workbook.xml.rels"]
    } == {name for name in declared_parts if name.startswith("xl/") and name != "xl/workbook.xml"}
    assert {element.get("Target") for element in parts["_rels/.rels"]} == {
        name for name in declared_parts if name.startswith("docProps/")
    } | {"xl/workbook.xml"}


def test_a_text_is_stored_once_however_often_it_is_used() -> None:
    book = Workbook((Worksheet("Sheet", (("same", "same"), ("same", "other"))),))
    with zipfile.ZipFile(io.BytesIO(packed(book))) as archive:
        texts = archive.read("xl/sharedStrings.xml").decode()
    assert 'count="4" uniqueCount="2"' in texts
    assert texts.count("same") == 1
