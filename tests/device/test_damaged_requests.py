"""What a device does with the requests after one that was damaged, over a network and over a serial line."""

from __future__ import annotations

from collections.abc import Sequence

import pytest

from fieldspec.codec.reference.checksums import checksum
from fieldspec.testing import simulation
from fieldspec.tools.carriers.carrier import CarrierError
from fieldspec.tools.simulator.simulation import settings_of
from simulators import SPECS


class ScriptedCarrier:
    """Bytes that come at stated seconds, by a time that nobody waits for."""

    name = "script"
    datagrams = False

    def __init__(self, arrivals: Sequence[tuple[float, bytes]], keeps_pauses: bool) -> None:
        self.arrivals, self.keeps_pauses = list(arrivals), keeps_pauses
        self.now = 0.0
        self.answers: list[bytes] = []

    def read(self, seconds: float) -> bytes:
        """The bytes that come within some seconds."""
        if not self.arrivals:
            raise CarrierError("the script has ended")
        arrival, data = self.arrivals[0]
        if arrival > self.now + seconds:
            self.now += seconds
            return b""
        self.now = max(self.now, arrival)
        del self.arrivals[0]
        return data

    def write(self, data: bytes) -> None:
        """Notes an answer."""
        self.answers.append(data)

    def close(self) -> None:
        """Nothing is open."""


def packet(text: str) -> bytes:
    """A packet of the ESC11, with the sum of its bytes, 8.1."""
    data = bytes.fromhex(text)
    return data + bytes([-sum(data) & 0xFF])


def rtu(text: str) -> bytes:
    """A frame of Modbus RTU, with its checksum."""
    data = bytes.fromhex(text)
    return data + checksum("crc16_modbus", data, "little").to_bytes(2, "little")


READ = rtu("01 03 10 00 00 01")


def answers(device: str, arrivals: Sequence[tuple[float, bytes]], keeps_pauses: bool = False) -> list[bytes]:
    """What a device answers."""
    carrier = ScriptedCarrier(arrivals, keeps_pauses)
    with simulation(device, folder=SPECS, ports={}) as running:
        link = next(iter(running.simulation.layout.links))
        settings = settings_of(running.simulation.layout.links[link].link)
        running.simulation._run(link, carrier, settings)
    return carrier.answers


IO_STATUS = bytes.fromhex("04 00 52 56")
"""An example of the manual, 9.4.3."""

DAMAGED = {
    "a wrong checksum": bytes.fromhex("04 00 52 57"),
    "a long request with a wrong checksum": bytes.fromhex("14 00 60 03 41 20 03 00 00 64") + bytes(9) + b"@",
    "a damaged length": bytes.fromhex("FB 00 52 56"),
    "a request that ends in the middle": bytes.fromhex("14 00 60 03 41"),
    "a request with the beginning of another one": IO_STATUS + bytes.fromhex("14 00 60"),
    "a request with a damaged one after it": IO_STATUS + bytes.fromhex("FB 00 52 56"),
}


@pytest.mark.proof(4)
@pytest.mark.parametrize("keeps_pauses", [False, True], ids=["network", "line"])
@pytest.mark.parametrize("name", DAMAGED)
def test_a_packet_after_the_pause_of_the_manual_is_answered(name: str, keeps_pauses: bool) -> None:
    # The manual, 7.3: after 600 ms without a byte the controller takes the next one as the length of a packet.
    damaged = DAMAGED[name]
    arrivals = [(1.0, damaged), (1.65, IO_STATUS), (3.0, b"")]
    expected = 2 if damaged.startswith(IO_STATUS) else 1
    assert [answer[1] for answer in answers("esc11", arrivals, keeps_pauses)] == [0] * expected


@pytest.mark.parametrize("keeps_pauses", [False, True], ids=["network", "line"])
def test_a_packet_with_a_shorter_pause_within_it_is_answered(keeps_pauses: bool) -> None:
    arrivals = [(1.0, IO_STATUS[:2]), (1.55, IO_STATUS[2:]), (3.0, b"")]
    assert len(answers("esc11", arrivals, keeps_pauses)) == 1


@pytest.mark.parametrize("keeps_pauses", [False, True], ids=["network", "line"])
def test_the_pause_counts_from_the_bytes_behind_a_whole_packet(keeps_pauses: bool) -> None:
    arrivals = [(1.0, IO_STATUS + bytes.fromhex("14 00 60")), (1.65, IO_STATUS), (1.7, IO_STATUS), (3.0, b"")]
    carrier_answers = answers("esc11", arrivals, keeps_pauses)
    assert len(carrier_answers) == 3


def test_a_frame_half_a_second_after_a_damaged_one_is_answered_over_a_network() -> None:
    # The data of the damaged one look like the beginning of a request with 240 bytes.
    damaged = rtu("01 10 20 02 00 04 08 01 10 20 02 00 78 F0 00")[:-1] + b"\x55"
    read = rtu("01 03 04 10 00 01")
    assert answers("ck10", [(1.0, damaged), (1.5, read), (3.0, b"")]) == [rtu("01 03 02 00 00")]


@pytest.mark.parametrize(
    "arrivals",
    [
        [(1.0, READ[:3]), (5.0, READ[3:]), (7.0, b"")],
        [(1.0, READ[:3]), (6.5, READ), (8.0, b"")],
    ],
    ids=["slow", "broken off"],
)
def test_the_rest_of_a_frame_is_waited_for_over_a_network_for_five_seconds(arrivals: list[tuple[float, bytes]]) -> None:
    assert answers("tc100", arrivals) == [rtu("01 03 02 00 00")]
