"""The values of registers and parameters, which have functions of their own."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import Orders, RegisterLayout
from fieldspec.language.model.registers import ParameterSet
from fieldspec.targets.c.naming import Naming, Noun
from fieldspec.targets.c.runtime_files import is_bit
from fieldspec.targets.c.values import WireValue
from fieldspec.targets.pieces import Result, Run, facts_of, piece, register_runs, run_pieces

LoneValue = tuple[Noun, tuple[str, ...], WireValue, int, bool]
"""The noun and the names of the functions of a value, its size on the wire, and whether it is a trigger."""


def lone_pieces(
    kind: str, layout: DeviceLayout, naming: Naming, make: Callable[[LoneValue], Iterable[Result]]
) -> Iterator[Result]:
    """The results of `make` for the values of registers and parameters, which have functions of their own."""
    device = layout.device
    orders = Orders(device.byte_order, device.word_order)
    runs: list[Run[LoneValue]] = [(facts, partial(_of_registers, run)) for run, facts in register_runs(layout)]
    runs += [
        ((parameters, device.enums, device.flags), partial(_of_parameters, parameters, orders))
        for parameters in device.parameters.values()
    ]

    def pieces(lone: LoneValue) -> Iterable[Result]:
        noun, names, wire, size, trigger = lone
        words = (noun, names, wire.order, wire.swapped, size, trigger)
        return piece(kind, facts_of(device, wire.value), words, lambda: tuple(make(lone)), naming)

    return run_pieces(f"{kind}s", runs, (orders,), pieces, naming)


def _of_registers(registers: Sequence[RegisterLayout]) -> Iterator[LoneValue]:
    for register in registers:
        if not is_bit(register):
            wire = WireValue(register.register.value, register.order, register.swapped)
            yield "register", (register.name,), wire, register.size, register.register.trigger


def _of_parameters(parameters: ParameterSet, orders: Orders) -> Iterator[LoneValue]:
    for parameter in parameters.parameters:
        if parameter.reserved:
            continue
        names = (parameters.name, parameter.name)
        inner = [((*names, inner.name), inner.value) for inner in parameter.subindices if not inner.reserved]
        for full_names, value in [(names, parameter.value), *inner]:
            yield "parameter", full_names, WireValue(value, *orders.of(value)), value.size, parameter.trigger
