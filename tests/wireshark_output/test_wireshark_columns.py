"""The column of information has the messages of a packet and the registers that they access."""

from __future__ import annotations

import pytest

from layouts import SPECS, newest
from test_libmodbus import crc
from wireshark_output.dissection import FIRST_PORT, Packet, pcap, port_options, tshark

LAYOUT = newest(SPECS, "tc100")
PORTS = {(LAYOUT.device.id, "rtu", ""): FIRST_PORT}


def column(direction: str, *frames: bytes) -> list[str]:
    """The column of information of packets, each with a frame without its checksum."""
    packets = [
        Packet(3000, FIRST_PORT, "request" if place == 0 else direction, frame + crc(frame))
        for place, frame in enumerate(frames)
    ]
    options = ("-T", "fields", "-e", "_ws.col.Info", *port_options(LAYOUT, PORTS))
    return tshark([LAYOUT], pcap(packets), *options).stdout.splitlines()


def read(address: int, words: int) -> bytes:
    return bytes((1, 3)) + address.to_bytes(2, "big") + words.to_bytes(2, "big")


def test_a_register_that_is_written_is_in_the_column() -> None:
    write = bytes.fromhex("0106201E0003")
    assert column("response", write, write) == [
        "write_register request: motion_command",
        "write_register response: motion_command",
    ]


def test_an_answer_has_the_registers_that_its_request_asks_for() -> None:
    asked, answered = column("response", read(0x2011, 1), bytes((1, 3, 2, 0, 1)))
    assert (asked, answered) == ("read_registers request: servo", "read_registers response: servo")


@pytest.mark.parametrize(("address", "words", "text"), [(0x2010, 1, "read_registers request")])
def test_what_no_register_has_adds_nothing(address: int, words: int, text: str) -> None:
    assert column("request", read(address, words)) == [text]


def test_of_many_registers_the_first_ones_are_there_with_their_number() -> None:
    (text,) = column("request", read(0x1000, 30))
    names = [
        register.name
        for register in sorted(LAYOUT.registers, key=lambda own: own.address)
        if 0x1000 - register.words < register.address < 0x101E and register.count == 1
    ]
    assert text == f"read_registers request: {', '.join(names[:3])}, and {len(names) - 3} more"
