"""Which numbers on the wire the sets of parameters have."""

from __future__ import annotations

from collections.abc import Iterable

from fieldspec.checks.occupied import merged
from fieldspec.model.parameter import Parameter, ParameterSet


def on_wire(held: ParameterSet, parameter: Parameter) -> tuple[int, int]:
    """The first and the last number on the wire of a parameter."""
    first = held.base + parameter.number
    return first, first + parameter.count - 1


def wire_numbers(sets: Iterable[ParameterSet]) -> list[tuple[int, int]]:
    """The numbers on the wire of all parameters of some sets, with a row or without, in order."""
    return merged(pair for held in sets for pair in _of_set(held))


def _of_set(held: ParameterSet) -> list[tuple[int, int]]:
    families = held.numbers.intervals if held.numbers is not None else ()
    rows = [on_wire(held, parameter) for parameter in held.parameters]
    return [*rows, *((held.base + low, held.base + high) for low, high in families)]
