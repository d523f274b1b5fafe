"""Constants and all numbers in examples are values that their fields can have.

Why: the manual shows the value on the wire. If the printed range excludes it, the range or the value is
misprinted.

Example: a field with a range of 1..100 and the value 0 in a sample frame.

Fix: Correct the range or the value, and write an erratum. If a value outside the range represents a state, list it
under `sentinels`.
"""

from __future__ import annotations

from fieldspec.language.checks.facts import values
from fieldspec.language.checks.finding import Findings, finding, label, range_key
from fieldspec.language.checks.numbers import Legal, numbers
from fieldspec.language.model.device import Device

_HELP = "correct one of them, or list the value under `sentinels`"


def value_within_range(device: Device) -> Findings:
    legal = Legal(device)
    for fact, value in values(device):
        reason = legal.objection(value, value.const, writes=True) if value.const is not None else ""
        if reason:
            text = f"{fact.name} is always {value.const}, which {reason}"
            yield finding(fact.place, "const", text, _HELP)
    for example in device.examples.values():
        if example.refused:
            continue
        for path, fact, value, number in numbers(device, example):
            reason = legal.objection(value, number)
            if reason:
                text = f"{path} is {number} in the example {example.id}, which {reason}"
                related_label = label(fact.place, range_key(fact.place), "its permitted values")
                yield finding(example.place, "values", text, _HELP, related_label)
