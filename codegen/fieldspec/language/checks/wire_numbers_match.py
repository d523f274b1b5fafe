"""The printed number of a parameter on the wire is the base of its set plus its number, and no number belongs to two
sets of one number space.

Why: a manual that prints `Pt25B` and `0x225B` states the same number twice. If the two differ, one of them leads the
user to a wrong parameter.

Example: parameter 0x317 of a set with the base 0x2000 that is printed as 0x2371 on the wire.

Fix: Correct the number, the printed number or the base, and write an erratum if the manual prints it that
way.
"""

from __future__ import annotations

from fieldspec.language.checks.addresses import on_wire, wire_numbers
from fieldspec.language.checks.finding import Findings, addresses, finding, hexadecimal, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Place
from fieldspec.language.model.ranges import uncovered
from fieldspec.language.model.registers import ParameterSet


def wire_numbers_match(device: Device) -> Findings:
    for parameter_set in device.parameters.values():
        yield from _printed(parameter_set)
    spaces: dict[str, list[ParameterSet]] = {}
    for parameter_set in device.parameters.values():
        earlier = spaces.setdefault(parameter_set.space, [])
        for other in earlier:
            yield from _claimed(parameter_set, other)
        earlier.append(parameter_set)


def _printed(parameter_set: ParameterSet) -> Findings:
    for parameter in parameter_set.parameters:
        right = parameter_set.base + parameter.number
        if parameter.wire_number is not None and parameter.wire_number != right:
            text = f"{parameter.name} has the number {hexadecimal(parameter.wire_number)} on the wire; as"
            text += f" {parameter_set.number_text(parameter.number)} it should have {hexadecimal(right)}"
            related_label = label(
                parameter_set.place, "base", f"{parameter_set.name} begins at {hexadecimal(parameter_set.base)}"
            )
            help = "correct the number, the number on the wire or the base"
            yield finding(parameter.place, "wire_number", text, help, related_label)


def _claimed(parameter_set: ParameterSet, other: ParameterSet) -> Findings:
    """The first number of a set that another one has too."""
    other_numbers = wire_numbers([other])
    claims: list[tuple[int, int, str, Place, str]] = [
        (*on_wire(parameter_set, row), row.name, row.place, "number") for row in parameter_set.parameters
    ]
    for low, high in parameter_set.numbers.intervals if parameter_set.numbers is not None else ():
        claims.append(
            (parameter_set.base + low, parameter_set.base + high, parameter_set.name, parameter_set.place, "numbers")
        )
    for low, high, name, place, key in claims:
        if uncovered(low, high, other_numbers) != [(low, high)]:
            text = f"{name} has {addresses(low, high)} on the wire, which {other.name} also uses"
            related_label = label(
                other.place, "base", f"{other.name} has {addresses(other_numbers[0][0], other_numbers[-1][1])}"
            )
            help = "correct a number, a base or the space of one of the sets"
            yield finding(place, key, text, help, related_label)
            return
