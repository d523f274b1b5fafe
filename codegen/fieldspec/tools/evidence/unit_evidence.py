"""The evidence in the files of one unit: its note, and the series of values that facts had over time."""

from __future__ import annotations

import re
from collections import Counter
from typing import TypeAlias

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import dataclass, field
from fieldspec.foundation.source import Span
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.enums import Bit
from fieldspec.language.model.quantity import real_text
from fieldspec.language.reading.nodes import Mapping, Scalar
from fieldspec.language.reading.yaml_reader import decoded, key_span, parsed
from fieldspec.tools.evidence.observables import Observable

FILE = "unit.yaml"
RULE = "evidence_notes_complete"
REDACTED = "redacted"

_REQUIRED = ("model", "firmware", "serial_number")
_KEYS = (*_REQUIRED, "unit_address", "remarks")
_HELP = {
    "model": "write the model as its label has it",
    "firmware": 'write the firmware in quotes, such as "2.12"; `unknown` if it is not known',
    "serial_number": "write `serial_number: redacted`, and remove the number from the files",
}


@dataclass(frozen=True, slots=True)
class UnitNote:
    """A unit: its model and firmware, and its address on a line that it shares; None if the files have only it."""

    name: str
    model: str
    firmware: str
    unit_address: int | None
    remarks: str


def unit_note(name: str, path: str, data: bytes) -> tuple[UnitNote | None, list[Diagnostic]]:
    """The note of a unit from the content of its file, or None, and what is wrong with it."""
    file, findings = decoded(path, data)
    node = None
    if not findings:
        node, findings = parsed(file)
    if findings:
        return None, findings
    if not isinstance(node, Mapping):
        text = f"a note has the keys {', '.join(_REQUIRED)}"
        return None, [Diagnostic(RULE, text, Span(file, 0, 0), help="write them as `key: value`")]
    findings = [
        Diagnostic(RULE, f"a note has no key `{key}`", key_span(node, key), help=f"use one of {', '.join(_KEYS)}")
        for key in node.values
        if key not in _KEYS
    ]
    texts: dict[str, str] = {}
    for key in _KEYS:
        value = node.values.get(key)
        if value is None:
            if key in _REQUIRED:
                findings.append(Diagnostic(RULE, f"`{key}` is missing", Span(file, 0, 0), help=_HELP[key]))
        elif not isinstance(value, Scalar) or not value.text.strip():
            findings.append(Diagnostic(RULE, f"`{key}` is not a text", value.span, help=_HELP.get(key, "write a text")))
        else:
            texts[key] = value.text.strip()
    if texts.get("serial_number", REDACTED) != REDACTED:
        span = node.values["serial_number"].span
        findings.append(Diagnostic(RULE, "a note has no serial number", span, help=_HELP["serial_number"]))
    address = texts.get("unit_address")
    if address is not None and not re.fullmatch(r"[0-9]{1,9}", address):
        span = node.values["unit_address"].span
        findings.append(Diagnostic(RULE, "`unit_address` is not a number", span, help="write it as 1"))
    if findings:
        return None, findings
    number = int(address) if address is not None else None
    return UnitNote(name, texts["model"], texts["firmware"], number, texts.get("remarks", "")), []


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
