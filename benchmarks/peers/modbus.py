"""Modbus RTU's request to read registers: by hand, and with construct."""

from __future__ import annotations

import struct

import construct as c

HEAD = struct.Struct(">BBHH")


def _table() -> list[int]:
    table = []
    for byte in range(256):
        crc = byte
        for _ in range(8):
            crc = crc >> 1 ^ 0xA001 if crc & 1 else crc >> 1
        table.append(crc)
    return table


TABLE = _table()


def crc16(data: bytes) -> int:
    """The CRC of Modbus, a look-up for each byte."""
    crc = 0xFFFF
    for byte in data:
        crc = crc >> 8 ^ TABLE[(crc ^ byte) & 255]
    return crc


class ReadRequest:
    """A request, by hand: it checks lengths, ranges, the function and the CRC, as the generated one does."""

    __slots__ = ("count", "start", "station")

    def __init__(self, station: int, start: int, count: int) -> None:
        self.station = station
        self.start = start
        self.count = count

    def build(self) -> bytes:
        """The frame."""
        if not 0 <= self.station <= 16:
            raise ValueError(f"station is {self.station}")
        if not 1 <= self.count <= 125:
            raise ValueError(f"count is {self.count}")
        body = HEAD.pack(self.station, 3, self.start, self.count)
        return body + crc16(body).to_bytes(2, "little")

    @classmethod
    def parse(cls, frame: bytes) -> ReadRequest:
        """The request of a frame."""
        if len(frame) != 8:
            raise ValueError(f"{len(frame)} bytes")
        body = frame[:6]
        if crc16(body) != frame[6] | frame[7] << 8:
            raise ValueError("CRC")
        station, function, start, count = HEAD.unpack(body)
        if function != 3:
            raise ValueError(f"function {function}")
        if not 1 <= count <= 125:
            raise ValueError(f"count is {count}")
        return cls(station, start, count)


CONSTRUCT = c.Struct(
    "body"
    / c.RawCopy(
        c.Struct("station" / c.Int8ub, "function" / c.Const(3, c.Int8ub), "start" / c.Int16ub, "count" / c.Int16ub)
    ),
    "check" / c.Checksum(c.Int16ul, crc16, c.this.body.data),
).compile()
