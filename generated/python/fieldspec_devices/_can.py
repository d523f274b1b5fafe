"""CAN frames: their identifier, and the parts that are its bits."""

from __future__ import annotations

from ._error import CodecError
from ._record import Record
from ._typing import TYPE_CHECKING

if TYPE_CHECKING:
    from typing import Literal

    from ._typing import Data

    Field = tuple[int, Literal["big", "little"], int, int]

_EXTENDED = 1 << 31
_HEADER = 8
_DATA = 8


class CanFrame(Record):
    """The identifier and the data of a CAN frame, as drivers take and give them; `is_extended` means 29 bits."""

    __slots__ = ("data", "identifier", "is_extended")
    __match_args__ = ("identifier", "data", "is_extended")

    def __init__(self, identifier: int, data: bytes, is_extended: bool = False) -> None:
        self.identifier, self.data, self.is_extended = identifier, data, is_extended

    @classmethod
    def of(cls, frame: Data) -> CanFrame:
        """The record of a frame as encoders return it. Raises CodecError for other bytes."""
        if len(frame) < _HEADER or frame[4] != len(frame) - _HEADER:
            raise CodecError("wrong_mark", "it is not a CAN frame", 0)
        identifier = int.from_bytes(frame[:4], "big")
        return cls(identifier & ~_EXTENDED, bytes(frame[_HEADER:]), bool(identifier & _EXTENDED))

    def frame(self) -> bytes:
        """The frame as decoders take it."""
        identifier = self.identifier | (_EXTENDED if self.is_extended else 0)
        return identifier.to_bytes(4, "big") + bytes((len(self.data), 0, 0, 0)) + self.data


class CanIdentifier:
    """The parts of an identifier with some bits: the size, the order, the first bit and the bits of each."""

    __slots__ = ("bits", "fields", "flags", "size")

    def __init__(self, bits: int, *fields: Field) -> None:
        self.bits, self.fields = bits, fields
        self.flags = _EXTENDED if bits == 29 else 0
        self.size = sum(field[0] for field in fields)

    def escaped(self, data: Data) -> bytes:
        """The frame of the bytes of some parts and of the data. Raises CodecError."""
        identifier, at = self.flags, 0
        for size, order, first, width in self.fields:
            number = int.from_bytes(data[at : at + size], order)
            if number >> width:
                raise CodecError("out_of_range", f"{number} has more than {width} bits")
            identifier |= number << first
            at += size
        if len(data) - at > _DATA:
            raise CodecError("wrong_length", f"a CAN frame has at most {_DATA} bytes of data, not {len(data) - at}")
        return identifier.to_bytes(4, "big") + bytes((len(data) - at, 0, 0, 0)) + bytes(data[at:])

    def original(self, data: Data, offset: int) -> bytes:
        """The bytes of the parts and the data of a frame; `offset` is its place. Raises CodecError."""
        identifier = int.from_bytes(data[:4], "big")
        wrong = 0 if len(data) < _HEADER or identifier & ~((1 << self.bits) - 1) != self.flags else -1
        if wrong < 0 and (data[4] != len(data) - _HEADER or data[4] > _DATA):
            wrong = 4
        if wrong < 0 and any(data[5:_HEADER]):
            wrong = 5
        if wrong >= 0:
            text, size = f"it is not a CAN frame with an identifier of {self.bits} bits", len(data) - _HEADER
            if wrong == 4 and data[4] != size:
                text = f"byte 4 says {data[4]} bytes of data, but there are {size}"
            elif wrong == 4:
                text = f"a CAN frame has at most {_DATA} bytes of data, not {size}"
            elif wrong == 5:
                text = "the three bytes after the data length are not zero"
            raise CodecError("wrong_mark", text, offset + wrong)
        parts = [
            (identifier >> first & (1 << width) - 1).to_bytes(size, order) for size, order, first, width in self.fields
        ]
        return b"".join(parts) + bytes(data[_HEADER:])

    def end(self, _data: bytearray, _at: int, _end: bytes) -> int:
        """-1: frames come one by one."""
        return -1
