"""A file that is not a list is refused with one line that says what to do and exit code 2; nothing is written."""

from __future__ import annotations

import io
import warnings
import zipfile
from collections.abc import Callable
from contextlib import nullcontext, suppress
from pathlib import Path

import openpyxl
import pytest
from hypothesis import given
from hypothesis import strategies as st
from openpyxl.styles import Font
from openpyxl.utils import get_column_letter

from command_line import SPECS, CommandLine
from example_counts import examples
from fieldspec.tools.lists import json_text, text_sheet, workbook_size
from fieldspec.tools.lists import sheet as limits
from fieldspec.tools.lists.list_file import content_sheet
from fieldspec.tools.lists.listing import listing
from fieldspec.tools.lists.sheet import ListError

LIST = "地址,名称\n0x2000,位置\n"


def book(change: Callable[[openpyxl.Workbook], object]) -> bytes:
    """A workbook with a small list, and a change."""
    workbook = openpyxl.Workbook()
    for row in (["Address", "Name", "Note"], ["0x2000", "a", 1], ["0x2001", "b", 2], ["0x2002", "c", 3]):
        workbook.worksheets[0].append(row)
    change(workbook)
    buffer = io.BytesIO()
    workbook.save(buffer)
    return buffer.getvalue()


def cell(place: str, value: object) -> Callable[[openpyxl.Workbook], object]:
    return lambda workbook: workbook.worksheets[0].__setitem__(place, value)


def merged(area: str) -> Callable[[openpyxl.Workbook], object]:
    return lambda workbook: workbook.worksheets[0].merge_cells(area)


def packed(**parts: str) -> bytes:
    """A zip file with parts; `__` stands for a slash, `_` for a point."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as file:
        for name, text in parts.items():
            file.writestr(name.replace("__", "/").replace("_", "."), text)
    return buffer.getvalue()


BAD: dict[str, tuple[bytes, str]] = {
    "empty": (b"", "is empty"),
    "blank": (b"\n ,,\n\t\n", "is empty"),
    "commas": (b",,,\n,,,\n", "is empty"),
    "a heading alone": (b"Address,Name\n", "has a heading and no rows"),
    "no addresses": (b"Name,Value\nspeed,5\n", "has no column that looks like addresses (Name, Value); name it with"),
    "prose": (b"Dear Sir,\nplease find the list below.\n", "has no column that looks like addresses"),
    "binary": (b"\x7fELF\0\0\1\0", "is binary: use a CSV or XLSX file"),
    "random bytes": (bytes(range(128, 256)), "is not UTF-8; state its encoding, such as --encoding gbk"),
    "GBK": (LIST.encode("gbk"), "is not UTF-8; state its encoding"),
    "Big5": ("位址,名稱\n0x2000,a\n".encode("big5"), "is not UTF-8; state its encoding"),
    "UTF-16 without a mark": (LIST.encode("utf-16-le"), "utf-16-le"),
    "ASCII in UTF-16": ("Address,Name\n0x10,a\n".encode("utf-16-le"), "is binary: use a CSV or XLSX file, or add"),
    "old Excel": (b"\xd0\xcf\x11\xe0" + b"\0" * 600, "is an old workbook of Excel; save it as .xlsx"),
    "PDF": (b"%PDF-1.7\n", "is a PDF; save its table as CSV"),
    "thousands": (b'Address,Name\n"8,192",a\n', "`8,192` in row 2, which is written with thousands separators"),
    "points between thousands": (
        b"Address;Name\n1.000;a\n",
        "`1.000` in row 2, which is written with thousands separators",
    ),
    "apostrophes": (b"Address,Name\n8'192,a\n", "with thousands separators"),
    "columns parted by blanks": (b"Address Name\n0x10 a\n", "use tabs, commas or bars instead"),
    "words": (
        b"Address,Name\nfour,a\n",
        "has no address under Address: `four` in row 2, which is not an address; name the column",
    ),
    "fractions": (b"Address,Name\n1.6.5,a\n", "has no address under Address: `1.6.5` in row 2"),
    "huge numbers": (b"Address,Name\n99999999999999,a\n", "has no address under Address"),
    "above 32 bits": (b"Address,Name\n9999999999,a\n", ": is too great"),
    "an open quote": (b'Address,Name\n0x10,"a\n' + b"x" * 200000, "cannot be read as a table at row 2"),
    "JSON that is none": (b'[{"address": 1]', "begins like JSON but is not JSON"),
    "JSON of numbers": (b"[1, 2]", "is JSON but not a list of objects"),
    "JSON too deep": (b"[" * 100000, "is JSON that is nested more than 16 levels deep"),
    "an empty workbook": (book(lambda workbook: workbook.worksheets[0].delete_rows(1, 9)), "is empty"),
    "a workbook cut off": (book(cell("A1", "Address"))[:2000], "is a truncated or protected workbook"),
    "OpenDocument": (packed(content_xml="x"), "is an OpenDocument file; save its table as CSV or XLSX"),
    "C": (b"#define SPEED 0x10 // R/W\n#define TORQUE 0x11\n", "is source code in C, which is not read as a list"),
    "an enum in C": (b"enum Register {\n    Speed = 5328,\n    Level = 1066,\n};\n", "is source code in C"),
    "Python": (b"import x\nregisters = [\n  {'name': 'a', 'address': 4000},\n]\n", "is source code in Python"),
    "JavaScript": (b"module.exports = [\n  {address: 3028, name: 'V'},\n];\n", "is source code in JavaScript"),
    "openHAB": (b'Bridge modbus:tcp:x [ host="h" ] {\n  Thing data a [ readStart="0" ]\n}\n', "things of openHAB"),
    "eBUS": (b"# type (r[1-9];w;u),circuit,name,[ID]\nr,,Temp,0F00\n", "is a configuration of messages of an eBUS"),
    "YAML of a template": (b"block/DAC:\n  description: a\n  items: []\n", "is YAML of no program that is known"),
    "a comment for a heading": (
        b'"type","topic","col2"\n# reference, size, register\n# a, b, 5\npoll,a,1\n',
        "has no column that looks like addresses (type, topic, col2)",
    ),
    "JSON with a fault in line 3": (b'[{"address": 1},\n\n {"address" 2}]', "but is not JSON: line 3, Expecting ':'"),
    "a layout by its name": (b'{"T065020": {"volts": {"value": 160, "length": 4}}}', "has no column that looks like"),
    "a zip file": (packed(readme_txt="x"), "is an archive and not a workbook"),
    "entities": (packed(xl__workbook_xml="<!DOCTYPE x [<!ENTITY a 'b'>]><x>&a;</x>"), "declares entities"),
    "a workbook of nothing": (packed(xl__workbook_xml="<x/>"), "is not a readable workbook"),
}


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> CommandLine:
    return CommandLine(capsys, monkeypatch, SPECS)


@pytest.mark.parametrize(("content", "text"), BAD.values(), ids=BAD)
@pytest.mark.parametrize("verb", ["compare", "import"])
def test_a_bad_file_is_refused_in_one_line(
    verb: str, content: bytes, text: str, run: CommandLine, tmp_path: Path
) -> None:
    path = tmp_path / "list.dat"
    path.write_bytes(content)
    words = ("compare", "tc100", str(path)) if verb == "compare" else ("import", str(path), "--to", "new/device.yaml")
    words = tuple(str(tmp_path / word) if word.startswith("new/") else word for word in words)
    ran = run(*words)
    assert (ran.code, ran.out) == (2, "")
    assert ran.err.startswith(f"fieldspec: {path} ")
    assert text in ran.err
    assert ran.err.count("\n") == 1
    assert [path.name for path in tmp_path.iterdir()] == ["list.dat"]


@pytest.mark.parametrize(
    ("options", "text"),
    [
        (("--encoding", "klingon"), "there is no encoding klingon"),
        (("--encoding", "base64"), "there is no encoding base64"),
        (("--encoding", "ascii"), "is not in the encoding ascii"),
        (("--address", "Wo"), "has no column Wo; choose from 地址, 名称, or give a letter or a number"),
        (("--address", "Z"), "has no column Z"),
        (("--name", "Wo"), "has no column Wo"),
        (("--sheet", "1"), "is not a workbook, so --sheet has no effect"),
    ],
)
def test_an_option_that_does_not_fit_the_file_is_refused(options: tuple[str, ...], text: str, run: CommandLine) -> None:
    ran = run("compare", "tc100", "-", *options, stdin=LIST.encode())
    assert (ran.code, ran.out) == (2, "")
    assert text in ran.err


@pytest.mark.parametrize("encoding", ["gbk", "big5hkscs", "utf-16", "utf-16-le", "utf-32", "utf-8-sig", "gb18030"])
def test_an_encoding_that_is_named_is_read(encoding: str, run: CommandLine) -> None:
    text = "地址,名\n0x2000,相對移動量\n" if encoding != "gbk" else LIST
    assert run("compare", "tc100", "-", "--encoding", encoding, stdin=text.encode(encoding)).code == 1


@pytest.mark.parametrize("encoding", ["utf-16", "utf-32", "utf-8-sig"])
def test_a_byte_order_mark_is_enough(encoding: str, run: CommandLine) -> None:
    assert run("compare", "tc100", "-", stdin=LIST.encode(encoding)).code == 1


@pytest.mark.parametrize("name", ["nothing.csv", "."])
def test_a_file_that_is_not_there_is_wrong_use(name: str, run: CommandLine, tmp_path: Path) -> None:
    ran = run("compare", "tc100", str(tmp_path / name))
    assert ran.code == 2
    assert ran.err.startswith("fieldspec: cannot read ")


def test_a_huge_file_is_refused_before_it_is_read_whole(run: CommandLine, tmp_path: Path) -> None:
    path = tmp_path / "huge.csv"
    with path.open("wb") as file:
        file.truncate(limits.MOST_BYTES + 1)
    assert run("compare", "tc100", str(path)).err.endswith("has more than 32 MiB; a list of registers is smaller\n")


def test_too_many_rows_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(text_sheet, "MOST_ROWS", 2)
    monkeypatch.setattr(workbook_size, "MOST_ROWS", 2)
    for content in (b"Address\n1\n2\n3\n", book(lambda _workbook: None)):
        with pytest.raises(ListError, match="has more than 2 rows"):
            content_sheet(content)


WHOLE = book(lambda _workbook: None)
DAMAGE = st.lists(st.tuples(st.integers(4, len(WHOLE) - 1), st.integers(0, 255)), min_size=1, max_size=4)
PARTS = sorted(zipfile.ZipFile(io.BytesIO(WHOLE)).namelist())


def read_or_refused(content: bytes) -> None:
    with warnings.catch_warnings(), suppress(ListError):
        warnings.simplefilter("error")  # they would be printed with the place of a library
        content_sheet(content)


@examples(400)
@given(DAMAGE)
def test_a_workbook_with_damaged_bytes_is_read_or_refused(damage: list[tuple[int, int]]) -> None:
    content = bytearray(WHOLE)
    for offset, byte in damage:
        content[offset] = byte
    read_or_refused(bytes(content))


@examples(400)
@given(st.sampled_from(PARTS), DAMAGE)
def test_a_workbook_whose_parts_are_damaged_and_whose_checksums_are_right_is_read_or_refused(
    name: str, damage: list[tuple[int, int]]
) -> None:
    buffer = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(WHOLE)) as whole, zipfile.ZipFile(buffer, "w") as file:
        for part in PARTS:
            content = bytearray(whole.read(part))
            for offset, byte in damage if part == name else ():
                content[offset % len(content)] = byte
            file.writestr(part, bytes(content))
    read_or_refused(buffer.getvalue())


@pytest.mark.parametrize(
    "call", [("compare", "tc100", "{}"), ("import", "{}", "--to", "-"), ("audit", "tc100", "--dump", "{}")]
)
def test_every_verb_refuses_a_damaged_workbook_in_a_line(
    call: tuple[str, ...], run: CommandLine, tmp_path: Path
) -> None:
    path = tmp_path / "list.xlsx"
    content = bytearray(WHOLE)
    with zipfile.ZipFile(io.BytesIO(WHOLE)) as packed_book:
        first = packed_book.getinfo("xl/workbook.xml").header_offset
    content[first + 50 : first + 60] = b"\xff" * 10
    path.write_bytes(content)
    result = run(*(word.format(path) for word in call))
    assert (result.code, result.out, result.err) == (
        2,
        "",
        f"fieldspec: {path} is a damaged workbook; save it again as .xlsx, or as CSV\n",
    )


def test_a_workbook_that_unpacks_to_too_much_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(workbook_size, "_MOST_UNPACKED", 1000)
    with pytest.raises(ListError, match="unpacks to more"):
        content_sheet(book(lambda _workbook: None))


@pytest.mark.parametrize(("most", "is_taken"), [(5, True), (4, False)])
def test_lists_objects_and_what_they_have_are_values_of_json(
    monkeypatch: pytest.MonkeyPatch, most: int, is_taken: bool
) -> None:
    monkeypatch.setattr(json_text, "MOST_VALUES", most)
    with nullcontext() if is_taken else pytest.raises(ListError, match="more than 4 values"):
        json_text.json_data('[1, {"a, b": 2, "c": 3}, "[{,"]')


def test_columns_have_the_letters_that_spreadsheets_give_them() -> None:
    columns = range(1, limits.MOST_COLUMNS + 1)
    assert [limits.letters(column) for column in columns] == [*map(get_column_letter, columns)]


def test_formulas_and_merged_cells_that_are_not_used_do_no_harm(run: CommandLine, tmp_path: Path) -> None:
    def change(workbook: openpyxl.Workbook) -> None:
        workbook.worksheets[0]["D1"] = "Sum"
        workbook.worksheets[0]["D2"] = "=1+1"
        workbook.worksheets[0].merge_cells("D3:D4")

    path = tmp_path / "list.xlsx"
    path.write_bytes(book(change))
    assert run("compare", "tc100", str(path)).code == 1


@pytest.mark.parametrize(
    ("change", "text"),
    [
        (cell("A3", "=A2+1"), "3    A3    is a formula whose value the file does not have"),
        (cell("A2", 2e10), "2    20000000000  is not an address"),
        (cell("A2", "2024-01-01"), "2    2024-01-01  is not an address"),
    ],
)
def test_a_row_that_cannot_be_read_is_a_difference_and_hides_no_other(
    change: Callable[[openpyxl.Workbook], object], text: str, run: CommandLine, tmp_path: Path
) -> None:
    path = tmp_path / "list.xlsx"
    path.write_bytes(book(change))
    ran = run("compare", "tc100", str(path), "--format", "csv")
    assert ran.code == 1
    row, address, reason = text.split(maxsplit=2)
    assert f"not compared,,{row},{address},{reason},," in ran.out.splitlines()


def test_a_text_that_is_merged_over_rows_counts_for_each_of_them(run: CommandLine, tmp_path: Path) -> None:
    path = tmp_path / "list.xlsx"
    path.write_bytes(book(merged("B2:B3")))
    ran = run("import", str(path), "--to", "-")
    assert ran.code == 0
    assert "at: 0x2000, name: a," in ran.out
    assert "at: 0x2001, name: a_2001," in ran.out


def test_a_number_that_a_workbook_shows_with_an_exponent_is_no_address(run: CommandLine, tmp_path: Path) -> None:
    def typed_as_digits(workbook: openpyxl.Workbook) -> None:
        cell("A3", 1200)(workbook)
        workbook.worksheets[0]["A3"].number_format = "0.00E+00"

    path = tmp_path / "list.xlsx"
    path.write_bytes(book(typed_as_digits))
    ran = run("import", str(path), "--to", "-")
    assert ran.code == 0
    assert "not used: row 3, Address `1.2E+3`: has an exponent" in ran.err


def test_rows_that_are_struck_out_and_hidden_sheets_are_not_taken(run: CommandLine, tmp_path: Path) -> None:
    def struck(workbook: openpyxl.Workbook) -> None:
        for struck_cell in workbook.worksheets[0][3]:
            struck_cell.font = Font(strike=True)
        hidden = workbook.create_sheet("Old")
        for row in (["Address", "Name", "Note"], ["0x3000", "old", 1], ["0x3001", "older", 1]):
            hidden.append(row)
        hidden.sheet_state = "hidden"

    path = tmp_path / "list.xlsx"
    path.write_bytes(book(struck))
    ran = run("import", str(path), "--to", "-")
    assert ran.code == 0
    assert "not used: row 3: is struck out" in ran.err
    assert ": Old; --sheet names one" in ran.err
    assert [at for at in ("0x2000", "0x2001", "0x2002", "0x3000") if f"at: {at}, name" in ran.out] == [
        "0x2000",
        "0x2002",
    ]


LIKELY = st.text(alphabet="Adres,;|\t\n\"'0x12hH=-~[]{}:地址", max_size=80).map(str.encode)


@given(content=st.binary(max_size=200) | LIKELY)
@examples(300)
def test_any_bytes_are_a_list_or_are_refused(content: bytes) -> None:
    try:
        register_list = listing(content_sheet(content), {})
    except ListError:
        return
    assert all(row.address >= 0 for base in register_list.bases for row in register_list.rows(base))
