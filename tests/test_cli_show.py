"""`fieldspec show` shows a device, or every item that a text means, with its bits drawn."""

from __future__ import annotations

import pytest

from command_line import MADE_UP, CommandLine
from fieldspec.render.drawing import drawn
from fieldspec.render.item import handles, items
from laid_out import newest

WIDGET = newest(MADE_UP, "widget")
HANDLES = sorted({handle for item in items(WIDGET) for handle in handles(item) if handle})

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
    return CommandLine(capsys, monkeypatch, MADE_UP)


@pytest.mark.parametrize(("name", "drawing"), [("status", STATUS), ("wide_status", WIDE)])
def test_a_word_is_drawn_with_a_box_a_bit(name: str, drawing: str) -> None:
    assert list(drawn(WIDGET.device.flags[name])) == drawing.split("\n")


def test_a_device_is_shown_with_all_that_it_has(run: CommandLine) -> None:
    found = run("show", "widget")
    assert (found.code, found.err) == (0, "")
    assert found.lines[0].startswith("Widget (Nobody), version 2.0, identity ")
    for cell in ("0x1010   position", "0x9010   points  1..5", "0x20  stop", "enums: exception_code, color, direction"):
        assert cell in found.out


@pytest.mark.parametrize("text", HANDLES)
def test_everything_that_has_a_name_can_be_shown(run: CommandLine, text: str) -> None:
    found = run("show", "widget", text)
    assert (found.code, found.err) == (0, "")
    assert text in found.lines[0]


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
        ("start", ["trigger writing it starts something; reading gives 0"]),
        ("position", ["atomic its words are read in one request"]),
        ("stroke", ["number 1", "range 0..9999 (0.0..999.9 mm)", "default 125"]),
        ("temperature", ["unit 0.5 V, -40", "since 2.0"]),
        ("limit", ["range -10..-1, 1..10", "values 32767 = ignored"]),
        ("overload", ["problem The load is too heavy.", "cause A blocked axis -> Clear it."]),
        ("corner", ["size 4 bytes", "+0 i16 x 0.1 mm -1000..1000 (-100.0..100.0 mm)"]),
        ("rtu", ["order bytes big, words big", "request: station, function, body, crc"]),
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
    found = run("show", "widget", text)
    assert found.code == 0
    shown = [" ".join(line.split()) for line in found.lines]
    assert [line for line in lines if line not in shown] == []


def test_a_text_that_means_several_items_shows_all(run: CommandLine) -> None:
    found = run("show", "widget", "nest")
    assert found.lines[0] == "nest"
    assert found.lines.count("nest") == 2
    assert "  code      0x24" in found.lines
    assert any(line.startswith("  size      ") for line in found.lines)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["show", "widget", "positon"], "there is no item of widget positon; did you mean position?"),
        (["show", "widget", "0x7000"], "there is no item of widget 0x7000; "),
        (["show", "widget", "0x1002"], "there is no item of widget 0x1002; "),
        (["show", "widget", ""], "there is no item of widget "),
        (["show", "nothing"], "there is no device nothing"),
        (["show"], "the following arguments are required"),
    ],
)
def test_what_there_is_not_is_wrong_use(run: CommandLine, arguments: list[str], said: str) -> None:
    found = run(*arguments)
    assert (found.code, found.out) == (2, "")
    assert said in found.err
