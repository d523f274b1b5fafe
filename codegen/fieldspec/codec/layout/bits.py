"""Bits in bytes: the first one is the least significant bit of the first byte, and the last byte is filled with 0."""

from __future__ import annotations

from collections.abc import Iterator, Sequence


def packed_size(count: int) -> int:
    """The bytes that a number of bits take."""
    return (count + 7) // 8


def packed_bits(bits: Sequence[int]) -> bytes:
    """The bytes that carry bits, the first bit lowest in the first byte."""
    number = sum(bit << index for index, bit in enumerate(bits))
    return number.to_bytes(packed_size(len(bits)), "little")


def unpacked_bits(data: bytes) -> Iterator[int]:
    """All bits of some bytes, with those that only fill the last one."""
    for byte in data:
        yield from (byte >> index & 1 for index in range(8))
