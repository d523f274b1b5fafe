"""What a device has at its addresses: one item for each register, field of a table, and parameter."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from decimal import Decimal

from fieldspec.classes import dataclass, replace
from fieldspec.layout.device import DeviceLayout, TableLayout
from fieldspec.layout.record import FieldLayout, RecordLayout
from fieldspec.model.access import narrowed
from fieldspec.model.address_space import BIT
from fieldspec.model.device import Device
from fieldspec.model.enums import Enum
from fieldspec.model.fact import Citation
from fieldspec.model.registers import Parameter, ParameterSet, Register
from fieldspec.model.value import Value

REGISTERS = "registers"
"""The name of the first space of registers; further ones, and spaces of parameters, have their own names."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Item:
    """A value at `address` with a size of `words` of 16 bits, None for a parameter, a bit and a register of bytes.

    A field of a table, and a parameter with several elements, stand for `count` values: the first has the number
    `first`, and they are `stride` addresses apart, or all at one address if that is 0. `access` is empty if the manual
    does not state it. `members` are the names of raw values, `ucum` the code of the unit.
    """

    space: str
    address: int
    name: str
    words: int | None
    type: str
    access: str
    value: Value | None
    count: int = 1
    stride: int = 0
    first: int = 0
    printed_name: str = ""
    label: str = ""
    members: tuple[tuple[str, str], ...] = ()
    source: Citation | None = None
    unverified: bool = False
    ucum: str = ""

    def addresses(self) -> range:
        """The addresses of all values that it stands for."""
        step = self.stride or 1
        return range(self.address, self.address + (self.count if self.stride else 1) * step, step)


def items(layout: DeviceLayout) -> list[Item]:
    """All items of a device: registers, tables and parameters, each by address."""
    enums = layout.device.enums
    items = [item for register in layout.device.registers() for item in _register(layout.device, register, enums)]
    items += [item for table in layout.tables.values() for item in _table(layout.device, table, enums)]
    items.sort(key=lambda item: item.address)
    for parameter_set in layout.device.parameters.values():
        items += [
            item for parameter in parameter_set.parameters for item in _parameter(parameter_set, parameter, enums)
        ]
    return [replace(item, ucum=_code(layout.device, item.value)) for item in items]


def _code(device: Device, value: Value | None) -> str:
    unit = device.unit(value.quantity_unit) if value is not None and value.quantity_unit else None
    return unit.ucum if unit is not None else ""


def _type(value: Value) -> str:
    """The type, and the form of the digits of a number that is sent as such: `u16 bcd`."""
    return f"{value.type.name} {value.digits}".strip()


def _register(device: Device, register: Register, enums: Mapping[str, Enum]) -> Iterator[Item]:
    for number in range(register.count):
        index = register.index_from + number
        is_list = register.count > 1
        sources = register.element_sources[number : number + 1] or register.sources
        printed = register.element_name.format(n=index) if register.element_name and is_list else register.printed_name
        yield Item(
            space=_space(device, register.space),
            address=register.address + number * register.stride,
            name=f"{register.name}_{index}" if is_list else register.name,
            words=register.width if register.unit_size > 1 and register.value.type.name != BIT else None,
            type=_type(register.value),
            access=register.access,
            value=register.value,
            printed_name=printed,
            label=register.label,
            members=_members(register.value, enums),
            source=_first(sources),
            unverified=register.unverified,
        )


def _table(device: Device, table_layout: TableLayout, enums: Mapping[str, Enum]) -> Iterator[Item]:
    table = table_layout.table
    for name, field, byte, access in _flat(table_layout.record, table.access):
        yield Item(
            space=_space(device, table.space),
            address=table.base + byte // 2,
            name=f"{table.name}.{name}",
            words=(byte % 2 + field.size + 1) // 2,
            type=_type(field.value) if field.value else "bytes",
            access=access,
            value=field.value,
            count=table.count,
            stride=table.stride,
            first=table.index_from,
            members=_members(field.value, enums),
            printed_name=field.field.printed_name,
            label=field.field.label,
            source=_first(field.field.sources),
            unverified=field.field.unverified,
        )


def _space(device: Device, name: str) -> str:
    own = device.space_name(name)
    return REGISTERS if own == device.space_name("") else own


def _flat(
    record: RecordLayout, access: str, before: str = "", start: int = 0
) -> Iterator[tuple[str, FieldLayout, int, str]]:
    """The name, field, offset in bytes and access of each value in a record, and in the records in it.

    `access` is that of the container of the record.
    """
    for field in record.fields:
        allowed = narrowed(access, field.field.access)
        count = field.count or 1
        for number in range(count):
            name = f"{before}{field.name}" + (f"_{number}" if count > 1 else "")
            byte = start + field.offset + number * field.size
            if field.record is None:
                yield name, field, byte, allowed
            else:
                yield from _flat(field.record, allowed, f"{name}.", byte)


def _parameter(parameter_set: ParameterSet, parameter: Parameter, enums: Mapping[str, Enum]) -> Iterator[Item]:
    for number in range(parameter.number, parameter.number + parameter.count):
        yield Item(
            space=parameter_set.space,
            address=parameter_set.base + number,
            name=f"{parameter.name}_{number}" if parameter.count > 1 else parameter.name,
            words=None,
            type=parameter.value.type.name,
            access=parameter.access,
            value=parameter.value,
            count=parameter.elements or 1,
            members=_members(parameter.value, enums),
            printed_name=parameter.printed_name,
            label=parameter.label,
            source=_first(parameter.sources),
            unverified=parameter.unverified,
        )


def _first(sources: tuple[Citation, ...]) -> Citation | None:
    return sources[0] if sources else None


def _members(value: Value | None, enums: Mapping[str, Enum]) -> tuple[tuple[str, str], ...]:
    """The raw values with names: members of the enum, and sentinels."""
    enum = enums.get(value.enum) if value is not None and value.enum else None
    enum_members = [(str(member.value), member.name) for member in enum.members] if enum is not None else []
    return (
        *enum_members,
        *((sentinel.text, sentinel.name) for sentinel in (value.sentinels if value is not None else ())),
    )


def exact_number(number: Decimal | str) -> int | Decimal | str:
    """An exact number, as an int if it is whole; a fraction as it is written."""
    if isinstance(number, str):
        return number
    return int(number) if number == number.to_integral_value() else number
