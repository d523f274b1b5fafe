"""No two rows of a list, members of an enum, enums or bit fields have the same description. A repeated
description is a warning and does not fail the check, because it does not affect the bytes.

Why: a repeated description was usually copied from the row above and not changed, so the reader mistakes an output for
an input. Reserved rows may have the same description, and so may rows whose names differ only in a number.

Example: the registers inputs and outputs, both described as "The states of the inputs."

Fix: Find out what the second row is, describe it, and write an erratum with the printed description. If the
repetition is correct, set `allow: {descriptions_differ: <reason>}`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from fieldspec.language.checks.facts import lists
from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.diagnostics import Severity
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Fact

_KEYS = ("doc", "problem")
_NUMBER = re.compile(r"[0-9]+")


def descriptions_differ(device: Device) -> Findings:
    for rows in _families(device):
        described_rows = [row for row in rows if row.name and not getattr(row, "reserved", False)]
        for key in _KEYS:
            yield from _of_key(described_rows, key)


def _families(device: Device) -> Iterator[Iterable[Fact]]:
    """Everything whose items are described side by side."""
    yield from lists(device)
    yield device.enums.values()
    yield device.flags.values()
    for enum in device.enums.values():
        yield enum.members


def _of_key(rows: Iterable[Fact], key: str) -> Findings:
    first: dict[str, Fact] = {}
    for row in rows:
        text = getattr(row, key, "")
        other = first.setdefault(text, row) if text else row
        if other is not row and _NUMBER.sub("", other.name) != _NUMBER.sub("", row.name):
            yield finding(
                row.place,
                key,
                f"{other.name} and {row.name} have the same description",
                "find out what each of them is, or allow it with a reason",
                label(other.place, key, other.name),
                severity=Severity.WARNING,
            )
