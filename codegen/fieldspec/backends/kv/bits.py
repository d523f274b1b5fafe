"""Which bits of which words a value has."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

Bit = tuple[int, int]
"""A word, and a bit in it; bit 0 is the least significant."""


def bits(start: int, size: int, order: str, swapped: bool, unit: int) -> tuple[Bit, ...]:
    """The bits of a number in memory, the least significant first.

    It begins at a byte of its area, whose words hold `unit` bytes each, the first one of two in the upper half.
    """
    return tuple(
        (byte // unit, 8 * (unit - 1 - byte % unit) + bit)
        for significance in range(size)
        for byte in (start + wire_byte(significance, size, order, swapped),)
        for bit in range(8)
    )


def wire_byte(significance: int, size: int, order: str, swapped: bool) -> int:
    """Which byte on the wire, from 0, is the one with a significance, from 0."""
    byte = size - 1 - significance if order == "big" else significance
    return (size // 2 - 1 - byte // 2) * 2 + byte % 2 if swapped else byte


def written(held: Sequence[Bit], first: int) -> str:
    """Bits as text, the most significant first: `15..0`, `3`, `1:15..0 0:15..0`.

    The number before a colon is that of the word, counted from `first`; it is left out where all are in that word.
    """
    runs: list[tuple[int, int, int]] = []
    for word, bit in reversed(held):
        if runs and runs[-1][0] == word and runs[-1][2] == bit + 1:
            runs[-1] = (word, runs[-1][1], bit)
        else:
            runs.append((word, bit, bit))
    alone = all(word == first for word, _, _ in runs)
    return " ".join(("" if alone else f"{word - first}:") + _span(high, low) for word, high, low in runs)


def words(held: Iterable[Bit]) -> int:
    """How many words some bits reach over."""
    numbers = [word for word, _ in held]
    return max(numbers) - min(numbers) + 1


def _span(high: int, low: int) -> str:
    return str(high) if high == low else f"{high}..{low}"
