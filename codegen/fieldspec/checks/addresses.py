"""The addresses and parameter numbers that a device occupies, and what is at each."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from fieldspec.classes import dataclass
from fieldspec.model.device import Device
from fieldspec.model.fact import Fact
from fieldspec.model.ranges import merged
from fieldspec.model.registers import Parameter, ParameterSet, Register, Table
from fieldspec.model.sizes import RecordSizes

SPACE = 0x10000
"""How many addresses a space has at most: a frame carries them in 16 bits."""


@dataclass(frozen=True, slots=True)
class Block:
    """Neighbouring addresses, `first` to `last`, that a fact holds in a space; `key` is where its address stands."""

    space: str
    first: int
    last: int
    fact: Fact
    key: str
    name: str


def table_words(table: Table, sizes: RecordSizes) -> int:
    """The words of one element that are known to be used; at least one."""
    size = sizes.named(table.record)
    return max(1, (size + 1) // 2 if size is not None else table.words or 1)


def blocks(device: Device) -> Iterator[Block]:
    """The addresses of every element of every register and table."""
    sizes = RecordSizes(device)
    for register in device.registers():
        space, width = device.space_name(register.space), max(1, register.width)
        yield from _elements(register, space, "at", register.address, width, register.stride, register.count)
    for table in device.tables.values():
        space, width = device.space_name(table.space), table_words(table, sizes)
        yield from _elements(table, space, "base", table.base, width, table.stride, table.count)


def extents(device: Device) -> Iterator[tuple[str, int, int]]:
    """The space, and the first and last address, of every register and table; what lies between elements is theirs."""
    sizes = RecordSizes(device)
    for register in device.registers():
        yield device.space_name(register.space), register.address, _last(register)
    for table in device.tables.values():
        yield (
            device.space_name(table.space),
            table.base,
            table.base + (table.count - 1) * table.stride + table_words(table, sizes) - 1,
        )


def _last(register: Register) -> int:
    return max(register.address, register.end - 1)


def _elements(fact: Fact, space: str, key: str, first: int, words: int, stride: int, count: int) -> Iterator[Block]:
    if count == 1 or stride <= words:
        yield Block(space, first, first + (count - 1) * stride + words - 1, fact, key, fact.name)
        return
    for number in range(min(count, SPACE // stride + 1)):
        address = first + number * stride
        yield Block(space, address, address + words - 1, fact, key, fact.name)


def on_wire(parameter_set: ParameterSet, parameter: Parameter) -> tuple[int, int]:
    """The first and the last number on the wire of a parameter."""
    first = parameter_set.base + parameter.number
    return first, first + parameter.count - 1


def wire_numbers(sets: Iterable[ParameterSet]) -> list[tuple[int, int]]:
    """The numbers on the wire of all parameters of some sets, with a row or without, in order."""
    return merged(pair for parameter_set in sets for pair in _of_set(parameter_set))


def _of_set(parameter_set: ParameterSet) -> list[tuple[int, int]]:
    families = parameter_set.numbers.intervals if parameter_set.numbers is not None else ()
    rows = [on_wire(parameter_set, parameter) for parameter in parameter_set.parameters]
    return [*rows, *((parameter_set.base + low, parameter_set.base + high) for low, high in families)]
