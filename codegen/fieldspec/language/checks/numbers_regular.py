"""If registers have the numbers of rows in another table of the manual, their addresses rise in equal steps with the
numbers.

Why: if parameter 0 is at the first address and each parameter has two words, all addresses follow. A row that
does not follow has a misprinted address or number, or a row is missing from one of the tables.

Example: parameters 11, 12 and 14 at 0x139E, 0x13A0 and 0x13A2.

Fix: Correct the address or the number, and write an erratum if the manual prints it that way, or transcribe
the missing row.
"""

from __future__ import annotations

from collections import Counter
from itertools import pairwise

from fieldspec.language.checks.finding import Findings, finding, hexadecimal, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.registers import Register

_HELP = "correct the address or the number"


def numbers_regular(device: Device) -> Findings:
    for group in device.groups:
        rows = [(row.number, row) for row in group.registers if row.number is not None]
        first: dict[int, Register] = {}
        for number, row in rows:
            other = first.setdefault(number, row)
            if other is not row:
                text = f"{other.name} and {row.name} have the number {number}"
                related_label = label(other.place, "number", other.name)
                yield finding(row.place, "number", text, _HELP, related_label)
        yield from _uneven(list(first.items()))


def _uneven(rows: list[tuple[int, Register]]) -> Findings:
    """The findings of rows whose address is not the one that most rows give their number."""
    if len(rows) < 2:
        return
    from fractions import Fraction

    steps = Counter(
        Fraction(following.address - before.address, number - last)
        for (last, before), (number, following) in pairwise(rows)
    )
    step, _ = steps.most_common(1)[0]
    bases = Counter(row.address - step * number for number, row in rows)
    base, _ = bases.most_common(1)[0]
    usual = next(row for number, row in rows if row.address - step * number == base)
    for number, row in rows:
        right = base + step * number
        if row.address != right:
            right_place = hexadecimal(int(right)) if right.denominator == 1 else f"{float(right):.1f}"
            text = f"{row.name} is number {number} at {hexadecimal(row.address)}, but the others give {right_place}"
            related_label = label(usual.place, "number", f"{usual.name} is one of the others")
            yield finding(row.place, "at", text, _HELP, related_label)
