"""A bit means one thing when it is 0, and another when it is 1.

Why: where a manual prints one text for both, a line was copied and not changed.

Example: a bit with `zero: outside of the zone` and `one: outside of the zone`.

Cure: Put one of the texts right, and write an erratum with what is printed.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.finding import finding, label
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device


def senses_differ(device: Device) -> Iterator[Diagnostic]:
    for word in device.flags.values():
        for bit in word.bits:
            if bit.zero and bit.zero == bit.one:
                text = f"{bit.name} means `{bit.one}` at 0 and at 1"
                there = label(bit.place, "zero", "at 0")
                yield finding("senses_differ", bit.place, "one", text, "put one of the texts right", there)
