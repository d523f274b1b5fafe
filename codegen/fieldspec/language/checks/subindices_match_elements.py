"""If the elements of an array are described individually, every element is described exactly once.

Why: the manual prints the number of elements next to the type, and the elements in a separate table. If they
differ, a row is missing or the number is misprinted.

Example: `elements: 7` for a parameter with the subindices 0 to 5.

Fix: Transcribe the missing elements or correct the number, and write an erratum. If the manual describes
only some elements, set `allow: {subindices_match_elements: <reason>}`.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, enumeration, finding, interval, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.ranges import merged, uncovered
from fieldspec.language.model.registers import Parameter


def subindices_match_elements(device: Device) -> Findings:
    for parameter_set in device.parameters.values():
        for parameter in parameter_set.parameters:
            if parameter.subindices:
                yield from _of_parameter(parameter)


def _of_parameter(parameter: Parameter) -> Findings:
    last = (parameter.elements or 1) - 1
    count = label(parameter.place, "elements", f"it has the elements 0 to {last}" if last else "it has one element")
    described: list[tuple[int, int]] = []
    for inner in parameter.subindices:
        for low, high in inner.indices.intervals:
            if low < 0 or high > last:
                text = f"{inner.name or interval(low, high)} is element {interval(low, high)} of {parameter.name}"
                help = "correct the subindex or the number of elements"
                yield finding(inner.place, "index", text, help, count)
            elif uncovered(low, high, merged(described)) != [(low, high)]:
                text = f"element {interval(low, high)} of {parameter.name} is described twice"
                yield finding(inner.place, "index", text, "correct one of the subindices")
            described.append((low, high))
    holes = uncovered(0, last, merged(described))
    if holes:
        text = (
            f"there is no description of element {enumeration([interval(*hole) for hole in holes])} of {parameter.name}"
        )
        help = "transcribe the missing elements, or allow it with a reason"
        yield finding(parameter.place, "subindices", text, help, count)
