"""A device is compared with someone else's list: every form of address, what differs, and what only one of them has."""

from __future__ import annotations

import csv
import io
from pathlib import Path
from typing import Any

import openpyxl
import pytest
from hypothesis import given
from hypothesis import strategies as st

from command_line import SPECS, TEST_SPECS, CommandLine
from example_counts import examples
from fieldspec.tools.lists.comparison import compared
from fieldspec.tools.lists.item import items
from fieldspec.tools.lists.listing import listing
from fieldspec.tools.lists.text_sheet import text_sheet
from layouts import newest
from spec_files import DEVICE

SPEC = """
registers:
  - group: motion
    section: "1"
    rows:
      - {at: 0x0010, name: speed, type: u16, checked: {words: 1}, access: rw, unit: "%", range: 1..100,
         default: 50, source: L1}
      - {at: 0x0011, name: position, printed_name: POS, label: 位置, type: i32, checked: {words: 2}, access: ro,
         scale: 0.01, unit: mm, range: -1000..1000, source: L2}
  - group: status
    section: "1"
    rows:
      - {at: 0x001A, name: state, type: u16, checked: {words: 1}, access: ro, source: L3}
tables:
  - {name: points, base: 0x0100, stride: 8, count: 4, record: point, source: 1 L4}
records:
  - name: point
    source: 1 L5
    fields: [{name: target, type: i32, source: 1 L5}, {name: mode, type: u16, source: 1 L6}]
"""
HEAD = "Address,Name,Words,Type,Access\n"
ROWS = ["0x0010,Speed,1,UINT16,R/W", "0x0011,POS,2,DINT,RO", "0x001A,State,1,WORD,R"]
POINTS = ["0x0100,Target,2,INT,", "0x0102,Mode,1,UINT,"]


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """The specs of a made-up device."""
    path = tmp_path / "specs" / "gadget" / "device.yaml"
    path.parent.mkdir(parents=True)
    path.write_text(DEVICE + SPEC, "utf-8")
    return tmp_path / "specs"


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, folder: Path) -> CommandLine:
    return CommandLine(capsys, monkeypatch, folder)


def against(run: CommandLine, text: str | bytes, *options: str) -> Any:
    """The result for a list."""
    return run.json("compare", "gadget", "-", *options, stdin=text.encode() if isinstance(text, str) else text)


def summary(result: Any) -> tuple[list[str], list[tuple[str, str]], list[int], list[str]]:
    """Names that agree, what differs, the addresses that only the list has, and the names that only the device has."""
    return (
        [entry["name"] for entry in result["agree"]],
        [(entry["name"], what["what"]) for entry in result["differ"] for what in entry["differences"]],
        [entry["address"] for entry in result["only_in_list"]],
        [f"{entry['name']} {entry['elements']}".strip() for entry in result["only_in_device"]],
    )


LISTS = {
    "with a mark before": HEAD + "\n".join(ROWS),
    "with a mark after": HEAD + "\n".join(row.replace("0x", "", 1).replace(",", "h,", 1) for row in ROWS),
    "with letters": HEAD + "\n".join(row.removeprefix("0x") for row in ROWS),
    "with a heading that says it": "Addr (Hex)\tName\n10\tspeed\n11\tposition\n",
    "in decimal": "Address,Name\n16,speed\n17,position\n26,state\n",
    "with references": "Address,Name\n40017,speed\n40018,position\n40027,state\n",
    "with six-digit references": "Address,Name\n400017,speed\n300018,position\n400027,state\n",
    "with tables": "Address,Name\n4x0017,speed\n3x0018,position\n",
    "with both ends": "Address;Name\n0x0010;speed\n0x0011-0x0012;position\n",
    "in Chinese": "寄存器地址,名称,数据类型,读写\n0x0010,speed,无符号,读写\n0x0011,位置,有符号,只读\n",
    "in Chinese of Taiwan": "位址,名稱,資料型態,屬性\n0010H,speed,無符號,讀寫\n0011H,位置,DINT,唯讀\n",
    "in full width": "地址,名称\n\uff10\uff58\uff10\uff10\uff11\uff10,speed\n\uff10\uff10\uff11\uff11\uff28,位置\n",
    "below a title": "My list,,\n,,\nAddress,Name,Remark\nMotion,,\n0x0010,speed,a\n0x0011,POS,b\n",
    "with bars": "| Address | Name |\n|---|---|\n| 0x0010 | speed |\n| 0x0011 | POS |\n",
    "as JSON": '[{"address": 16, "name": "speed"}, {"address": 17, "name": "position"}]',
    "with a byte order mark": "\ufeffAddress,Name\n0x0010,speed\n",
    "with DOS line ends": "Address,Name\r\n0x0010,speed\r\n0x0011,POS\r\n",
    "with ranges in the unit": "Address,Name,Range,Unit\n0x0010,speed,1~100,%\n0x0011,POS,-10.00 to 10.00,MM\n",
    "with min and max": "Address,Name,Min,Max,Default\n0x0010,speed,1,100,50\n0x0011,POS,-1000,1000,\n",
}


@pytest.mark.parametrize("text", LISTS.values(), ids=LISTS)
def test_a_list_is_understood(text: str, run: CommandLine) -> None:
    result = against(run, text)
    agree, differ, extra, missing = summary(result)
    assert result["offset"] == 0
    assert agree[0] == "speed"
    assert (differ, extra) == ([], [])
    assert sorted([*agree, *missing]) == ["points.mode 0..3", "points.target 0..3", "position", "speed", "state"]


@pytest.mark.parametrize(
    ("row", "what"),
    [
        ("0x0010,Velocity,1,UINT16,R/W", [("speed", "name")]),
        ("0x0010,Speed,2,UINT16,R/W", [("speed", "words")]),
        ("0x0010,Speed,1,INT,R/W", [("speed", "type")]),
        ("0x0010,Speed,1,FLOAT,RO", [("speed", "type"), ("speed", "access")]),
        ("0x0010,Speed,1,nonsense,RW", [("speed", "type")]),
        ("0x0010,,,,", []),
    ],
)
def test_differences_are_reported(row: str, what: list[tuple[str, str]], run: CommandLine) -> None:
    assert summary(against(run, HEAD + row))[1] == what


@pytest.mark.parametrize(
    ("heads", "cells", "what"),
    [
        ("Unit", "rpm", ["unit"]),
        ("Scale", "0.1", ["scale"]),
        ("Min,Max", "0,100", ["min"]),
        ("Range", "1-99", ["max"]),
        ("Default", "0x33", ["default"]),
        ("Count", "2", ["count"]),
    ],
)
def test_numbers_that_differ_are_reported(heads: str, cells: str, what: list[str], run: CommandLine) -> None:
    assert [text for _, text in summary(against(run, f"Address,{heads}\n0x10,{cells}\n"))[1]] == what


@pytest.mark.parametrize(
    ("head", "cell", "what"),
    [("Const", "7", []), ("Const", "8", ["const"]), ("Default", "7", []), ("Default", "8", ["default"])],
)
def test_a_constant_is_neither_another_constant_nor_has_it_another_default(
    head: str, cell: str, what: list[str], run: CommandLine
) -> None:
    unlock = "{at: 0x1B, name: unlock, type: u16, checked: {words: 1}, access: wo, const: 7, source: L1}"
    spec = f"registers:\n  - {{group: keys, section: '1', rows: [{unlock}]}}\n"
    (run.folder / "gadget" / "device.yaml").write_text(DEVICE + spec, "utf-8")
    assert [text for _, text in summary(against(run, f"Address,{head}\n0x1B,{cell}\n"))[1]] == what


def test_what_is_ignored_is_no_difference(run: CommandLine) -> None:
    text = HEAD + "0x0010,Velocity,2,UINT16,R/W"
    assert summary(against(run, text, "--ignore", "name,words"))[1] == []


def test_an_address_that_only_the_list_has_is_reported_with_what_the_device_has_there(run: CommandLine) -> None:
    result = against(run, HEAD + "\n".join([*ROWS, "0x0012,Pos high,1,,", "0x0999,Ghost,1,,", "0x0010,Speed,1,,"]))
    assert [(entry["address"], entry["remark"]) for entry in result["only_in_list"]] == [
        (0x12, "inside position"),
        (0x999, ""),
        (0x10, "listed before in row 2"),
    ]


def test_elements_of_a_table_that_the_list_omits_are_reported_together(run: CommandLine) -> None:
    rows = [*ROWS, *POINTS, "0x0110,Target,2,INT,"]
    missing = summary(against(run, HEAD + "\n".join(rows)))[3]
    assert missing == ["points.target 1", "points.target 3", "points.mode 1..3"]


def test_a_count_and_a_stride_stand_for_all_elements(run: CommandLine) -> None:
    text = "Address,Name,Count,Stride\n0x10,speed,,\n0x11,POS,,\n0x1A,state,,\n0x100,target,4,8\n0x102,mode,4,8\n"
    assert against(run, text)["same"]


@pytest.mark.parametrize("offset", [1, -1])
def test_an_offset_of_one_for_the_whole_list_is_one_difference(offset: int, run: CommandLine) -> None:
    heads, rows = "Address,Name,Count,Stride\n", [(0x10, "speed,,"), (0x11, "POS,,"), (0x1A, "state,,")]
    rows += [(0x100, "target,4,8"), (0x102, "mode,4,8")]
    text = heads + "\n".join(f"{address + offset},{rest}" for address, rest in rows)
    result = against(run, text)
    assert (result["offset"], result["offset_is_a_difference"], result["same"]) == (offset, True, False)
    assert summary(result)[1:] == ([], [], [])
    assert against(run, text, "--offset", str(offset))["same"]


def test_an_offset_is_recognised_by_addresses_alone(run: CommandLine) -> None:
    assert against(run, "Address\n17\n18\n27\n")["offset"] == 1


def test_one_row_that_is_off_by_one_is_no_offset_of_the_list(run: CommandLine) -> None:
    result = against(run, HEAD + "\n".join([*ROWS[:2], "0x001B,State,1,WORD,R", *POINTS]))
    assert result["offset"] == 0
    assert [entry["address"] for entry in result["only_in_list"]] == [0x1B]


@pytest.mark.parametrize(
    "options",
    [
        ("--address", "Where", "--name", "What"),
        ("--address", "B", "--name", "1"),
        ("--address", "2", "--name", "what", "--base", "hex"),
    ],
)
def test_columns_can_be_named(options: tuple[str, ...], run: CommandLine) -> None:
    assert summary(against(run, "What,Where\nspeed,0x10\nPOS,0x11\n", *options))[0] == ["speed", "position"]


def test_a_list_without_a_heading_is_read_by_letters(run: CommandLine) -> None:
    assert summary(against(run, "0x10,speed\n0x11,POS\n", "--address", "A", "--name", "B"))[0] == ["speed", "position"]


def test_digits_are_read_as_the_option_says(run: CommandLine) -> None:
    assert summary(against(run, "Address,Name\n10,speed\n", "--base", "hex"))[0] == ["speed"]
    assert summary(against(run, "Address,Name\n10,speed\n", "--base", "decimal"))[2] == [10]


def test_the_exit_code_tells_whether_anything_differs(run: CommandLine) -> None:
    rest = ["0x0100,Target,2,INT,,4,8", "0x0102,Mode,1,UINT,,4,8"]
    rows = [*(f"{row},," for row in ROWS), *rest]
    text = "Address,Name,Words,Type,Access,Count,Stride\n" + "\n".join(rows)
    assert run("compare", "gadget", "-", stdin=text.encode()).code == 0
    assert run("compare", "gadget", "-", stdin=text.replace("Speed", "Sped").encode()).code == 1


def test_the_text_says_which_columns_are_used_and_what_differs(run: CommandLine) -> None:
    text = "Adr.,Signal,R/W\n10h,Velocity,RO\nAxis,,\n1Ah,State,RO\n"
    ran = run("compare", "gadget", "-", stdin=text.encode())
    assert ran.out == (
        "addresses: Adr., hexadecimal\n"
        "columns: name from Signal, access from R/W\n"
        "rows without an address: 3\n"
        "\n"
        "differs:\n"
        "address  row  name   what    ours   theirs\n"
        "0x0010   2    speed  name    speed  Velocity\n"
        "0x0010   2    speed  access  rw     RO\n"
        "\n"
        "only in the device:\n"
        "address  name\n"
        "0x0011   position\n"
        "0x0100   points.target of 0..3\n"
        "0x0102   points.mode of 0..3\n"
        "\n"
        "1 agree, 1 differ, 0 only in the list, 3 only in the device\n"
    )


def test_at_most_ten_rows_without_an_address_are_named(run: CommandLine) -> None:
    text = "Address,Name\n0x10,speed\n" + "Axis,\n" * 12
    out = run("compare", "gadget", "-", stdin=text.encode()).out
    assert "rows without an address: 3, 4, 5, 6, 7, 8, 9, 10, 11, 12 and 2 more\n" in out


def test_csv_has_a_row_for_each_result_and_no_formula(run: CommandLine) -> None:
    text = "Address,Name\n0x10,=1+2\n0x999,@x\n"
    ran = run("compare", "gadget", "-", "--format", "csv", stdin=text.encode())
    rows = list(csv.reader(io.StringIO(ran.out)))
    assert rows[:3] == [
        ["result", "address", "row", "name", "what", "ours", "theirs"],
        ["differs", "0x0010", "2", "speed", "name", "speed", "'=1+2"],
        ["only in the list", "0x0999", "3", "'@x", "", "", ""],
    ]


def test_a_workbook_with_a_title_that_is_merged_is_read(run: CommandLine, tmp_path: Path) -> None:
    book = openpyxl.Workbook()
    sheet = book.worksheets[0]
    for row in (["The list"], ["Address", "Name", "Note"], [16, "speed", "a"], ["0x11", "POS"], [], [26.0, "state"]):
        sheet.append(row)
    sheet.merge_cells("A1:C1")
    sheet.merge_cells("C3:C4")
    path = tmp_path / "list.xlsx"
    book.save(path)
    result = run.json("compare", "gadget", str(path))
    assert [(entry["name"], entry["row"]) for entry in result["agree"]] == [("speed", 3), ("position", 4), ("state", 6)]


def test_a_sheet_is_chosen_by_its_name(run: CommandLine, tmp_path: Path) -> None:
    book = openpyxl.Workbook()
    book.worksheets[0].append(["nothing here"])
    for row in (["Address", "Name"], [16, "speed"]):
        book.create_sheet("Registers").append(row) if row[0] == "Address" else book["Registers"].append(row)
    path = tmp_path / "list.xlsx"
    book.save(path)
    assert summary(run.json("compare", "gadget", str(path), "--sheet", "Registers"))[0] == ["speed"]
    ran = run("compare", "gadget", str(path), "--sheet", "Others")
    assert (ran.code, ran.err) == (2, f"fieldspec: {path} has no sheet Others; choose from Sheet, Registers\n")


FORMS = {
    "0x{:04X}": "hex",
    "{:04x}h": "hex",
    "${:X}": "hex",
    "{}": "decimal",
    "4{:05d}": "one more",
}


@given(data=st.data(), form=st.sampled_from(sorted(FORMS)))
@examples(40)
def test_some_rows_of_a_device_agree_however_their_addresses_are_written(data: st.DataObject, form: str) -> None:
    registers = [item for item in items(newest(SPECS, "tc100")) if item.address < 0x8000]
    chosen = data.draw(st.lists(st.sampled_from(registers), min_size=8, unique_by=lambda item: item.address))
    shift = 1 if FORMS[form] == "one more" else 0
    text = "Address,Name\n" + "".join(f"{form.format(item.address + shift)},{item.name}\n" for item in chosen)
    result = compared(registers, listing(text_sheet(text.encode()), {}))
    assert [pair.item.name for pair in result.agreeing] == [item.name for item in chosen]


def test_a_count_stands_for_several_equal_registers(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    run = CommandLine(capsys, monkeypatch, SPECS)
    agree = "Address,Name,Count\n0x1060,AlarmHistory,50\n"
    report = run.json("compare", "tc100", "-", "--ignore", "name", stdin=agree.encode())
    assert [entry["name"] for entry in report["only_in_device"] if entry["name"].startswith("alarm_history")] == []
    report = run.json("compare", "tc100", "-", "--ignore", "name", stdin=agree.replace("50", "51").encode())
    assert [what["what"] for entry in report["differ"] for what in entry["differences"]] == ["count"]


def test_a_count_stands_for_several_single_bits(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    run = CommandLine(capsys, monkeypatch, TEST_SPECS)
    report = run.json("compare", "station", "-", "--ignore", "name", stdin=b"Space,Address,Name,Count\ncoils,0,K,8\n")
    names = [entry["name"] for entry in report["only_in_device"]]
    assert [name for name in names if name.startswith(("relays", "enable"))] == ["enable"]
    assert report["differ"] == []
