"""`decode` and `encode` use a device's own terms for messages and directions, and explain process data."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

import pytest

from command_line import TEST_SPECS, CommandLine
from fieldspec.cli import main
from fieldspec.command.verbs.completion import suggest
from fieldspec.language.model.texts import Example
from layouts import newest
from test_cli_encode import arguments_of

EXAMPLES = newest(TEST_SPECS, "glider-x").device.examples
RECEIVED = "F0 03 20 00 00 00"
POSITION = "04 01 FF FF FF FE 00 00 05 DC 20 00 00 00"
READ = "07 01 00 01 23 17 00 00"
ANSWER = "07 01 00 06 01 0B B8"


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> CommandLine:
    return CommandLine(capsys, monkeypatch, TEST_SPECS)


def decoded(run: CommandLine, *arguments: str) -> Any:
    return run.json("decode", "glider-x", *arguments)


def cells(run: CommandLine, *arguments: str) -> list[str]:
    """The lines of an explanation, with runs of blanks replaced by one."""
    return [" ".join(line.split()) for line in run("decode", "glider-x", *arguments).lines]


@pytest.mark.parametrize("example", EXAMPLES.values(), ids=lambda example: example.id)
def test_every_example_is_explained_by_its_message_and_direction(run: CommandLine, example: Example) -> None:
    request = ["--request", EXAMPLES[example.reply_to].frame.hex()] if example.reply_to else []
    options = ["--message", example.message, "--direction", example.direction, *request]
    result = run("decode", "glider-x", example.frame.hex(), *options)
    assert (result.code, result.err) == (0, "")
    assert "ambiguous" not in result.out


@pytest.mark.parametrize(
    "example", [e for e in EXAMPLES.values() if not e.exception_response], ids=lambda example: example.id
)
def test_every_example_is_written_from_its_values(run: CommandLine, example: Example) -> None:
    link = newest(TEST_SPECS, "glider-x").device.links[example.link]
    options = [f"--{link.message_name}", example.message, "--direction", link.direction_name(example.direction)]
    values = {name: value for name, value in example.values.items() if name != "order"}
    result = run("encode", "glider-x", *options, *arguments_of(values))
    assert (result.code, result.err) == (0, "")
    assert bytes.fromhex(result.lines[0]) == example.frame


@pytest.mark.parametrize(
    "options",
    [
        ["--telegram", "3", "--direction", "received"],
        ["--telegram=3", "--direction=received"],
        ["--telegram", "telegram_3", "--direction", "request"],
        ["--message", "3", "--direction", "received"],
        ["--message", "telegram_3", "--direction", "received", "--link", "cyclic"],
        ["--message", "0x3", "--direction", "received"],
        ["--direction", "received"],
    ],
    ids=" ".join,
)
def test_a_telegram_is_named_in_the_terms_of_the_device(run: CommandLine, options: list[str]) -> None:
    data = decoded(run, RECEIVED, *options)
    assert (data["link"], data["direction"], data["direction_name"]) == ("cyclic", "request", "received")
    assert (data["message"], data["chosen"], data["wrong"]) == ("telegram_3", "only", False)


def test_the_title_uses_the_terms_of_the_device(run: CommandLine) -> None:
    result = run("decode", "glider-x", RECEIVED, "--telegram", "3", "--direction", "sent")
    assert result.lines[0] == "telegram_3 sent, cyclic, Glider X 1.1: Speed"


def test_options_may_stand_before_the_bytes(run: CommandLine) -> None:
    first = run("decode", "glider-x", "--telegram", "3", "--direction", "received", *RECEIVED.split())
    assert first == run("decode", "glider-x", RECEIVED, "--telegram", "3", "--direction", "received")


def test_the_number_of_a_coded_message_is_its_code(run: CommandLine) -> None:
    assert decoded(run, READ, "--message", "1")["message"] == "read_parameter"


def test_frames_without_a_code_are_told_apart_by_length(run: CommandLine) -> None:
    assert decoded(run, POSITION)["message"] == "telegram_11"
    assert decoded(run, POSITION)["chosen"] == "only"
    assert run("decode", "glider-x", RECEIVED).lines[1] == (
        "ambiguous: 6 bytes may be telegram_3 received or telegram_3 sent; --direction tells"
    )


def test_a_frame_of_no_known_length_is_reported_with_the_known_lengths(run: CommandLine) -> None:
    result = run("decode", "glider-x", "F0 03 20", "--link", "cyclic", "--direction", "received")
    assert result.code == 1
    assert result.lines[2] == (
        "the frame has 3 bytes; telegram_3 received has 6, telegram_11 received has 14, telegram_70 received has 2"
    )


def test_a_frame_of_another_length_than_the_telegram_is_wrong(run: CommandLine) -> None:
    result = run("decode", "glider-x", RECEIVED, "--telegram", "11", "--direction", "received")
    assert result.code == 1
    assert "the frame has 6 bytes; telegram_11 received has 14" in result.lines
    assert "wrong: gain at byte 6: 8 bytes are missing for gain, torque_reduction, spare" in result.lines


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--telegram", "4"], "there is no telegram 4; choose from 3, 11, 70"),
        (["--telegram", "telegram_4"], "there is no telegram telegram_4; did you mean telegram_3?"),
        (["--telegramm", "3"], "there is no option --telegramm; did you mean --telegram?"),
        (
            ["--verbose"],
            "there is no option --verbose; choose from --direction, --format, --link, --message, --telegram",
        ),
        (["--telegram"], "--telegram needs a name or a number"),
        (["--telegram", "3", "--message", "3"], "--message and --telegram both name the message"),
        (["--telegram", "read_parameter"], "read_parameter is not sent on cyclic, but on channel"),
        (["--link", "channel", "--telegram", "3"], "channel has no telegram; what it sends is called message"),
        (["--link", "channel", "--message", "telegram_3"], "telegram_3 is not sent on channel, but on cyclic"),
        (
            ["--link", "channel", "--direction", "sent"],
            "sent is a direction of cyclic; channel has request and response",
        ),
        (
            ["--message", "read_parameter", "--direction", "sent"],
            "sent is a direction of cyclic; channel has request and",
        ),
        (
            ["--telegram", "3", "--direction", "up"],
            "there is no direction up; choose from received, request, response, ",
        ),
        (["--request", READ, "--direction", "received"], "so --direction cannot be received"),
    ],
    ids=lambda part: part if isinstance(part, str) else " ".join(part),
)
def test_an_unknown_telegram_or_direction_is_wrong_use(run: CommandLine, arguments: list[str], message: str) -> None:
    result = run("decode", "glider-x", RECEIVED, *arguments)
    assert (result.code, result.out) == (2, "")
    assert message in result.err


def test_a_device_without_such_words_has_no_such_option(run: CommandLine) -> None:
    result = run("decode", "widget", "00 06 20 00 20 46", "--telegram", "3")
    assert (result.code, result.out) == (2, "")
    assert "there is no option --telegram" in result.err


def test_a_telegram_of_a_later_version_is_unknown_to_an_earlier_one(run: CommandLine) -> None:
    assert run("decode", "glider-x", "20 00", "--telegram", "70").code == 0
    result = run("decode", "glider-x@1.0", "20 00", "--telegram", "70")
    assert (result.code, result.err) == (2, "fieldspec: there is no telegram 70; choose from 3, 11\n")


def test_words_values_and_their_reference_values_are_explained(run: CommandLine) -> None:
    rows = cells(run, POSITION, "--telegram", "11", "--direction", "received")
    assert "0 04 01 control CTL 0x0401 bit 0 on 2 L27" in rows
    assert "bits 9..10 path=negative" in rows
    assert "2 FF FF FF FE target TPOS -2 -2 control unit 2 L28" in rows
    assert "6 00 00 05 DC gain KP 1500 1.500 1/s 2 L29" in rows
    assert "10 20 00 torque_reduction MRED 8192 50 % output_torque: 50 % of Pt42A 2 L30" in rows


def test_the_state_in_a_status_word_is_named(run: CommandLine) -> None:
    assert "state: inhibited (S1)" in run("decode", "glider-x", "00 40 00 00 00 00", "--direction", "sent").out
    assert "state: running (S2)" in run("decode", "glider-x", "00 03 00 00 00 00", "--direction", "sent").out
    assert "state" not in run("decode", "glider-x", "00 01 00 00 00 00", "--direction", "sent").out


def test_a_bit_that_acts_at_an_edge_says_so(run: CommandLine) -> None:
    assert "bit 7 acknowledge: acts at its rising edge" in run("decode", "glider-x", "00 80 00 00 00 00").out


@pytest.mark.parametrize(
    ("number", "message"),
    [
        ("23 17", "0x2317 reference_speed: parameter Pt317"),
        ("21 00", "0x2100 servo: parameter Pt100"),
        ("41 02", "0x4102 unused: parameter Ut102"),
        ("03 C4", "964 identification: parameter 964"),
        ("30 00", "0x3000 3 L38"),
    ],
)
def test_the_number_of_a_parameter_is_named_as_the_manual_writes_it(
    run: CommandLine, number: str, message: str
) -> None:
    assert any(message in line for line in cells(run, f"07 01 00 01 {number} 00 00"))


def test_the_request_says_which_parameter_a_response_holds(run: CommandLine) -> None:
    assert "5 0B B8 values[0] 3000 3 L38" in cells(run, ANSWER)
    named = "5 0B B8 values[0] 3000 3000 rpm reference_speed: parameter Pt317 8 L68"
    assert named in cells(run, ANSWER, "--request", READ)


@pytest.mark.parametrize(
    ("request_frame", "answer", "message"),
    [
        ("07 01 00 02 03 C4 00 00", "06 02 0A AA 00 01", "identification.firmware: parameter 964[1]"),
        ("07 01 00 02 03 C4 00 00", "06 02 0A AB 00 01", "note on values[0]: It should be 2730."),
        ("07 01 00 01 03 C4 00 03", "06 01 00 00", "identification: parameter 964[3]"),
        ("07 01 00 01 03 B1 00 07", "06 01 0E E0", "fault_codes: parameter 945[7]"),
        ("07 01 00 01 40 95 00 00", "06 01 00 24", "alarm_code: parameter Ut095"),
        ("07 01 00 01 24 2A 00 00", "06 01 0B B8", "3.000 Nm"),
        ("07 01 00 01 24 2A 00 00", "04 01 00 00 0B B8", "3.000 Nm"),
        ("07 01 00 01 24 2A 00 00", "08 01 3F C0 00 00", "1.5"),
        ("07 01 00 01 21 00 00 00", "06 01 00 01", "servo: parameter Pt100"),
    ],
)
def test_a_value_is_read_as_the_element_of_the_parameter(
    run: CommandLine, request_frame: str, answer: str, message: str
) -> None:
    result = run("decode", "glider-x", f"07 01 00 {answer}", "--request", request_frame)
    assert message in result.out
    assert result.code == 0


def test_a_value_that_its_format_does_not_have_stays_wrong(run: CommandLine) -> None:
    result = run("decode", "glider-x", "07 01 00 01 01 02", "--request", READ)
    assert result.code == 1
    assert "wrong: values[0] at byte 5: should be 0 or 1" in result.lines


def test_values_of_unknown_type_stay_undecoded(run: CommandLine) -> None:
    result = run("decode", "glider-x", "07 01 00 03 01 00 00", "--link", "channel", "--direction", "response")
    assert result.code == 1
    assert "wrong: format at byte 3: should be one of 1, 2, 4, 6, 8, 66" in result.lines
    assert "wrong: values at byte 5: format 3 does not decide the type of values" in result.lines


@pytest.mark.parametrize(
    ("line", "chosen"),
    [(f"TX: {RECEIVED}", "mark"), (f"received: {RECEIVED}", "likeliest"), (f"Sent: {RECEIVED}", "likeliest")],
)
def test_a_direction_in_a_log_that_the_device_uses_the_other_way_round_is_ignored(
    run: CommandLine, line: str, chosen: str
) -> None:
    (log_line,) = run("decode", "glider-x", "-", "--format", "json", stdin=line.encode()).lines
    assert f'"chosen": "{chosen}"' in log_line


@pytest.mark.parametrize(
    ("arguments", "frame"),
    [
        (["--telegram", "3", "control=on,no_off2,sign_of_life=15", "speed_setpoint=50 %"], RECEIVED),
        (["--telegram", "3", "CTL=0xF003", "nset=50%"], RECEIVED),
        (["3", "control=0xF003", "speed_setpoint=536870912"], RECEIVED),
        (["telegram_3", "--direction", "sent", "status=ready", "speed_actual=-50 %"], "00 01 E0 00 00 00"),
        (["read_parameter", "reference=7", "element_count=1", "number=Pt317", "subindex=0"], READ),
        (["read_parameter", "reference=7", "element_count=1", "number=reference_speed", "subindex=0"], READ),
        (["1", "reference=7", "element_count=1", "number=pt100", "subindex=0"], "07 01 00 01 21 00 00 00"),
        (["read_parameter", "--direction", "response", "reference=7", "format=unsigned16", "values=3000"], ANSWER),
        (
            ["write_parameter", "reference=8", "number=Pt42A", "format=floating", "values=1.5"],
            EXAMPLES["write-request"],
        ),
    ],
)
def test_a_telegram_is_written_from_names_and_units(
    run: CommandLine, arguments: list[str], frame: str | Example
) -> None:
    result = run("encode", "glider-x", *arguments)
    assert (result.code, result.err) == (0, "")
    assert result.lines == [frame if isinstance(frame, str) else frame.frame.hex(" ").upper()]


def test_a_percentage_that_is_no_whole_count_is_rounded_with_a_note(run: CommandLine) -> None:
    result = run("encode", "glider-x", "3", "control=0", "speed_setpoint=10 %")
    assert (result.code, result.lines) == (0, ["00 00 06 66 66 66"])
    assert result.err == (
        "fieldspec: speed_setpoint: 10 % is 107374182.4 counts; 107374182 is sent, which is 9.99999996 %\n"
    )


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--telegram", "4"], "there is no telegram 4; choose from 3, 11, 70"),
        (["--telegram", "3", "control=0"], "speed_setpoint is not given; telegram_3 received has the fields control, "),
        (["--telegram", "3", "--direction", "request", "speed=1"], "there is no field speed"),
        (["--telegram", "3", "control=1", "CTL=2"], "CTL and control are the same field"),
        (
            ["--telegram", "3", "control=of"],
            "`of` is not a bit of control_word: on, no_off2, acknowledge, sign_of_life",
        ),
        (["--telegram", "3", "control=sign_of_life=16"], "16 does not fit the 4 bits of sign_of_life"),
        (["--telegram", "3", "control=0", "speed_setpoint=250 %"], "out_of_range"),
        (
            ["--telegram", "3", "control=0", "speed_setpoint=50 rpm"],
            "`50 rpm` is not a number; give a count, or with its",
        ),
        (
            ["11", "control=0", "target=0", "gain=1.5 1/s", "torque_reduction=101 %"],
            "out_of_range: torque_reduction is",
        ),
        (["read_parameter", "--direction", "response", "reference=1", "values=1"], "it decides what values holds"),
        (["read_parameter", "--direction", "sent"], "sent is a direction of cyclic; channel has request and response"),
    ],
)
def test_what_cannot_be_written_is_wrong_use(run: CommandLine, arguments: list[str], message: str) -> None:
    result = run("encode", "glider-x", *arguments)
    assert (result.code, result.out) == (2, "")
    assert message in result.err


@pytest.mark.parametrize("verb", ["decode", "encode"])
def test_the_help_uses_the_terms_of_the_device(
    verb: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "400")
    with pytest.raises(SystemExit) as left:
        main([verb, "glider-x", "--specs", str(TEST_SPECS), "--help"])
    assert left.value.code == 0
    assert "On cyclic, --telegram is one of 3, 11, 70; --direction is received or sent." in capsys.readouterr().out


@pytest.mark.parametrize("words", [["decode", "--help"], ["decode", "no-such-device", "-h"], ["--help"]], ids=" ".join)
def test_the_help_needs_no_device(words: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as left:
        main(words)
    assert left.value.code == 0
    assert "telegram" not in capsys.readouterr().out


@pytest.mark.parametrize("shell", ["bash", "zsh", "tcsh"])
def test_shells_offer_the_terms_of_the_devices(
    shell: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("FIELDSPEC_SPECS", str(TEST_SPECS))
    assert main(["completion", shell]) == 0
    script = capsys.readouterr().out
    for word in ("telegram", "received", "request"):
        assert word in script


def test_shells_offer_the_verbs_where_there_are_no_specs(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("FIELDSPEC_SPECS", str(tmp_path / "missing"))
    assert main(["completion", "bash"]) == 0
    assert "decode" in capsys.readouterr().out


def test_shells_offer_an_option_for_messages_to_the_verbs_that_take_one(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("FIELDSPEC_SPECS", str(TEST_SPECS))
    parser = argparse.ArgumentParser()
    verbs = parser.add_subparsers()
    for name in ("check", "decode", "encode"):
        verb = verbs.add_parser(name)
        verb.add_argument("--message")
        verb.add_argument("--direction", choices=("request", "response"))
    suggest(parser)
    offered = {
        name: {word for action in verb._actions for word in action.option_strings}
        for name, verb in verbs.choices.items()
    }
    assert "--telegram" in offered["decode"] & offered["encode"]
    assert "--telegram" not in offered["check"]
    choices = {name: verb._option_string_actions["--direction"].choices for name, verb in verbs.choices.items()}
    assert choices["check"] == ("request", "response")
    assert choices["decode"] == choices["encode"]
    first, second, *others = choices["decode"] or ()
    assert (first, second) == ("request", "response")
    assert "received" in others
    assert others == sorted({*others} - {"request", "response"})
