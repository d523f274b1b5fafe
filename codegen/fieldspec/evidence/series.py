"""The values that one register, field or bit had over time, summed up so that series can be compared."""

from __future__ import annotations

from typing import TypeAlias

from fieldspec.classes import dataclass, field
from fieldspec.model.quantity import real_text

MOST_VALUES = 1 << 12
"""The different values that are remembered of one series."""

SeriesValue: TypeAlias = "int | float | str"


@dataclass(slots=True)
class Series:
    """How often a value was seen, which ones, and where first.

    `pattern` is equal for two series if the moments at which they change, and what they return to, are the same: each
    value of one then goes with one value of the other.
    """

    where: str
    count: int = 0
    labels: dict[SeriesValue, int] = field(default_factory=dict)
    pattern: int = 0
    label: int = -1

    def add(self, value: SeriesValue, moment: int) -> None:
        """Adds a value that was seen at a moment, later than those before."""
        self.count += 1
        label = self.labels.get(value, -1)
        if label < 0:
            label = len(self.labels)
            if label < MOST_VALUES:
                self.labels[value] = label
            else:
                label += self.count
        if label != self.label:
            self.pattern = hash((self.pattern, moment, label))
            self.label = label

    @property
    def changes(self) -> bool:
        """Whether there were two different values."""
        return len(self.labels) > 1

    @property
    def is_zero(self) -> bool:
        """Whether it was always 0."""
        return all(value == 0 for value in self.labels)

    @property
    def text(self) -> str:
        """The values in a few words: all of a few, else the least and the greatest."""
        numbers = [value for value in self.labels if not isinstance(value, str)]
        if len(self.labels) <= 4 or len(numbers) < len(self.labels):
            values = sorted(self.labels, key=lambda value: (isinstance(value, str), value))
            return ", ".join(_value_text(value) for value in values[:4]) + (", .." if len(values) > 4 else "")
        return f"{_value_text(min(numbers))}..{_value_text(max(numbers))}"


def _value_text(value: SeriesValue) -> str:
    return real_text(value) if isinstance(value, float) else str(value)
