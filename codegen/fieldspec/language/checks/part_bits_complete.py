"""Outside a CAN identifier, parts with `bits` divide all bits of a byte or word before the body. They are neighbours,
have one unsigned type and byte order, and no bit in common.

Why: the value of a bit without a part would be undefined, and a bit with two parts would have two values.

Example: `{name: address, type: u8, bits: 0..4}` and `{name: mirror, type: u8, bits: 6}`, which leave out bits 5 and 7.

Fix: Give every bit to one part, as `const` or `reserved` if the manual says so. Remove `bits` from a part that has
whole bytes.
"""

from __future__ import annotations

from fieldspec.foundation.line_text import plural
from fieldspec.language.checks.finding import Findings, finding, label, type_text
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_count, is_signed
from fieldspec.language.model.link import Part


def part_bits_complete(device: Device) -> Findings:
    for link in device.links.values():
        for direction in ("request", "response") if not link.is_can else ():
            word: list[Part] = []
            has_body = False
            for part in link.parts(direction):
                has_body |= part.role == "body"
                if not part.is_shared:
                    yield from _of_word(word)
                    word = []
                if part.bits is not None:
                    yield from _of_part(device, part, has_body)
                    word.append(part)
            yield from _of_word(word)


def _of_part(device: Device, part: Part, has_body: bool) -> Findings:
    if part.value is None:
        text = f"`bits` has no effect in a part with the role {part.role}"
        yield finding(part.place, "bits", text, "remove `bits`")
    elif has_body:
        text = f"{part.name} has `bits`, but comes after the body"
        yield finding(part.place, "bits", text, "state the whole byte or word as one part")
    elif is_count(part.value.encoding) and is_signed(part.value.encoding):
        text = f"{part.name} is {part.value.type.name}, but some bits of a byte or word have no sign"
        yield finding(part.place, "type", text, "use an unsigned type")
    elif part.value.flags in device.flags:
        flags = device.flags[part.value.flags]
        bit = next((bit for bit in flags.bits if bit.mask > part.value.high), None)
        if bit is not None:
            text = f"{part.name} has {type_text(part.value)}, which do not hold {bit.name} of {flags.name}"
            related_label = label(bit.place, "name", bit.name)
            yield finding(part.place, "flags", text, "correct the bits, or use narrower flags", related_label)


def _of_word(parts: list[Part]) -> Findings:
    """The findings of the parts of one byte or word."""
    values = [part.value for part in parts if part.value is not None]
    if not values:
        return
    first, kind = parts[0], values[0].type
    own = label(first.place, "type", f"the first part of these bits, {first.name}")
    for part, value in zip(parts, values, strict=True):
        if (value.type, value.byte_order) != (kind, values[0].byte_order):
            text = f"{part.name} shares bytes with {first.name}, but has a different type or byte order"
            help = f"give all parts of one byte or word the same type, or give every bit of {kind.name} to a part"
            yield finding(part.place, "bits", text, help, own)
            return
    claimed: set[int] = set()
    for part in parts:
        low, high = part.bits or (0, 0)
        wrong = [bit for bit in range(low, high + 1) if bit in claimed or bit >= 8 * kind.size]
        if wrong:
            objection = f"{kind.name} does not have" if wrong[0] >= 8 * kind.size else "another part has"
            text = f"{part.name} has bit {wrong[0]}, which {objection}"
            yield finding(part.place, "bits", text, "correct the bits, or use a wider type", own)
            return
        claimed |= set(range(low, high + 1))
    free = sorted(set(range(8 * kind.size)) - claimed)
    if free:
        text = f"no part has bit {free[-1]} of the {plural(kind.size, 'byte')} of {first.name}"
        help = "give every bit to a neighbouring part; a bit without a meaning is `reserved`"
        yield finding(first.place, "bits", text, help)
    elif len(parts) == 1:
        text = f"{first.name} has all bits of {kind.name}"
        yield finding(first.place, "bits", text, "remove `bits`")
