"""What lies at an address: a register, an element of an array, or a field of a table's element."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from fieldspec.checks.sizes import Sizes
from fieldspec.classes import dataclass
from fieldspec.model.access import narrowed
from fieldspec.model.device import Device
from fieldspec.model.fact import Fact
from fieldspec.model.primitive import Kind
from fieldspec.model.record import Field
from fieldspec.model.table import Table
from fieldspec.model.value import Value


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
        """The words that it takes; one where it is no single value."""
        return max(1, (self.value.size + 1) // 2) if self.value is not None else 1


class Addresses:
    """Looks up addresses of a device."""

    def __init__(self, device: Device) -> None:
        self._device = device
        self._registers = {(device.space_name(r.space), r.address): r for r in device.registers() if r.count == 1}
        self._arrays = [r for r in device.registers() if r.count > 1]
        sizes = Sizes(device)
        self._fields: dict[str, dict[int, Field]] = {}
        for table in device.tables.values():
            record = device.records.get(table.record)
            placed = sizes.offsets(record) if record is not None else []
            self._fields[table.name] = {at // 2: field for field, at in placed if at % 2 == 0}

    def at(self, space: str, address: int) -> Addressed | None:
        """What begins at an address of a space; an empty name means the first space."""
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
            found = self._in_table(table, address) if self._device.space_name(table.space) == own else None
            if found is not None:
                return found
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
        """What begins in neighbouring words of a space."""
        at = start
        while at < start + words:
            found = self.at(space, at)
            if found is not None:
                yield found
            at += found.words if found is not None else 1

    def counts(self, space: str, start: int, words: Sequence[int]) -> Iterator[tuple[int, Addressed, int]]:
        """The address, the fact and the count of every whole number in neighbouring words."""
        index = 0
        while index < len(words):
            found = self.at(space, start + index)
            taken = words[index : index + found.words] if found is not None else []
            if found is not None and found.value is not None and len(taken) == found.words:
                if found.value.type.kind in (Kind.INTEGER, Kind.BOOLEAN):
                    yield start + index, found, self._joined(taken, found.value)
                index += found.words
            else:
                index += 1

    def _joined(self, words: Sequence[int], value: Value) -> int:
        number = 0
        for word in words if self._device.word_order == "big" else reversed(words):
            number = number << 16 | (word & 0xFFFF)
        bits = 8 * value.type.size
        number &= (1 << bits) - 1
        return number - (1 << bits) if value.type.signed and number >> (bits - 1) else number
