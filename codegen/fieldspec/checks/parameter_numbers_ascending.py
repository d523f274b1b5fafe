"""The numbers of a set's parameters rise, and where nearly all of them rise by one, all do.

Why: parameters are listed by number. A number that falls, repeats or skips is misprinted, or a line was
left out.

Example: parameters 12, 13, 15 in a list that otherwise goes from 0 to 31 without a hole.

Cure: Transcribe the missing line, as `reserved` if it has no meaning, or put the number right and write
an erratum. If the manual leaves numbers out, say `allow: {parameter_numbers_ascending: <reason>}` on the
parameter behind them. A set that says which `numbers` there are may describe some of them only.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from fieldspec.checks.finding import finding, interval, label
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device

_FEW = 4
"""Of so many steps at most one may skip, or the list has holes by design."""


def parameter_numbers_ascending(device: Device) -> Iterator[Diagnostic]:
    for parameter_set in device.parameters.values():
        pairs = list(pairwise(parameter_set.parameters))
        skips = sum(behind.number > before.number + before.count for before, behind in pairs)
        holes_meant = parameter_set.numbers is not None or skips * _FEW > len(pairs)
        for before, parameter in pairs:
            number, last = parameter.number, before.number + before.count - 1
            if number == last + 1 or (number > last and holes_meant):
                continue
            if number > last:
                text = f"{parameter_set.name} does not list {interval(last + 1, number - 1)}"
                help = "transcribe what is missing, or allow it with a reason"
            else:
                text = f"parameter {number} is listed behind {last}"
                help = "put one of the numbers right"
            there = label(before.place, "number", f"the one before is {last}")
            yield finding("parameter_numbers_ascending", parameter.place, "number", text, help, there)
