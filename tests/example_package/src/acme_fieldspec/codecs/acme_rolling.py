"""A sum of 16 bits from 5AA5h on, turned by three bits before each byte."""

from __future__ import annotations


def checksum(data: bytes) -> int:
    """The sum of some bytes."""
    total = 0x5AA5
    for byte in data:
        total = (total << 3 | total >> 13) & 0xFFFF
        total = total + byte & 0xFFFF
    return total
