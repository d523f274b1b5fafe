"""The range of a field that carries a parameter number contains exactly the numbers of its set, and every row
of the set has one of these numbers.

Why: a listed number that the field does not accept cannot be read. A number that the field accepts and the
list does not contain is a parameter without a description.

Example: a range of 1..63 for the number of a parameter, where the set has the parameters 0 to 31.

Fix: Correct the range and write an erratum, or transcribe the missing parameters. If the manual describes
only some parameters of a set, state all numbers under `numbers`.
"""

from __future__ import annotations

from fieldspec.foundation.line_text import plural
from fieldspec.language.checks.addresses import wire_numbers
from fieldspec.language.checks.facts import values
from fieldspec.language.checks.finding import Findings, enumeration, finding, interval, label, range_key
from fieldspec.language.diagnostics import Label
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_count
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.ranges import Ranges, merged, uncovered
from fieldspec.language.model.record import Field
from fieldspec.language.model.registers import ParameterSet
from fieldspec.language.model.value import Value


def parameter_numbers_within_range(device: Device) -> Findings:
    for parameter_set in device.parameters.values():
        yield from _set_numbers(parameter_set)
    for fact, value in values(device):
        part = value.parameter
        sets = device.sets(part.set) if part is not None else []
        if part is None or not sets:
            continue
        if part.part == "number":
            yield from _compare_numbers(fact, value, part.set, sets)
        if part.part == "values" and isinstance(fact, Field):
            yield from _field_numbers(fact, sets[0])


def _set_numbers(parameter_set: ParameterSet) -> Findings:
    numbers = parameter_set.numbers
    if numbers is None:
        return
    permitted = merged(numbers.intervals)
    for parameter in parameter_set.parameters:
        last = parameter.number + parameter.count - 1
        if not any(low <= parameter.number and last <= high for low, high in permitted):
            text = f"{parameter_set.name} has the numbers {numbers.text()}, not {interval(parameter.number, last)}"
            related_label = label(parameter_set.place, "numbers", "the numbers")
            yield finding(parameter.place, "number", text, "correct the number or the set", related_label)


def _field_numbers(field: Field, parameter_set: ParameterSet) -> Findings:
    """Whether a field has one value for each number of a set, and each parameter has one value."""
    parameter_count = sum(parameter.count for parameter in parameter_set.parameters)
    ranges = field.repeat or Ranges(((field.count or 1, field.count or 1),))
    if merged(ranges.intervals) != [(parameter_count, parameter_count)]:
        value_count = f"{ranges.text()} {'value' if ranges.text() == '1' else 'values'}"
        text = f"{field.name} has {value_count}, but {parameter_set.name} has {plural(parameter_count, 'parameter')}"
        key = "repeat" if field.repeat is not None else "count" if field.count is not None else "name"
        instead = " instead of `repeat`" if key == "repeat" else ""
        help = f"state `count: {parameter_count}`{instead}" if parameter_count > 1 else f"remove `{key}`"
        help += ", or correct the list"
        yield finding(field.place, key, text, help, _list(parameter_set))
    parameter = next(
        (candidate for candidate in parameter_set.parameters if candidate.elements or candidate.subindices), None
    )
    if parameter is not None:
        text = f"{field.name} has one value for each parameter, but {parameter.name} has elements"
        help = "read the elements by messages of their own, or state them as parameters"
        related_label = label(parameter.place, "elements" if parameter.elements else "subindices", "the elements")
        yield finding(field.place, "parameter", text, help, related_label)


def _compare_numbers(fact: Fact, value: Value, name: str, sets: list[ParameterSet]) -> Findings:
    """A field's range against the numbers on the wire, or, where it has none, its type."""
    if not is_count(value.encoding):
        return
    numbers = wire_numbers(sets)
    permitted = merged(value.ranges.intervals) if value.ranges is not None else [(value.type.low, value.type.high)]
    refused = [hole for low, high in numbers for hole in uncovered(low, high, permitted)]
    unlisted = (
        [hole for low, high in permitted for hole in uncovered(low, high, numbers)] if value.ranges is not None else []
    )
    if refused or unlisted:
        faults = []
        if refused:
            faults.append(f"refuses {enumeration([interval(*hole) for hole in refused])} of {name}")
        if unlisted:
            faults.append(f"takes {enumeration([interval(*hole) for hole in unlisted])}, which {name} does not list")
        key = range_key(fact.place) if value.ranges is not None else "type"
        text = f"the {'range' if value.ranges is not None else 'type'} of {fact.name} {' and '.join(faults)}"
        yield finding(fact.place, key, text, "correct the range or the list", _list(sets[0]))


def _list(parameter_set: ParameterSet) -> Label:
    return label(parameter_set.place, "name", "the parameters")
