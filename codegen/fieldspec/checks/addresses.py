"""The addresses and parameter numbers that a device occupies, and what is at each."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from fieldspec.classes import dataclass
from fieldspec.model.access import narrowed
from fieldspec.model.device import Device
from fieldspec.model.fact import Fact
from fieldspec.model.ranges import merged
from fieldspec.model.record import Field
from fieldspec.model.registers import Parameter, ParameterSet, Register, Table
from fieldspec.model.sizes import RecordSizes
from fieldspec.model.value import Kind, Value

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
        at = first + number * stride
        yield Block(space, at, at + words - 1, fact, key, fact.name)


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


@dataclass(frozen=True, slots=True)
class Addressed:
    """A value that begins at an address, and the fact that it belongs to.

    `access` is empty where not printed; `holder` is the fact that states it: the register, the field or its table.
    """

    fact: Fact
    value: Value | None
    access: str
    holder: Fact

    @property
    def words(self) -> int:
        """The addresses that it takes; one where it is not a single value."""
        size = self.fact.unit_size if isinstance(self.fact, Register) else 2
        return max(1, -(-self.value.size // size)) if self.value is not None else 1


class Addresses:
    """Looks up addresses of a device."""

    def __init__(self, device: Device) -> None:
        self._device = device
        self._registers = {(device.space_name(r.space), r.address): r for r in device.registers() if r.count == 1}
        self._arrays = [r for r in device.registers() if r.count > 1]
        sizes = RecordSizes(device)
        self._fields: dict[str, dict[int, Field]] = {}
        for table in device.tables.values():
            record = device.records.get(table.record)
            placed = sizes.offsets(record) if record is not None else []
            self._fields[table.name] = {at // 2: field for field, at in placed if at % 2 == 0}

    def at(self, space: str, address: int) -> Addressed | None:
        """The value that begins at an address of a space; an empty name means the first space."""
        own = self._device.space_name(space)
        register = self._registers.get((own, address))
        for array in self._arrays if register is None else ():
            if self._device.space_name(array.space) != own:
                continue
            number, rest = divmod(address - array.address, array.stride)
            if 0 <= number < array.count and rest == 0:
                register = array
        if register is not None:
            return Addressed(register, register.value, register.access, register)
        for table in self._device.tables.values():
            occupant = self._in_table(table, address) if self._device.space_name(table.space) == own else None
            if occupant is not None:
                return occupant
        return None

    def _in_table(self, table: Table, address: int) -> Addressed | None:
        number, rest = divmod(address - table.base, table.stride)
        field = self._fields[table.name].get(rest) if 0 <= number < table.count else None
        if field is None:
            return None
        single = field.value is not None and field.count is None and field.repeat is None
        access = narrowed(table.access, field.access)
        return Addressed(field, field.value if single else None, access, field if access == field.access else table)

    def within(self, space: str, start: int, words: int) -> Iterator[Addressed]:
        """The values that begin in neighbouring words of a space."""
        at = start
        while at < start + words:
            occupant = self.at(space, at)
            if occupant is not None:
                yield occupant
            at += occupant.words if occupant is not None else 1

    def counts(self, space: str, start: int, words: Sequence[int]) -> Iterator[tuple[int, Addressed, int]]:
        """The address, the fact and the count of every whole number in neighbouring words."""
        index = 0
        while index < len(words):
            occupant = self.at(space, start + index)
            taken = words[index : index + occupant.words] if occupant is not None else []
            if occupant is not None and occupant.value is not None and len(taken) == occupant.words:
                if occupant.value.type.kind in (Kind.INTEGER, Kind.BOOLEAN):
                    yield start + index, occupant, self._joined(taken, occupant, occupant.value)
                index += occupant.words
            else:
                index += 1

    def _of_bytes(self, units: Sequence[int], value: Value) -> int:
        """The unsigned number in neighbouring bytes."""
        data = bytes(unit & 0xFF for unit in units)
        order = value.byte_order or self._device.byte_order
        words = value.word_order or self._device.word_order or order
        if value.has_words and words != order:
            data = b"".join(data[at : at + 2] for at in range(len(data) - 2, -1, -2))
        return int.from_bytes(data, "little" if order == "little" else "big")

    def _joined(self, words: Sequence[int], occupant: Addressed, value: Value) -> int:
        number = 0
        if isinstance(occupant.fact, Register) and occupant.fact.unit_size == 1:
            number = self._of_bytes(words, value)
        else:
            for word in words if self._device.word_order == "big" else reversed(words):
                number = number << 16 | (word & 0xFFFF)
        bits = 8 * value.type.size
        number &= (1 << bits) - 1
        return number - (1 << bits) if value.type.signed and number >> (bits - 1) else number
