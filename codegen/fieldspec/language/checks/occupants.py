"""What begins at the addresses of a device, and the numbers that bytes at them are."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.foundation.classes import dataclass
from fieldspec.language.checks.addresses import SPACE
from fieldspec.language.model.access import narrowed
from fieldspec.language.model.address_space import WORD
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_array
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.raw_numbers import number_in, orders_of
from fieldspec.language.model.record import Field, Record
from fieldspec.language.model.registers import Table
from fieldspec.language.model.sizes import RecordSizes
from fieldspec.language.model.value import Value


@dataclass(frozen=True, slots=True)
class Addressed:
    """A value that begins `skip` bytes after an address, and the fact that it belongs to.

    `access` is empty where not printed; `holder` is the fact that states it: the register, the field or its table.
    """

    fact: Fact
    value: Value | None
    access: str
    holder: Fact
    skip: int = 0


class Addresses:
    """Looks up addresses of a device."""

    def __init__(self, device: Device) -> None:
        self._device = device
        self._registers = {(device.space_name(r.space), r.address): r for r in device.registers() if r.count == 1}
        self._arrays = [r for r in device.registers() if r.count > 1]
        self._sizes = RecordSizes(device)
        self._fields: dict[str, dict[int, list[tuple[Field, int]]]] = {}
        for table in device.tables.values():
            placed = self._fields.setdefault(table.name, {})
            for field, offset in self._placed(device.records.get(table.record), 0):
                placed.setdefault(offset // 2, []).append((field, offset % 2))

    def _placed(self, record: Record | None, start: int) -> Iterator[tuple[Field, int]]:
        """The values in a record with their offsets in bytes, those in inner records and in lists too."""
        size = self._sizes.named(record.name) if record is not None else None
        if record is None or not size or size > 2 * SPACE:  # one that is empty, or fits no space, is a finding
            return
        for field, offset in self._sizes.offsets(record):
            element = self._sizes.element(field)
            for number in range(field.count or 1) if element else ():
                element_offset = start + offset + number * (element or 0)
                if field.record:
                    yield from self._placed(self._device.records.get(field.record), element_offset)
                else:
                    yield field, element_offset

    def at(self, space: str, address: int) -> list[Addressed]:
        """The values that begin at an address of a space; an empty name means the first space.

        One register or table of those at the same address is enough.
        """
        own = self._device.space_name(space)
        register = self._registers.get((own, address))
        for array in self._arrays if register is None else ():
            number, rest = divmod(address - array.address, array.stride)
            if 0 <= number < array.count and rest == 0 and self._device.space_name(array.space) == own:
                register = array
        if register is not None:
            return [Addressed(register, register.value, register.access, register)]
        for table in self._device.tables.values():
            occupants = self._in_table(table, address) if self._device.space_name(table.space) == own else []
            if occupants:
                return occupants
        return []

    def _in_table(self, table: Table, address: int) -> list[Addressed]:
        number, rest = divmod(address - table.base, table.stride)
        occupants = []
        for field, skip in self._fields[table.name].get(rest, []) if 0 <= number < table.count else ():
            access = narrowed(table.access, field.access)
            # A register says where a table that moves begins: what these bytes are is not known here.
            value = field.value if not table.base_by and not field.reserved else None
            occupants.append(Addressed(field, value, access, field if access == field.access else table, skip))
        return occupants

    def within(self, space: str, start: int, units: int) -> Iterator[Addressed]:
        """The values that begin at neighbouring addresses of a space."""
        for address in range(start, start + units):
            yield from self.at(space, address)

    def numbers(
        self, space: str, start: int, data: bytes, writes: bool
    ) -> Iterator[tuple[int, Addressed, int | float | None]]:
        """The address, the fact and the number of every value that is whole in the bytes at neighbouring addresses.

        In a space of bits, each has a byte. The number is None where the bytes are not the digits of one.
        """
        unit = 2 if self._device.space(space).unit == WORD else 1
        for index in range(len(data) // unit):
            for occupant in self.at(space, start + index):
                value = occupant.value
                if value is None or is_array(value.encoding):
                    continue
                first = index * unit + occupant.skip
                own = data[first : first + value.size]
                if len(own) == value.size:
                    order, swapped = orders_of(value, self._device.byte_order, self._device.word_order)
                    swapped = value.write_swapped(swapped) if writes else swapped
                    yield start + index, occupant, number_in(value, own, order, swapped)
