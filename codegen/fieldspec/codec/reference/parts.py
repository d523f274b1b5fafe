"""The parts of frames as constructs, and their checksums."""

from __future__ import annotations

import construct

from fieldspec.codec.layout.part import PartLayout
from fieldspec.codec.reference.checksums import checksum, checksum_digits
from fieldspec.codec.reference.structs import value_construct


def part_construct(part: PartLayout) -> construct.Construct:
    """A part as a number; a check has no value of its own."""
    if part.role != "checksum":
        return value_construct(part.value, part.order, False)
    if part.digits:
        return construct.Bytes(part.size)
    return construct.BytesInteger(part.size, swapped=part.order != "big")


def checksum_of(part: PartLayout, data: bytes) -> int | bytes:
    """The checksum of the bytes that it covers: a number, or digits."""
    number = checksum(part.algorithm, data[part.start : part.stop], part.order)
    return checksum_digits(number, part.digits, part.size) if part.digits else number


def checksum_text(value: int | bytes, part: PartLayout) -> str:
    """A checksum as it is on the wire: its digits, or its bytes in their order."""
    if isinstance(value, bytes):
        return value.decode("latin-1")
    return value.to_bytes(part.size, "little" if part.order == "little" else "big").hex(" ").upper()
