"""Fields with the same label and different names have the same type, range, scale, unit and enum.

Why: a manual uses one label for a quantity everywhere. If two quantities have the same label, one of the
labels was copied from another table. The rule labels_unique covers the fields of one record.

Example: a field with a word to write is labelled "number of words", like the count of another message.

Fix: Find out what the field is, correct its label, and write an erratum with the printed label. If both
labels are correct, set `allow: {labels_consistent: <reason>}`.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from fieldspec.language.checks.facts import layers
from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.record import Field, Record
from fieldspec.language.model.value import Value


def labels_consistent(device: Device) -> Findings:
    families: dict[str, list[tuple[Record, Field]]] = {}
    for layer in layers(device):
        for field in layer.fields:
            if field.label and field.value is not None and not field.reserved:
                families.setdefault(field.label, []).append((layer, field))
    for family in families.values():
        yield from _odd(family)


def _odd(family: Sequence[tuple[Record, Field]]) -> Findings:
    """Findings at the fields with the rarer names; of names that are equally rare, at those that come later."""
    usual, _ = Counter(field.name for _, field in family).most_common(1)[0]
    holder, example = next((layer, field) for layer, field in family if field.name == usual)
    for layer, field in family:
        alike = field.name == usual or layer is holder
        if not alike and field.value and example.value and _differ(field.value, example.value):
            yield finding(
                field.place,
                "label",
                f"{field.name} and {example.name} have the same label, `{field.label}`, but are different values",
                "find out what each of them is, or allow it with a reason",
                label(example.place, "label", example.name),
            )


def _differ(value: Value, other: Value) -> bool:
    return value.type != other.type or any(
        mine != theirs
        for mine, theirs in (
            (value.unit, other.unit),
            (value.ranges, other.ranges),
            (value.enum, other.enum),
            (value.flags, other.flags),
        )
        if mine and theirs
    )
