"""Frames in SLIP and in COBS over pseudo-terminals: a generated client and codec, and a peer of other libraries."""

from __future__ import annotations

import importlib
import struct
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import pytest
import serial
import sliplib
from cobs import cobs
from crccheck.crc import Crc16Ibm3740, Crc32IsoHdlc

from layouts import TEST_SPECS, newest
from python_package import link_of, module_of, package
from serial_lines import SECONDS, Line, serial_line

MODULE = module_of(newest(TEST_SPECS, "beacon"))
STATION = 1
MEMORY = [0xC0DB, 0, 0xDDDC, 0x00C0, 1, 0xFFFF, 0xDB00, 0x1000] * 12
"""Words of a device, with every byte that SLIP and COBS give a meaning."""


@dataclass(frozen=True)
class Peer:
    """The frames of a link in other libraries: what is before the body, the checksum, the escape and the end."""

    head: bytes
    checksum: Callable[[bytes], bytes]
    encode: Callable[[bytes], bytes]
    decode: Callable[[bytes], bytes]
    end: bytes

    def frame(self, body: bytes) -> bytes:
        """The bytes on the line."""
        data = self.head + body
        return self.encode(data + self.checksum(data))

    def body(self, frame: bytes) -> bytes:
        """The body of a frame whose head and checksum are right."""
        data = self.decode(frame)
        size = len(self.checksum(b""))
        assert data.startswith(self.head)
        assert data[-size:] == self.checksum(data[:-size])
        return data[len(self.head) : -size]


PEERS = {
    "slip": Peer(
        bytes([STATION, 0x10]),
        lambda data: struct.pack(">H", Crc16Ibm3740.calc(data)),
        lambda data: sliplib.encode(data) + sliplib.END,
        lambda frame: sliplib.decode(frame.strip(sliplib.END)),
        b"\xc0",
    ),
    "cobs": Peer(
        b"\x10",
        lambda data: struct.pack(">I", Crc32IsoHdlc.calc(data)),
        lambda data: cobs.encode(data) + b"\0",
        lambda frame: cobs.decode(frame.rstrip(b"\0")),
        b"\0",
    ),
}
LINKS = pytest.mark.parametrize("name", PEERS)


@contextmanager
def port_of(serve: Callable[[Line], None]) -> Iterator[serial.Serial]:
    """A port, at whose other end a device is served: `serve` reads requests and answers until nothing comes."""
    ended = threading.Event()

    def work(line: Line) -> None:
        while not ended.is_set():
            serve(line)

    with serial_line() as (near, path), serial.Serial(path, 115200, timeout=0.05) as port:
        thread = threading.Thread(target=work, args=(Line(near),), daemon=True)
        thread.start()
        try:
            yield port
        finally:
            ended.set()
            thread.join(SECONDS)


def words_at(address: int) -> list[int]:
    """What the device has at an address: up to a hundred words."""
    return MEMORY[address % 8 :][: 1 + address % 90]


@LINKS
def test_a_generated_client_reads_from_a_device_of_other_libraries(name: str) -> None:
    peer, received = PEERS[name], bytearray()

    def serve(line: Line) -> None:
        received.extend(line.receive(0.02))
        while peer.end in received:
            frame, _, rest = bytes(received).partition(peer.end)
            received[:] = rest
            (address,) = struct.unpack(">H", peer.body(frame + peer.end))
            words = words_at(address)
            line.send(peer.frame(struct.pack(f">H{len(words)}H", address, *words)))

    client = importlib.import_module(f"{package().__name__}.beacon.client")
    with port_of(serve) as port:
        device = client.Client(port, link=name, timeout=SECONDS)
        for address in (0, 0xC0, 0xDB, 0xC0DB, 0xDDDC, 89):
            answer: Any = device.ask(MODULE.ReadRequest(address))
            message = getattr(answer, "message", answer)
            assert (message.address, list(message.values)) == (address, words_at(address))


@LINKS
def test_a_generated_codec_answers_requests_of_other_libraries(name: str) -> None:
    peer, link = PEERS[name], link_of(MODULE, name)
    framer = link.request_framer()

    def serve(line: Line) -> None:
        for frame in framer.feed(line.receive(0.02)):
            address = link.decode_request(frame).message.address
            response = MODULE.ReadResponse(address, words_at(address))
            line.send(link.encode_response(STATION, response) if name == "slip" else link.encode_response(response))

    with port_of(serve) as port:
        port.timeout = SECONDS
        port.write(b"\x55" + peer.end)
        for address in (0, 0xC0, 0xDB, 0xC0DB, 0xDDDC, 89):
            port.write(peer.frame(struct.pack(">H", address)))
            body = peer.body(port.read_until(peer.end))
            words = words_at(address)
            assert body == struct.pack(f">H{len(words)}H", address, *words)
