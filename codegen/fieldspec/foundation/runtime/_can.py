"""CAN frames: their identifier, and the parts that are its bits."""

from __future__ import annotations

from ._error import CodecError
from ._record import Record
from ._typing import TYPE_CHECKING

if TYPE_CHECKING:
    from typing import Literal

    from ._typing import Data

    Field = tuple[int, Literal["big", "little"], int, int]

_EXTENDED, _REMOTE = 1 << 31, 1 << 30
_HEADER = 8
_DATA = 8


class CanFrame(Record):
    """The identifier and the data of a CAN frame, as drivers take and give them; `is_extended` means 29 bits.

    `dlc` is the number of the data. A remote request has no data, and `dlc` is the number that it asks for.
    """

    __slots__ = ("data", "dlc", "identifier", "is_extended", "is_remote")
    __match_args__ = ("identifier", "data", "is_extended", "is_remote", "dlc")

    def __init__(
        self,
        identifier: int,
        data: bytes = b"",
        is_extended: bool = False,
        is_remote: bool = False,
        dlc: int | None = None,
    ) -> None:
        self.identifier, self.data, self.is_extended, self.is_remote = identifier, data, is_extended, is_remote
        self.dlc = len(data) if dlc is None else dlc

    @classmethod
    def of(cls, frame: Data) -> CanFrame:
        """The record of a frame as encoders return it. Raises CodecError for other bytes."""
        identifier = int.from_bytes(frame[:4], "big")
        is_remote = bool(identifier & _REMOTE)
        if len(frame) < _HEADER or len(frame) != _HEADER + (0 if is_remote else frame[4]):
            raise CodecError("wrong_mark", "it is not a CAN frame", 0)
        is_extended = bool(identifier & _EXTENDED)
        return cls(identifier & ~(_EXTENDED | _REMOTE), bytes(frame[_HEADER:]), is_extended, is_remote, frame[4])

    def frame(self) -> bytes:
        """The frame as decoders take it."""
        flags = (_EXTENDED if self.is_extended else 0) | (_REMOTE if self.is_remote else 0)
        data = b"" if self.is_remote else self.data
        return (self.identifier | flags).to_bytes(4, "big") + bytes((self.dlc, 0, 0, 0)) + data


class CanIdentifier:
    """The parts of an identifier with some bits: the size, the order, the first bit and the bits of each.

    `remote` is the place of the code among them where remote requests are sent: it has a bit for these, which are
    sent without data, and the number of the data in place of data.
    """

    __slots__ = ("bits", "fields", "flags", "remote", "size")

    def __init__(self, bits: int, *fields: Field, remote: int = -1) -> None:
        self.bits, self.fields, self.remote = bits, fields, remote
        self.flags = _EXTENDED if bits == 29 else 0
        self.size = sum(field[0] for field in fields)

    def escaped(self, data: Data) -> bytes:
        """The frame of the bytes of some parts and of the data. Raises CodecError."""
        identifier, offset = self.flags, 0
        for row, (size, order, first, width) in enumerate(self.fields):
            number = int.from_bytes(data[offset : offset + size], order)
            if row == self.remote:
                identifier |= number & _REMOTE
                number &= ~_REMOTE
            if number >> width:
                raise CodecError("out_of_range", f"{number} has more than {width} bits")
            identifier |= number << first
            offset += size
        content = bytes(data[offset:])
        size = len(content)
        if identifier & _REMOTE:
            size, content = content[0] if size == 1 else size, b""
        if size > _DATA:
            raise CodecError("wrong_length", f"a CAN frame has at most {_DATA} bytes of data, not {size}")
        return identifier.to_bytes(4, "big") + bytes((size, 0, 0, 0)) + content

    def original(self, data: Data, offset: int) -> bytes:
        """The bytes of the parts and the data of a frame; `offset` is its place. Raises CodecError."""
        identifier = int.from_bytes(data[:4], "big")
        remote = identifier & _REMOTE if self.remote >= 0 else 0
        wrong = 0 if len(data) < _HEADER or identifier & ~((1 << self.bits) - 1) != self.flags | remote else -1
        if wrong < 0 and (len(data) != _HEADER + (0 if remote else data[4]) or data[4] > _DATA):
            wrong = 4
        if wrong < 0 and any(data[5:_HEADER]):
            wrong = 5
        if wrong >= 0:
            text, size = f"it is not a CAN frame with an identifier of {self.bits} bits", len(data) - _HEADER
            if wrong == 4 and remote and size:
                text = f"a remote request has no data, but there are {size} bytes"
            elif wrong == 4 and not remote and data[4] != size:
                text = f"byte 4 says {data[4]} bytes of data, but there are {size}"
            elif wrong == 4:
                text = f"a CAN frame has at most {_DATA} bytes of data, not {size}"
            elif wrong == 5:
                text = "the three bytes after the data length are not zero"
            raise CodecError("wrong_mark", text, offset + wrong)
        parts = [
            (identifier >> first & (1 << width) - 1 | (remote if row == self.remote else 0)).to_bytes(size, order)
            for row, (size, order, first, width) in enumerate(self.fields)
        ]
        return b"".join(parts) + bytes(data[4:5] if remote else data[_HEADER:])

    def end(self, _data: bytearray, _offset: int, _end: bytes) -> int:
        """-1: frames come one by one."""
        return -1
