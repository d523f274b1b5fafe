"""The position of an encoder with 16 tracks, of which one changes at each step."""

from __future__ import annotations


def decode(data: bytes) -> int:
    """The position in two bytes."""
    number = data[0] << 8 | data[1]
    for shift in (8, 4, 2, 1):
        number ^= number >> shift
    return number


def encode(number: int) -> bytes:
    """The tracks of a position."""
    return (number ^ number >> 1).to_bytes(2, "big")
