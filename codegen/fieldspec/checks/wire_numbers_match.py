"""The printed number of a parameter on the wire is the base of its set plus its number, and no number belongs
to two sets of one space.

Why: a manual that prints `Pt25B` and `0x225B` says the same thing twice. Where the two differ, one of them
sends the user to another parameter.

Example: number 0x317 of a set with the base 0x2000, beside 0x2371.

Cure: Put the number, the printed one or the base right, and write an erratum if it is printed so.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.addresses import on_wire, wire_numbers
from fieldspec.checks.finding import addresses, finding, hexadecimal, label
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device
from fieldspec.model.fact import Place
from fieldspec.model.registers import ParameterSet
from fieldspec.model.value import uncovered

_CODE = "wire_numbers_match"


def wire_numbers_match(device: Device) -> Iterator[Diagnostic]:
    for held in device.parameters.values():
        yield from _printed(held)
    spaces: dict[str, list[ParameterSet]] = {}
    for held in device.parameters.values():
        earlier = spaces.setdefault(held.space, [])
        for other in earlier:
            yield from _claimed(held, other)
        earlier.append(held)


def _printed(held: ParameterSet) -> Iterator[Diagnostic]:
    for parameter in held.parameters:
        right = held.base + parameter.number
        if parameter.wire_number is not None and parameter.wire_number != right:
            text = f"{parameter.name} has the number {hexadecimal(parameter.wire_number)} on the wire; as"
            text += f" {held.number_text(parameter.number)} it has {hexadecimal(right)}"
            there = label(held.place, "base", f"{held.name} begins at {hexadecimal(held.base)}")
            help = "put the number, the one on the wire or the base right"
            yield finding(_CODE, parameter.place, "wire_number", text, help, there)


def _claimed(held: ParameterSet, other: ParameterSet) -> Iterator[Diagnostic]:
    """The first number of a set that another one has too."""
    taken = wire_numbers([other])
    claims: list[tuple[int, int, str, Place, str]] = [
        (*on_wire(held, row), row.name, row.place, "number") for row in held.parameters
    ]
    for low, high in held.numbers.intervals if held.numbers is not None else ():
        claims.append((held.base + low, held.base + high, held.name, held.place, "numbers"))
    for low, high, name, place, key in claims:
        if uncovered(low, high, taken) != [(low, high)]:
            text = f"{name} has {addresses(low, high)} on the wire, where {other.name} has numbers too"
            there = label(other.place, "base", f"{other.name} has {addresses(taken[0][0], taken[-1][1])}")
            help = "put a number, a base or the space of one of the sets right"
            yield finding(_CODE, place, key, text, help, there)
            return
