"""Halves and whole numbers with sign and magnitude: their bits, by Python's `struct` and by counting."""

from __future__ import annotations

import random
import struct
from collections.abc import Iterator

HALVES = [struct.unpack(">e", bits.to_bytes(2, "big"))[0] for bits in range(1 << 16)]
"""The numbers of all bits of a half."""

FIRST_TOO_GREAT = 65520.0
"""The least number that is as near to infinity as to the greatest half."""

MAGNITUDES = [*range(1 << 7), 0, *range(-1, -(1 << 7), -1)]
"""The numbers of all bits of a byte with sign and magnitude."""


def half_bits(number: float) -> int:
    """The bits of the nearest half."""
    return int.from_bytes(struct.pack(">e", number), "big")


def numbers_near_halves(seed: int, count: int) -> Iterator[float]:
    """Halves, numbers midway between two of them and beside the middle, and numbers of all sizes that a half has."""
    dice = random.Random(seed)
    for _ in range(count):
        bits = dice.randrange(0x7BFF)
        middle = (HALVES[bits] + HALVES[bits + 1]) / 2
        sign = dice.choice((-1, 1))
        yield sign * middle
        yield sign * middle * (1 + 2**-52)
        yield sign * middle * (1 - 2**-53)
        yield sign * HALVES[bits]
        yield dice.uniform(-2, 2) * 2.0 ** dice.randint(-27, 14)


def magnitude(data: bytes) -> int:
    """The number of bytes with a sign and a magnitude, the most significant one first."""
    size = int.from_bytes(bytes([data[0] & 0x7F]) + data[1:], "big")
    return -size if data[0] > 0x7F else size
