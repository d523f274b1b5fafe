"""The default of a lower bound is less than the default of its upper bound, unless both are 0.

Why: a pair of bounds leaves values between them. If the lower one is not below the upper one, a sign or a
digit is misprinted.

Example: soft limits with the range -2147483648..2147483647 that both default to 2147483647.

Fix: Correct one of the defaults, and write an erratum.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeAlias

from fieldspec.foundation.names import Name
from fieldspec.language.checks.facts import layers
from fieldspec.language.checks.finding import Findings, default_key, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_signed
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.value import Value

_PAIRS = {"negative": "positive", "lower": "upper", "minimum": "maximum", "low": "high"}
"""The word of a lower bound, and that of the upper one."""

_Rows: TypeAlias = Sequence[tuple[Fact, Value]]


def bounds_ordered(device: Device) -> Findings:
    for group in device.groups:
        yield from _of_list([(row, row.value) for row in group.registers if not row.copy_of])
    for parameter_set in device.parameters.values():
        yield from _of_list([(row, row.value) for row in parameter_set.parameters])
    for layer in layers(device):
        yield from _of_list([(field, field.value) for field in layer.fields if field.value is not None])


def _of_list(rows: _Rows) -> Findings:
    rows_by_words = {Name.of(fact.name).words: (fact, value) for fact, value in rows}
    for words, (fact, value) in rows_by_words.items():
        for index, word in enumerate(words):
            upper = rows_by_words.get((*words[:index], _PAIRS[word], *words[index + 1 :])) if word in _PAIRS else None
            if upper is not None and _comparable(value, upper[1]):
                yield from _compare_defaults(fact, value, *upper)


def _comparable(value: Value, other: Value) -> bool:
    """Whether two values lie on one axis: bounds of which each counts in its own direction do not."""
    return is_signed(value.encoding) and (value.scale, value.unit, value.ranges) == (
        other.scale,
        other.unit,
        other.ranges,
    )


def _compare_defaults(fact: Fact, value: Value, other: Fact, above: Value) -> Findings:
    low, high = value.default, above.default
    if isinstance(low, int) and isinstance(high, int) and low >= high and (low, high) != (0, 0):
        text = f"the default of {fact.name} is {low}, but the default of {other.name} is {high}"
        related_label = label(other.place, default_key(other.place), "the upper bound")
        yield finding(fact.place, default_key(fact.place), text, "correct one of them", related_label)
