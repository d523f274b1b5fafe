"""The command line on two real devices: process data, the parameter channel, and the registers of a point table."""

from __future__ import annotations

import pytest

from command_line import SPECS, CommandLine


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> CommandLine:
    return CommandLine(capsys, monkeypatch, SPECS)


def test_process_data_of_a_real_drive_explain_themselves(run: CommandLine) -> None:
    frame = "04 BF 91 00 00 00 00 00 40 00 FF FF D8 F0 00 00 03 E8 40 00 20 00 00 00"
    result = run("decode", "hiwin-e", "--telegram", "111", "--direction", "received", frame)
    assert (result.code, result.err) == (0, "")
    for message in ("bit 10 control_by_plc", "bits 9..10 path=shortest", "-10000 control unit", "STW1", "3.2 L551"):
        assert message in result.out


@pytest.mark.parametrize(
    ("request_frame", "answer", "message"),
    [
        ("01 01 00 01 10 00 31 20 00 00", "01 01 00 01 07 01 00 00 80 C0", "bit 15 range_locked"),
        ("01 01 00 01 10 00 24 2A 00 00", "01 01 00 01 07 01 00 00 03 E8", "1.000 Nm"),
        ("01 01 00 01 10 07 03 C4 00 00", "01 01 00 01 06 02 0A AA 00 05", "drive_identification.drive_unit_type"),
        ("01 01 00 01 10 00 21 00 00 00", "01 01 00 01 06 01 00 05", "parameter Pt100"),
        ("01 01 00 01 10 00 FF FF 00 00", "01 81 00 01 44 01 00 00", "parameter_number_not_allowed"),
    ],
)
def test_values_of_a_real_drive_are_read_as_the_requested_parameter(
    run: CommandLine, request_frame: str, answer: str, message: str
) -> None:
    result = run("decode", "hiwin-e", answer, "--request", request_frame)
    assert (result.code, result.err) == (0, "")
    assert message in result.out


def test_a_telegram_of_a_real_drive_is_written_from_names_and_units(run: CommandLine) -> None:
    values = ["STW1=on,no_off2,no_off3,enable_operation,control_by_plc", "speed_setpoint_b=50 %", "STW2=sign_of_life=1"]
    result = run("encode", "hiwin-e", "--telegram", "3", "--direction", "received", *values, "G1_STW=0")
    assert (result.code, result.err, result.lines) == (0, "", ["04 0F 20 00 00 00 10 00 00 00"])


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("111", "telegram_111"),
        ("Pt317", "0x2317 (8983) on the wire"),
        ("0x2317", "Pt317"),
        ("Pt0FF", "0x20FF (8447) on the wire"),
        ("STW1", "control_by_plc"),
        ("NSOLL_B", "100/2^30 %"),
        ("commanded_speed", "reference * raw / 0x40000000"),
    ],
)
def test_items_of_a_real_drive_are_found_by_their_names(run: CommandLine, text: str, message: str) -> None:
    result = run("show", "hiwin-e", text)
    assert (result.code, result.err) == (0, "")
    assert message in result.out


def test_words_of_a_real_point_table_are_explained_with_their_request(run: CommandLine) -> None:
    request = run("encode", "ck10", "read_registers", "station=1", "address=0x2730", "word_count=6").lines[0]
    answer = ["--direction", "response", "station=1", "values=0xFFFF 0xFFFE 0 1 7 0xA120"]
    frame = run("encode", "ck10", "read_registers", *answer).lines[0]
    words = [" ".join(line.split()) for line in run("decode", "ck10", frame, "--request", request).lines]
    assert "reads 0x2730..0x2735" in words
    assert any("FF FF FF FE points[1].position 位置 rw -2 -2 pulse" in line for line in words)
    assert any("points[1].high_speed 高速 rw 500000 500000 pps" in line for line in words)


def test_a_part_of_a_value_that_must_be_accessed_in_one_request_is_pointed_out(run: CommandLine) -> None:
    result = run("decode", "ck10", "01 03 13 88 00 01 00 A4", "--direction", "request")
    assert "reads 0x1388" in result.lines
    assert (
        "note on resolution: The frame contains only some of its words, which must be accessed in one request."
        in result.lines
    )
