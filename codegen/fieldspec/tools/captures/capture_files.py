"""Packets of captures in the formats pcap and pcapng, in batches of a limited size.

Sources: draft-ietf-opsawg-pcap, draft-ietf-opsawg-pcapng.
"""

from __future__ import annotations

import struct
from collections import Counter
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from fieldspec.foundation.classes import dataclass
from fieldspec.tools.captures.columns import NO_TIME, Bytes, Numbers, number_at, numbers

BATCH = 1 << 23
"""The bytes that are read at once."""

LONGEST = 1 << 26
"""The bytes of the longest record or block that a capture may have; a greater length is not a length."""

INTERFACE, PACKET, SIMPLE, ENHANCED = 1, 2, 3, 6
"""The kinds of blocks of pcapng that are read: interfaces, and packets as the first version of the format had them,
without times, and with all."""

NOTHING = bytes(16)
"""The record of a packet without a time and without a byte: what a file has where nothing was written."""

Read = Callable[[int], bytes]
"""Reads at most this number of bytes; returns none at the end."""


class CaptureError(ValueError):
    """A file that is not a capture, or one from which nothing more can be read. `offset` counts bytes of the file."""

    def __init__(self, offset: int, detail: str) -> None:
        super().__init__(f"byte {offset}: {detail}")
        self.offset, self.detail = offset, detail


@dataclass(frozen=True, slots=True)
class Packets:
    """Captured packets: `size` bytes each from `at` on in the buffer. `interface` is the place of the interface.

    `original` is the size that each had before the capture cut it short. `time` is in nanoseconds since 1970. `end` is
    the offset in the file after the last one.
    """

    buffer: Bytes
    at: Numbers
    size: Numbers
    original: Numbers
    time: Numbers
    interface: Numbers
    end: int


@dataclass(slots=True)
class Interface:
    """The kind of packets of an interface, the parts of a second that its times count, and what is added to them."""

    link_type: int
    ticks: int
    offset: int = 0


class CaptureReader:
    """Reads one capture. `interfaces` grows as the file describes them; `losses` counts what cannot be read.

    `position` and `interfaces` are all that is needed to go on reading later, from that byte of the file on. `rest`
    counts the unread bytes; without it they are read to be counted.
    """

    def __init__(self, read: Read, state: dict[str, Any] | None = None, rest: Callable[[], int] | None = None) -> None:
        self.read, self.rest = read, rest or self._rest
        self.losses: Counter[str] = Counter()
        self.pending = b""
        self.position = 0
        self.interfaces: list[Interface] = []
        self.order, self.is_blocks = "", False
        if state is None:
            self._open()
        else:
            self.position, self.order, self.is_blocks = state["position"], state["order"], state["blocks"]
            self.interfaces = [Interface(*values) for values in state["interfaces"]]

    def state(self, end: int) -> dict[str, Any]:
        """What another reader needs to go on after the packets that end at a byte of the file."""
        interfaces = [[own.link_type, own.ticks, own.offset] for own in self.interfaces]
        return {"position": end, "order": self.order, "blocks": self.is_blocks, "interfaces": interfaces}

    def _open(self) -> None:
        head = self._more(24)
        magic = head[:4]
        for order in "<>":
            ticks = {0xA1B2C3D4: 10**6, 0xA1B23C4D: 10**9}.get(struct.unpack(f"{order}I", magic.ljust(4, b"\0"))[0])
            if ticks is not None:
                if len(head) < 24:
                    raise CaptureError(0, "the file ends within its header of 24 bytes")
                self.order = order
                link_type = struct.unpack(f"{order}I", head[20:24])[0] & 0xFFFF
                self.interfaces = [Interface(link_type, ticks)]
                self.pending, self.position = b"", 24
                return
        if magic != b"\x0a\x0d\x0d\x0a":
            begin = magic.hex(" ").upper() or "nothing"
            raise CaptureError(0, f"the file begins with {begin}: neither pcap nor pcapng")
        self.is_blocks = True

    def _more(self, size: int) -> bytes:
        """Reads until there are `size` bytes that no packet has taken, or the file ends."""
        parts = [self.pending]
        available = len(self.pending)
        while available < size and (data := self.read(size - available)):
            parts.append(data)
            available += len(data)
        self.pending = b"".join(parts)
        return self.pending

    def batches(self) -> Iterator[Packets]:
        """The packets of the file. What cannot be read is in `losses`, in bytes."""
        size = BATCH
        while True:
            data = self._more(size)
            if not data:
                return
            places, used = self._blocks(data) if self.is_blocks else self._records(data)
            self.position += used
            self.pending = data[used:]
            if places:
                buffer = np.frombuffer(data, np.uint8)
                heads = numbers(places)
                yield self._of_blocks(buffer, heads) if self.is_blocks else self._of_records(buffer, heads)
            if used:
                size = BATCH
            elif len(data) < size:
                self.losses["truncated"] += len(data)
                return
            else:
                size = len(data) * 2  # the next record is longer than what was read

    def _word(self, buffer: Bytes, offsets: Numbers) -> Numbers:
        return number_at(buffer, offsets, 4, "big" if self.order == ">" else "little")

    def _nanoseconds(self, seconds: Numbers, rest: Numbers, interface: Numbers) -> Numbers:
        """Times in nanoseconds, from seconds and ticks."""
        ticks = numbers([own.ticks for own in self.interfaces])[interface]
        exact = rest * (10**9 // ticks)
        coarse = (rest.astype(np.float64) * (1e9 / ticks)).astype(np.int64)
        return seconds * 10**9 + np.where(10**9 % ticks == 0, exact, coarse)

    def _records(self, data: bytes) -> tuple[list[int], int]:
        """The places of the whole records of a pcap file in some bytes, and how many bytes they take."""
        places: list[int] = []
        size_at = struct.Struct(f"{self.order}I").unpack_from
        offset, end = 0, len(data)
        add = places.append
        while offset + 16 <= end:
            (size,) = size_at(data, offset + 8)
            if size > LONGEST or (not size and data.startswith(NOTHING, offset)):
                self._lose(
                    f"a packet of {size} bytes at byte {self.position + offset}, which no packet has", end - offset
                )
                return places, end
            following = offset + 16 + size
            if following > end:
                break
            add(offset)
            offset = following
        return places, offset

    def _of_records(self, buffer: Bytes, heads: Numbers) -> Packets:
        interface = np.zeros(len(heads), np.int64)
        time = self._nanoseconds(self._word(buffer, heads), self._word(buffer, heads + 4), interface)
        size, original = self._word(buffer, heads + 8), self._word(buffer, heads + 12)
        return Packets(buffer, heads + 16, size, original, time, interface, self.position)

    def _lose(self, reason: str, size: int) -> None:
        """Counts the rest of a file from which no record can be told."""
        self.losses[reason] += size + self.rest()
        self.read = lambda _: b""

    def _rest(self) -> int:
        return sum(map(len, iter(lambda: self.read(BATCH), b"")))

    def _blocks(self, data: bytes) -> tuple[list[int], int]:
        """The places of the packets in the whole blocks of a pcapng file in some bytes, and the bytes of these."""
        places: list[int] = []
        offset, end = 0, len(data)
        while offset + 12 <= end:
            if data[offset : offset + 4] == b"\x0a\x0d\x0d\x0a":
                if places:
                    break  # the interfaces of the next section are others
                self.order = "<" if data[offset + 8 : offset + 12] == b"\x4d\x3c\x2b\x1a" else ">"
                self.interfaces = []
            kind, size = struct.unpack_from(f"{self.order}II", data, offset)
            if size < 12 or size % 4 or size > LONGEST:
                self._lose(
                    f"a block of {size} bytes at byte {self.position + offset}, which no block has", end - offset
                )
                return places, end
            if offset + size > end:
                break
            if (kind in (PACKET, ENHANCED) and size >= 32) or (kind == SIMPLE and size >= 16):
                places.append(offset)
            elif kind == INTERFACE:
                if places:
                    break  # the packets so far belong to the interfaces as they are
                self._add_interface(data[offset + 8 : offset + size - 4])
            offset += size
        return places, offset

    def _of_blocks(self, buffer: Bytes, heads: Numbers) -> Packets:
        """The packets of blocks. Simple blocks have no time and belong to the first interface."""
        kind = self._word(buffer, heads)
        simple = kind == SIMPLE
        room = self._word(buffer, heads + 4) - np.where(simple, 16, 32)
        interface = np.where(simple, 0, self._word(buffer, heads + 8))
        old = kind == PACKET  # its interface has two bytes, and the number of packets before it that are lost two more
        interface[old] = number_at(buffer, heads[old] + 8, 2, "big" if self.order == ">" else "little")
        original = np.where(simple, self._word(buffer, heads + 8), self._word(buffer, heads + 24))
        size = np.where(simple, np.minimum(original, room), self._word(buffer, heads + 20))
        wrong = (size > room) | (interface >= len(self.interfaces))
        self.losses["packets whose block contradicts itself"] += int(room[wrong].sum())
        right = ~wrong
        heads, size, original = heads[right], size[right], original[right]
        interface, simple = interface[right], simple[right]
        count = self._word(buffer, heads + 12) << 32 | self._word(buffer, heads + 16)
        count[simple | (count < 0)] = 0
        ticks = numbers([own.ticks for own in self.interfaces])[interface]
        offset = numbers([own.offset for own in self.interfaces])[interface]
        time = self._nanoseconds(count // ticks + offset, count % ticks, interface)
        time[simple] = NO_TIME
        return Packets(buffer, heads + np.where(simple, 12, 28), size, original, time, interface, self.position)

    def _add_interface(self, body: bytes) -> None:
        """Reads the description of an interface with the options that bear on times."""
        if len(body) < 8:
            self.interfaces.append(Interface(-1, 10**6))
            return
        own = Interface(struct.unpack_from(f"{self.order}H", body)[0], 10**6)
        offset = 8
        while offset + 4 <= len(body):
            code, size = struct.unpack_from(f"{self.order}HH", body, offset)
            value = body[offset + 4 : offset + 4 + size]
            if code == 0:
                break
            if code == 9 and value:
                power = min(value[0] & 0x7F, 62 if value[0] & 0x80 else 18)
                own.ticks = 2**power if value[0] & 0x80 else 10**power
            elif code == 14 and len(value) == 8:
                own.offset = struct.unpack(f"{self.order}q", value)[0]
            offset += 4 + (size + 3) // 4 * 4
        self.interfaces.append(own)
