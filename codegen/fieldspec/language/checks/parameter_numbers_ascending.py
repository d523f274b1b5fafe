"""The parameter numbers of a set rise, and if nearly all of them rise by one, all do.

Why: manuals list parameters by number. If a number falls, repeats or is skipped, it is misprinted or a row is
missing.

Example: parameters 12, 13, 15 in a list that is otherwise complete from 0 to 31.

Fix: Transcribe the missing row, as `reserved` if it has no meaning, or correct the number and write an
erratum. If the manual skips numbers, set `allow: {parameter_numbers_ascending: <reason>}` on the parameter
after them. A set that states its `numbers` may describe only some of them.
"""

from __future__ import annotations

from itertools import pairwise

from fieldspec.language.checks.finding import Findings, finding, interval, label
from fieldspec.language.model.device import Device

_FEW = 4
"""The number of steps of which at most one may skip; otherwise, the list has gaps by design."""


def parameter_numbers_ascending(device: Device) -> Findings:
    for parameter_set in device.parameters.values():
        pairs = list(pairwise(parameter_set.parameters))
        skips = sum(following.number > before.number + before.count for before, following in pairs)
        holes_meant = parameter_set.numbers is not None or skips * _FEW > len(pairs)
        for before, parameter in pairs:
            number, last = parameter.number, before.number + before.count - 1
            if number == last + 1 or (number > last and holes_meant):
                continue
            if number > last:
                text = f"{parameter_set.name} does not list {interval(last + 1, number - 1)}"
                help = "transcribe the missing parameters, or allow it with a reason"
            else:
                text = f"parameter {number} is listed after {last}"
                help = "correct one of the numbers"
            related_label = label(before.place, "number", f"the one before is {last}")
            yield finding(parameter.place, "number", text, help, related_label)
