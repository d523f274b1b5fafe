"""Items that the manual numbers consecutively have consecutive numbers, bits or addresses.

Why: inputs 1 to 14, bits 0 to 6 of a point number and similar series are printed in order. If an item is out of
sequence, its number or its address is misprinted.

Example: OUT 1 to OUT 10 are bits 0 to 9, but OUT 4 is bit 5.

Fix: Correct the number, the bit, the value or the address, and write an erratum. If the item is correct, set `allow:
{series_regular: <reason>}`.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable
from functools import lru_cache

from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Fact

_FEWEST = 4
_SMALL = 4
_NUMBERED = re.compile(r"(.*?)([0-9]{1,6})(\D*)", re.DOTALL)

_Placed = tuple[Fact, str, int, int]


def series_regular(device: Device) -> Findings:
    for group in device.groups:
        # Those of a copy are compared with the others by copies_agree.
        rows = [row for row in group.registers if row.count == 1 and not row.copy_of]
        yield from _of_list((row, "at", row.address, row.width) for row in rows)
    for word in device.flags.values():
        yield from _of_list((bit, "bit", bit.first, bit.width) for bit in word.bits if not bit.pieces)
    for enum in device.enums.values():
        if enum.derived:
            continue
        yield from _of_list((member, "value", member.value, 1) for member in enum.members)
    for parameter_set in device.parameters.values():
        yield from _of_list(
            (parameter, "number", parameter.number, 1) for parameter in parameter_set.parameters if parameter.count == 1
        )


def _of_list(rows: Iterable[_Placed]) -> Findings:
    all_rows = list(rows)
    reported: set[int] = set()
    for key in ("printed_name", "label"):
        series: dict[tuple[str, str, int], list[tuple[int, _Placed]]] = {}
        for row in all_rows:
            parts = _parts(getattr(row[0], key))
            if parts:
                series.setdefault((parts[0], parts[2], row[3]), []).append((int(parts[1]), row))
        for numbered in series.values():
            for odd in _odd(numbered):
                if odd.span.start not in reported:
                    reported.add(odd.span.start)
                    yield odd


@lru_cache(maxsize=20_000)
def _parts(text: str) -> tuple[str, ...]:
    """A text in parts: what is before a number, the number, and what is after it; nothing where it has no number."""
    match = _NUMBERED.fullmatch(text)
    return match.groups() if match else ()


def _odd(numbered: list[tuple[int, _Placed]]) -> Findings:
    """Findings where nearly all of a series keep their distance to their number, and a small part does not."""
    if len(numbered) < _FEWEST:
        return
    step = numbered[0][1][3]
    bases = Counter(place - step * number for number, (_, _, place, _) in numbered)
    base, times = bases.most_common(1)[0]
    odd = len(numbered) - times
    if odd == 0 or odd * _SMALL > len(numbered):
        return
    usual = next(row for number, row in numbered if row[2] - step * number == base)
    for number, (fact, key, place, _) in numbered:
        if place - step * number != base:
            text = f"{fact.name} is number {number} of a series, but has {place}, not {base + step * number}"
            help = "correct its place or its number, or allow it with a reason"
            related_label = label(usual[0].place, usual[1], f"{usual[0].name} matches the series")
            yield finding(fact.place, key, text, help, related_label)
