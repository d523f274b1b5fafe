"""Intervals of numbers: the intervals of a value, and the gaps between them."""

from __future__ import annotations

from bisect import bisect_left
from decimal import Decimal
from operator import itemgetter

from fieldspec.foundation.classes import TYPE_CHECKING, dataclass

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence


@dataclass(frozen=True, slots=True)
class Ranges:
    """Intervals with both ends, in ascending order.

    The ends are whole numbers. Those of a floating-point value may have a fraction; they are then the floats that the
    value can be exactly.
    """

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

    def includes(self, low: int, high: int) -> bool:
        """Whether one of the intervals has all numbers from `low` to `high`."""
        return any(first <= low and high <= last for first, last in self.intervals)

    def text(self) -> str:
        """`0..127, 10000..10127`"""
        pairs = ((bound_text(low), bound_text(high)) for low, high in self.intervals)
        return ", ".join(low if low == high else f"{low}..{high}" for low, high in pairs)


def bound_text(bound: float) -> str:
    """A bound with all its digits, and never with an exponent."""
    return f"{bound}" if isinstance(bound, int) else f"{Decimal(repr(bound)):f}"


def merged(intervals: Iterable[tuple[int, int]], step: int = 1) -> list[tuple[int, int]]:
    """The same numbers in as few intervals as possible, in ascending order.

    `step` is the distance of neighbouring numbers: 1 for whole ones, 0 for those between which there are always others.
    """
    result: list[tuple[int, int]] = []
    for low, high in sorted(intervals):
        if result and low <= result[-1][1] + step:
            result[-1] = result[-1][0], max(result[-1][1], high)
        else:
            result.append((low, high))
    return result


def uncovered(low: int, high: int, merged_intervals: Sequence[tuple[int, int]], step: int = 1) -> list[tuple[int, int]]:
    """The parts of `low` to `high` that are in none of some intervals, which `merged` has put in order.

    With a `step` of 0, the ends that a part shares with an interval do not belong to it.
    """
    holes = []
    start = low
    for index in range(bisect_left(merged_intervals, low, key=itemgetter(1)), len(merged_intervals)):
        first, last = merged_intervals[index]
        if first > high:
            break
        if first > start:
            holes.append((start, first - step))
        start = max(start, last + step)
    if start < high or (start == high and (step or not merged_intervals)):
        holes.append((start, high))
    return holes


def intervals(text: str) -> tuple[tuple[Decimal, Decimal], ...]:
    """`0..127, 10000..10127` as pairs of exact numbers."""
    pairs = []
    for part in text.split(", "):
        low, _, high = part.partition("..")
        pairs.append((_bound_number(low), _bound_number(high or low)))
    return tuple(pairs)


def whole_intervals(text: str) -> tuple[tuple[int, int], ...] | None:
    """The intervals of a text as pairs of whole numbers; None where a bound has a decimal point."""
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


def _bound_number(text: str) -> Decimal:
    return Decimal(int(text, 16)) if "x" in text else Decimal(text)
