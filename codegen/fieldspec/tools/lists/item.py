"""The content of a device's addresses: one item for each register, field of a table, and parameter."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from decimal import Decimal
from typing import Any

from fieldspec.codec.layout.device import DeviceLayout, TableLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.record import FieldLayout, RecordLayout, RegisterLayout
from fieldspec.foundation.classes import dataclass, field, replace
from fieldspec.language.model.access import narrowed
from fieldspec.language.model.address_space import BIT
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Citation
from fieldspec.language.model.record import Field
from fieldspec.language.model.registers import Parameter, ParameterSet, Register, Subindex
from fieldspec.language.model.value import Value
from fieldspec.tools.lists.orders import order_text
from fieldspec.tools.lists.value_forms import type_text

MESSAGES = "messages"
"""The word of an export for the fields of messages, in place of the name of a space."""

REGISTERS = "registers"
"""The name of the first space of registers; further ones, and spaces of parameters, have their own names."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Item:
    """A value at `address` with a size of `words` of 16 bits, None for a parameter, a bit and a register of bytes.

    A field of a table, and a parameter with several elements, stand for `count` values: the first has the number
    `first`, and they are `stride` addresses apart, or all at one address if that is 0. `access` is empty if the manual
    does not state it. `members` are the names of raw values, of which `special` are states and no quantities; `ucum` is
    the code of the unit, `order` that of the bytes of two words, empty for the usual one. `subindices` are the first
    and the last one of elements of the parameter at the address. `bits` are the lowest and the highest number and the
    name of each. `other_names` are the names that the manual has for members and bits, by ours.
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
    special: tuple[tuple[str, str], ...] = ()
    bits: tuple[tuple[int, str, str], ...] = ()
    other_names: Mapping[str, frozenset[str]] = field(default_factory=dict)
    order: str = ""
    source: Citation | None = None
    unverified: bool = False
    ucum: str = ""
    subindices: tuple[int, int] | None = None

    def addresses(self) -> range:
        """The addresses of all values that it stands for."""
        step = self.stride or 1
        return range(self.address, self.address + (self.count if self.stride else 1) * step, step)


def items(layout: DeviceLayout, with_messages: bool = False) -> list[Item]:
    """All items of a device: registers, tables and parameters, each by address, and perhaps fields of messages."""
    items = [item for register in layout.registers for item in _register(layout.device, register)]
    items += [item for table in layout.tables.values() for item in _table(layout.device, table)]
    items.sort(key=lambda item: item.address)
    for parameter_set in layout.device.parameters.values():
        items += [item for parameter in parameter_set.parameters for item in _parameter(parameter_set, parameter)]
    if with_messages:
        for message in layout.messages.values():
            items += [item for direction in message.message.directions for item in _message(message, direction)]
    return [replace(item, ucum=_code(layout.device, item.value), **_named(layout.device, item.value)) for item in items]


def _named(device: Device, value: Value | None) -> dict[str, Any]:
    """The attributes of an item that name its raw values and its bits."""
    enum = device.enums.get(value.enum) if value is not None and value.enum else None
    flags = device.flags.get(value.flags) if value is not None and value.flags else None
    members = enum.members if enum is not None else ()
    bits = [bit for bit in flags.bits if not bit.reserved] if flags is not None else []
    special = tuple((sentinel.text, sentinel.name) for sentinel in (value.sentinels if value is not None else ()))
    other_names = {
        fact.name: frozenset(filter(None, (fact.printed_name, fact.label, *getattr(fact, "aliases", ()))))
        for fact in (*members, *bits)
    }
    return {
        "members": (
            *((str(member.value), member.name) for member in members),
            *((number, name) for number, name in special if ".." not in number),
        ),
        "special": special,
        "bits": tuple((bit.first, bit.number_text.replace(" ", ""), bit.name) for bit in bits),
        "other_names": other_names,
    }


def _code(device: Device, value: Value | None) -> str:
    unit = device.unit(value.quantity_unit) if value is not None and value.quantity_unit else None
    return unit.ucum if unit is not None else ""


def _register(device: Device, layout: RegisterLayout) -> Iterator[Item]:
    register = layout.register
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
            access=register.access,
            order=order_text(register.value, layout.order, layout.swapped),
            **{**_stated(register, register.value), "printed_name": printed, "source": _first(sources)},
        )


def _table(device: Device, table_layout: TableLayout) -> Iterator[Item]:
    table = table_layout.table
    for name, part, byte, access in _flat(table_layout.record, table.access):
        yield _field(
            part,
            space=_space(device, table.space),
            address=table.base + byte // 2,
            name=f"{table.name}.{name}",
            words=(byte % 2 + part.size + 1) // 2,
            access=access,
            count=table.count,
            stride=table.stride,
            first=table.index_from,
        )


def _field(part: FieldLayout, **place: Any) -> Item:
    """The item of a field, with where it is."""
    return Item(order=order_text(part.value, part.order, part.swapped), **_stated(part.field, part.value), **place)


def _message(layout: MessageLayout, direction: str) -> Iterator[Item]:
    """The fields of a message, at its code, or at the number by which people know it."""
    message = layout.message
    code = message.printed_code(direction)
    for name, part in _parts(layout.data(direction)):
        yield _field(
            part,
            space=MESSAGES,
            address=code if code is not None else message.number or 0,
            name=f"{message.name}.{direction}.{name}",
            words=None,
            access="",
            count=part.count or 1,
        )


def _parts(record: RecordLayout, before: str = "") -> Iterator[tuple[str, FieldLayout]]:
    """The name and the layout of each field in a record, and in the records and cases in it."""
    for part in record.stated_fields:
        name = f"{before}{part.name}"
        if part.record is not None:
            yield from _parts(part.record, f"{name}.")
        elif part.cases:
            yield from ((f"{name}.{case.name}", replace(part, value=case.value)) for case in part.cases)
        else:
            yield name, part


def _space(device: Device, name: str) -> str:
    full_name = device.space_name(name)
    return REGISTERS if full_name == device.space_name("") else full_name


def _flat(
    record: RecordLayout, access: str, before: str = "", start: int = 0
) -> Iterator[tuple[str, FieldLayout, int, str]]:
    """The name, field, offset in bytes and access of each value in a record, and in the records in it.

    `access` is that of the container of the record.
    """
    for part in record.fields:
        allowed = narrowed(access, part.field.access)
        count = part.count or 1
        for number in range(count):
            name = f"{before}{part.name}" + (f"_{number}" if count > 1 else "")
            byte = start + part.offset + number * part.size
            if part.record is None:
                yield name, part, byte, allowed
            else:
                yield from _flat(part.record, allowed, f"{name}.", byte)


def _parameter(parameter_set: ParameterSet, parameter: Parameter) -> Iterator[Item]:
    for number in range(parameter.number, parameter.number + parameter.count):
        yield Item(
            space=parameter_set.space,
            address=parameter_set.base + number,
            name=f"{parameter.name}_{number}" if parameter.count > 1 else parameter.name,
            words=None,
            access=parameter.access,
            count=parameter.elements or 1,
            **_stated(parameter, parameter.value),
        )
        yield from _elements(parameter_set, parameter, number)


def _elements(parameter_set: ParameterSet, parameter: Parameter, number: int) -> Iterator[Item]:
    """The elements of a parameter that have meanings of their own."""
    for part in parameter.subindices:
        if part.reserved:
            continue
        yield Item(
            space=parameter_set.space,
            address=parameter_set.base + number,
            name=f"{parameter.name}.{part.name}",
            words=None,
            access=parameter.element_access(part.indices.low),
            subindices=(part.indices.low, part.indices.high),
            **_stated(part, part.value),
        )


def _stated(fact: Field | Register | Parameter | Subindex, value: Value | None) -> dict[str, Any]:
    """The attributes of an item that a fact states: its value, its names, and where the manual has it."""
    return {
        "type": type_text(value) if value else "bytes",
        "value": value,
        "printed_name": fact.printed_name,
        "label": fact.label,
        "source": _first(fact.sources),
        "unverified": fact.unverified,
    }


def _first(sources: tuple[Citation, ...]) -> Citation | None:
    return sources[0] if sources else None


def exact_number(number: Decimal | str) -> int | Decimal | str:
    """An exact number, as an int if it is whole; a fraction as it is written."""
    if isinstance(number, str):
        return number
    return int(number) if number == number.to_integral_value() else number
