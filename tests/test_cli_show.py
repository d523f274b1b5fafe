"""`fieldspec show` shows a device, or every item that a text may mean, with a drawing of its bits."""

from __future__ import annotations

import pytest

from command_line import TEST_SPECS, CommandLine
from fieldspec.command.rendering.blocks import drawn
from fieldspec.command.rendering.item import handles, items, numbered
from layouts import newest

WIDGET = newest(TEST_SPECS, "widget")
HANDLES = [
    (device, handle)
    for device in ("widget", "glider-x")
    for handle in sorted({handle for item in items(newest(TEST_SPECS, device)) for handle in handles(item) if handle})
]

STATUS = """\
 15  14  13  12  11  10   9   8   7   6   5   4   3   2   1   0
+---+---+---+---+---+---+---+---+---+---+---+---+---+---+---+---+
|   | x |   |   | x   x   x   x |   |   | x   x |   | x | x | x |
+---+---+---+---+---+---+---+---+---+---+---+---+---+---+---+---+
      |                       |               |       |   |   +- 0 ready 准备: 0 not ready, 1 ready
      |                       |               |       |   +- 1 start: Its rising edge starts; at its rising edge
      |                       |               |       +- 2 brake: 0 braked, 1 free; active low
      |                       |               +- 4..5 level: How full it is; values level
      |                       +- 8..11 lap: Counts the laps
      +- 14 overlay: when the mode is 3"""
WIDE = """\
 31  30  29  28  27  26  25  24  23  22  21  20  19  18  17  16
+---+---+---+---+---+---+---+---+---+---+---+---+---+---+---+---+
| x |   |   |   |   |   |   |   |   |   |   |   |   |   |   |   |
+---+---+---+---+---+---+---+---+---+---+---+---+---+---+---+---+
  +- 31 last

 15  14  13  12  11  10   9   8   7   6   5   4   3   2   1   0
+---+---+---+---+---+---+---+---+---+---+---+---+---+---+---+---+
|   |   |   |   |   |   |   |   |   |   |   |   |   |   |   | x |
+---+---+---+---+---+---+---+---+---+---+---+---+---+---+---+---+
                                                              +- 0 first"""


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> CommandLine:
    return CommandLine(capsys, monkeypatch, TEST_SPECS)


@pytest.mark.parametrize(("name", "drawing"), [("status", STATUS), ("wide_status", WIDE)])
def test_a_word_is_drawn_with_a_box_for_each_bit(name: str, drawing: str) -> None:
    assert list(drawn(WIDGET.device.flags[name])) == drawing.split("\n")


NUMBERS = {
    "widget": {
        "status_word": [0x1000],
        "position": [0x1010, 0x1011],
        "output": [0x2010, 0x2011, 0x2014, 0x2015, 0x2018, 0x2019],
        "points": [*range(0x9010, 0x9058)],
        "slots": [*range(0xA000, 0xA006)],
        "exchange": [0x22],
    },
    "glider-x": {
        "turns": [2, *range(0x104, 0x108)],
        "reference_speed": [0x317, 0x2317],
        "unused": [*range(0x100, 0x105), *range(0x4100, 0x4105)],
        "fixed_stop": [78, 0xEE0],
    },
}


@pytest.mark.parametrize(("device", "name"), [(device, name) for device, names in NUMBERS.items() for name in names])
def test_an_item_has_the_numbers_of_its_words_and_no_others(device: str, name: str) -> None:
    (item,) = (item for item in items(newest(TEST_SPECS, device)) if name in handles(item))
    assert [number for number in range(1 << 16) if numbered(item, number)] == NUMBERS[device][name]


def test_a_device_is_shown_with_all_its_items(run: CommandLine) -> None:
    result = run("show", "widget")
    assert (result.code, result.err) == (0, "")
    assert result.lines[0].startswith("Widget (Nobody), version 2.0, identity ")
    for cell in ("0x1010   position", "0x9010   points  1..5", "0x20  stop", "enums: exception_code, color, direction"):
        assert cell in result.out


@pytest.mark.parametrize(("device", "text"), HANDLES)
def test_everything_that_has_a_name_can_be_shown(run: CommandLine, device: str, text: str) -> None:
    result = run("show", device, text)
    assert (result.code, result.err) == (0, "")
    assert text in result.lines[0]


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        ("0x1010", ["position", "address 0x1010 (4112), 2 words", "unit 0.01 mm"]),
        ("4112", ["position"]),
        ("1011H", ["position"]),
        ("0x1022", ["alarm_history", "here 0x1022 is alarm_history[3]"]),
        ("0x2014", ["output", "here 0x2014 is output[2]"]),
        ("0x9022", ["points", "here 0x9022 is in points[2].position"]),
        ("0x20", ["stop 停止", "code 0x20", "no data"]),
        ("停止", ["stop 停止"]),
        ("StatusWord", ["status_word StatusWord 状态字"]),
        ("lamp", ["default 1", "restart needed", "1 green 绿"]),
        ("start", ["trigger writing it starts an action; reading returns 0"]),
        ("position", ["atomic its words are read in one request"]),
        ("stroke", ["number 1", "range 0..9999 (0.0..999.9 mm)", "default 125"]),
        ("temperature", ["unit 0.5 V, -40", "since 2.0"]),
        ("limit", ["range -10..-1, 1..10", "values 32767 = ignored"]),
        ("overload", ["problem The load is too heavy.", "cause A blocked axis -> Clear it."]),
        ("corner", ["size 4 bytes", "+0 i16 x 0.1 mm -1000..1000 (-100.0..100.0 mm)"]),
        ("registers/position", ["position", "address 0x1010 (4112), 2 words"]),
        ("enums/alarm/overload", ["problem The load is too heavy."]),
        ("rtu", ["order bytes big", "request: station, function, body, crc"]),
        ("ascii", ["marks 3A .. 0D 0A"]),
        ("supply", ["value 21.6..26.4 V"]),
        ("cable", ["value twisted pair"]),
        ("stop-response", ["message stop response", "answers stop-request", "frame 00 06 20 00 41 67"]),
        ("inverted_brake", ["about flags/status/brake"]),
        ("pins", ["Pin Signal 信号 Colour", "1 ground red"]),
        ("state", ["0x1000 status_word StatusWord 状态字 u16 ro status"]),
        ("everything", ["+0 u8 byte 字节 0..127, 200..210"]),
        ("packet_status", ["| | +- 0 busy"]),
    ],
)
def test_an_item_is_shown_by_name_print_label_address_or_code(run: CommandLine, text: str, lines: list[str]) -> None:
    result = run("show", "widget", text)
    assert result.code == 0
    visible = [" ".join(line.split()) for line in result.lines]
    assert [line for line in lines if line not in visible] == []


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        ("11", ["telegram_11", "number 11", "bytes received 14, sent 10", "received data", "sent data"]),
        ("telegram_70", ["beside telegram_3 or telegram_11", "since 1.1"]),
        (
            "speed_setpoint",
            ["goes to the device", "unit 100/2^30 %", "lies in telegram_3 received, byte 2, words 2 and 3"],
        ),
        ("NSET", ["speed_setpoint NSET", "share of Pt317 (3000 rpm by default): commanded_speed"]),
        (
            "output_torque",
            ["quantity reference * (1 - raw / 0x4000)", "reference Pt42A", "raw u16 of torque_reduction"],
        ),
        ("short_speed", ["reference not said", "raw i16"]),
        (
            "Pt317",
            [
                "reference_speed Pt317",
                "number Pt317, 0x2317 (8983) on the wire",
                "for rotary",
                "used by telegram_3, telegram_11",
                "unit rpm",
            ],
        ),
        ("pt317", ["reference_speed Pt317"]),
        ("0x2317", ["reference_speed Pt317"]),
        ("0x317", ["reference_speed Pt317"]),
        ("2317h", ["reference_speed Pt317"]),
        ("Pt100", ["Pt100", "set servo", "number Pt100, 0x2100 (8448) on the wire"]),
        ("0x2100", ["Pt100", "set servo"]),
        ("Ut102", ["unused Ut102", "number Ut102, 0x4102 (16642) on the wire"]),
        ("0x4102", ["unused Ut100", "here Ut102, 0x4102 (16642) on the wire"]),
        ("964", ["identification", "elements 5", "0 maker u16 0x0AAA", "2..4 reserved u16"]),
        (
            "servo",
            [
                "base a number on the wire is the number + 0x2000",
                "numbers Pt000 to PtFFF, 0x2000 to 0x2FFF on the wire",
            ],
        ),
        ("AL.EE0", ["fixed_stop AL.EE0", "value 3808 (0xEE0)", "number 78", "cause A wall -> Move the wall"]),
        ("al.ee0", ["fixed_stop AL.EE0"]),
        ("0xEE0", ["fixed_stop AL.EE0"]),
        ("78", ["fixed_stop AL.EE0"]),
        ("internal_alarm", ["follows from alarm", "78 fixed_stop AL.EE0"]),
        ("running", ["running S2", "shown by status_word", "set ready, operating", "clear inhibited"]),
        ("status_word", ["inhibited S1 inhibited ready, operating 0x0040 of 0x0043"]),
        ("stored_turns", ["copy of turns at 0x0104", "address 0x0204 (516), 4 words"]),
        ("turns", ["copied in stored_turns at 0x0204", "number 2"]),
        ("cyclic", ["sends telegram: 3, 11, 70; received goes to the device, sent comes from it", "received: body"]),
        ("read_parameter", ["+2 bool8 x 1..8 values, format boolean", "u16 x 1..8 values, format unsigned16 or word"]),
    ],
)
def test_telegrams_and_parameters_are_found_by_their_names(run: CommandLine, text: str, lines: list[str]) -> None:
    result = run("show", "glider-x", text)
    assert result.code == 0
    visible = [" ".join(line.split()) for line in result.lines]
    assert [line for line in lines if line not in visible] == []


def test_the_overview_uses_the_terms_of_the_device(run: CommandLine) -> None:
    lines = [" ".join(line.split()) for line in run("show", "glider-x").lines]
    for line in (
        "cyclic Process data telegram received / sent",
        "channel Parameter channel message request / response",
        "11 telegram_11 Position",
        "speed_setpoint NSET i32 to 100/2^30 %",
        "Pt317 0x2317 reference_speed Pt317 u16 rw rpm",
        "Ut100..Ut104 0x4100..0x4104 unused u16 ?",
        "conversions: commanded_speed, output_torque, short_speed",
    ):
        assert line in lines


def test_a_text_that_means_several_items_shows_all(run: CommandLine) -> None:
    result = run("show", "widget", "nest")
    assert result.lines[0] == "nest"
    assert result.lines.count("nest") == 2
    assert "  code      0x24" in result.lines
    assert any(line.startswith("  size      ") for line in result.lines)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["show", "widget", "positon"], "there is no item of widget positon; did you mean position?"),
        (["show", "widget", "0x7000"], "there is no item of widget at 0x7000 (28672); the nearest are "),
        (
            ["show", "widget", "0x1002"],
            "there is no item of widget at 0x1002 (4098); the nearest are status_word at 0x1000",
        ),
        (["show", "widget", ""], "there is no item of widget "),
        (
            ["show", "glider-x", "0x3000"],
            "there is no item of glider-x at 0x3000 (12288); the nearest are reference_speed at 0x2317",
        ),
        (["show", "glider-x", "Xt100"], "there is no item of glider-x Xt100; did you mean Ut100?"),
        (["show", "nothing"], "there is no device nothing"),
        (["show"], "the following arguments are required"),
    ],
)
def test_an_unknown_item_or_device_is_wrong_use(run: CommandLine, arguments: list[str], message: str) -> None:
    result = run(*arguments)
    assert (result.code, result.out) == (2, "")
    assert message in result.err


@pytest.mark.parametrize(
    ("device", "number", "expected"),
    [
        ("station", "40001", ["filter_time", "0x0000 (40001)"]),
        ("station", "30005", ["counters", "0x0004 is counters[3]"]),
        ("wattmeter", "40002", ["ratio", "0x0000 (40001)"]),
    ],
)
def test_an_item_is_shown_by_the_number_that_the_manual_prints_for_its_address(
    run: CommandLine, device: str, number: str, expected: list[str]
) -> None:
    result = run("show", device, number)
    assert (result.code, result.lines[0]) == (0, expected[0])
    assert expected[1] in result.out


def test_a_number_that_the_manual_prints_for_no_address_is_wrong_use(run: CommandLine) -> None:
    assert run("show", "station", "40999").code == 2


def test_the_registers_of_several_spaces_are_shown_with_their_space_and_printed_number(run: CommandLine) -> None:
    assert "holding_registers  0x0000   40001   filter_time" in run("show", "station").out
