"""The memory of a simulated device: words at addresses, elements of parameters, and the fields of messages."""

from __future__ import annotations

from collections.abc import Iterable
from decimal import Decimal

from fieldspec.codec.explain.occupants import Occupant, base_of_table, count_of_occupant, element_number, occupants
from fieldspec.codec.explain.spans import Span
from fieldspec.codec.explain.values import number_of
from fieldspec.codec.layout.bases import at_usual_bases, moving_tables
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.reference.structs import value_construct
from fieldspec.foundation.classes import TYPE_CHECKING, replace
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_array, is_real
from fieldspec.language.model.registers import Parameter, ParameterSet, Register, Table
from fieldspec.language.model.text_form import text_bytes
from fieldspec.language.model.value import Value
from fieldspec.tools.simulator.noted import Noted

if TYPE_CHECKING:
    from typing import Any, Literal, TypeAlias

    from fieldspec.codec.layout.values import Raw
    from fieldspec.tools.simulator.segments import Transfer

Address: TypeAlias = "tuple[str, int]"
"""The name of a space, and an address in it."""

Element: TypeAlias = "tuple[str, int, int]"
"""The name of a parameter set, a number of the set, and the index of an element."""

_LAST = 0x10000


def default_raw(device: Device, value: Value) -> Raw:
    """The raw value at delivery where nothing else states it.

    That is the default, that of fields of bits, the constant, 0, or what is nearest to 0; for an enum without it the
    first available member.
    """
    if is_array(value.encoding):
        text = value.default if isinstance(value.default, str) else ""
        return text if value.text_form is not None else text_bytes(value, "big", text)
    if value.default is not None:
        return float(value.default) if isinstance(value.default, str) else value.default
    if value.const is not None:
        return value.const
    nearest = 0
    if value.ranges is not None and 0 not in value.ranges and value.sentinel(0) is None:
        nearest = min((bound for interval in value.ranges.intervals for bound in interval), key=abs)
    if is_real(value.encoding):
        return float(nearest)
    if value.flags:
        word = device.flags[value.flags]
        return word.nearest(nearest or word.initial)
    enum = device.enums.get(value.enum)
    if enum is None or enum.open or value.sentinel(nearest) is not None:
        return nearest
    members = [member.value for member in enum.members if not member.unavailable and _fits(value, member.value)]
    return nearest if nearest in members or not members else members[0]


def _fits(value: Value, number: int) -> bool:
    """Whether a value can have a number."""
    return value.low <= number <= value.high and (value.ranges is None or number in value.ranges)


class Memory:
    """The values of a device. The `stored` values are nonvolatile.

    Tables are at their usual addresses here, wherever the device says that they begin; see `place`.
    """

    def __init__(self, layout: DeviceLayout) -> None:
        self.layout = layout
        self.words: Noted[Address, int] = Noted()
        self.occupants: dict[Address, list[Occupant]] = {}
        self._write_places: dict[Address, int] = {}
        self.elements: Noted[Element, Raw] = Noted()
        self.fields: Noted[str, Raw] = Noted()
        self.lists: dict[str, list[dict[str, Raw]]] = {}
        self.formats: dict[tuple[str, int], int] = {}
        self.transfers: dict[str, Transfer] = {}
        """The values in pieces that are on their way, by link."""
        """The number of the format in which a parameter was last written, or is to be read."""
        self._constructs: dict[int, Any] = {}
        self.order: Literal["big", "little"] = "big" if layout.device.byte_order == "big" else "little"
        device = layout.device
        for space in dict.fromkeys([*device.spaces, device.space_name("")]):
            for occupant in occupants(at_usual_bases(layout), Span(space, 0, _LAST, 0, b"")):
                for number in range(occupant.words):
                    address = occupant.address + number
                    self.occupants.setdefault((space, address), []).append(occupant)
                    if occupant.value.write_word_order:
                        in_word = 2 // device.space(space).unit_size
                        word, rest = divmod(number, in_word)
                        turned = occupant.address + occupant.words - (word + 1) * in_word + rest
                        self._write_places.setdefault((space, address), turned)
        self._bases = [
            (layout.tables[name], device.space_name(register.register.space), base_of_table(layout, name))
            for name, register in moving_tables(layout).items()
        ]
        self.deliver()

    @property
    def changes(self) -> tuple[int, int, int]:
        """Other numbers after everything that may have changed a watched value."""
        return self.words.changes, self.elements.changes, self.fields.changes

    def deliver(self) -> None:
        """Sets everything to what it is when the device is delivered, as far as the values themselves say it."""
        device = self.layout.device
        self.words.replace(dict.fromkeys(self.occupants, 0))
        for (space, address), present in self.occupants.items():
            for occupant in present:
                if occupant.address == address:
                    self.write(space, occupant, default_raw(device, _as_read(occupant)))
        for table, space, register in self._bases:
            self.write(space, register, table.table.base)
        elements = (
            ((parameter_set.name, parameter.number + offset, index), element_value(parameter, index))
            for parameter_set in device.parameters.values()
            for parameter in parameter_set.parameters
            for offset in range(parameter.count)
            for index in range(parameter.elements or 1)
        )
        self.elements.replace({element: default_raw(device, value) for element, value in elements})
        self.fields.replace({})
        self.lists.clear()

    def at(self, space: str, address: int) -> list[Occupant]:
        """The occupants of an address: mostly one value, several if the spec permits an overlap."""
        return self.occupants.get((space, address), [])

    def place(self, space: str, address: int) -> int:
        """Where the memory has what the device has at an address now; -1 where it has moved away."""
        if not self._bases:
            return address
        own = [row for row in self._bases if self.layout.device.space_name(row[0].table.space) == space]
        moved = False
        for table, register_space, register in own:
            usual, base = table.table.base, self.read(register_space, register)
            extent = (table.table.count - 1) * table.table.stride + table.words
            if isinstance(base, int) and base <= address < base + extent:
                if (space, address - base + usual) in self.occupants:
                    return address - base + usual
            elif usual <= address < usual + extent:
                moved = True
        is_register = any(isinstance(occupant.outer, Register) for occupant in self.at(space, address))
        return -1 if moved and not is_register else address

    def write_place(self, space: str, address: int) -> int:
        """Where the memory, which has what is read, has what is written to one of its addresses."""
        return self._write_places.get((space, address), address)

    def has_base(self, space: str, addresses: range) -> bool:
        """Whether some addresses have a register that says where a table begins."""
        return any(own == space and register.address in addresses for _, own, register in self._bases)

    def is_absent(self, occupant: Occupant) -> bool:
        """Whether something is a field in an element of a table that the device has not got now."""
        count = count_of_occupant(self.layout, occupant)
        if count is None:
            return False
        table = occupant.outer
        assert isinstance(table, Table)
        number = self.read(self.layout.device.space_name(table.space), count)
        return isinstance(number, int) and element_number(occupant) >= number

    def read(self, space: str, occupant: Occupant) -> Raw:
        """The raw value of an occupant."""
        span = range(occupant.address, occupant.address + occupant.words)
        size = self.layout.device.space(space).unit_size
        data = b"".join(self.words[space, address].to_bytes(size, self.order) for address in span)
        skip = occupant.skip
        return number_of(occupant.value, data[skip : skip + occupant.value.size], occupant.order, occupant.swapped)

    def write(self, space: str, occupant: Occupant, raw: Raw) -> None:
        """Sets the raw value of an occupant, with no more than its bits."""
        data = self.bytes_of(occupant.value, raw, occupant.order, occupant.swapped)
        span = range(occupant.address, occupant.address + occupant.words)
        size = self.layout.device.space(space).unit_size
        old = b"".join(self.words[space, address].to_bytes(size, self.order) for address in span)
        new = old[: occupant.skip] + data + old[occupant.skip + len(data) :]
        for number, address in enumerate(span):
            self.words[space, address] = int.from_bytes(new[size * number : size * (number + 1)], self.order)

    def bytes_of(self, value: Value, raw: Raw, order: str, swapped: bool) -> bytes:
        """The bytes of a raw value; a number that is too great for its type is cut to the type's bounds."""
        if isinstance(raw, str):
            return text_bytes(value, order, raw)
        if isinstance(raw, bytes):
            return raw.ljust(value.size, b"\0")[: value.size]
        if not is_real(value.encoding) and isinstance(raw, int | float | Decimal):
            raw = min(max(round(raw), value.low), value.high)
        key = id(value)
        codec = self._constructs.get(key)
        if codec is None:
            codec = self._constructs[key] = value_construct(value, order, swapped)
        data: bytes = codec.build(raw)
        return data


def _as_read(occupant: Occupant) -> Value:
    """The value of an occupant as it is read: no enum binds a trigger, which does not return what was written."""
    return replace(occupant.value, enum="") if occupant.trigger and occupant.value.enum else occupant.value


def element_value(parameter: Parameter, index: int) -> Value:
    """The value of an element: that of the parameter, or of the run of elements that it belongs to."""
    element = parameter.element(index)
    return parameter.value if element is None else element.value


def numbers_of(sets: Iterable[ParameterSet]) -> list[tuple[str, int, Parameter]]:
    """All numbers of some sets with the parameter of each."""
    return [
        (parameter_set.name, parameter.number + offset, parameter)
        for parameter_set in sets
        for parameter in parameter_set.parameters
        for offset in range(parameter.count)
    ]
