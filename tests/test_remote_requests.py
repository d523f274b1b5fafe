"""Remote requests of a CAN bus: told apart from data, by identifiers of 11 and 29 bits, in codecs and on a bus."""

from __future__ import annotations

import importlib
import struct
from collections.abc import Iterator
from pathlib import Path

import can
import pytest

from captures.conversations import SOCKETCAN, pcap
from captures.test_decode_in_bulk import decode
from fieldspec.cli import main
from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.explain.lines import log_line
from fieldspec.codec.reference.frames import codec
from fieldspec.codec.reference.records import CodecError
from fieldspec.testing import simulation
from layouts import TEST_SPECS, newest
from python_package import codec_error, module_of, package, runtime
from random_devices.agreement import JUDGES, Comparison, compare_layout

TURRET = newest(TEST_SPECS, "turret")
MODULE = module_of(TURRET)
ASKS = "40 00 00 29 08 00 00 00"
POSITION = struct.pack("<2f", 1.5, -2.0)
TIMEOUT = 10.0


@pytest.fixture
def bus(request: pytest.FixtureRequest) -> Iterator[can.BusABC]:
    """What else is on the virtual bus of a test."""
    with can.Bus(interface="virtual", channel=request.node.name) as own_bus:
        yield own_bus


def test_codecs_agree_on_random_frames_of_a_bus_with_remote_requests() -> None:
    result = Comparison()
    names = {"python", "javascript", "tcc", "explainer", "script", "captures", "command"}
    compare_layout(TURRET, 1, 90, tuple(judge for judge in JUDGES if judge.name in names), result)
    assert result.disagreements == []
    assert set(result.asked) == names


@pytest.mark.parametrize(
    ("link", "frame", "message"),
    [
        ("standard", "40 00 00 2A 02 00 00 00", "read_limit"),
        ("standard", "00 00 00 2A 02 00 00 00 2C 01", "write_limit"),
        ("standard", "40 00 00 01 00 00 00 00", "read_inputs"),
        ("extended", "C0 00 00 01 04 00 00 00", "read_serial"),
        ("extended", "C0 1A BC DE 01 00 00 00", "read_hours"),
        ("extended", "C0 1A BC DE 02 00 00 00", "read_minutes"),
    ],
)
def test_the_kind_the_identifier_and_the_dlc_of_a_frame_tell_its_message(link: str, frame: str, message: str) -> None:
    decoded = codec(TURRET).links[link].decode(bytes.fromhex(frame), "request")
    assert decoded.message is not None
    assert decoded.message.name == message
    assert explained(TURRET, link, "request", bytes.fromhex(frame)).message == message


@pytest.mark.parametrize(
    ("link", "frame", "reason"),
    [
        ("standard", "00 00 00 29 08 00 00 00 00 00 00 00 00 00 00 00", "unknown_code"),
        ("standard", "40 00 00 29 04 00 00 00", "wrong_const"),
        ("standard", "40 00 00 29 08 00 00 00 00 00 00 00 00 00 00 00", "wrong_mark"),
        ("standard", "40 00 00 29 09 00 00 00", "wrong_mark"),
        ("standard", "C0 00 00 29 08 00 00 00", "wrong_mark"),
        ("extended", "40 00 00 01 04 00 00 00", "wrong_mark"),
        ("extended", "E0 00 00 01 04 00 00 00", "wrong_mark"),
    ],
)
def test_what_is_no_remote_request_of_the_device_is_refused_alike(link: str, frame: str, reason: str) -> None:
    with pytest.raises(CodecError) as refused:
        codec(TURRET).links[link].decode(bytes.fromhex(frame), "request")
    assert refused.value.reason == reason
    with pytest.raises(codec_error()) as refused_by_code:
        getattr(MODULE, link).decode_request(bytes.fromhex(frame))
    assert getattr(refused_by_code.value, "reason", "") == reason
    assert explained(TURRET, link, "request", bytes.fromhex(frame)).reasons == (reason,)


def test_a_driver_gets_the_kind_of_a_frame_with_its_identifier() -> None:
    frame = MODULE.extended.encode_request(MODULE.ReadSerialRequest())
    record = MODULE.extended.can_frame(frame)
    assert (record.identifier, record.data, record.is_extended, record.is_remote, record.dlc) == (1, b"", True, True, 4)
    assert record.frame() == frame
    data = MODULE.standard.can_frame(MODULE.standard.encode_request(1, MODULE.WriteLimitRequest(300)))
    assert (data.identifier, data.data, data.is_remote, data.dlc) == (0x2A, b"\x2c\x01", False, 2)


@pytest.mark.parametrize(
    ("text", "frame"),
    [
        ("123#R", "40 00 01 23 00 00 00 00"),
        ("(1436509052.249713) can0 029#R8", ASKS),
        ("  can0  029   [8]  remote request", ASKS),
        (" (2023-02-07 11:32:15.427178)  can0  TX - -  001   [0]  remote request", "40 00 00 01 00 00 00 00"),
        ("00000123#R4", "C0 00 01 23 04 00 00 00"),
        ("029#R8 R", ASKS),
    ],
)
def test_remote_requests_of_candump_are_frames(text: str, frame: str) -> None:
    line = log_line(text, [link.link for link in TURRET.links.values()])
    assert line is not None
    assert line.frame == bytes.fromhex(frame)


def test_an_explanation_says_the_identifier_and_the_dlc() -> None:
    explanation = explained(TURRET, "standard", "request", bytes.fromhex(ASKS))
    rows = [(row.at, row.sent, row.path, row.number) for row in explanation.rows]
    assert rows == [
        ("identifier", "029", "node", 1),
        ("identifier", "", "command", 9),
        ("DLC", "08 00 00 00", "dlc", 8),
    ]
    assert explanation.values["command"] == 9


def test_captures_have_remote_requests_beside_data(tmp_path: Path) -> None:
    packets = ["40000029 08000000", "00000029 08000000" + POSITION.hex(), "40000029 08000000 0000000000000000"]
    content = pcap(map(bytes.fromhex, packets), SOCKETCAN)
    _, _, frames, values = decode(tmp_path, content, "--link", "standard", device="turret")
    assert [(frame["verdict"], frame["direction"], frame["message"]) for frame in frames] == [
        ("ok", "request", "read_position"),
        ("ok", "response", "read_position"),
        ("ok", "request", "read_position"),
    ]
    read = {value["register"]: value["value"] for value in values if value["frame"] == 2}
    assert read == {"read_position.position": 1.5, "read_position.velocity": -2.0}


def test_a_simulated_device_answers_a_remote_request_of_another_program(bus: can.BusABC) -> None:
    place = f"can://virtual/{bus.channel_info.rpartition(' ')[2]}"
    with simulation("turret", ports={"standard": place}, unit_address=1, folder=str(TEST_SPECS)):
        bus.send(can.Message(arbitration_id=0x29, is_extended_id=False))  # data, which nobody answers
        bus.send(can.Message(arbitration_id=0x29, is_extended_id=True, is_remote_frame=True, dlc=8))
        bus.send(can.Message(arbitration_id=0x2A, is_extended_id=False, is_remote_frame=True, dlc=2))
        answer = bus.recv(TIMEOUT)
        assert answer is not None
        assert (answer.arbitration_id, answer.is_remote_frame, answer.dlc) == (0x2A, False, 2)
        assert bus.recv(0.2) is None


def test_live_sends_a_remote_request_over_a_bus(bus: can.BusABC, capsys: pytest.CaptureFixture[str]) -> None:
    place = f"can://virtual/{bus.channel_info.rpartition(' ')[2]}"
    options = ("--link", "standard", "--port", place, "--unit", "1", "--timeout", "0.5", "--specs", str(TEST_SPECS))
    with simulation("turret", ports={"standard": place}, unit_address=1, folder=str(TEST_SPECS)):
        assert main(["live", "turret", "read", "read_position", *options]) == 0
    asked = bus.recv(TIMEOUT)
    assert asked is not None
    assert (asked.arbitration_id, asked.is_remote_frame, asked.dlc, asked.is_extended_id) == (0x29, True, 8, False)


def test_a_generated_client_sends_a_remote_request_over_a_bus(bus: can.BusABC) -> None:
    channel = bus.channel_info.rpartition(" ")[2]
    client = importlib.import_module(f"{package().__name__}.turret.client")
    with (
        simulation("turret", ports={"standard": f"can://virtual/{channel}"}, unit_address=1, folder=str(TEST_SPECS)),
        can.Bus(interface="virtual", channel=channel) as own_bus,
    ):
        turret = client.Client(
            runtime("transports").CanTransport(own_bus, can.Message), unit_address=1, link="standard"
        )
        reply = turret.ask(MODULE.ReadPositionRequest())
    assert reply.message == MODULE.ReadPositionResponse(0.0, 0.0)
