"""Only a field of several bits has a sign, a scale or a unit, and no enum or edge beside them. A signed field has
fewer bits than its word.

Why: a single bit is true or false, and members of an enum are no quantities. A word that is one number as a
whole is a value.

Example: `unit: mm` on `bit: 3`, or `signed: true` on `bits: 0..15` of a `u16`.

Cure: Remove the key, or correct the bits. State a number that fills its word as a value of a signed type, with
its scale and its unit.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.finding import finding
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device

_CODE = "bit_numbers_apply"
_KEYS = ("signed", "scale", "offset", "unit")


def bit_numbers_apply(device: Device) -> Iterator[Diagnostic]:
    for word in device.flags.values():
        for bit in word.bits:
            keys = [key for key in _KEYS if key in bit.place] if bit.is_number else []
            if not keys:
                continue
            why = ""
            if bit.width == 1:
                why, help = "is a single bit", "remove it, or correct the bits"
            elif bit.enum or bit.edge:
                why, help = f"has an {'enum' if bit.enum else 'edge'}", "remove one of them"
            elif bit.signed and bit.width >= 8 * word.type.size:
                why, help = f"fills {word.name}", "state the word as a value of a signed type"
            if why:
                text = f"{bit.name} {why}, to which `{keys[0]}` does not apply"
                yield finding(_CODE, bit.place, keys[0], text, help)
