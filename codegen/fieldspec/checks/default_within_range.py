"""A default is a value that the fact can have: within its range, its type and its closed enum.

Why: a device is not delivered with a setting that it does not accept. If the two disagree, one of them is
misprinted.

Example: a range of 1..127 with a default of -1.

Cure: Correct the range or the default, and write an erratum. If the default is a special value outside the
range, list it under `sentinels`.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.facts import values
from fieldspec.checks.finding import default_key, finding, label, range_key
from fieldspec.checks.numbers import Legal
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device
from fieldspec.model.value import Kind


def default_within_range(device: Device) -> Iterator[Diagnostic]:
    legal = Legal(device)
    for fact, value in values(device):
        key = default_key(fact.place)
        if isinstance(value.default, str):
            if value.type.kind in (Kind.INTEGER, Kind.BOOLEAN):
                text = f"the default of {fact.name} is `{value.default}`, but its raw values are whole numbers"
                help = "state the raw value: the value in the unit, less the offset, divided by the scale"
                if value.default.isdecimal():
                    help = f"numbers have no leading zeros: write it as `{value.default.lstrip('0')}`"
                yield finding("default_within_range", fact.place, key, text, help)
            continue
        if value.default is None:
            continue
        why = legal.objection(value, value.default)
        if why:
            text = f"the default of {fact.name} is {value.default}, which {why}"
            help = "correct one of them, or list the value under `sentinels`"
            labels = (label(fact.place, range_key(fact.place), "the range"),) if value.ranges else ()
            yield finding("default_within_range", fact.place, key, text, help, *labels)
