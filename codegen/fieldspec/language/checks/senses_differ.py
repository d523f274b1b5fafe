"""A bit has different meanings at 0 and at 1.

Why: if a manual prints the same text for both meanings, a row was copied and not changed.

Example: a bit with `zero: outside the zone` and `one: outside the zone`.

Fix: Correct one of the texts, and write an erratum with the printed text.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device


def senses_differ(device: Device) -> Findings:
    for word in device.flags.values():
        for bit in word.bits:
            if bit.zero and bit.zero == bit.one:
                text = f"{bit.name} means `{bit.one}` both at 0 and at 1"
                related_label = label(bit.place, "zero", "at 0")
                yield finding(bit.place, "one", text, "correct one of the texts", related_label)
