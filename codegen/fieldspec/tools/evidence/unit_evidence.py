"""The evidence in the files of one unit, value by value."""

from __future__ import annotations

from collections import Counter

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import dataclass, field
from fieldspec.language.model.enums import Bit
from fieldspec.tools.evidence.notes import UnitNote
from fieldspec.tools.evidence.observables import Observable
from fieldspec.tools.evidence.series import Series, SeriesValue


@dataclass(slots=True)
class Trouble:
    """Values that do not fit the spec: how often, a few of them, and where the first one is."""

    where: str
    count: int = 0
    values: list[str] = field(default_factory=list)

    def add(self, value: str) -> None:
        """Counts a value and adds it to the examples."""
        self.count += 1
        if value not in self.values and len(self.values) < 4:
            self.values.append(value)


@dataclass(slots=True)
class UnitEvidence:
    """The evidence of one unit. Keys are the path of a fact, the path of a value, and `read` or `write`.

    `bits` has the path of the bit in place of that of the flags; `refusals` counts exceptions by name.
    """

    note: UnitNote
    layout: DeviceLayout
    sources: list[str] = field(default_factory=list)
    series: dict[tuple[str, str, str], Series] = field(default_factory=dict)
    bits: dict[tuple[str, str, str], Series] = field(default_factory=dict)
    troubles: dict[tuple[str, str, str], Trouble] = field(default_factory=dict)
    refusals: dict[tuple[str, str, str], Counter[str]] = field(default_factory=dict)
    unlisted: dict[tuple[str, int], Trouble] = field(default_factory=dict)
    flags: dict[str, tuple[Bit, ...]] = field(default_factory=dict)

    def add(
        self, item: Observable, path: str, operation: str, value: SeriesValue, moment: int, place_text: str
    ) -> None:
        """Adds a value that the unit has answered with, or has accepted."""
        key = (item.fact.place.path, path, operation)
        series = self.series.get(key)
        if series is None:
            series = self.series[key] = Series(place_text)
        series.add(value, moment)
        if item.value.flags and isinstance(value, int):
            for bit in self._bits(item.value.flags):
                own = (bit.place.path, path, operation)
                if own not in self.bits:
                    self.bits[own] = Series(place_text)
                self.bits[own].add(bit.joined(value), moment)

    def add_trouble(self, item: Observable, path: str, verdict: str, value: str, place_text: str) -> None:
        """Adds a value that does not fit the spec."""
        self.troubles.setdefault((item.fact.place.path, path, verdict), Trouble(place_text)).add(value)

    def add_refusal(self, item: Observable, path: str, operation: str, name: str) -> None:
        """Adds a request that the unit has refused."""
        self.refusals.setdefault((item.fact.place.path, path, operation), Counter())[name] += 1

    def add_unlisted(self, space: str, address: int, value: str, place_text: str) -> None:
        """Adds a word that no register of the spec has."""
        self.unlisted.setdefault((space, address), Trouble(place_text)).add(value)

    def _bits(self, name: str) -> tuple[Bit, ...]:
        if name not in self.flags:
            flags = self.layout.device.flags[name]
            self.flags[name] = tuple(bit for bit in flags.bits if not bit.reserved)
        return self.flags[name]
