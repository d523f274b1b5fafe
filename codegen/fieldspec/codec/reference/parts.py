"""The parts of frames as constructs, and their checksums."""

from __future__ import annotations

from typing import Any

import construct

from fieldspec.codec.layout.frame import FrameLayout
from fieldspec.codec.layout.part import PartLayout
from fieldspec.codec.reference.checksums import checksum, checksum_digits
from fieldspec.codec.reference.structs import value_construct


def part_construct(part: PartLayout) -> construct.Construct:
    """A part as a number; a check has no value of its own."""
    if part.width:
        return _Bits(construct.BytesInteger(part.size, swapped=part.order != "big"), part.shift, part.width)
    if part.role != "checksum":
        return value_construct(part.value, part.order, False)
    if part.digits:
        return construct.Bytes(part.size)
    return construct.BytesInteger(part.size, swapped=part.order != "big")


class _Bits(construct.Adapter):  # type: ignore[misc]
    """A number in some bits of a whole one; the other bits are built as 0."""

    def __init__(self, whole: construct.Construct, shift: int, width: int) -> None:
        super().__init__(whole)
        self.factor, self.modulus = 1 << shift, 1 << width

    def _decode(self, whole: int, context: Any, path: str) -> int:
        return whole // self.factor % self.modulus

    def _encode(self, number: int, context: Any, path: str) -> int:
        if not 0 <= number < self.modulus:
            raise construct.IntegerError(f"{number} does not fit its bits", path=path)
        return number * self.factor


class FrameParts:
    """The parts around the data of all frames in one direction, with what depends on their layout alone."""

    def __init__(self, shape: FrameLayout) -> None:
        self.shape = shape
        self.lengths, self.checksums = shape.lengths, shape.checksums
        self.digits, self.constants = shape.digits, shape.constants
        self.code, self.unit_address = shape.role("code"), shape.role("unit_address")
        self.visible = [
            part.name for part in shape.header if part.role not in ("length", "checksum") and not part.reserved
        ]
        """The names of the parts before the data that belong to what a frame says."""
        self._constructs = [(part, part_construct(part)) for part in shape.parts]

    def numbers(self, data: bytes, is_sent: bool = False) -> dict[str, Any]:
        """The numbers of parts by name, None for what is not digits. In sent bytes, no escaped part has its place."""
        size = len(data)
        return {
            part.name: number.parse(data[part.at(size) : part.at(size) + part.size])
            for part, number in self._constructs
            if not (is_sent and part.escaped)
        }

    def data(self, numbers: dict[str, Any], body: bytes) -> bytes:
        """The bytes of all parts around some data."""
        header, trailer = bytearray(self.shape.header_size), bytearray(self.shape.trailer_size)
        for part, number in self._constructs:
            side, offset = (header, part.offset) if part.offset >= 0 else (trailer, part.at(len(trailer)))
            for place, byte in enumerate(number.build(numbers[part.name]), offset):
                side[place] |= byte
        return bytes(header) + body + bytes(trailer)


def checksum_of(part: PartLayout, data: bytes) -> int | bytes:
    """The checksum of the bytes that it covers: a number, or digits."""
    number = checksum(part.algorithm, data[part.start : part.stop], part.order)
    return checksum_digits(number, part.digits, part.size) if part.digits else number


def checksum_text(value: int | bytes, part: PartLayout) -> str:
    """A checksum as it is on the wire: its digits, or its bytes in their order."""
    if isinstance(value, bytes):
        return value.decode("latin-1")
    return value.to_bytes(part.size, "little" if part.order == "little" else "big").hex(" ").upper()
