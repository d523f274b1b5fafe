"""`decode` of bytes that are not a valid frame says why: checksum, position, version. Errata are those of the link."""

from __future__ import annotations

import io
from pathlib import Path

import pytest

from fieldspec.cli import main

SPECS = str(Path(__file__).resolve().parent.parent / "specs")
READ = "01 03 10 00 00 01 80 CA"
"""An example of the manual, 8.4 L1843."""
NEWER = "04 00 4E 52"
"""An example of the manual of the ESC11, 9.3.10 L877, of a command that works from 1.17 on."""


def decoded(capsys: pytest.CaptureFixture[str], device: str, frame: str, *options: str) -> str:
    main(["decode", device, frame, *options, "--specs", SPECS])
    return capsys.readouterr().out


@pytest.mark.parametrize(
    ("device", "frame", "expected"),
    [
        (
            "tc100",
            "01 03 10 00 00 01",
            f"the checksum is missing: with crc 80 CA, this is a valid read_registers request on rtu: {READ}",
        ),
        (
            "tc100",
            ":010310000001\\r\\n",
            "the checksum is missing: with lrc EB, this is a valid read_registers request",
        ),
        ("tc100", f"00 {READ}", "bytes 1..8 are a valid read_registers request on rtu, with 1 before it: " + READ),
        ("tc100", f"{READ} 00", "bytes 0..7 are a valid read_registers request on rtu, with 1 after it: " + READ),
        (
            "tc100",
            f"FF 00 {READ} 00",
            "bytes 2..9 are a valid read_registers request on rtu, with 2 before and 1 after",
        ),
    ],
)
def test_bytes_that_are_not_a_frame_have_a_reason(
    capsys: pytest.CaptureFixture[str], device: str, frame: str, expected: str
) -> None:
    assert expected in decoded(capsys, device, frame)


def test_a_frame_among_other_bytes_is_explained_and_the_other_bytes_are_not(capsys: pytest.CaptureFixture[str]) -> None:
    frame = decoded(capsys, "tc100", READ).splitlines()
    lines = decoded(capsys, "tc100", f"FF 00 {READ} 00").splitlines()
    assert [line for line in lines if not line.startswith("bytes 2..9")] == frame


def test_each_of_two_joined_frames_is_explained(capsys: pytest.CaptureFixture[str]) -> None:
    text = decoded(capsys, "tc100", f"{READ} {READ}")
    assert text.count("read_registers request, rtu, ") == 2


def test_bytes_around_a_frame_are_a_finding() -> None:
    assert main(["decode", "tc100", f"{READ} 00", "--specs", SPECS]) == 1


def test_a_response_among_other_bytes_of_a_log_answers_the_request_before_it(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    log = f"FF {READ}\nFF 01 03 02 12 34 B5 33\n"
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(log.encode())))
    assert main(["decode", "tc100", "--specs", SPECS]) == 1
    assert "this answers the request in line 1" in capsys.readouterr().out


def test_errata_about_another_link_are_not_printed_with_a_frame(capsys: pytest.CaptureFixture[str]) -> None:
    text = decoded(capsys, "tc100", READ)
    assert "erratum rtu-read-word-count" in text
    assert "erratum ascii-read-word-count-digits" not in text
    assert "2 more errata about this message or other links; print them with --errata" in text


def test_all_errata_are_printed_on_request(capsys: pytest.CaptureFixture[str]) -> None:
    text = decoded(capsys, "tc100", READ, "--errata")
    assert "erratum ascii-read-word-count-digits" in text
    assert "erratum rtu-line" in text
    assert "--errata" not in text


def test_a_frame_of_another_version_is_said_to_be_one(capsys: pytest.CaptureFixture[str]) -> None:
    text = decoded(capsys, "esc11@before-1.17", NEWER, "--direction", "request")
    assert "version 1.17 reads it as a valid reset_alarm request on serial: fieldspec decode esc11@1.17 0400" in text
