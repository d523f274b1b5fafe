"""No two entries of a bit field use the same bit.

Why: a bit has one meaning. If it has two under different conditions, each entry states its `when`.

Example: bit 3 for the alarm, and bits 2..3 for the mode.

Fix: Correct one of the numbers and write an erratum, or add `when` to both entries.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.checks.settled import of_words
from fieldspec.language.model.device import Device
from fieldspec.language.model.enums import Bit, Flags


def bits_unique(device: Device) -> Findings:
    return of_words(device, _of_word)


def _of_word(word: Flags) -> Findings:
    owners: dict[int, list[Bit]] = {}
    for bit in word.bits:
        same_bit_owners = [other for number in bit.places for other in owners.get(number, [])]
        clash = next((other for other in same_bit_owners if not _apart(bit, other)), None)
        if clash is not None:
            yield finding(
                bit.place,
                _key(bit),
                f"{bit.name} uses {_claim(bit)} of {word.name}, which {clash.name} also uses",
                "correct one of the numbers, or add `when` to both entries",
                label(clash.place, _key(clash), f"{clash.name} has {_claim(clash)}"),
            )
        for number in bit.places:
            owners.setdefault(number, []).append(bit)


def _apart(bit: Bit, other: Bit) -> bool:
    return bool(bit.when and other.when and bit.when != other.when)


def _key(bit: Bit) -> str:
    return "bits" if "bits" in bit.place else "bit"


def _claim(bit: Bit) -> str:
    return f"bit {bit.first}" if bit.width == 1 else f"the bits {bit.number_text}"
