"""No two rows of one list, no two members of one enum, no two enums and no two words of flags have the same
description. Two that do are a warning, and stop nothing: the bytes are the same whatever the description says.

Why: a description that stands twice was copied from the row above and not changed: whoever reads it takes
an output for an input. Reserved rows may share theirs, and so may rows whose names differ in a number only.

Example: two registers, inputs and outputs, both described as "The states of the inputs."

Cure: Find out what the second one is and say it, and write an erratum with the description that stands
for both in print. If it is no slip, say `allow: {descriptions_differ: <reason>}`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from fieldspec.checks.facts import lists
from fieldspec.checks.finding import finding, label
from fieldspec.diagnostics import Diagnostic, Severity
from fieldspec.model.device import Device
from fieldspec.model.fact import Fact

_KEYS = ("doc", "problem")
_NUMBER = re.compile(r"[0-9]+")


def descriptions_differ(device: Device) -> Iterator[Diagnostic]:
    for rows in _families(device):
        meant = [row for row in rows if row.name and not getattr(row, "reserved", False)]
        for key in _KEYS:
            yield from _of_key(meant, key)


def _families(device: Device) -> Iterator[Iterable[Fact]]:
    """Everything whose items are described side by side."""
    yield from lists(device)
    yield device.enums.values()
    yield device.flags.values()
    for enum in device.enums.values():
        yield enum.members


def _of_key(rows: Iterable[Fact], key: str) -> Iterator[Diagnostic]:
    first: dict[str, Fact] = {}
    for row in rows:
        text = getattr(row, key, "")
        other = first.setdefault(text, row) if text else row
        if other is not row and _NUMBER.sub("", other.name) != _NUMBER.sub("", row.name):
            yield finding(
                "descriptions_differ",
                row.place,
                key,
                f"{other.name} and {row.name} have the same description",
                "find out what each of them is, or allow it with a reason",
                label(other.place, key, other.name),
                severity=Severity.WARNING,
            )
