"""Responses with another code than their request, as the outputs and the verbs have them.

The device `ecu` puts such a code into each response. Two of its messages have one code in their responses.
"""

from __future__ import annotations

import json
import subprocess
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from bounded import HANGING
from captures.bulk import Sent, decoded, values, verdicts
from external_tools import require_tool
from fieldspec.cli import main
from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.reference.frames import codec
from fieldspec.codec.reference.records import CodecError
from fieldspec.targets.c.backend import files as c_files
from fieldspec.targets.docs.backend import files as documentation
from fieldspec.targets.iec.backend import files as iec_files
from fieldspec.targets.python.backend import files as python_files
from fieldspec.targets.st.backend import files as st_files
from fieldspec.testing import SimulatedDevice, simulation
from fieldspec.tools.captures.decoding import Choices
from fieldspec.tools.live.client import Client, NoAnswerError, RefusedError, Timing
from js_output.javascript import module_path
from layouts import TEST_SPECS, newest
from python_package import codec_error, module_of
from simulators import Unit, parts_of
from wireshark_output.dissection import Packet, pcap, prefix_of, tshark

SPECS = str(TEST_SPECS)
ECU = newest(TEST_SPECS, "ecu")
MODULE = module_of(ECU)
LINK = codec(ECU).links["datagrams"]
ANSWERED, MISCODED = (bytes.fromhex(text) for text in ("62 01 10 05 DC", "22 01 10 05 DC"))
TEMPERATURES = bytes.fromhex("FA 3C FB")
SILENT = bytes.fromhex("3E 80")


class Once:
    """A carrier on which some datagrams come after a request."""

    datagrams = True

    def __init__(self, *frames: bytes) -> None:
        self.frames: list[bytes] = []
        self.coming = frames

    def write(self, data: bytes) -> None:
        self.frames = list(self.coming)

    def read(self, timeout: float) -> bytes:
        return self.frames.pop(0) if self.frames else b""

    def close(self) -> None:
        """Nothing is open."""


# Codecs and explanations


@pytest.mark.parametrize(
    ("frame", "asked"),
    [(MISCODED, ""), (MISCODED, "read_word"), (bytes.fromhex("6E 01 10"), "read_word"), (SILENT, "")],
)
def test_a_response_with_another_code_is_refused_at_the_code(frame: bytes, asked: str) -> None:
    request = [MODULE.ReadWordRequest] if asked else []
    for decode in (
        lambda: LINK.decode(frame, "response", asked),
        lambda: MODULE.datagrams.decode_response(frame, *request),
    ):
        with pytest.raises((CodecError, codec_error())) as refused:
            decode()
        assert (refused.value.reason, refused.value.offset) == ("unknown_code", 0)
    assert explained(ECU, "datagrams", "response", frame, asked).reasons == ("unknown_code",)


def test_only_the_request_tells_which_of_several_responses_with_one_code_this_is() -> None:
    with pytest.raises(CodecError, match="only the request identifies the message"):
        LINK.decode(TEMPERATURES, "response")
    assert LINK.decode(TEMPERATURES, "response", "read_hours").values == {"hours": 0x3CFB}
    assert MODULE.datagrams.decode_response(TEMPERATURES, MODULE.ReadTemperaturesRequest()).message.bridge == -5
    assert MODULE.datagrams.decode_response(TEMPERATURES, MODULE.ReadHoursRequest()).message.hours == 0x3CFB
    (row, *_) = explained(ECU, "datagrams", "response", TEMPERATURES).rows
    assert "only the request distinguishes them" in row.verdict


@pytest.mark.parametrize(
    ("frame", "request_frame", "expected"),
    [
        ("22 01 10 05 DC", "22 01 10", "service is 0x22, but 0x62 answers read_word"),
        ("22 01 10 05 DC", "22 01 10", "wrong: should be 0x62 with 0x01 at byte 1"),
        ("50 03 00 32 01 F4", "22 01 10", "service is 0x50, but 0x62 answers read_word"),
        ("7F 10 22", "22 01 10", "refused_service does not repeat the request: should be 34"),
        ("62 01 11 00 00", "22 01 10", "identifier does not repeat the request: should be 16"),
        ("FA 12 34", "BB", "4660 h"),
    ],
)
def test_decode_says_which_code_answers_a_request(
    capsys: pytest.CaptureFixture[str], frame: str, request_frame: str, expected: str
) -> None:
    main(["decode", "ecu", frame, "--request", request_frame, "--specs", SPECS])
    assert expected in capsys.readouterr().out


def test_lines_of_a_log_are_read_with_the_requests_before_them(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    log = tmp_path / "log.txt"
    log.write_text("> BA\n< FA 3C FB\n> BB\n< FA 12 34\n> 10 03\n< 7F 10 22\n> 22 01 10\n< 22 01 10 05 DC\n", "utf-8")
    monkeypatch.setattr("sys.stdin", log.open(encoding="utf-8"))
    main(["decode", "ecu", "-", "--specs", SPECS, "--format", "json"])
    explanations = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert [(own["direction"], own["message"], own["error"], own["wrong"]) for own in explanations] == [
        ("request", "read_temperatures", False, False),
        ("response", "read_temperatures", False, False),
        ("request", "read_hours", False, False),
        ("response", "read_hours", False, False),
        ("request", "change_session", False, False),
        ("response", "change_session", True, False),
        ("request", "read_word", False, False),
        ("response", None, False, True),
    ]


# Devices and clients


@pytest.mark.parametrize(
    ("request_frame", "response"),
    [
        ("22 01 00", "62 01 00 0B B8"),
        ("2E 01 10 00 01", "7F 2E 31"),
        ("84 00", "7F 84 11"),
        ("62 01 10", "7F 62 11"),
        ("22 09 10", "7F 22 11"),
        ("3E 00", "7E 00"),
        ("3E 80", ""),
        ("BB", "FA 00 00"),
    ],
)
def test_a_simulated_device_answers_with_the_code_of_the_response(request_frame: str, response: str) -> None:
    unit = Unit("ecu", "datagrams", folder=SPECS)
    assert unit.answer_to(bytes.fromhex(request_frame)).frame == bytes.fromhex(response)


def test_live_takes_the_response_with_its_code_and_no_other() -> None:
    def client(*frames: bytes) -> Client:
        return Client(ECU, "datagrams", Once(*frames), 0, Timing(timeout=0.02, retries=0))

    values = {"identifier": 0x10}
    foreign = [MISCODED, bytes.fromhex("7F 2E 31"), bytes.fromhex("6E 01 10")]
    assert client(*foreign, ANSWERED).ask("read_word", values).values["word"] == 1500
    with pytest.raises(NoAnswerError):
        client(*foreign).ask("read_word", values)
    with pytest.raises(RefusedError, match="request_out_of_range"):
        client(*foreign, bytes.fromhex("7F 22 31")).ask("read_word", values)
    assert client(TEMPERATURES).ask("read_hours", {}).values == {"hours": 0x3CFB}


@pytest.fixture(scope="module")
def device() -> Iterator[SimulatedDevice]:
    with simulation("ecu", ports={"datagrams": "udp://127.0.0.1:0"}, folder=SPECS) as simulated:
        yield simulated


def test_live_reads_and_writes_by_name(device: SimulatedDevice, capsys: pytest.CaptureFixture[str]) -> None:
    def live(*arguments: str) -> int:
        return main(["live", "ecu", *arguments, "--port", device.place, "--timeout", "2", "--specs", SPECS])

    assert live("write", "speed_limit=4000rpm", "target_position=-70000", "--yes") == 0
    capsys.readouterr()
    assert live("read", "speed_limit", "target_position", "read_hours.hours", "--format", "json") == 0
    values = {row["name"]: row["value"] for row in json.loads(capsys.readouterr().out)}
    assert values == {"speed_limit": 4000, "target_position": -70000, "read_hours.hours": 0}


FLAGGED = f"""device:
  id: gadget
  name: Gadget
  vendor: Maker
  manual: {{title: The manual, file: gadget.txt, sha256: "{"0" * 64}", lines: 99}}
links:
  - name: line
    source: 1 L1
    byte_order: big
    request: &frame [{{name: command, role: code, type: u8}}, {{name: body, role: body}}]
    response: *frame
    exception_response: {{flag: 0x80, record: refusal}}
enums:
  - {{name: reason, source: 1 L2, members: [{{value: 1, name: unknown}}, {{value: 2, name: wrong_value}}]}}
records:
  - name: refusal
    source: 1 L2
    fields: [{{name: refused, type: u8, same_as: command}}, {{name: reason, type: u8, enum: reason}}]
messages:
  - name: select
    code: 0x22
    response_code: 0x62
    source: 1 L3
    request: [{{name: item, type: u8, range: 1..3}}]
    response: []
behaviour:
  - {{name: refuse_code, refuse: unknown_code, with: unknown, source: 1 L4}}
  - {{name: refuse_value, refuse: value_invalid, with: wrong_value, source: 1 L4}}
"""


def test_the_flag_of_an_exception_response_is_put_on_the_code_of_the_response(tmp_path: Path) -> None:
    (tmp_path / "gadget").mkdir()
    (tmp_path / "gadget" / "device.yaml").write_text(FLAGGED, "utf-8")
    unit = Unit("gadget", "line", folder=str(tmp_path))
    answers = [unit.answer_to(bytes.fromhex(text)).frame.hex(" ") for text in ("22 03", "22 09", "30")]
    assert answers == ["62", "e2 22 02", "b0 30 01"]
    layout, _ = parts_of("gadget", str(tmp_path))
    for refusal, error in ((bytes.fromhex("E2 22 02"), RefusedError), (bytes.fromhex("A2 22 02"), NoAnswerError)):
        with pytest.raises(error):
            Client(layout, "line", Once(refusal), 0, Timing(timeout=0.02, retries=0)).ask("select", {"item": 1})
    explanation = explained(layout, "line", "response", bytes.fromhex("E2 22 02"))
    assert (explanation.message, explanation.error, explanation.reasons) == ("select", True, ())


# Captures

CONVERSATION = (
    ("BA", "FA 3C FB"),
    ("BB", "FA 12 34"),
    ("22 01 10", "62 01 10 05 DC"),
    ("10 03", "7F 10 22"),
    ("22 01 10", "22 01 10 05 DC"),
)
"""Requests, each with its response; the last one has the code of the request."""

FRAMES = [bytes.fromhex(text) for pair in CONVERSATION for text in pair]


PAIRED = ("read_temperatures", "read_hours", "read_word", "change_session")


def direction_of(at: int) -> str:
    """The direction of a frame of the conversation."""
    return "response" if at % 2 else "request"


def test_bulk_decoding_pairs_responses_with_their_requests() -> None:
    sent = [Sent(0, direction_of(at), frame) for at, frame in enumerate(FRAMES)]
    ((device, batch),) = decoded(ECU, sent, Choices())
    assert verdicts([(device, batch)]) == ["ok"] * 9 + ["unknown_code"]
    texts = [device.texts.texts[place] if place >= 0 else "" for place in batch.frames.message.tolist()]
    assert texts == [*(name for name in PAIRED for _ in range(2)), "read_word", ""]
    exceptions = [device.texts.texts[place] for place in batch.frames.exception.tolist() if place >= 0]
    assert exceptions == ["conditions_not_correct"]
    assert batch.frames.request.tolist() == [number for at in (1, 3, 5, 7) for number in (-1, at)] + [-1, -1]


def test_bulk_values_are_those_of_the_explainer() -> None:
    sent = [Sent(0, direction_of(at), frame) for at, frame in enumerate(FRAMES)]
    rows = {(row.register, row.raw) for row in values(decoded(ECU, sent, Choices()))}
    assert {("read_temperatures.bridge", -5), ("read_hours.hours", 0x1234), ("exception.refused_service", 0x10)} <= rows


def test_wireshark_pairs_responses_with_their_requests() -> None:
    port, prefix = 2300, prefix_of(ECU)
    packets = [Packet(40000, port, direction_of(at), frame) for at, frame in enumerate(FRAMES)]
    fields = [option for name in ("message", "request_in") for option in ("-e", f"{prefix}.frame.{name}")]
    options = ("-2", "-T", "fields", *fields, "-o", f"{prefix}.datagrams_udp:{port}")
    rows = [line.split("\t") for line in tshark([ECU], pcap(packets), *options).stdout.splitlines()]
    pairs = [row for at, name in enumerate(PAIRED) for row in ([name, ""], [name, str(2 * at + 1)])]
    assert rows == [*pairs, ["read_word", ""], ["", ""]]


# Outputs and listings


def test_the_page_has_both_codes() -> None:
    (text,) = (text for path, text in documentation([ECU]).items() if path.endswith("1.md"))
    assert isinstance(text, str)
    chapter = text[text.index('<a id="messages/read_word"></a>') : text.index('<a id="messages/read_long"></a>')]
    assert "- Code: `0x22` (34)\n" in chapter
    assert "- Code of the response: `0x62` (98)\n" in chapter
    asked, answered = chapter.split("*Response on ")
    assert "| `0` | `service` | `u8` | `0x22` (34) | 1 L2 |" in asked
    assert "| `0` | `service` | `u8` | `0x62` (98) | 1 L2 |" in answered


CONSTANTS: dict[str, tuple[Callable[..., Any], str]] = {
    "ecu_v1_constants.h": (c_files, "#define ECU_READ_WORD_RESPONSE_CODE 98u"),
    "ecu_v1.st": (st_files, "    READ_WORD_RESPONSE_CODE : UINT := 16#0062; //"),
    "ecu_v1_constants.st": (iec_files, "    ECU_MSG_READ_WORD_RESPONSE_CODE : UINT := 16#0062; (*"),
    "fieldspec_devices/ecu/v1.py": (python_files, "    CODE: _ClassVar[int | None] = 0x62"),
}
"""The beginning of a line that each output has."""


@pytest.mark.parametrize("path", CONSTANTS)
def test_generated_code_has_the_code_of_the_response(path: str) -> None:
    files, begin = CONSTANTS[path]
    assert any(line.startswith(begin) for line in files([ECU])[path].splitlines())


def test_javascript_has_the_code_of_the_response() -> None:
    script = (
        f"import * as ecu from {json.dumps(module_path(ECU))};"
        "const messages = Object.values(ecu).filter((own) => own?.request && own?.name);"
        "console.log(JSON.stringify(messages.map((own) => [own.name, own.code, own.responseCode])));"
    )
    command = [require_tool("node"), "--input-type=module", "-e", script]
    run = subprocess.run(command, capture_output=True, text=True, check=True, timeout=HANGING)
    codes = {name: (code, answered) for name, code, answered in json.loads(run.stdout)}
    assert codes == {name: (own.message.code, own.message.code_of("response")) for name, own in ECU.messages.items()}


@pytest.mark.parametrize("number", ["0x22", "0x62"])
def test_show_finds_messages_by_either_code(capsys: pytest.CaptureFixture[str], number: str) -> None:
    assert main(["show", "ecu", number, "--specs", SPECS]) == 0
    text = capsys.readouterr().out
    names = [line.strip() for line in text.splitlines() if line.startswith("read_")]
    assert names == ["read_word", "read_long", "read_serial_number"]
    assert text.count("  code          0x22\n  response code 0x62\n") == 3


def test_facts_have_a_row_for_the_code_of_the_response(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["facts", "ecu", "--specs", SPECS, "--format", "json"]) == 0
    rows = {row["path"]: row for row in json.loads(capsys.readouterr().out) if row["kind"] == "response_code"}
    stated = [name for name, own in ECU.messages.items() if own.message.response_code is not None]
    assert list(rows) == [f"messages/{name}/response_code" for name in stated]
    row = rows["messages/read_word/response_code"]
    assert (row["code"], row["name"], row["sources"]) == (0x62, "read_word", "3 L10")
