"""Which addresses the registers, arrays of registers and tables of a device hold."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable, Iterator, Sequence
from operator import itemgetter

from fieldspec.checks.sizes import Sizes
from fieldspec.classes import dataclass
from fieldspec.model.device import Device
from fieldspec.model.fact import Fact
from fieldspec.model.register import Register
from fieldspec.model.table import Table

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


def table_words(table: Table, sizes: Sizes) -> int:
    """The words of one element that are known to be used; at least one."""
    size = sizes.named(table.record)
    return max(1, (size + 1) // 2 if size is not None else table.words or 1)


def blocks(device: Device) -> Iterator[Block]:
    """The addresses of every element of every register and table."""
    sizes = Sizes(device)
    for register in device.registers():
        space, width = device.space_name(register.space), max(1, register.width)
        yield from _elements(register, space, "at", register.address, width, register.stride, register.count)
    for table in device.tables.values():
        space, width = device.space_name(table.space), table_words(table, sizes)
        yield from _elements(table, space, "base", table.base, width, table.stride, table.count)


def extents(device: Device) -> Iterator[tuple[str, int, int]]:
    """The space, and the first and last address, of every register and table; what lies between elements is theirs."""
    sizes = Sizes(device)
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
        at = first + number * stride
        yield Block(space, at, at + words - 1, fact, key, fact.name)


def merged(intervals: Iterable[tuple[int, int]]) -> list[tuple[int, int]]:
    """The same addresses in intervals that are sorted and do not touch."""
    joined: list[tuple[int, int]] = []
    for low, high in sorted(intervals):
        if joined and low <= joined[-1][1] + 1:
            joined[-1] = joined[-1][0], max(joined[-1][1], high)
        else:
            joined.append((low, high))
    return joined


def free(first: int, last: int, taken: Sequence[tuple[int, int]]) -> list[tuple[int, int]]:
    """The parts of `first` to `last` that no interval of `taken`, as `merged` gives them, reaches into."""
    holes = []
    at = first
    for index in range(bisect_left(taken, first, key=itemgetter(1)), len(taken)):
        low, high = taken[index]
        if low > last:
            break
        if low > at:
            holes.append((at, low - 1))
        at = max(at, high + 1)
    if at <= last:
        holes.append((at, last))
    return holes
