"""`fieldspec encode` writes the frame of a message, or says why it cannot."""

from __future__ import annotations

import re
import struct

import pytest
from crccheck.crc import Crc16Modbus

from command_line import SPECS, TEST_SPECS, CommandLine
from fieldspec.language.model.texts import Example
from fieldspec_devices import esc11
from layouts import newest

WIDGET = newest(TEST_SPECS, "widget")
READ = ["read_registers", "station=1", "address=0x1000", "word_count=2"]
WRITE = ["write_registers", "station=16", "address=0x2001"]
PACKET = ["--link", "packet", "receiver=7", "sequence=1"]


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> CommandLine:
    return CommandLine(capsys, monkeypatch, TEST_SPECS)


@pytest.fixture
def run_on_devices(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> CommandLine:
    return CommandLine(capsys, monkeypatch, SPECS)


_WITH_RECORDS = [
    example.id
    for example in WIDGET.device.examples.values()
    if not example.refused and not example.exception_response and "[{" in str(example.values)
]


def arguments_of(value: object, name: str = "") -> list[str]:
    """Values of the spec as arguments: `nest.corners.0.x=1`."""
    if isinstance(value, dict):
        pairs = list(value.items())
    elif isinstance(value, list) and value and isinstance(value[0], dict | list):
        pairs = list(enumerate(value))
    else:
        text = ",".join(map(str, value)) if isinstance(value, list) else str(value)
        return [f"{name}={text}"]
    return [argument for key, member in pairs for argument in arguments_of(member, f"{name}.{key}".lstrip("."))]


def test_elements_of_lists_are_named_as_decode_prints_them(run: CommandLine) -> None:
    example = next(e for e in WIDGET.device.examples.values() if e.id in _WITH_RECORDS)
    code = WIDGET.links[example.link].frame(example.direction).role("code")
    values = {name: value for name, value in example.values.items() if code is None or name != code.name}
    arguments = [re.sub(r"\.([0-9]+)(?=[.=])", r"[\1]", argument) for argument in arguments_of(values)]
    assert any("[0]" in argument for argument in arguments)
    options = ["--link", example.link, "--direction", example.direction]
    result = run("encode", "widget", example.message, *arguments, *options)
    assert bytes.fromhex(result.lines[0]) == example.frame


@pytest.mark.parametrize(
    "example",
    [e for e in WIDGET.device.examples.values() if not e.refused and not e.exception_response],
    ids=lambda example: example.id,
)
def test_every_example_is_written_from_its_values(run: CommandLine, example: Example) -> None:
    code = WIDGET.links[example.link].frame(example.direction).role("code")
    values = {name: value for name, value in example.values.items() if code is None or name != code.name}
    options = ["--link", example.link, "--direction", example.direction]
    result = run("encode", "widget", example.message, *arguments_of(values), *options)
    assert (result.code, result.err) == (0, "")
    assert bytes.fromhex(result.lines[0]) == example.frame


@pytest.mark.parametrize(
    ("arguments", "frame"),
    [
        (READ, "01 03 10 00 00 02 C0 CB"),
        (["read_registers", "station=1", "address=status_word", "word_count=2"], "01 03 10 00 00 02 C0 CB"),
        (["write_register", "station=1", "address=lamp", "value=5"], "01 06 20 00 00 05 42 09"),
        ([*WRITE, "values=0xFFFF 0xFF9C"], "10 10 20 01 00 02 04 FF FF FF 9C BA 23"),
        ([*WRITE, "values.0=65535", "values.1=65436"], "10 10 20 01 00 02 04 FF FF FF 9C BA 23"),
        (["exchange", *PACKET, "data="], "00 08 07 01 22 00 00 32"),
    ],
)
def test_values_are_taken_in_every_spelling(run: CommandLine, arguments: list[str], frame: str) -> None:
    assert run("encode", "widget", *arguments).lines == [frame]


def test_a_frame_of_characters_is_shown_as_text_and_bytes(run: CommandLine) -> None:
    result = run("encode", "widget", *READ, "--link", "ascii")
    assert result.lines == ["3A 30 31 30 33 31 30 30 30 30 30 30 32 45 41 0D 0A", r":010310000002EA\r\n"]
    assert run("encode", "widget", *READ, "--link", "ascii", "--format", "hex").lines == result.lines[:1]


def test_json_has_the_frame_and_its_message(run: CommandLine) -> None:
    assert run.json("encode", "widget", *READ, "--link", "ascii") == {
        "device": "widget",
        "version": "2.0",
        "link": "ascii",
        "direction": "request",
        "direction_name": "request",
        "message": "read_registers",
        "frame": "3A3031303331303030303030324541" + "0D0A",
        "characters": ":010310000002EA\r\n",
    }
    assert run.json("encode", "widget", *READ)["characters"] is None


def test_what_is_encoded_can_be_decoded(run: CommandLine) -> None:
    frame = run("encode", "widget", *READ).out
    assert run.json("decode", "widget", frame)["values"] == {
        "station": 1,
        "function": 3,
        "address": 0x1000,
        "word_count": 2,
    }


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["read_registerz"], "there is no message read_registerz; did you mean read_registers?"),
        ([*READ, "--link", "tcp"], "there is no link tcp; choose from ascii, packet, rtu"),
        (READ[:3], "missing_value: word_count is not given; the request has the fields station, address, word_count"),
        ([*READ, "adress=1"], "there is no field adress; did you mean address?"),
        ([*READ, "station=2"], "station has two values"),
        ([*READ[:3], "word_count"], "word_count is not of the form NAME=VALUE"),
        ([*READ[:3], "=1"], "=1 is not of the form NAME=VALUE"),
        ([*READ[:3], "word_count=11"], "out_of_range: word_count is 11, not in 1..10"),
        ([*READ[:3], "word_count=two"], "word_count: `two` is not a number; give a count"),
        (["read_registers", "station=99", *READ[2:]], "out_of_range: station is 99"),
        (["read_registers", "station=1", "address=nothing", READ[3]], "address: `nothing` is not a number"),
        (
            ["exchange", *PACKET, "size=3", "data=1,2,3"],
            "size is not given: it is the number of bytes of data; give receiver",
        ),
        (["exchange", *PACKET, "data=1,300"], "out_of_range: data is 300"),
        ([*WRITE, "values=1", "byte_count=2"], "byte_count is not given: it is the number of bytes of values; give"),
        ([*READ, "--link", "rtu", "function=3"], "function is not given: it is the code of the message; give station"),
        ([*READ, "--link", "rtu", "crc=3"], "crc is not given: it is the checksum of what it covers; give station"),
        (["nest", *PACKET, "nest=4"], "nest: a mapping of fields is expected"),
        (["nest", *PACKET, "nest=4", "nest.color=1"], "nest.color: nest has a value of its own"),
        (["read_corners", *PACKET, "count=1", "corners.1.x=1"], "there is no field corners"),
        (["write_one", *PACKET, "number=1", "value=1", "--direction", "sideways"], "there is no direction sideways"),
        ([], "name the message; widget has "),
        (["station=1"], "name the message; widget has "),
        (["--message", "stop", "stop"], "stop is not of the form NAME=VALUE"),
    ],
)
def test_wrong_use_says_what_is_wrong(run: CommandLine, arguments: list[str], message: str) -> None:
    result = run("encode", "widget", *arguments)
    assert (result.code, result.out) == (2, "")
    assert message in result.err


def test_a_message_of_a_later_version_is_unknown_to_an_earlier_one(run: CommandLine) -> None:
    values = [*PACKET, "number=2", "value=0xFFFF"]
    assert run("encode", "widget@2.0", "write_one", *values).code == 0
    result = run("encode", "widget@before-2.0", "write_one", *values)
    assert (result.code, result.err) == (2, "fieldspec: there is no message write_one; did you mean write_all?\n")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["write_one", *PACKET, "number=2", "value=0xFFFE"], "value (home) is -2: wrong: should be one of -1, 0, 1"),
        (["write_register", "station=1", "address=limit", "value=0"], "limit is 0: wrong: should be -10..-1, 1..10"),
        ([*WRITE, "values=0x000F 0xFFFF"], "target is 10485.75 mm: wrong: should be -9999.99..9999.99 mm"),
    ],
)
def test_a_value_beyond_its_parameter_or_register_is_refused(
    run: CommandLine, arguments: list[str], message: str
) -> None:
    result = run("encode", "widget", *arguments)
    assert (result.code, result.out) == (2, "")
    assert message in result.err


@pytest.mark.parametrize(("name", "number", "size"), [("factor", 1, 3), ("limit", 3, 5), ("capacity", 5, 6)])
def test_the_value_of_a_parameter_in_bytes_says_how_many_they_are(
    run: CommandLine, name: str, number: int, size: int
) -> None:
    result = run("encode", "flowmeter", "write_setting", "station=1", f"number={name}", "index=0", "data=258")
    data = struct.pack("<BBHBBQ", 1, 0x12, number, 0, size, 258)
    check = Crc16Modbus.calc(data).to_bytes(2, "little")
    assert (result.code, bytes.fromhex(result.out)) == (0, data + check)


def test_a_parameter_of_another_size_than_the_bytes_of_a_message_is_refused(run: CommandLine) -> None:
    result = run("encode", "axis", "download_1", "index=target", "data=5")
    assert (result.code, result.out) == (2, "")
    assert "target has 4 bytes; use another message" in result.err


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["write_register", "address=0x4E26", "value=1"], "flash_points[0].acceleration_time at 0x4E26 can only be"),
        (["write_registers", "address=0x4E26", "values=1,2"], "flash_points[0].acceleration_time at 0x4E26 can only"),
        (["write_registers", "address=0x4E1F", "values=1,2"], "flash_points[0].position at 0x4E20 can only be read"),
        (["write_register", "address=model_id", "value=1"], "model_id at 0x0834 can only be read"),
    ],
)
def test_a_value_that_is_read_only_is_not_written(
    run_on_devices: CommandLine, arguments: list[str], message: str
) -> None:
    result = run_on_devices("encode", "ck10", *arguments, "station=1")
    assert (result.code, result.out) == (2, "")
    assert message in result.err


@pytest.mark.parametrize(
    ("arguments", "register"),
    [
        (["write_register", "address=0x07D0", "value=77"], "axis_start_speed at 0x07D0"),
        (["write_register", "address=0x07D1", "value=77"], "axis_start_speed at 0x07D0"),
        (["write_registers", "address=0x07D0", "values=77"], "axis_start_speed at 0x07D0"),
        (["write_registers", "address=0x07D4", "values=0,100,7"], "target_position_or_distance at 0x07D6"),
        (["read_registers", "address=0x07D5", "word_count=3"], "axis_move_speed at 0x07D4"),
        (["write_register", "address=0x2710", "value=1"], "points[0].position at 0x2710"),
    ],
)
def test_a_part_of_an_atomic_register_is_not_accessed(
    run_on_devices: CommandLine, arguments: list[str], register: str
) -> None:
    result = run_on_devices("encode", "ck10", *arguments, "station=1")
    assert (result.code, result.out) == (2, "")
    assert f"{register} has 2 words, all of which must be accessed in one request; no frame is written" in result.err
    whole = run_on_devices("encode", "ck10", "write_registers", "address=0x07D4", "values=0,100,0,7", "station=1")
    assert whole.code == 0


def test_a_sentinel_may_be_written_to_a_register(run: CommandLine) -> None:
    result = run("encode", "widget", "write_register", "station=1", "address=limit", "value=0x7FFF")
    assert result.lines == ["01 06 20 03 7F FF 12 7A"]


def test_a_quantity_whose_count_is_a_sentinel_is_refused(run: CommandLine) -> None:
    result = run("encode", "widget", "set_everything", "station=3", "everything.half=655.35mm")
    assert (result.code, result.out) == (2, "")
    assert "everything.half: `655.35mm` would be the count 65535, which stands for ignored; write " in result.err


@pytest.mark.parametrize("quantity", ["9999mm", "9999.0001 mm", "999.9cm"])
def test_a_quantity_that_is_sent_as_a_sentinel_is_refused(run: CommandLine, quantity: str) -> None:
    others = ["sample.exact=too_far", "sample.pair=1,2", "sample.turned=1", "sample.widths=not_measured,2"]
    direction = ["--direction", "response"]
    result = run("encode", "probe", "measure", f"sample.distance={quantity}", *others, *direction)
    assert (result.code, result.out) == (2, "")
    assert f"`{quantity}` would be sent as 9999.0, which stands for too_far; write `too_far`" in result.err
    assert run("encode", "probe", "measure", "sample.distance=too_far", *others, *direction).code == 0


@pytest.mark.parametrize(
    ("arguments", "frame"),
    [
        ([*WRITE, "values=-1.00mm"], "10 10 20 01 00 02 04 FF FF FF 9C BA 23"),
        ([*WRITE, "values=-1.00 mm, ignored"], "10 10 20 01 00 03 06 FF FF FF 9C 7F FF B0 C5"),
        (["write_register", "station=16", "address=lamp", "value=blue"], "10 06 20 00 00 05 41 48"),
    ],
)
def test_registers_are_written_in_their_units_and_by_name(run: CommandLine, arguments: list[str], frame: str) -> None:
    assert run("encode", "widget", *arguments).lines == [frame]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (
            ["write_register", "station=16", "address=target", "value=1mm"],
            "1mm takes 2 words, and write_register writes",
        ),
        ([*WRITE, "values=99999.99mm"], "target is 9999999, not in -999999..999999"),
        (["write_registers", "station=16", "address=0x4000", "values=1mm"], "no register or field of words begins at"),
    ],
)
def test_a_quantity_that_no_register_takes_is_refused(run: CommandLine, arguments: list[str], message: str) -> None:
    result = run("encode", "widget", *arguments)
    assert (result.code, result.out) == (2, "")
    assert message in result.err


def test_a_register_of_another_space_is_refused(run: CommandLine) -> None:
    result = run("encode", "meter", "read_holding_registers", "station=1", "address=voltage", "word_count=1")
    assert (result.code, result.out) == (2, "")
    assert "voltage lies in input_registers, and read_holding_registers reads holding_registers" in result.err
    result = run("encode", "meter", "read_input_registers", "station=1", "address=voltage", "word_count=1")
    assert result.lines == ["01 04 00 00 00 01 31 CA"]


def test_a_value_that_is_read_only_may_be_requested_and_returned(run_on_devices: CommandLine) -> None:
    run = run_on_devices
    assert run("encode", "ck10", "read_registers", "station=1", "address=0x4E26", "word_count=3").code == 0
    echo = ["write_register", "station=1", "address=0x4E26", "value=1", "--direction", "response"]
    assert run("encode", "ck10", *echo).code == 0


def test_a_count_of_a_register_has_no_leading_zeros(run: CommandLine) -> None:
    ran = run("encode", "widget", *WRITE, "values=-1.00 mm, 007")
    assert (ran.code, ran.out) == (2, "")
    assert "`007` is not a number" in ran.err


@pytest.mark.parametrize(
    ("device", "arguments", "frame"),
    [
        ("tc100", ["motion_speed=50%", "--link", "rtu"], "01 06 20 14 00 32 43 DB"),
        ("tc100", ["station=3", "motion_speed=50%", "--link", "rtu"], "03 06 20 14 00 32 42 39"),
        ("tc100", ["unit=3", "motion_speed=50%", "--link", "rtu"], "03 06 20 14 00 32 42 39"),
        ("tc100", ["motion_speed=50%"], b":01062014003293\r\n".hex(" ").upper()),
        ("tc100", ["unit=3", "motion_speed=50%"], b":03062014003291\r\n".hex(" ").upper()),
    ],
)
def test_a_register_is_written_by_its_name_with_a_value_in_its_unit(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, device: str, arguments: list[str], frame: str
) -> None:
    result = CommandLine(capsys, monkeypatch, SPECS)("encode", device, "write", *arguments, "--format", "hex")
    assert (result.code, result.out.strip()) == (0, frame)


@pytest.mark.parametrize(
    ("options", "frame"),
    [([], b":010310000001EB\r\n"), (["--link", "rtu"], bytes.fromhex("010310000001 80CA"))],
)
def test_a_message_is_sent_on_the_link_of_the_factory_settings(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, options: list[str], frame: bytes
) -> None:
    words = ["read_registers", "station=1", "address=0x1000", "word_count=1", "--format", "hex"]
    result = CommandLine(capsys, monkeypatch, SPECS)("encode", "tc100", *words, *options)
    assert (result.code, result.out.strip()) == (0, frame.hex(" ").upper())


@pytest.mark.parametrize(("quantity", "count"), [(20.004, 2000), (20.005, 2000), (20.015, 2002), (20.006, 2001)])
def test_the_command_line_rounds_as_the_generated_code(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, quantity: float, count: int
) -> None:
    arguments = ["esc11", "move_relative", "address=0", f"distance={quantity}mm", "speed=50", "--format", "hex"]
    result = CommandLine(capsys, monkeypatch, SPECS)("encode", *arguments)
    assert bytes.fromhex(result.out)[3:7] == count.to_bytes(4, "little")
    assert f"counts; {count} is sent" in result.err
    assert esc11.MoveRelativeRequest(distance_mm=quantity, speed=50).distance == count
