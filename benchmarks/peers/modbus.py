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


def _position(following: int) -> tuple[int, ...]:
    """What each byte adds to the CRC, its bytes exchanged, of a frame in which so many bytes follow."""
    places = TABLE
    for _ in range(following):
        places = [crc >> 8 ^ TABLE[crc & 255] for crc in places]
    return tuple((crc & 255) << 8 | crc >> 8 for crc in places)


WHOLE = struct.Struct(">BBHHH")
pack, unpack, new = WHOLE.pack, WHOLE.unpack, object.__new__
P0, P2, P3 = _position(0), _position(2), _position(3)
ALWAYS = crc16(bytes((0, 3, 0, 0, 0, 0)))
STATIONS = tuple((ALWAYS & 255) << 8 ^ ALWAYS >> 8 ^ share for share in _position(5)[:17])


class Message:
    """What a request to read registers says; the least that `written` and `read` can do with it is all there is."""

    __slots__ = ("count", "start")

    def __init__(self, start: int, count: int) -> None:
        self.start = start
        self.count = count


class Addressed:
    """A message and its station."""

    __slots__ = ("message", "station")
    station: int
    message: Message


def encoded_bytes(station: int, message: Message) -> bytes:
    """A frame in one `pack`, its CRC by a table for each place: nothing by hand was found to be faster."""
    start, count = message.start, message.count
    try:
        if 1 <= count <= 60:
            return pack(station, 3, start, count, STATIONS[station] ^ P3[start >> 8] ^ P2[start & 255] ^ P0[count])
    except (struct.error, LookupError):
        pass
    raise ValueError(f"{station}, {start}, {count}")


def read(frame: bytes) -> Addressed:
    """The other way round, with one `unpack`."""
    station, function, start, count, check = unpack(frame)
    if check != STATIONS[station] ^ P3[start >> 8] ^ P2[start & 255] ^ P0[count] or function != 3:
        raise ValueError("CRC or function")
    message = new(Message)
    message.start = start
    message.count = count
    addressed = new(Addressed)
    addressed.station = station
    addressed.message = message
    return addressed


CONSTRUCT = c.Struct(
    "body"
    / c.RawCopy(
        c.Struct("station" / c.Int8ub, "function" / c.Const(3, c.Int8ub), "start" / c.Int16ub, "count" / c.Int16ub)
    ),
    "check" / c.Checksum(c.Int16ul, crc16, c.this.body.data),
).compile()
