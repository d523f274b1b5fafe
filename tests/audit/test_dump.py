"""What was read from a device is decoded as the codecs decode it, and judged; files that cannot be used are refused."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from command_line import CommandLine, RunResult
from fieldspec.codec.reference.records import CodecError, decoded_value
from fieldspec.codec.reference.structs import value_construct
from fieldspec.tools.audit.addressed_values import addressed_values
from fieldspec.tools.lists.workbook_reader import workbook_sheet
from layouts import TEST_SPECS, layout_at, newest
from spec_files import DEVICE, gadget

SPEC = """
registers:
  - group: all
    section: "1"
    defaults: {type: u16, access: rw}
    rows:
      - {at: 0x10, name: percent, range: 0..100, unit: "%", default: 50, source: L1}
      - {at: 0x11, name: position, type: i32, unit: mm, scale: 0.01, source: L2}
      - {at: 0x13, name: mode, enum: mode, source: L3}
      - {at: 0x14, name: status, flags: status, source: L4}
      - {at: 0x15, name: spare, reserved: true, source: L5}
      - {at: 0x16, name: start, trigger: true, const: 1, source: L6}
      - {at: 0x17, name: code, enum: code, source: L7}
      - {at: 0x18, name: flag, type: bool16, source: L8}
      - {at: 0x19, name: model, const: 7, source: L9}
      - {at: 0x1A, name: limit, range: 0..9, sentinels: [{value: 0xFFFF, name: none}], source: L10}
enums:
  - {name: mode, section: "1", source: L3, members: [{value: 0, name: stop}, {value: 1, name: go}]}
  - {name: code, section: "1", source: L7, open: true, members: [{value: 0, name: fine}]}
flags:
  - name: status
    type: u16
    section: "1"
    source: L4
    bits: [{bit: 0, name: ready}, {bit: 1, name: spare, reserved: true}]
links:
  - name: wire
    byte_order: big
    word_order: big
    source: 1 L1
    request: [{name: code, role: code, type: u8}, {name: body, role: body}]
    response: [{name: code, role: code, type: u8}, {name: body, role: body}]
"""
SERVO = """
parameters:
  - name: servo
    space: pnu
    base: 0x2000
    source: 1 L1
    type: i16
    rows:
      - {number: 1, name: gain, range: -5..5, source: 1 L2}
      - {number: 2, name: names, type: u16, elements: 3, source: 1 L3}
"""


@pytest.fixture
def run(tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> CommandLine:
    (tmp_path / "gadget").mkdir()
    (tmp_path / "gadget" / "device.yaml").write_text(DEVICE + SPEC, "utf-8")
    return CommandLine(capsys, monkeypatch, tmp_path)


def dump(run: CommandLine, text: str | bytes, *options: str) -> RunResult:
    data = text if isinstance(text, bytes) else text.encode()
    return run("audit", "gadget", "--dump", "-", *options, stdin=data)


def section(run: CommandLine, text: str | bytes, *options: str) -> dict[str, Any]:
    data: dict[str, Any] = json.loads(dump(run, text, "--format", "json", *options).out)
    section: dict[str, Any] = data["sections"]["dump"]
    return section


def findings_of(run: CommandLine, text: str | bytes, *options: str) -> list[tuple[str, str]]:
    """The findings, as rule and message."""
    return [(finding["code"], finding["message"]) for finding in section(run, text, *options)["findings"]]


def values(run: CommandLine, text: str | bytes, *options: str) -> dict[str, tuple[str, str]]:
    """The raw values and their meanings by name."""
    rows = section(run, text, *options)["tables"]["values"]
    return {row["name"]: (row["raw"], row["meaning"]) for row in rows}


HEAD = "address,value\n"


def test_values_are_decoded_with_their_meanings(run: CommandLine) -> None:
    text = HEAD + "0x10,50\n0x11,0xFFFF\n0x12,0xFF9C\n0x13,1\n0x14,1\n0x1A,0xFFFF\n"
    assert values(run, text) == {
        "percent": ("50", "50 %"),
        "position": ("-100", "-1.00 mm"),
        "mode": ("1", "go"),
        "status": ("1", "[ready]"),
        "limit": ("65535", "none"),
    }
    assert dump(run, text).code == 0


@pytest.mark.parametrize(
    ("rows", "expected"),
    [
        ("0x10,101", [("dump_value_within_range", "percent is 101; it should be 0..100 %")]),
        ("0x13,5", [("dump_value_known", "mode is 5; it should be one of 0, 1")]),
        ("0x17,5", [("dump_value_known", "code: code does not list 5.")]),
        ("0x18,2", [("dump_value_known", "flag is 2; it should be 0 or 1")]),
        ("0x19,8", [("dump_value_known", "model is 8; it should be 7")]),
        ("0x14,0x8002", [("dump_reserved_clear", "status has bits set that have no meaning: 1, 15")]),
        ("0x15,3", [("dump_reserved_clear", "spare is reserved and holds 3")]),
        ("0x11,1", [("dump_value_whole", "position has more words than the dump: 0x0012 is missing")]),
        ("0x10,1\n0x10,2", [("dump_value_whole", "an address has two values")]),
        ("0x10,70000", [("dump_value_within_range", "percent has 1 words; 70000 does not fit into them")]),
        ("0x10,50\n0x40,1", [("dump_address_known", "the spec does not have the address 0x0040")]),
        ("0x16,0", []),
        ("0x10,10", []),
        ("0x1A,0xFFFF", []),
    ],
)
def test_what_cannot_be_is_found(run: CommandLine, rows: str, expected: list[tuple[str, str]]) -> None:
    assert findings_of(run, f"{HEAD}{rows}\n") == expected


@pytest.mark.parametrize(("rows", "code"), [("0x10,101", 1), ("0x17,5", 0), ("0x10,50\n0x40,1", 0), ("0x10,50", 0)])
def test_the_exit_code_is_1_where_the_device_or_the_spec_is_wrong(run: CommandLine, rows: str, code: int) -> None:
    assert dump(run, f"{HEAD}{rows}\n").code == code


def test_a_finding_points_to_the_row_of_the_dump_and_to_the_spec(run: CommandLine) -> None:
    ran = dump(run, HEAD + "0x10,50\n0x10,50\n0x13,5\n")
    assert "standard input:4:1: error[dump_value_known]" in ran.out
    assert "name: mode" in ran.out


def test_values_that_are_not_the_initial_ones_are_told_and_no_finding(run: CommandLine) -> None:
    part = section(run, HEAD + "0x10,60\n")
    assert [(row["name"], row["raw"], row["initial"]) for row in part["tables"]["defaults"]] == [
        ("percent", "60", "50")
    ]
    assert part["findings"] == []


@pytest.mark.parametrize(
    "text",
    [
        "address,value\n0x10,50\n0x13,1\n",
        "address;value\n16;50\n19;1\n",
        "Address (hex)\tValue\n10\t50\n13\t1\n",
        "16,50\n19,1\n",
        "10h,50\n13h,1\n",
        '[{"address": "0x10", "value": 50}, {"address": "0x13", "value": 1}]',
        '{"0x10": 50, "0x13": 1}',
        '{"16": "50", "19": true}',
        "地址,当前值\n0x10,50\n0x13,1\n",
        "\ufeffaddress,value\r\n0x10,50\r\n0x13,1\r\n",
        "| address | value |\n|---|---|\n| 0x10 | 50 |\n| 0x13 | 1 |\n",
        "address,value\n0x10,50\n0x12,-\n0x13,1\n",
        "16: 50\n19: 1\n",
        "Register 16 = 50 (0x0032)\nRegister 19 = 1 (0x0001)\n",
        "[[16, 50], [19, 1]]",
        "0x13: 0x0001\n0x10: 0x0032\n",
    ],
)
def test_a_dump_may_be_written_in_many_ways(run: CommandLine, text: str) -> None:
    assert values(run, text) == {"percent": ("50", "50 %"), "mode": ("1", "go")}


@pytest.mark.parametrize(
    ("text", "options"),
    [
        ("address,value\n0x11,0xFFFF\n0x12,0xFF9C\n", ()),
        ("address,value,words\n0x11,-100,2\n", ()),
        ("address,value\n0x11,4294967196\n", ()),
        ('{"0x11": [65535, 65436]}', ()),
        ("address,value\n0x11,FFFF FF9C\n", ()),
        ("address,value\n18,0xFFFF\n19,0xFF9C\n", ("--offset", "1")),
        ("no.,what\n0x11,65535\n0x12,65436\n", ("--address", "no.", "--value", "what")),
        ("a,b,c\nx,0x11,65535\nx,0x12,65436\n", ("--address", "2", "--value", "C")),
        ("register,value\n40018,0xFFFF\n40019,0xFF9C\n", ("--base", "4xxxx")),
    ],
)
def test_a_value_of_two_words_may_be_written_in_many_ways(
    run: CommandLine, text: str, options: tuple[str, ...]
) -> None:
    assert values(run, text, *options) == {"position": ("-100", "-1.00 mm")}


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "standard input is empty"),
        ("address,value\n", "has a heading and no rows"),
        ("name,value\nx,1\n", "has no column that looks like addresses"),
        ("address,name\n16,x\n", "has no column that looks like values"),
        ("address,value\n16,\n", "has no value under value"),
        ('address;value\n16;"1,000"\n', "with thousands separators; remove them"),
        ("address;value\n1.000;5\n", "with thousands separators; remove them"),
        ("address;value\n16;1.000\n", "with thousands separators; remove them"),
        ("address;value\n1,000;5\n", "with thousands separators; remove them"),
        ("address,value\n0xF000,1\n0xF001,1\n", "has no address that Gadget has; if it is a dump of this device"),
        ("address,value\n16,12.5\n", "which is not a whole number of counts"),
        ("address,value\n16,abc?\n", "which is not a whole number of counts"),
        ("address,value\n16,99999999999999999999\n", "which is too great"),
        ("address,value\nhere,1\n", "has no address under address"),
        (b"\x00\x01\x02\x03", "is binary"),
        ("地址,当前值\n16,1\n".encode("gbk"), "is not UTF-8; state its encoding"),
        (b"%PDF-1.7", "is a PDF"),
        ('{"a": ', "begins like JSON but is not JSON"),
        ("[1, 2]", "is JSON but not a list of objects"),
    ],
)
def test_a_file_that_cannot_be_used_is_wrong_use(run: CommandLine, text: str | bytes, message: str) -> None:
    ran = dump(run, text)
    assert ran.code == 2
    assert message in ran.err
    assert ran.out == ""


def test_another_encoding_can_be_named(run: CommandLine) -> None:
    text = "地址,当前值\n0x10,50\n".encode("gbk")
    assert values(run, text, "--encoding", "gbk") == {"percent": ("50", "50 %")}


def test_rows_of_several_values_have_all_of_them(run: CommandLine) -> None:
    read = values(run, "Addr,+0,+1,+2,+3\n0x10,50,0,0,1\n")
    assert (read["percent"], read["mode"]) == (("50", "50 %"), ("1", "go"))


def test_options_of_dumps_need_a_dump(run: CommandLine) -> None:
    ran = run("audit", "gadget", "--offset", "1")
    assert (ran.code, ran.err) == (2, "fieldspec: --offset goes with --dump FILE\n")


def test_a_dump_may_be_a_workbook(run: CommandLine) -> None:
    from fieldspec.foundation.spreadsheet import Workbook, Worksheet
    from fieldspec.tools.lists.workbook_writer import packed

    content = packed(Workbook((Worksheet("dump", (("address", "value"), ("0x10", 101))),)))
    assert workbook_sheet(content).rows
    assert findings_of(run, content) == [("dump_value_within_range", "percent is 101; it should be 0..100 %")]


def test_the_parameters_of_a_device_are_judged_by_their_numbers_on_the_wire(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "gadget").mkdir()
    (tmp_path / "gadget" / "device.yaml").write_text(DEVICE + SERVO, "utf-8")
    run = CommandLine(capsys, monkeypatch, tmp_path)
    text = '{"0x2001": -6, "0x2002": [1, 2, 3], "0x2003": 1}'
    assert values(run, text) == {
        "gain": ("-6", ""),
        "names[0]": ("1", ""),
        "names[1]": ("2", ""),
        "names[2]": ("3", ""),
    }
    assert [code for code, _ in findings_of(run, text)] == ["dump_value_within_range", "dump_address_known"]


def test_the_columns_of_compare_are_as_they_were(run: CommandLine, tmp_path: Path) -> None:
    path = tmp_path / "list.csv"
    path.write_text("address,name,words\n0x10,percent,1\n", "utf-8")
    assert "percent" not in run("compare", "gadget", str(path), "--ignore", "type").err


@pytest.mark.parametrize("device", ["widget", "glider-x", "gizmo"])
@pytest.mark.parametrize("pattern", [b"\0\0", b"\0\1", b"\xff\xff", b"\x12\x34", b"\x80\0"])
def test_a_value_is_wrong_exactly_where_the_reference_refuses_it(device: str, pattern: bytes) -> None:
    from fieldspec.codec.explain.values import decode_value

    layout = newest(TEST_SPECS, device)
    seen = 0
    for slot in addressed_values(layout):
        value = slot.value
        if slot.reserved or slot.unread or value.size % 2:
            continue
        data = pattern * (value.size // 2)
        decoded = decode_value(layout.device, value, data, slot.order, slot.swapped)
        raw = value_construct(value, slot.order, slot.swapped).parse(data)
        try:
            decoded_value(slot.name, value, raw, layout.device, None)
        except CodecError:
            assert decoded.reason, slot.name
        else:
            assert decoded.reason in ("", "out_of_range"), slot.name
        seen += 1
    assert bool(seen) == bool(layout.registers)


def test_every_value_of_a_table_has_an_address_of_its_own() -> None:
    values = [slot for slot in addressed_values(newest(TEST_SPECS, "widget")) if slot.name.startswith("points[")]
    assert len({(slot.address, slot.skip) for slot in values}) == len(values) == 5 * 6


def test_bytes_in_one_word_are_read_apart() -> None:
    text = """
records: [{name: pair, section: "1", source: L1, fields: [{name: high, type: u8}, {name: low, type: u8}]}]
tables: [{name: pairs, section: "1", source: L2, base: 0, stride: 1, count: 1, record: pair, access: rw}]
"""
    values = [
        (slot.name, slot.address, slot.words, slot.skip) for slot in addressed_values(layout_at(gadget(text), "1"))
    ]
    assert values == [("pairs[0].high", 0, 1, 0), ("pairs[0].low", 0, 1, 1)]
