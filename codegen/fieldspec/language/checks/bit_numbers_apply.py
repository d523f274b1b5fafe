"""Only several bits together have a sign, a scale or a unit; such bits have neither an enum nor an edge. Only a single
bit has an active level and texts for 0 and 1. A signed number has fewer bits than its word. Only several bits in the
data of a message have a range, and only if their meaning is always the same.

Why: a single bit is true or false, and enum members are not quantities. A word that is one number as a whole is a
value. Codecs cannot evaluate a condition, and do not check the bits of a part of a frame.

Example: `unit: mm` on `bit: 3`, or `signed: true` on `bits: 0..15` of a `u16`.

Fix: Remove the key, or correct the bits. State a number that fills its word as a value of a signed type, with
its scale and its unit.
"""

from __future__ import annotations

from functools import partial

from fieldspec.language.checks.finding import Findings, finding, label, range_key
from fieldspec.language.checks.settled import of_values, of_words
from fieldspec.language.model.device import Device
from fieldspec.language.model.enums import Bit, Flags
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.value import Value

_KEYS = ("signed", "scale", "offset", "unit")
_LEVEL_KEYS = ("zero", "one", "active")


def bit_numbers_apply(device: Device) -> Findings:
    yield from of_words(device, _of_word)
    yield from of_values(device, partial(_of_sentinels, device))
    for link in device.links.values():
        for part in (*link.request, *link.response):
            bounded = device.flags[part.value.flags].bounded if part.value and part.value.flags in device.flags else ()
            if bounded:
                text = f"{part.name} is a part of a frame, to which the range of {bounded[0].name} does not apply"
                related_label = label(bounded[0].place, range_key(bounded[0].place), "the range")
                yield finding(part.place, "flags", text, "use a word of bits without a range", related_label)


def _of_sentinels(device: Device, fact: Fact, value: Value) -> Findings:
    bounded = device.flags[value.flags].bounded if value.flags in device.flags else ()
    if bounded and value.sentinels:
        text = f"{fact.name} has special values, which the range of {bounded[0].name} does not except"
        related_label = label(bounded[0].place, range_key(bounded[0].place), "the range")
        help = "remove one of them, or use a word of bits without a range"
        yield finding(fact.place, "sentinels", text, help, related_label)


def _of_word(word: Flags) -> Findings:
    for bit in word.bits:
        yield from _of_number(word, bit)
        yield from _of_range(bit)
        for key in _LEVEL_KEYS:
            if bit.width > 1 and key in bit.place:
                text = f"{bit.name} has {bit.width} bits, to which `{key}` does not apply"
                yield finding(bit.place, key, text, "name the numbers with an `enum`, or divide the bits")


def _of_number(word: Flags, bit: Bit) -> Findings:
    keys = [key for key in _KEYS if key in bit.place] if bit.is_number else []
    if not keys:
        return
    reason = ""
    if bit.width == 1:
        reason, help = "is a single bit", "remove it, or correct the bits"
    elif bit.enum or bit.edge:
        reason, help = f"has an {'enum' if bit.enum else 'edge'}", "remove one of them"
    elif bit.signed and bit.width >= 8 * word.type.size:
        reason, help = f"fills {word.name}", "state the word as a value of a signed type"
    if reason:
        text = f"{bit.name} {reason}, to which `{keys[0]}` does not apply"
        yield finding(bit.place, keys[0], text, help)


def _of_range(bit: Bit) -> Findings:
    if bit.ranges is None:
        return
    key, reason = range_key(bit.place), ""
    if bit.width == 1:
        reason, help = "is a single bit", "remove it, or correct the bits"
    elif bit.reserved or bit.edge:
        reason, help = "is reserved" if bit.reserved else "has an edge", "remove one of them"
    elif bit.when:
        reason, help = "has its meaning under a condition only", "remove it, and state the range in `doc`"
    if reason:
        yield finding(bit.place, key, f"{bit.name} {reason}, to which `{key}` does not apply", help)
