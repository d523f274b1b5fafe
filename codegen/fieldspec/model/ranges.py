"""The values that a number may take: one or several intervals."""

from __future__ import annotations

from decimal import Decimal

from fieldspec.classes import dataclass


@dataclass(frozen=True, slots=True)
class Ranges:
    """Intervals of whole numbers, both ends included, in the order of the spec."""

    intervals: tuple[tuple[int, int], ...]

    @property
    def low(self) -> int:
        """The least value."""
        return min(low for low, _ in self.intervals)

    @property
    def high(self) -> int:
        """The greatest value."""
        return max(high for _, high in self.intervals)

    def __contains__(self, value: object) -> bool:
        return isinstance(value, int | float) and any(low <= value <= high for low, high in self.intervals)

    def text(self) -> str:
        """`0..127, 10000..10127`"""
        return ", ".join(f"{low}" if low == high else f"{low}..{high}" for low, high in self.intervals)


def intervals(text: str) -> tuple[tuple[Decimal, Decimal], ...]:
    """`0..127, 10000..10127` as pairs of exact numbers."""
    pairs = []
    for part in text.split(", "):
        low, _, high = part.partition("..")
        pairs.append((_number(low), _number(high or low)))
    return tuple(pairs)


def whole_intervals(text: str) -> tuple[tuple[int, int], ...] | None:
    """The same as pairs of whole numbers, or None where a bound is written as a fraction."""
    pairs = []
    for part in text.split(", "):
        low, _, high = part.partition("..")
        try:
            pairs.append((_whole(low), _whole(high or low)))
        except ValueError:
            return None
    return tuple(pairs)


def _whole(text: str) -> int:
    return int(text, 16) if "x" in text else int(text)


def _number(text: str) -> Decimal:
    return Decimal(int(text, 16)) if "x" in text else Decimal(text)
