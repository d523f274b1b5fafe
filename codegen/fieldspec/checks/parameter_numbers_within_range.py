"""The range of a field that holds the number of a parameter is that of the set's numbers.

Why: a number in the list that the field refuses cannot be read; a number that it takes and the list
lacks is a parameter that nobody described.

Example: a range of 1..63 for the number of one of the parameters 0 to 31.

Cure: Put the range right and write an erratum, or transcribe the missing parameters.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.finding import finding, interval, label, missing, range_key, shown
from fieldspec.checks.walking import fields
from fieldspec.diagnostics import Diagnostic, Label
from fieldspec.model.device import Device
from fieldspec.model.parameter import ParameterSet
from fieldspec.model.ranges import Ranges
from fieldspec.model.record import Field


def parameter_numbers_within_range(device: Device) -> Iterator[Diagnostic]:
    for field in fields(device):
        part = field.value.parameter if field.value is not None else None
        held = device.parameters.get(part.set) if part is not None else None
        if part is None or field.value is None or held is None:
            continue
        if part.part == "number" and field.value.ranges is not None:
            yield from _compared(field, field.value.ranges, held)
        if part.part == "values" and field.count is not None and field.count != len(held.parameters):
            text = f"{field.name} has {field.count} values; {held.name} has {len(held.parameters)} parameters"
            help = "put the number of values, or the list, right"
            yield finding("parameter_numbers_within_range", field.place, "count", text, help, _list(held))


def _compared(field: Field, ranges: Ranges, held: ParameterSet) -> Iterator[Diagnostic]:
    numbers = [parameter.number for parameter in held.parameters]
    refused = [number for number in numbers if number not in ranges]
    unlisted = missing(ranges, numbers)
    if refused or unlisted:
        faults = []
        if refused:
            faults.append(f"refuses {shown(refused)} of {held.name}")
        if unlisted:
            faults.append(f"takes {shown([interval(*hole) for hole in unlisted])}, which {held.name} does not list")
        text = f"the range of {field.name} {' and '.join(faults)}"
        help = "put the range or the list right"
        yield finding("parameter_numbers_within_range", field.place, range_key(field.place), text, help, _list(held))


def _list(held: ParameterSet) -> Label:
    return label(held.place, "name", "the parameters")
