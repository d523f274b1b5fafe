"""The facts of what is addressed: registers, tables of records, and numbered parameters."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.facts.row import Row, of_fact, of_value, row
from fieldspec.facts.wire import fields
from fieldspec.layout.device import DeviceLayout, TableLayout
from fieldspec.model.device import Device
from fieldspec.model.register import Register, RegisterGroup


def memory(layout: DeviceLayout) -> Iterator[Row]:
    """The rows of groups of registers, of tables and of sets of parameters."""
    for group in layout.device.groups:
        yield from _group(group)
    yield from _tables(layout)
    yield from _parameters(layout.device)


def _group(group: RegisterGroup) -> Iterator[Row]:
    yield from of_fact("register_group", group)
    for number, gap in enumerate(group.gaps):
        low, high = gap.addresses.low, gap.addresses.high
        path = f"{group.place.path}/gaps/{number}"
        yield row("gap", path, group.sources, name=group.name, address=low, words=high - low + 1)
    for register in group.registers:
        if register.count == 1:
            cells: Row = {"address": register.address, "words": register.width, "access": register.access}
            yield from of_fact("register", register, register.value, **cells)
        else:
            yield from _series(register)


def _series(register: Register) -> Iterator[Row]:
    """A row for several equal registers, and one for each, with its own line where the spec has it."""
    words = register.end - register.address
    yield from of_fact("register_series", register, register.value, address=register.address, words=words)
    for number in range(register.count):
        index = register.index_from + number
        sources = register.element_sources[number : number + 1] or register.sources
        printed = register.element_name.format(n=index) if register.element_name else register.printed_name
        cells: Row = {
            **of_value(register.value),
            "name": f"{register.name}_{index}",
            "printed_name": printed,
            "label": register.label,
            "address": register.address + number * register.stride,
            "words": register.width,
            "access": register.access,
        }
        yield row("register", f"{register.place.path}/{index}", sources, **cells)


def _tables(layout: DeviceLayout) -> Iterator[Row]:
    done: set[str] = set()
    for laid in layout.tables.values():
        table = laid.table
        yield from of_fact("table", table, address=table.base, words=laid.words, access=table.access)
        yield from _elements(laid)
        if laid.record.name not in done:
            done.add(laid.record.name)
            yield from of_fact("record", laid.record.record, words=laid.words, bytes=laid.record.size)
            yield from fields("table_field", laid.record, base=table.base)


def _elements(laid: TableLayout) -> Iterator[Row]:
    """The elements of which the manual prints the addresses."""
    for element in laid.table.elements:
        name = f"{laid.name}_{element.index}"
        cells: Row = {"name": name, "address": laid.table.address(element.index), "words": laid.words}
        yield row("table_element", element.place.path, element.sources, **cells)


def _parameters(device: Device) -> Iterator[Row]:
    for words in device.parameters.values():
        yield from of_fact("parameter_set", words)
        for parameter in words.parameters:
            cells: Row = {"code": parameter.number, "access": parameter.access}
            yield from of_fact("parameter", parameter, parameter.value, **cells)
