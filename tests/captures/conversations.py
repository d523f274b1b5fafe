"""Captures and logs of conversations with a made-up meter, written byte by byte."""

from __future__ import annotations

import struct
from collections.abc import Iterable, Sequence
from typing import NamedTuple

CLIENT, SERVER = b"\x0a\0\0\1", b"\x0a\0\0\2"
ETHERNET, USER_0, RTAC, SOCKETCAN = 1, 147, 250, 227


class Segment(NamedTuple):
    """A segment of TCP: its direction, the number of its first byte, and its data."""

    is_request: bool
    sequence: int
    data: bytes


def ethernet(segment: Segment, port: int = 502) -> bytes:
    """An Ethernet packet with a segment."""
    ports = (49152, port) if segment.is_request else (port, 49152)
    hosts = (CLIENT, SERVER) if segment.is_request else (SERVER, CLIENT)
    tcp = struct.pack(">HHIIBBHHH", *ports, segment.sequence % 2**32, 0, 0x50, 0x18, 8192, 0, 0) + segment.data
    head = struct.pack(">BBHHHBBH", 0x45, 0, 20 + len(tcp), 0, 0, 64, 6, 0) + b"".join(hosts)
    return bytes(12) + b"\x08\0" + head + tcp


def pcap(packets: Iterable[bytes], link_type: int = ETHERNET, milliseconds: Sequence[int] = ()) -> bytes:
    """A capture, one millisecond from packet to packet, or with the times in milliseconds."""
    parts = [struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 0x40000, link_type)]
    for number, packet in enumerate(packets):
        time = milliseconds[number] if milliseconds else number
        parts.append(struct.pack("<IIII", time // 1000, time % 1000 * 1000, len(packet), len(packet)) + packet)
    return b"".join(parts)


def pcapng(packets: Iterable[bytes], link_type: int = ETHERNET) -> bytes:
    """The same in blocks, with times in nanoseconds."""
    options = struct.pack("<HHB3xHH", 9, 1, 9, 0, 0)
    interface = struct.pack("<HHI", link_type, 0, 0) + options
    parts = [block(0x0A0D0D0A, struct.pack("<IHHq", 0x1A2B3C4D, 1, 0, -1)), block(1, interface)]
    for number, packet in enumerate(packets):
        time = number * 10**6
        parts.append(
            block(6, struct.pack("<IIIII", 0, time >> 32, time & 0xFFFFFFFF, len(packet), len(packet)) + packet)
        )
    return b"".join(parts)


def block(kind: int, body: bytes) -> bytes:
    """A block of pcapng."""
    body += bytes(-len(body) % 4)
    return struct.pack("<II", kind, len(body) + 12) + body + struct.pack("<I", len(body) + 12)


def crc(data: bytes) -> bytes:
    """The CRC of Modbus, bit by bit."""
    register = 0xFFFF
    for byte in data:
        register ^= byte
        for _ in range(8):
            register = register >> 1 ^ (0xA001 if register & 1 else 0)
    return register.to_bytes(2, "little")


def rtu(*body: int) -> bytes:
    """A frame of Modbus RTU."""
    return bytes(body) + crc(bytes(body))


def tcp_poll(count: int, words: int = 4, first: int = 0) -> list[Segment]:
    """Reads of input registers of the unit 1 over Modbus TCP, and their responses with the numbers of the reads."""
    segments = []
    asked = answered = 1000
    for number in range(first, first + count):
        request = struct.pack(">HHHBBHH", number % 65536, 0, 6, 1, 4, 0, words)
        data = struct.pack(f">{words}H", *((number + word) % 65536 for word in range(words)))
        response = struct.pack(">HHHBBB", number % 65536, 0, 3 + len(data), 1, 4, len(data)) + data
        segments += [Segment(True, asked, request), Segment(False, answered, response)]
        asked, answered = asked + len(request), answered + len(response)
    return segments
