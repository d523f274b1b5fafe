"""Captures of a conversation over Modbus TCP in every form that networks and programs give them, with their truth."""

from __future__ import annotations

import gzip
import random
import struct
from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

SYN, PUSH_ACK, ACK, FIN_ACK = 2, 24, 16, 17
PORT, CLIENT_PORT = 502, 49152
UNIT = 7
REGISTERS = [f"{name}[{number}]" for name in ("voltages", "currents") for number in (1, 2, 3)]
"""The registers of two words each from the address 0 on."""


class Exchange(NamedTuple):
    """A read or a write of floats from an address on. An exception is the answer where it is not 0."""

    transaction: int
    code: int
    address: int
    floats: tuple[float, ...]
    exception: int

    @property
    def content(self) -> bytes:
        """The bytes of the registers."""
        return struct.pack(f">{len(self.floats)}f", *self.floats)

    @property
    def request(self) -> bytes:
        """The frame of the request."""
        count = 2 * len(self.floats)
        body = struct.pack(">BHH", self.code, self.address, count)
        return self._frame(body + (bytes([2 * count]) + self.content if self.code == 16 else b""))

    @property
    def answer(self) -> bytes:
        """The frame of the answer."""
        if self.exception:
            return self._frame(bytes([self.code | 0x80, self.exception]))
        if self.code == 16:
            return self._frame(struct.pack(">BHH", self.code, self.address, 2 * len(self.floats)))
        return self._frame(bytes([self.code, len(self.content)]) + self.content)

    def _frame(self, body: bytes) -> bytes:
        return struct.pack(">HHHB", self.transaction, 0, 1 + len(body), UNIT) + body


def exchanges(chance: random.Random, count: int) -> list[Exchange]:
    """Reads of input registers, some refused, and writes of the holding register of two words."""
    result = []
    for number in range(1, count + 1):
        first = chance.randrange(len(REGISTERS))
        size = chance.randrange(1, len(REGISTERS) - first + 1)
        is_write = chance.random() < 0.2
        floats = tuple(chance.randrange(4, 4000) / 4 for _ in range(1 if is_write else size))
        exception = chance.choice((1, 2, 3)) if not is_write and chance.random() < 0.1 else 0
        result.append(Exchange(number, 16 if is_write else 4, 0 if is_write else 2 * first, floats, exception))
    return result


class Segment(NamedTuple):
    """A segment of TCP. `milliseconds` have gone by before its capture, beside one for each packet."""

    is_request: bool
    sequence: int
    acknowledged: int
    flags: int
    data: bytes
    milliseconds: int = 0


class Talk:
    """Both sides of a connection, which send from some numbers on."""

    def __init__(self, client: int, server: int) -> None:
        self.segments: list[Segment] = []
        self.next = {True: client, False: server}

    def send(self, is_request: bool, data: bytes, flags: int = PUSH_ACK) -> None:
        """Sends a segment of one side."""
        own, other = self.next[is_request], self.next[not is_request]
        self.segments.append(Segment(is_request, own % 2**32, other % 2**32 if flags & ACK else 0, flags, data))
        self.next[is_request] = own + len(data) + bool(flags & SYN)

    def open(self) -> None:
        """Shakes hands."""
        self.send(True, b"", SYN)
        self.send(False, b"", SYN | ACK)
        self.send(True, b"", ACK)


Turns = Iterator[tuple[bool, list[bytes]]]
"""What one side sends after the other: its side, and the data of its segments."""


def turns(talk: Sequence[Exchange], frames: int, cuts: int, head: int, chance: random.Random) -> Turns:
    """So many frames at once, cut so often. No cut is among the first bytes of a frame, of which there are `head`."""
    for first in range(0, len(talk), frames):
        some = talk[first : first + frames]
        yield True, pieces([exchange.request for exchange in some], cuts, head, chance)
        yield False, pieces([exchange.answer for exchange in some], cuts, head, chance)


def pieces(frames: Sequence[bytes], cuts: int, head: int, chance: random.Random) -> list[bytes]:
    """Frames one after another, in pieces."""
    data = b"".join(frames)
    starts = [sum(map(len, frames[:number])) for number in range(len(frames))]
    places = [start + at for start, frame in zip(starts, frames, strict=True) for at in range(head, len(frame))]
    ends = [0, *sorted(chance.sample(places, min(cuts, len(places)))), len(data)]
    return [data[left:right] for left, right in pairwise(ends)]


def connection(content: Turns, client: int = 1000, server: int = 5000) -> list[Segment]:
    """A connection from its first packet to its last one."""
    talk = Talk(client, server)
    talk.open()
    for is_request, parts in content:
        for part in parts:
            talk.send(is_request, part)
        talk.send(not is_request, b"", ACK)
    talk.send(True, b"", FIN_ACK)
    return talk.segments


def runs_of_side(segments: Sequence[Segment]) -> Iterator[list[Segment]]:
    """The data that one side sends before the other one answers; segments without data are runs of their own."""
    run: list[Segment] = []
    for segment in segments:
        if run and (run[0].is_request != segment.is_request or not run[0].data or not segment.data):
            yield run
            run = []
        run.append(segment)
    yield run


def sent_again(segments: Sequence[Segment], chance: random.Random) -> list[Segment]:
    """Some segments come again, at once or after others of the same side."""
    result = []
    for run in runs_of_side(segments):
        again = [segment for segment in run if segment.data and chance.random() < 0.4]
        result += chance.choice(([*run, *again], [each for segment in run for each in [segment, *again[:1]]]))
    return result


def overlapping(segments: Sequence[Segment], _: random.Random) -> list[Segment]:
    """Segments that begin with the data of the one before."""
    result = []
    for run in runs_of_side(segments):
        for before, segment in zip([None, *run], run, strict=False):
            if before is not None and before.data:
                segment = segment._replace(sequence=before.sequence, data=before.data + segment.data)
            result.append(segment)
    return result


def out_of_order(segments: Sequence[Segment], chance: random.Random) -> list[Segment]:
    """The segments of a run in any order."""
    return [segment for run in runs_of_side(segments) for segment in chance.sample(run, len(run))]


def late(segments: Sequence[Segment], _: random.Random) -> list[Segment]:
    """The first segment of a run was lost before the capture, and comes again after the others, seconds later."""
    result: list[Segment] = []
    time = 0
    for run in runs_of_side(segments):
        result += [segment._replace(milliseconds=time) for segment in run[1:]]
        time += 3000 if len(run) > 1 else 0
        result.append(run[0]._replace(milliseconds=time))
    return result


def ethernet(kind: int, packet: bytes, *tags: int) -> bytes:
    """A packet of Ethernet, with the types of tags of VLANs before its own."""
    head = b"".join(struct.pack(">HH", tag, 100 + number) for number, tag in enumerate(tags))
    return bytes(12) + head + struct.pack(">H", kind) + packet


def ipv4(is_request: bool, content: bytes) -> bytes:
    """A packet of IPv4."""
    hosts = [b"\x0a\0\0\1", b"\x0a\0\0\2"][:: 1 if is_request else -1]
    return struct.pack(">BBHHHBBH", 0x45, 0, 20 + len(content), 0, 0, 64, 6, 0) + b"".join(hosts) + content


def ipv6(is_request: bool, content: bytes, *extensions: tuple[int, bytes]) -> bytes:
    """A packet of IPv6, with extension headers by their kinds."""
    hosts = [bytes.fromhex(f"20010db8{0:020x}{number:04x}") for number in (1, 2)][:: 1 if is_request else -1]
    kinds = [*(kind for kind, _ in extensions), 6]
    body = b"".join(bytes([after]) + rest for after, (_, rest) in zip(kinds[1:], extensions, strict=True)) + content
    return struct.pack(">IHBB", 6 << 28, len(body), kinds[0], 64) + b"".join(hosts) + body


OPTIONS = b"\0\1\4\0\0\0\0"
"""The rest of a header of options, of which there are none."""

Wrap = Callable[[bool, bytes], bytes]
NETWORKS: dict[str, tuple[int, Wrap]] = {
    "IPv4": (1, lambda way, data: ethernet(0x0800, ipv4(way, data))),
    "IPv6": (1, lambda way, data: ethernet(0x86DD, ipv6(way, data))),
    "IPv6 with options": (1, lambda way, data: ethernet(0x86DD, ipv6(way, data, (0, OPTIONS), (60, OPTIONS)))),
    "IPv6 in one fragment": (1, lambda way, data: ethernet(0x86DD, ipv6(way, data, (44, bytes(7))))),
    "VLAN": (1, lambda way, data: ethernet(0x0800, ipv4(way, data), 0x8100)),
    "VLAN and IPv6": (1, lambda way, data: ethernet(0x86DD, ipv6(way, data), 0x8100)),
    "QinQ": (1, lambda way, data: ethernet(0x0800, ipv4(way, data), 0x88A8, 0x8100)),
    "old QinQ": (1, lambda way, data: ethernet(0x0800, ipv4(way, data), 0x9100, 0x8100)),
    "QinQ and IPv6": (1, lambda way, data: ethernet(0x86DD, ipv6(way, data), 0x88A8, 0x8100)),
    "padding of Ethernet": (1, lambda way, data: ethernet(0x0800, ipv4(way, data)) + bytes(9)),
    "Linux cooked": (113, lambda way, data: struct.pack(">HHH8xH", 0, 1, 6, 0x0800) + ipv4(way, data)),
    "Linux cooked, IPv6": (113, lambda way, data: struct.pack(">HHH8xH", 0, 1, 6, 0x86DD) + ipv6(way, data)),
    "Linux cooked 2": (276, lambda way, data: struct.pack(">HHIHBB8x", 0x86DD, 0, 1, 1, 0, 6) + ipv6(way, data)),
    "raw IP": (101, ipv6),
    "loopback of BSD": (108, lambda way, data: struct.pack(">I", 2) + ipv4(way, data)),
}


def packets(segments: Iterable[Segment], wrap: Wrap) -> Iterator[bytes]:
    """The packets of segments."""
    for segment in segments:
        ports = [CLIENT_PORT, PORT][:: 1 if segment.is_request else -1]
        numbers = (segment.sequence % 2**32, segment.acknowledged)
        head = struct.pack(">HHIIBBHHH", *ports, *numbers, 0x50, segment.flags, 8192, 0, 0)
        yield wrap(segment.is_request, head + segment.data)


class Packet(NamedTuple):
    """A packet of a file: its nanoseconds, its bytes, and how many of them are captured."""

    time: int
    data: bytes
    size: int


def pcap(order: str, ticks: int, link_type: int, content: Sequence[Packet]) -> bytes:
    """A file of pcap in a byte order, with times in ticks of a second."""
    magic = {10**6: 0xA1B2C3D4, 10**9: 0xA1B23C4D}[ticks]
    parts = [struct.pack(f"{order}IHHiIII", magic, 2, 4, 0, 0, 0x40000, link_type)]
    for packet in content:
        seconds, rest = divmod(packet.time, 10**9)
        head = (seconds, rest * ticks // 10**9, packet.size, len(packet.data))
        parts += [struct.pack(f"{order}IIII", *head), packet.data[: packet.size]]
    return b"".join(parts)


def block(order: str, kind: int, body: bytes) -> bytes:
    """A block of pcapng."""
    body += bytes(-len(body) % 4)
    size = struct.pack(f"{order}I", len(body) + 12)
    return struct.pack(f"{order}I", kind) + size + body + size


def pcapng(order: str, kind: int, link_type: int, content: Sequence[Packet]) -> bytes:
    """A file of pcapng in a byte order, whose packets are in blocks of a kind: 2, 3 or 6."""
    options = struct.pack(f"{order}HHB3xHH", 9, 1, 9, 0, 0)
    parts = [
        block(order, 0x0A0D0D0A, struct.pack(f"{order}IHHq", 0x1A2B3C4D, 1, 0, -1)),
        block(order, 1, struct.pack(f"{order}HHI", link_type, 0, 0) + options),
    ]
    for packet in content:
        sizes = (packet.time >> 32, packet.time & 0xFFFFFFFF, packet.size, len(packet.data))
        head = {
            2: struct.pack(f"{order}HHIIII", 0, 0, *sizes),
            3: struct.pack(f"{order}I", len(packet.data)),
            6: struct.pack(f"{order}IIIII", 0, *sizes),
        }[kind]
        parts.append(block(order, kind, head + packet.data[: packet.size]))
    return b"".join(parts)


Form = Callable[[int, Sequence[Packet]], bytes]
FORMS: dict[str, Form] = {
    "pcap": lambda link, content: pcap("<", 10**6, link, content),
    "pcap in nanoseconds": lambda link, content: pcap("<", 10**9, link, content),
    "pcap of the other order": lambda link, content: pcap(">", 10**6, link, content),
    "pcap of the other order in nanoseconds": lambda link, content: pcap(">", 10**9, link, content),
    "pcapng": lambda link, content: pcapng("<", 6, link, content),
    "pcapng of the other order": lambda link, content: pcapng(">", 6, link, content),
    "pcapng with the first kind of packets": lambda link, content: pcapng("<", 2, link, content),
    "pcapng with that kind in the other order": lambda link, content: pcapng(">", 2, link, content),
    "pcapng without times": lambda link, content: pcapng("<", 3, link, content),
    "pcap in gzip": lambda link, content: gzip.compress(pcap("<", 10**6, link, content), mtime=0),
    "pcapng in gzip": lambda link, content: gzip.compress(pcapng(">", 6, link, content), mtime=0),
    "pcap in gzip of two members": lambda link, content: b"".join(
        gzip.compress(part, mtime=0) for part in halves(pcap("<", 10**9, link, content))
    ),
}


def halves(data: bytes) -> tuple[bytes, bytes]:
    """Two parts of some bytes."""
    return data[: len(data) // 2], data[len(data) // 2 :]


def capture(segments: Sequence[Segment], network: str = "IPv4", form: str = "pcap", most: int = 1 << 18) -> bytes:
    """A capture of segments, a millisecond from packet to packet, of which each has `most` bytes."""
    link_type, wrap = NETWORKS[network]
    content = [
        Packet((number + 1 + segment.milliseconds) * 10**6, data, min(len(data), most))
        for number, (segment, data) in enumerate(zip(segments, packets(segments, wrap), strict=True))
    ]
    return FORMS[form](link_type, content)
