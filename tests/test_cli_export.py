"""A device as a list: the same bytes for the same spec, no formulas, and nothing differs from the device."""

from __future__ import annotations

import csv
import io
import json
import re
import zipfile
from decimal import Decimal
from pathlib import Path

import openpyxl
import pytest

from command_line import SPECS, TEST_SPECS, CommandLine
from fieldspec.tools.lists.export import COLUMNS, as_csv, as_json, as_xlsx
from fieldspec.tools.lists.item import Item, items
from fieldspec.tools.lists.text_sheet import text_sheet
from fieldspec.tools.lists.workbook_reader import workbook_sheet
from layouts import newest

DEVICES = sorted(path.parent.name for path in SPECS.glob("*/device.yaml"))
FORMS = ("csv", "xlsx", "json")
PAGE = (Path(__file__).parent.parent / "docs" / "export.md").read_text("utf-8")
HOSTILE = ("=cmd|' /C calc'!A0", "+1+2", "-a", "@SUM(A1)", "*/", "{{", 'a"b,c', "伺服;\u2028x", "\t=1", "'quoted'")


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> CommandLine:
    return CommandLine(capsys, monkeypatch, SPECS)


def hostile_items() -> list[Item]:
    """Registers with texts that spreadsheets, CSV and YAML interpret."""
    return [
        Item(
            space="registers",
            address=number,
            name=f"register_{number}",
            words=1,
            type="u16",
            access="",
            value=None,
            printed_name=text,
            label=text,
        )
        for number, text in enumerate(HOSTILE)
    ]


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("device", DEVICES)
def test_an_export_does_not_differ_from_its_device(device: str, form: str, run: CommandLine, tmp_path: Path) -> None:
    path = tmp_path / f"list.{form}"
    ran = run("export", device, "--to", form, "--out", str(path))
    assert (ran.code, ran.out) == (0, "")
    layout = newest(SPECS, device)
    links, messages = (f"{len(names)} {{}} ({', '.join(names)})" for names in (layout.links, layout.messages))
    absent = f"the frames of {links.format('links')}, and {messages.format('messages')}"
    assert ran.err.replace("1 link ", "1 links ") == (
        f"not in the list: {absent}; `fieldspec facts {device}` has everything\n"
    )
    ran = run("compare", device, str(path))
    assert ran.code == 0, ran.out
    count = len(items(layout))
    assert ran.lines[-1] == f"{count} agree, 0 differ, 0 only in the list, 0 only in the device"


@pytest.mark.parametrize("device", ["widget", "glider-x", "hostile"])
@pytest.mark.parametrize("form", FORMS)
def test_an_export_of_a_made_up_device_does_not_differ_from_it(
    device: str, form: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    run = CommandLine(capsys, monkeypatch, TEST_SPECS)
    path = tmp_path / f"list.{form}"
    assert run("export", device, "--to", form, "--out", str(path)).code == 0
    ran = run("compare", device, str(path))
    assert ran.code == 0, ran.out


@pytest.mark.parametrize("device", ["caller", "widget", "grinder", "weigher"])
def test_messages_are_exported_compared_and_refused_by_name(
    device: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    run = CommandLine(capsys, monkeypatch, TEST_SPECS)
    path = tmp_path / "list.csv"
    absent = run("export", device, "--messages", "--out", str(path)).err
    rows = list(csv.DictReader(io.StringIO(path.read_text("utf-8"))))
    fields = [number for number, row in enumerate(rows, 2) if row["space"] == "messages"]
    names = {rows[number - 2]["name"].rsplit(".")[0] for number in fields}
    own = newest(TEST_SPECS, device)
    with_data = [m.name for m in own.messages.values() if any(m.data(d).fields for d in m.message.directions)]
    assert names == {*with_data}
    without_data = [name for name in own.messages if name not in names]
    assert re.findall(r"messages? \((.*?)\)", absent) == ([", ".join(without_data)] if without_data else [])
    assert run("compare", device, str(path)).code == 0
    ran = run("import", str(path), "--to", str(tmp_path / "again.yaml"), "--protocol", "none")
    if len(fields) == len(rows):
        assert (ran.code, f"is a field of the message {with_data[0]}" in ran.err) == (2, True)
        return
    assert ran.code == 0
    spec = (tmp_path / "again.yaml").read_text("utf-8")
    refused = re.findall(r"^# row (\d+): is a field of the message ", spec, re.MULTILINE)
    assert [int(number) for number in refused] == fields
    assert f" ({', '.join(with_data)}): a list has no frames for them" in ran.out


def test_documentation_describes_every_column_in_order() -> None:
    table = PAGE.partition("| column |")[2].partition("\n\n")[0]
    described = [name for line in table.splitlines() for name in re.findall(r"`(\w+)`", line.split("|")[1:2][0])]
    assert described == list(COLUMNS)


def test_the_same_device_gives_the_same_workbook_without_times_and_versions() -> None:
    sheet_items = items(newest(SPECS, "tc100"))
    first = as_xlsx(sheet_items, "tc100")
    assert first == as_xlsx(sheet_items, "tc100")
    with zipfile.ZipFile(io.BytesIO(first)) as packed:
        assert {part.date_time for part in packed.infolist()} == {(1980, 1, 1, 0, 0, 0)}
        texts = b"".join(packed.read(name) for name in packed.namelist() if name.startswith("docProps/"))
    assert b"openpyxl" not in texts
    assert re.findall(rb">(\d{4}-\d\d-\d\d)", texts) == [b"1980-01-01"] * 2


def test_no_cell_of_a_csv_is_a_formula() -> None:
    cells = [cell for row in csv.reader(io.StringIO(as_csv(hostile_items()))) for cell in row]
    assert [cell for cell in cells if cell[:1] in "=+-@\t\r" and cell] == []
    assert "'=cmd|' /C calc'!A0" in cells


def test_no_cell_of_a_workbook_is_a_formula() -> None:
    book = openpyxl.load_workbook(io.BytesIO(as_xlsx(hostile_items(), "x")))
    cells = [cell for row in book.worksheets[0].iter_rows() for cell in row if cell.value is not None]
    assert {cell.data_type for cell in cells} == {"s", "n"}
    assert all(cell.quotePrefix for cell in cells if str(cell.value).startswith(("=", "+", "-", "@")))


def test_hostile_texts_come_back_unchanged_except_for_control_characters() -> None:
    sheet_items = hostile_items()
    column = COLUMNS.index("printed_name")
    wanted = [" ".join(text.split()) for text in HOSTILE]
    for sheet in (
        text_sheet(as_csv(sheet_items).encode()),
        workbook_sheet(as_xlsx(sheet_items, "x")),
        text_sheet(as_json(sheet_items).encode()),
    ):
        assert [row.cell(column) for row in sheet.rows[1:]] == wanted


def test_a_negative_number_stays_a_number(run: CommandLine) -> None:
    ran = run("export", "tc100")
    rows = {row["name"]: row for row in csv.DictReader(io.StringIO(ran.out))}
    assert rows["points.position"]["min"] == "-2147483648"


def test_a_long_number_keeps_its_digits_in_a_workbook() -> None:
    (register,) = (item for item in items(newest(SPECS, "tc100")) if item.name == "write_enable_key")
    assert register.value is not None
    sheet = workbook_sheet(as_xlsx([register], "x"))
    assert sheet.rows[1].cell(COLUMNS.index("const")) == str(register.value.const)


@pytest.mark.parametrize(
    ("name", "cells"),
    [
        ("points.position", {"address": 0x9011, "hex": "0x9011", "words": 2, "count": 127, "stride": 16}),
        ("alarm_history_2", {"words": 1, "count": None, "type": "u16"}),
        ("full_count_limit", {"address": 0x108, "unit": "pulse", "max": 100000, "printed_name": "FullCountValue"}),
    ],
)
def test_a_row_has_the_facts_of_its_register(name: str, cells: dict[str, object], run: CommandLine) -> None:
    (row,) = (row for row in json.loads(run("export", "tc100", "--to", "json").out) if row["name"] == name)
    assert {key: row[key] for key in cells} == cells


def test_a_register_of_bytes_has_no_words() -> None:
    registers = [item for item in items(newest(TEST_SPECS, "flowmeter")) if item.space == "registers"]
    assert {item.words for item in registers} == {None}


def test_a_parameter_has_its_number_on_the_wire_and_no_words(run: CommandLine) -> None:
    rows = json.loads(run("export", "hiwin-e", "--to", "json").out, parse_float=Decimal)
    assert all(row["space"] == "pnu" and row["words"] is None for row in rows)
    assert any(row["address"] >= 0x2000 for row in rows)


def test_a_device_without_registers_cannot_be_exported(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    run = CommandLine(capsys, monkeypatch, tmp_path)
    assert run("new", "device", "empty", "--protocol", "packet").code == 0
    ran = run("export", "empty", "--out", str(tmp_path / "x.csv"))
    assert (ran.code, ran.err) == (
        2,
        "fieldspec: empty has no registers and no parameters; --messages exports its messages\n",
    )
    assert not (tmp_path / "x.csv").exists()
