"""Every bit is within the type of its bit field. Every value that uses the bit field holds all its bits and is not
wider than the bit field; at least one value is as wide as the bit field.

Why: a bit outside of the word cannot be read: the word is too narrow or the bit number is wrong. If the bit field is
wider than all its values, one of the types is wrong. In a wider value, it is unknown what the other bits mean, and
which half is the bit field.

Example: bit 16 in a bit field of type `u16`, a bit field with bit 9 in a `u8`, a bit field of type `u32` that only a
`u16` uses, or a bit field of type `u16` in a `u32`.

Fix: Correct the type or the bit number, and write an erratum if the manual prints it that way.
"""

from __future__ import annotations

from fieldspec.language.checks.facts import values
from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_count


def bits_within_width(device: Device) -> Findings:
    for word in device.flags.values():
        width = 8 * word.type.size
        for bit in word.bits:
            if bit.last >= width:
                yield finding(
                    bit.place,
                    "bits" if "bits" in bit.place else "bit",
                    f"{bit.name} has bit {bit.last}, but {word.name} has the bits 0 to {width - 1}",
                    "correct the number or the type",
                    label(word.place, "type", word.type.name),
                )
    widest: dict[str, int] = {}
    for fact, value in values(device):
        used = device.flags.get(value.flags)
        if used is None:
            continue
        widest[used.name] = max(widest.get(used.name, 0), value.type.size)
        if is_count(value.encoding) and value.type.size > used.type.size:
            text = f"{fact.name} is {value.type.name}, wider than {used.name}, which is {used.type.name}"
            help = (
                f"correct the type, or state `type: {value.type.name}` for {used.name}: narrower values may use it too"
            )
            related_label = label(used.place, "type", f"the type of {used.name}")
            yield finding(fact.place, "flags", text, help, related_label)
        if not used.bits:
            continue
        highest = max(used.bits, key=lambda bit: bit.last)
        if not is_count(value.encoding) or highest.last >= 8 * value.type.size:
            widest[used.name] = used.type.size  # one of the two is wrong, which one finding says
            yield finding(
                fact.place,
                "flags",
                f"{fact.name} is {value.type.name} and cannot hold bit {highest.last} of {used.name}",
                "correct the type, or name the right bit field",
                label(highest.place, "bit", f"{highest.name}"),
            )
    for name, size in widest.items():
        word = device.flags[name]
        # A word of three bytes has no type of its own.
        if word.type.size > next(whole for whole in (1, 2, 4, 8, size) if whole >= size):
            text = f"{name} is {word.type.name}, wider than every value that uses it"
            help = f"the widest of them has {8 * size} bits; correct its type or that of the word"
            yield finding(word.place, "type", text, help)
