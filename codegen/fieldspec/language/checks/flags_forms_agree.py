"""Bit fields with the same name in the manual have bits of the same name at the same position, with the same
active level and edge.

Why: a control word has several forms for different messages, and the manual prints each form in full. If a
bit is at different positions, one form is misprinted.

Example: fixed_stop is bit 8 in one form of STW2 and bit 9 in another.

Fix: Correct the bit, and write an erratum. If its position really differs, set `allow: {flags_forms_agree:
<reason>}`.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.enums import Bit, Flags


def flags_forms_agree(device: Device) -> Findings:
    forms: dict[str, list[Flags]] = {}
    for word in device.flags.values():
        if word.printed_name:
            forms.setdefault(word.printed_name, []).append(word)
    for words in forms.values():
        first: dict[str, tuple[Flags, Bit]] = {}
        for word in words:
            for bit in word.bits:
                if not bit.reserved and not bit.when:
                    other, same = first.setdefault(bit.name, (word, bit))
                    yield from _compare_bits(word, bit, other, same)


def _compare_bits(word: Flags, bit: Bit, other: Flags, same: Bit) -> Findings:
    for key, mine, theirs in (
        ("bits" if "bits" in bit.place else "bit", _place(bit), _place(same)),
        ("active", f"the active level {bit.active}", f"the active level {same.active}"),
        ("edge", f"the edge {bit.edge or 'none'}", f"the edge {same.edge or 'none'}"),
    ):
        if mine != theirs:
            text = f"{bit.name} has {theirs} in {other.name} and {mine} in {word.name}, forms of one word"
            related_label = label(same.place, key if key in same.place else "name", f"in {other.name}")
            help = "correct one of them, or allow it with a reason"
            yield finding(bit.place, key, text, help, related_label)


def _place(bit: Bit) -> str:
    return f"bit {bit.number_text}"
