"""Messages that only the device sends, of its own accord."""

from __future__ import annotations

from pathlib import Path

import pytest

from command_line import CommandLine
from fieldspec.codec.reference.frames import codec
from fieldspec.codec.reference.records import CodecError
from fieldspec.tools.live.client import Client, Timing
from layouts import TEST_SPECS, newest
from python_package import codec_error, module_of
from test_client_parts import Line

SCANNER = newest(TEST_SPECS, "scanner")
MODULE = module_of(SCANNER)
READ = "06 02 05 20 03 01 2C 41 42 43 31 32 33 B1"
STATE = "06 02 05 10 07 1C"


class Burst(Line):
    """A line that brings all frames after the first request."""

    def write(self, data: bytes) -> None:
        """Takes a request."""
        self.due, self.answers = self.answers[::-1], []


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> CommandLine:
    return CommandLine(capsys, monkeypatch, TEST_SPECS)


def test_python_has_no_request_for_it() -> None:
    frame = MODULE.host.decode_response(bytes.fromhex(READ))
    assert (frame.message.distance, frame.message.text) == (300, "ABC123")
    assert MODULE.host.encode_response(5, frame.message) == bytes.fromhex(READ)
    assert not hasattr(MODULE, "GoodReadRequest")


def test_python_takes_its_name_in_place_of_a_request() -> None:
    frame = bytes.fromhex(READ)
    assert MODULE.host.decode_response(frame, "good_read") == MODULE.host.decode_response(frame)
    with pytest.raises(codec_error(), match="the code 0x10 answers another request") as refusal:
        MODULE.host.decode_response(bytes.fromhex(STATE), "good_read")
    assert getattr(refusal.value, "reason", "") == "unknown_code"
    with pytest.raises(codec_error(), match="no message here is 'read_state'"):
        MODULE.host.decode_response(frame, "read_state")


def test_its_code_is_none_of_a_request() -> None:
    with pytest.raises(CodecError, match="no message has the code 0x20"):
        codec(SCANNER).links["host"].decode(bytes.fromhex("01 05 20 25 0D"), "request")
    with pytest.raises(CodecError, match="only the device sends good_read"):
        codec(SCANNER).links["host"].encode("request", "good_read", {"station": 5})


def test_it_is_no_answer_to_a_request() -> None:
    client = Client(SCANNER, "host", Burst(READ, STATE), 5, Timing(timeout=0.01, retries=1))
    assert client.ask("read_state", {}).values["state"] == 7
    with pytest.raises(CodecError, match="only the device sends"):
        client.ask("good_read", {})


def test_what_arrives_is_explained_as_no_response(run: CommandLine) -> None:
    result = run("decode", "scanner", READ)
    assert result.code == 0
    assert "A label has been read" in result.out


def test_a_frame_of_another_length_is_one_from_the_device(run: CommandLine) -> None:
    assert (
        "the data of the frame have 2 bytes; node_heartbeat response has 1"
        in run("decode", "node", "--link", "heartbeat", "00000701 02000000 0500").lines
    )
    named = run("decode", "node", "--message", "node_heartbeat", "00000701 02000000 0500")
    assert named.lines[0].startswith("node_heartbeat response, heartbeat")


def test_the_command_line_sends_none(run: CommandLine) -> None:
    result = run("encode", "scanner", "good_read", "--link", "host")
    assert result.code == 2
    assert "only the device sends good_read; use: --direction response" in result.err


ENGINE = """
device:
  id: engine
  name: Engine
  vendor: Test
  manual: {title: m, file: m.txt, sha256: "%s", lines: 900}
links:
  - name: bus
    source: 1 L1
    byte_order: little
    can: {identifier: 29, source: 1 L1}
    response: &parts
      - {name: priority, type: u8, bits: 26..28}
      - {name: group, role: code, type: u24, bits: 8..25}
      - {name: station, type: u8, bits: 0..7}
      - {name: data, role: body}
    request: *parts
messages:
  - {name: speed, code: 0xF004, requested: false, source: 1 L2, response: [{name: speed, type: u16}]}
""" % ("1" * 64)
SPEED = "(1612345678.0) can0 0CF00400#2110"
OTHER = "(1612345678.1) can0 18EAFF00#04F0"


@pytest.fixture
def engine(run: CommandLine, tmp_path: Path) -> CommandLine:
    """The command line with a device that nobody asks anything."""
    (tmp_path / "engine").mkdir()
    (tmp_path / "engine" / "device.yaml").write_text(ENGINE, "utf-8")
    run.folder = tmp_path
    return run


def test_an_unknown_frame_of_a_bus_without_requests_is_one_from_the_device(engine: CommandLine) -> None:
    result = engine("decode", "engine", "-", stdin=f"{OTHER}\n{SPEED}\n".encode())
    assert "line 1: unknown response, bus, Engine 1" in result.lines
    assert "wrong: group in the identifier: should be one of 0xF004" in result.lines
    assert "does not answer" not in result.out


def test_a_frame_that_is_said_to_be_a_request_is_told_that_there_is_none(engine: CommandLine) -> None:
    result = engine("decode", "engine", "--direction", "request", "98EAFF000200000004F0")
    assert (
        result.lines[-1] == "wrong: group in the identifier: should be that of a message, and none has a request here"
    )


def test_what_comes_between_a_request_and_its_response_is_not_called_a_wrong_answer(run: CommandLine) -> None:
    question = codec(SCANNER).links["host"].encode("request", "read_state", {"station": 5}).hex()
    result = run("decode", "scanner", "-", stdin=f"< {question}\n> {READ}\n".encode())
    assert "good_read" in result.out
    assert "does not answer" not in result.out
