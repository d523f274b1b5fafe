"""`fieldspec decode` explains a frame: every byte, the registers, and how sure the reading is."""

from __future__ import annotations

import subprocess
import sys
from typing import Any

import pytest

from command_line import SPECS, TEST_SPECS, CommandLine
from fieldspec.codec.explain.readings import FrameOptions, read_frame
from fieldspec.codec.reference import codec
from fieldspec.language.model.texts import Example
from layouts import newest

EXAMPLES = newest(TEST_SPECS, "widget").device.examples
READ = "01 03 10 00 00 02 C0 CB"
ANSWER = "01 03 04 12 34 FF FF BF 35"
WRITE = "01 06 20 00 00 05 42 09"
STOP = "00 06 20 00 20 46"
STOPPED = "00 06 20 00 41 67"


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> CommandLine:
    return CommandLine(capsys, monkeypatch, TEST_SPECS)


def decoded(run: CommandLine, *arguments: str) -> Any:
    return run.json("decode", "widget", *arguments)


def row(data: Any, path: str) -> Any:
    return next(row for row in (*data["rows"], *data["registers"]) if row["path"] == path)


@pytest.mark.parametrize(
    ("device", "frame", "cells"),
    [
        (
            "tc100",
            "01 06 20 1E 00 03 A2 0D",
            ["write_register", "0x201E", "motion_command", "homing", "right", "8.2 L1624", "rtu-homing"],
        ),
        (
            "esc11",
            "09 00 16 D0 07 00 00 32 28",
            ["move_relative", "distance", "D0 07 00 00", "2000", "20.00 mm", "50 %", "right", "10.1 L1164"],
        ),
    ],
)
def test_the_frames_of_the_readme_explain_themselves(
    device: str, frame: str, cells: list[str], capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    result = CommandLine(capsys, monkeypatch, SPECS)("decode", device, frame)
    assert (result.code, result.err) == (0, "")
    assert [cell for cell in cells if cell not in result.out] == []


@pytest.mark.parametrize("example", [e for e in EXAMPLES.values() if not e.refused], ids=lambda e: e.id)
def test_every_good_example_is_explained_with_exit_code_0(run: CommandLine, example: Example) -> None:
    request = ["--request", EXAMPLES[example.reply_to].frame.hex()] if example.reply_to else []
    result = run("decode", "widget", example.frame.hex(), "--direction", example.direction, *request)
    assert (result.code, result.err) == (0, "")
    assert example.message in result.lines[0]
    data = decoded(run, example.frame.hex(), "--direction", example.direction, *request)
    assert (data["link"], data["direction"], data["error"]) == (
        example.link,
        example.direction,
        example.exception_response,
    )
    assert b"".join(bytes.fromhex(part["raw"]) for part in data["rows"] if part["kind"] != "mark")
    assert data["wrong"] is False


OF_FRAMES = ("unknown_code", "wrong_checksum", "wrong_length", "incomplete")
"""Refusals that show without the link and the message."""


@pytest.mark.parametrize("example", [e for e in EXAMPLES.values() if e.refused in OF_FRAMES], ids=lambda e: e.id)
def test_every_example_that_is_refused_is_explained_with_exit_code_1(run: CommandLine, example: Example) -> None:
    result = run("decode", "widget", example.frame.hex(), "--direction", example.direction)
    assert result.code == 1
    assert "this is not a valid frame of widget" in result.out
    assert any(line.startswith("wrong: ") for line in result.lines)
    assert example.refused in decoded(run, example.frame.hex(), "--direction", example.direction)["reasons"]


@pytest.mark.parametrize(
    "example", [e for e in EXAMPLES.values() if e.refused and e.refused not in OF_FRAMES], ids=lambda e: e.id
)
def test_what_is_refused_in_a_message_is_explained_for_that_message(run: CommandLine, example: Example) -> None:
    options = ["--link", example.link, "--direction", example.direction, "--message", example.message]
    assert run("decode", "widget", example.frame.hex(), *options).code == 1
    assert example.refused in decoded(run, example.frame.hex(), *options)["reasons"]


def test_the_table_has_every_byte_in_aligned_columns(run: CommandLine) -> None:
    lines = run("decode", "widget", WRITE, "--direction", "request").lines
    heading = next(line for line in lines if line.startswith("at"))
    column = heading.index("bytes")
    table = lines[lines.index(heading) + 1 :][:5]
    assert " ".join(line[column : column + 5].strip() for line in table) == WRITE


def test_bytes_may_be_several_arguments_and_options_stand_between_them(run: CommandLine) -> None:
    result = run("decode", "widget", *READ.split()[:3], "--link", "rtu", *READ.split()[3:])
    assert result == run("decode", "widget", READ)


@pytest.mark.parametrize(
    ("frame", "options", "chosen", "number"),
    [
        (READ, [], "only", 1),
        (WRITE, [], "likeliest", 2),
        (WRITE, ["--direction", "response"], "only", 1),
        (f"RX: {WRITE}", [], "mark", 2),
        (ANSWER, ["--request", READ], "request", 1),
        (STOP, ["--message", "stop", "--direction", "request"], "only", 1),
        ("01 03 10 00 00 02 C0 CC", [], "closest", 0),
    ],
)
def test_json_says_how_the_reading_was_found(
    run: CommandLine, frame: str, options: list[str], chosen: str, number: int
) -> None:
    data = decoded(run, frame, *options)
    assert (data["chosen"], len(data["readings"])) == (chosen, number)


def test_a_frame_that_is_equal_in_both_directions_is_ambiguous(run: CommandLine) -> None:
    result = run("decode", "widget", WRITE)
    assert result.code == 0
    assert result.lines[1] == (
        "ambiguous: explained as the request of write_register, "
        "it may also be the response to write_register; --direction tells"
    )


def test_a_response_that_does_not_say_what_it_answers_is_ambiguous(run: CommandLine) -> None:
    result = run("decode", "widget", STOPPED, "--direction", "response")
    assert result.lines[0] == "response, packet, Widget 2.0"
    assert result.lines[1].startswith("ambiguous: explained as the response to stop, it may also be a response to one")
    assert result.lines[1].endswith("; --request or --message tells")
    assert "ambiguous" not in run("decode", "widget", STOPPED, "--message", "stop").out
    assert run("decode", "widget", STOPPED, "--request", STOP).lines[0] == "stop response, packet, Widget 2.0: 停止"


def test_the_request_gives_a_response_its_registers(run: CommandLine) -> None:
    assert decoded(run, ANSWER)["registers"] == []
    data = decoded(run, ANSWER, "--request", READ)
    assert [(register["address"], register["path"], register["raw"]) for register in data["registers"]] == [
        (0x1000, "status_word", "1234"),
        (0x1001, None, "FFFF"),
    ]


@pytest.mark.parametrize(
    ("frame", "request_frame", "message"),
    [
        (ANSWER, "01 03 10 00 00 03 01 0B", "the request asks for 3 words, but the response has 2"),
        (ANSWER, "02 03 10 00 00 02 C0 F8", "station is 1, but 2 in the request"),
        ("01 06 20 00 00 06 02 08", WRITE, "value does not repeat the request: should be 5"),
    ],
)
def test_a_response_that_does_not_fit_its_request_is_wrong(
    run: CommandLine, frame: str, request_frame: str, message: str
) -> None:
    result = run("decode", "widget", frame, "--request", request_frame)
    assert result.code == 1
    assert message in result.lines


def test_a_wrong_checksum_is_shown_with_the_right_one(run: CommandLine) -> None:
    assert "wrong: crc at byte 6: should be C0 CB" in run("decode", "widget", "01 03 10 00 00 02 C0 CC").lines


def test_a_value_beyond_the_manual_is_doubtful_and_not_wrong(run: CommandLine) -> None:
    result = run("decode", "widget", "00 07 07 01 23 06 38", "--direction", "request")
    assert result.code == 0
    assert "doubtful: count at byte 5: should be 0..5" in result.lines


def test_a_doubtful_value_fails_where_that_is_asked_for(run: CommandLine) -> None:
    result = run("decode", "widget", "00 07 07 01 23 06 38", "--direction", "request", "--strict")
    assert result.code == 1
    assert "doubtful: count at byte 5: should be 0..5" in result.lines


def test_a_frame_without_doubtful_values_passes_where_they_fail(run: CommandLine) -> None:
    assert run("decode", "widget", r":010310000002EA", "--strict").code == 0


def test_a_log_with_a_doubtful_value_fails_where_that_is_asked_for(run: CommandLine) -> None:
    line = b"00 07 07 01 23 06 38\n"
    assert run("decode", "widget", "--direction", "request", stdin=line).code == 0
    assert run("decode", "widget", "--direction", "request", "--strict", stdin=line).code == 1


def test_tables_have_their_doubtful_values_and_do_not_fail_on_them(run: CommandLine) -> None:
    result = run("decode", "widget", "log.txt", "--to", "csv", "--out", "tables", "--strict")
    assert (result.code, "--strict goes without --to" in result.err) == (2, True)


def test_a_frame_of_characters_shows_them_beside_their_bytes(run: CommandLine) -> None:
    result = run("decode", "widget", r":010310000002EA")
    assert result.code == 0
    assert "CR LF is missing at the end of the text and is assumed to have been sent" in result.lines
    assert any(line.split()[:4] == ["5", "1000", "10", "00"] for line in result.lines)


def test_elements_of_a_list_without_labels_share_a_line(run: CommandLine) -> None:
    result = run("decode", "widget", "00 0B 07 01 22 00 03 01 02 03 3E")
    assert any("data[0..2]" in line and "1 2 3" in line for line in result.lines)


def test_set_bits_have_a_line_each(run: CommandLine) -> None:
    lines = run("decode", "widget", STOPPED, "--message", "stop", "--direction", "response").lines
    at = next(number for number, line in enumerate(lines) if "bit 0 busy" in line)
    assert lines[at + 1].strip() == "bit 6 refused"


def test_a_misprint_of_the_manual_is_recognised(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    result = CommandLine(capsys, monkeypatch, SPECS)("decode", "esc11", "05 00 31 01 17")
    assert result.code == 1
    assert any("the manual prints this for 05 00 31 01 37" in line for line in result.lines)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["decode", "widgett", READ], "there is no device widgett; did you mean widget?"),
        (["decode", "widget@9", READ], "there is no version of widget 9"),
        (["decode", "widget", "hello"], "this is not a frame: there are no bytes in it"),
        (["decode", "widget", "01 0"], "this is not a frame: at byte 1, `0` is one digit of two"),
        (["decode", "widget", "01 06 xx"], "this is not a frame: `xx` is not a byte in hexadecimal digits"),
        (["decode", "widget", "# 01"], "this is not a frame: it has no bytes"),
        (["decode", "widget", READ, "--link", "rto"], "there is no link rto; did you mean rtu?"),
        (["decode", "widget", READ, "--message", "stopp"], "there is no message stopp; did you mean stop?"),
        (["decode", "widget", ANSWER, "--request", "zz"], "this is not a frame: there are no bytes in it"),
        (["decode", "widget", ANSWER, "--request", ANSWER], "--request is not a valid request of widget: "),
        (["decode", "widget", ANSWER, "--request", READ, "--direction", "request"], "--direction cannot be request"),
        (["decode", "widget", READ, "--direction", "up"], "there is no direction up; choose from request, response"),
        (
            ["decode", "widget", READ, "--format", "xml"],
            "there is no value of --format xml; choose from json, text; see: fieldspec decode",
        ),
        (["decode"], "the following arguments are required: DEVICE[@VERSION]"),
    ],
)
def test_wrong_use_says_what_is_wrong(run: CommandLine, arguments: list[str], message: str) -> None:
    result = run(*arguments)
    assert (result.code, result.out) == (2, "")
    assert result.err.startswith("fieldspec: ")
    assert message in result.err


def test_a_version_is_decoded_by_its_own_facts(run: CommandLine) -> None:
    frame = "00 09 00 09 33 02 FF FF 45"
    assert run("decode", "widget@2.0", frame, "--direction", "request").code == 0
    old = run("decode", "widget@before-2.0", frame, "--direction", "request")
    assert old.code == 1
    assert "wrong: command at byte 4: should be one of" in old.out


def test_json_has_every_key_of_every_row_and_null_for_what_is_absent(run: CommandLine) -> None:
    data = decoded(run, EXAMPLES["nest-request"].frame.hex())
    assert {frozenset(row_data) for row_data in data["rows"]} == {frozenset(data["rows"][0])}
    assert row(data, "nest.origin.x")["number"] == -1000
    assert row(data, "nest.origin.x")["value"] == "-100.0 mm"
    assert row(data, "nest.origin.x")["label"] is None
    assert row(data, "nest.filling")["number"] == "0000"
    meaning = row(data, "nest.words[1]")["meanings"][1]
    assert meaning == {"name": "level=high", "label": None, "text": None, "bits": "4..5"}


def test_json_writes_numbers_that_json_lacks_as_text(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    run = CommandLine(capsys, monkeypatch, TEST_SPECS)
    (link,) = codec(newest(TEST_SPECS, "gizmo")).links.values()
    values = {"station": 1, "word": 1, "wide": 1, "ratio": float("nan"), "turned": 1, "values": [1]}
    frame = link.encode("request", "mix", values).hex()
    assert row(run.json("decode", "gizmo", frame), "ratio")["number"] == "nan"


LAZY = {
    "construct",
    "jinja2",
    "rich",
    "shtab",
    "fieldspec.language.checks.table",
    "fieldspec.targets",
    "fieldspec.codec.reference",
}


def test_decoding_a_frame_imports_nothing_that_it_does_not_use() -> None:
    code = (
        "import sys; from fieldspec.cli import main; "
        f"main(['decode', 'widget', '{READ}', '--specs', {str(TEST_SPECS)!r}]); print(*sys.modules)"
    )
    for _ in range(2):  # the first one judges the spec, and caches the layout
        ran = subprocess.run([sys.executable, "-c", code], capture_output=True, check=True, encoding="utf-8")
    assert LAZY & set(ran.stdout.splitlines()[-1].split()) == set()


@pytest.mark.parametrize("name", ["widget", "ck10", "esc11", "hiwin-e", "tc100"])
def test_a_frame_of_an_example_is_explained_as_an_example(name: str) -> None:
    layout = newest(TEST_SPECS if name == "widget" else SPECS, name)
    good = [example for example in layout.device.examples.values() if not example.refused]
    readings = {(e.frame, e.link, e.direction, e.message, e.exception_response) for e in good}
    for example in good:
        explanation = read_frame(layout, example.frame, FrameOptions()).explanation
        assert (
            explanation.frame,
            explanation.link,
            explanation.direction,
            explanation.message,
            explanation.error,
        ) in readings, example.id
