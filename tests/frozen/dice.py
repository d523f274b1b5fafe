"""Random numbers by counting: those of a path are the same with every Python, whatever else is drawn."""

from __future__ import annotations

from collections.abc import Sequence
from hashlib import blake2b
from typing import TypeVar

Item = TypeVar("Item")
_SPARE = 8
"""Bytes that are drawn beyond those of a bound, so that no number is likelier than another."""


class Dice:
    """The methods of `random.Random` that the tests draw with, over the digests of a path and a counter."""

    def __init__(self, path: str) -> None:
        self._path = path.encode()
        self._count = 0
        self._bytes = b""

    def randbytes(self, size: int) -> bytes:
        """So many bytes."""
        while len(self._bytes) < size:
            self._bytes += blake2b(b"%d %s" % (self._count, self._path)).digest()
            self._count += 1
        data, self._bytes = self._bytes[:size], self._bytes[size:]
        return data

    def randrange(self, bound: int) -> int:
        """A number from 0 to below a bound."""
        return int.from_bytes(self.randbytes(_SPARE + bound.bit_length() // 8), "big") % bound

    def randint(self, low: int, high: int) -> int:
        """A number between two others, with both of them."""
        return low + self.randrange(high - low + 1)

    def random(self) -> float:
        """A fraction from 0 to below 1."""
        return self.randrange(1 << 53) / (1 << 53)

    def uniform(self, low: float, high: float) -> float:
        """A number between two others."""
        return low + (high - low) * self.random()

    def choice(self, items: Sequence[Item]) -> Item:
        """One of several items."""
        return items[self.randrange(len(items))]

    def sample(self, items: Sequence[Item], count: int) -> list[Item]:
        """So many of several items, each of them once."""
        remaining = list(items)
        return [remaining.pop(self.randrange(len(remaining))) for _ in range(count)]
