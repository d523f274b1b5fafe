"""The printed range of a bit field is 0 to the sum of its bits. A range with holes permits only some combinations of
the bits. If the bit field has a range, every value with these bits states a range too.

Why: the range of a word shows which bits it has. If the list of bits disagrees, one of them is wrong. Encoders apply
the range of the value; the range of the bit field is only shown to users.

Example: a range of 0..1 for a bit field with 14 inputs.

Fix: Correct the range or the list, and write an erratum. Reserved bits may be included or not. A group of bits with a
closed enum may be included with its greatest member, and the range may be the range of the whole type if its last bit
is in the list.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import partial

from fieldspec.language.checks.finding import Findings, finding, label, range_key
from fieldspec.language.checks.settled import of_values, of_words
from fieldspec.language.model.device import Device
from fieldspec.language.model.enums import Bit, Flags
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.ranges import Ranges
from fieldspec.language.model.value import Value

_WIDEST = 64


def bits_match_range(device: Device) -> Findings:
    yield from of_words(device, lambda word: _compare_range(device, word, word, word.ranges))
    yield from of_values(device, partial(_of_value, device))


def _of_value(device: Device, fact: Fact, value: Value) -> Findings:
    used = device.flags.get(value.flags)
    if used is not None:
        is_of_bits = value.packed_bits > 0 and range_key(fact.place) not in fact.place
        wrong = list(_compare_range(device, fact, used, None if is_of_bits else value.ranges))
        yield from wrong or _compare_words(fact, value, used)


def _compare_range(device: Device, fact: Fact, word: Flags, ranges: Ranges | None) -> Findings:
    if ranges is None or any(bit.last >= _WIDEST for bit in word.bits):
        return
    all_bits = _union(bit for bit in word.bits)
    ends = [bound for interval in ranges.intervals for bound in interval]
    if (len(ranges.intervals) > 1 or ranges.low > 0) and not any(bound & ~all_bits for bound in ends):
        return  # some words, such as those that tell messages apart
    useful = _union(bit for bit in word.bits if not bit.reserved)
    highest = sum(bit.placed(_highest(device, bit)) for bit in word.bits if not bit.reserved)
    whole = word.type.high if all_bits.bit_length() == word.type.high.bit_length() else useful
    if ranges.intervals not in (((0, all_bits),), ((0, useful),), ((0, highest),), ((0, whole),)):
        yield finding(
            fact.place,
            range_key(fact.place),
            f"the range of {fact.name} is {ranges.text()}; its bits give 0..{useful}",
            "correct the range or the list of bits",
            label(word.place, "bits", "the bits"),
        )


def _compare_words(fact: Fact, value: Value, word: Flags) -> Findings:
    """A value states a range where its words of bits have one: encoders compare that of the value."""
    if word.ranges is not None and value.ranges is None and value.const is None:
        text = f"{fact.name} states no range, but the words {word.name} have the range {word.ranges.text()}"
        related_label = label(word.place, "range", word.name)
        yield finding(fact.place, "flags", text, f"add `range: {word.ranges.text()}`", related_label)


def _highest(device: Device, bit: Bit) -> int:
    """The greatest value of a field of bits: that of its range, or of its enum, where it has a closed one."""
    enum = device.enums.get(bit.enum)
    full = (1 << bit.width) - 1
    if bit.ranges is not None and not bit.signed:
        return bit.ranges.high
    return full if enum is None or enum.open else max((member.value for member in enum.members), default=full)


def _union(bits: Iterable[Bit]) -> int:
    mask = 0
    for bit in bits:
        mask |= bit.mask
    return mask
