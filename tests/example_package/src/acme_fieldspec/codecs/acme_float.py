"""A number as a sign, a power of ten from 0 to 4, and 16 bits: `82 01 F4` is -500 * 10^2."""

from __future__ import annotations


def decode(data: bytes) -> int | None:
    """The number of three bytes; None where the first one has other bits."""
    power = data[0] & 0x7F
    if power > 4:
        return None
    number = data[1] << 8 | data[2]
    for _ in range(power):
        number *= 10
    return -number if data[0] & 0x80 else number


def encode(number: int) -> bytes:
    """The bytes of the nearest number."""
    power, rest = 0, abs(number)
    while rest > 0xFFFF:
        power += 1
        rest = (abs(number) + 10**power // 2) // 10**power
    return bytes((0x80 * (number < 0) | power, rest >> 8, rest & 0xFF))
