"""Every bit is within its word, and the word fits every value that uses it.

Why: a bit that the word does not have cannot be read. Either the word is too narrow or the bit number is
wrong.

Example: bit 16 in a word of type `u16`, or a bit field with bit 9 that a `u8` uses.

Cure: Correct the type or the bit number, and write an erratum if the manual prints it that way.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.facts import values
from fieldspec.checks.finding import finding, label
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device
from fieldspec.model.value import Kind


def bits_within_width(device: Device) -> Iterator[Diagnostic]:
    for word in device.flags.values():
        width = 8 * word.type.size
        for bit in word.bits:
            if bit.last >= width:
                yield finding(
                    "bits_within_width",
                    bit.place,
                    "bits" if "bits" in bit.place else "bit",
                    f"{bit.name} has bit {bit.last}, but {word.name} has the bits 0 to {width - 1}",
                    "correct the number or the type",
                    label(word.place, "type", word.type.name),
                )
    for fact, value in values(device):
        used = device.flags.get(value.flags)
        if used is None or not used.bits:
            continue
        highest = max(used.bits, key=lambda bit: bit.last)
        if value.type.kind is not Kind.INTEGER or highest.last >= 8 * value.type.size:
            yield finding(
                "bits_within_width",
                fact.place,
                "flags",
                f"{fact.name} is {value.type.name} and cannot hold bit {highest.last} of {used.name}",
                "correct the type, or name the right bit field",
                label(highest.place, "bit", f"{highest.name}"),
            )
