"""Requests that come in pieces over TCP, which has no pauses of its own, and over serial lines, which have."""

from __future__ import annotations

import socket
import time
from collections.abc import Iterator
from contextlib import contextmanager

import pytest

from bounded import HANGING
from fieldspec.codec.reference.checksums import checksum
from fieldspec.testing import SimulatedDevice, simulation
from fieldspec.tools.simulator import simulation as simulations
from layouts import TEST_SPECS
from simulators import SPECS

READ = bytes.fromhex("00 01 00 00 00 06 01 03")
PAUSE = 0.2


def rtu(text: str) -> bytes:
    """A frame in bytes, with its checksum."""
    data = bytes.fromhex(text)
    return data + checksum("crc16_modbus", data, "little").to_bytes(2, "little")


@contextmanager
def connected(device: SimulatedDevice) -> Iterator[socket.socket]:
    """A connection to a device over TCP."""
    host, _, port = device.place.removeprefix("tcp://").rpartition(":")
    with socket.create_connection((host, int(port)), 5) as connection:
        connection.settimeout(HANGING)
        yield connection


def sent_in_pieces(connection: socket.socket, *pieces: bytes) -> bytes:
    """What is answered to pieces with pauses between."""
    for piece in pieces[:-1]:
        connection.sendall(piece)
        time.sleep(PAUSE)
    connection.sendall(pieces[-1])
    return connection.recv(100)


@pytest.fixture
def ck10() -> Iterator[SimulatedDevice]:
    with simulation("ck10", ports={"rtu": "tcp://127.0.0.1:0"}, folder=SPECS) as device:
        device.set(**{"registers/user_outputs": 10})
        yield device


@pytest.mark.parametrize("at", [1, 2, 4, 7])
def test_a_request_in_two_segments_is_answered(ck10: SimulatedDevice, at: int) -> None:
    whole = rtu("01 03 04 10 00 01")
    with connected(ck10) as connection:
        assert sent_in_pieces(connection, whole[:at], whole[at:]) == rtu("01 03 02 00 0A")


def test_a_request_with_a_length_in_three_segments_is_answered() -> None:
    with (
        simulation("wattmeter", ports={"tcp": "tcp://127.0.0.1:0"}, folder=str(TEST_SPECS)) as device,
        connected(device) as connection,
    ):
        unit = bytes([device.simulation.server.unit_address])
        answer = sent_in_pieces(
            connection, bytes.fromhex("00 07 00"), bytes.fromhex("00 00 06"), unit + bytes.fromhex("03 FF F0 00 01")
        )
        assert answer[:2] == bytes.fromhex("00 07")


def test_a_request_with_a_code_that_no_message_has_is_refused_at_the_pause(
    ck10: SimulatedDevice, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(simulations, "PATIENCE", 2 * HANGING)
    monkeypatch.setattr(simulations, "NETWORK_PAUSE", 2 * HANGING)
    whole = rtu("01 41 00 00")
    with connected(ck10) as connection:
        assert sent_in_pieces(connection, whole) == rtu("01 C1 01")
        assert sent_in_pieces(connection, whole[:3], whole[3:]) == rtu("01 C1 01")


@pytest.mark.parametrize(
    ("damaged", "sound", "answer"),
    [
        ("01 10 04 10 00 01 F2 00 0A 00 00", "01 03 04 10 00 01", "01 03 02 00 0A"),
        ("01 10 04 10 00 01 04 00 0A 00 00", "01 03 04 10 00 01", "01 03 02 00 0A"),
    ],
    ids=["much too long", "a little too long"],
)
def test_a_request_behind_one_with_a_damaged_length_is_answered(
    ck10: SimulatedDevice, monkeypatch: pytest.MonkeyPatch, damaged: str, sound: str, answer: str
) -> None:
    monkeypatch.setattr(simulations, "PATIENCE", 2 * HANGING)
    with connected(ck10) as connection:
        connection.sendall(bytes.fromhex(damaged))
        time.sleep(PAUSE)
        connection.sendall(rtu(sound))
        assert connection.recv(100) == rtu(answer)


def test_a_request_behind_one_with_a_damaged_header_is_answered(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(simulations, "PATIENCE", 2 * HANGING)
    with (
        simulation("wattmeter", ports={"tcp": "tcp://127.0.0.1:0"}, folder=str(TEST_SPECS)) as device,
        connected(device) as connection,
    ):
        unit = bytes([device.simulation.server.unit_address])
        connection.sendall(bytes.fromhex("00 07 00 00 00 F6") + unit + bytes.fromhex("03 FF F0 00 01"))
        time.sleep(PAUSE)
        connection.sendall(bytes.fromhex("00 08 00 00 00 06") + unit + bytes.fromhex("03 FF F0 00 01"))
        assert connection.recv(100)[:2] == bytes.fromhex("00 08")
