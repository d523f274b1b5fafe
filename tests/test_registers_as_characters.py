"""Registers whose words messages carry as hexadecimal characters, as in Host Link."""

from __future__ import annotations

import importlib
import io
import json
import subprocess
from functools import reduce
from operator import xor
from typing import Any

import pytest

from captures import bulk
from captures.bulk import Sent
from command_line import CommandLine
from external_tools import require_tool
from fieldspec.cli import main
from fieldspec.codec.reference import codec
from fieldspec.testing import simulation
from fieldspec.tools.captures.decoding import Choices
from fieldspec.tools.evidence.redaction import Redaction
from fieldspec.tools.evidence.secrets import Secrets
from js_output.javascript import module_path
from layouts import TEST_SPECS, newest
from python_package import module_of, runtime

LAYOUT = newest(TEST_SPECS, "ladder")
LADDER = module_of(LAYOUT)
FOLDER = str(TEST_SPECS)


def sealed(text: str) -> bytes:
    """The characters of a frame with their exclusive or and the delimiters."""
    return f"{text}{reduce(xor, text.encode()):02X}*\r".encode()


REQUEST, RESPONSE = sealed("@10RR00010003"), sealed("@10RR00000186A00001")
DAMAGED = sealed("@10RR00000186a00001")


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> CommandLine:
    return CommandLine(capsys, monkeypatch, TEST_SPECS)


def test_an_explanation_shows_the_registers_and_their_characters(run: CommandLine) -> None:
    lines = f"{REQUEST.hex()}\n{RESPONSE.hex()}\n".encode()
    result = run("decode", "ladder", "-", "--link", "area", stdin=lines)
    rows = [" ".join(line.split()) for line in result.lines if line.startswith("0x000")]
    assert rows == [
        "0x0001 2 distance ro 6 L4",
        "0x0003 1 mode rw 6 L5",
        "0x0001 2 30 30 30 31 38 36 41 30 distance ro 100000 1000.00 m 6 L4",
        "0x0003 1 30 30 30 31 mode rw 1 running 6 L5",
    ]


def test_registers_after_a_wrong_character_have_no_value(run: CommandLine) -> None:
    frame = sealed("@10WR000005DC0001zz01").hex()
    result = run("decode", "ladder", frame, "--link", "area", "--direction", "request")
    assert result.code == 1
    rows = [" ".join(line.split()) for line in result.lines if line.startswith("0x000")]
    assert rows == ["0x0000 1 30 35 44 43 target_speed rw 1500 1500 rpm 6 L3", "0x0001 2 distance ro 6 L4"]


def test_captures_have_the_registers_of_characters() -> None:
    sent = [
        Sent(0, "request", REQUEST),
        Sent(0, "response", RESPONSE),
        Sent(0, "request", REQUEST),
        Sent(0, "response", DAMAGED),
        Sent(0, "request", sealed("@10WR000005DC")),
    ]
    batches = bulk.decoded(LAYOUT, sent, Choices(link="area"))
    assert bulk.verdicts(batches) == ["ok", "ok", "ok", "unknown_value", "ok"]
    values = [(value.register, value.raw) for value in bulk.values(batches) if value.operation]
    assert values == [("distance", 100000), ("mode", 1), ("target_speed", 1500)]


@pytest.mark.parametrize("link", ["area", "bus"])
def test_a_client_reads_and_writes_registers_by_the_messages_of_its_link(
    link: str, capsys: pytest.CaptureFixture[str]
) -> None:
    client_module = importlib.import_module(f"{LADDER.__package__}.client")
    with simulation("ladder", ports={link: "tcp://127.0.0.1:0"}, unit_address=3, folder=FOLDER) as device:
        host, port = device.place.removeprefix("tcp://").split(":")
        with runtime("transports").tcp(host, int(port)) as transport:
            client = client_module.Client(transport, link=link, unit_address=3)
            client.write(LADDER.TARGET_SPEED, 2500)
            client.write(LADDER.TENSION, 1.5)
            assert (client.read(LADDER.TARGET_SPEED), client.read(LADDER.TENSION)) == (2500, 1.5)
            assert client.read_group(client_module.COUNTERS)[LADDER.TENSION] == 1.5
        more = ["--link", link, "--port", device.place, "--unit", "3", "--specs", FOLDER]
        assert main(["live", "ladder", "read", "target_speed", "tension", *more]) == 0
    output = capsys.readouterr().out
    assert "2500 rpm" in output
    assert "1.5 N" in output


def test_a_link_without_messages_for_registers_refuses_them() -> None:
    client_module = importlib.import_module(f"{LADDER.__package__}.client")
    client = client_module.Client(io.BytesIO(), link="host", unit_address=3)
    with pytest.raises(runtime("errors").InvalidValueError, match="no message of host reads mode"):
        client.read(LADDER.MODE)


AREA = [{"beginningWord": 1, "wordCount": 2}, {"beginningWord": 4, "areaWords": [0x3FC0, 0]}]
BUS = [{"address": 1, "quantity": 2}, {"address": 4, "relay": 0x3FC0}, {"address": 5, "relay": 0}]


@pytest.mark.parametrize(
    ("functions", "response", "requests"),
    [
        ("ladder", "areaWords", AREA),
        ('ladder.registersOn("area")', "areaWords", AREA),
        ('ladder.registersOn("bus")', "relays", BUS),
    ],
)
def test_javascript_makes_requests_for_registers_by_the_messages_of_a_link(
    functions: str, response: str, requests: list[dict[str, Any]]
) -> None:
    program = f"""
    import * as ladder from "{module_path(LAYOUT)}";
    const {{ readRequests, readValue, writeRequests }} = {functions};
    const requests = [...readRequests(ladder.DISTANCE), ...writeRequests(ladder.TENSION, 1.5)];
    const value = readValue(ladder.DISTANCE, {{ {response}: [1, 0x86a0] }});
    console.log(JSON.stringify([requests.map(({{ data }}) => data), value]));
    """
    command = [require_tool("node"), "--input-type=module", "--eval", program]
    output: Any = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
    assert output == [requests, 100000]


def test_javascript_refuses_a_link_without_messages_for_registers_by_name() -> None:
    program = f'import {{ registersOn }} from "{module_path(LAYOUT)}"; registersOn("host");'
    command = [require_tool("node"), "--input-type=module", "--eval", program]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    assert "RangeError: there is no link host; known are area, bus" in run.stderr


def test_redaction_keeps_known_registers_and_drops_unknown_ones() -> None:
    link = codec(LAYOUT).links["area"]
    frame = sealed("@10WR0005000011112222")
    clean = Redaction(LAYOUT, Secrets()).frame("area", "request", frame, link.decode(frame, "request"), {})
    assert link.decode(clean, "request").values["area_words"] == [0, 0, 0]
    frame = sealed("@10WR000005DC")
    clean = Redaction(LAYOUT, Secrets()).frame("area", "request", frame, link.decode(frame, "request"), {})
    assert clean == frame
