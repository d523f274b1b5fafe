"""The facts of everything with an address: registers, record tables, and parameters."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from fieldspec.facts.row import FactRow, SharedRows, of_fact, of_flag, of_ranges, of_value, row
from fieldspec.facts.wire import fields
from fieldspec.layout.device import DeviceLayout, TableLayout
from fieldspec.model.address_space import BIT
from fieldspec.model.device import Device
from fieldspec.model.registers import Parameter, ParameterSet, Register, RegisterGroup


def memory(layout: DeviceLayout, shared: SharedRows) -> Iterator[FactRow]:
    """The rows of address spaces, groups of registers, tables and sets of parameters."""
    for space in layout.device.spaces.values():
        yield from of_fact("address_space", space, None, number=space.first_number, **of_ranges(space.bounds))
    for group in layout.device.groups:
        yield from _group(group, shared)
    yield from _tables(layout)
    yield from _parameters(layout.device, shared)


def _group(group: RegisterGroup, shared: SharedRows) -> Iterator[FactRow]:
    yield from of_fact("register_group", group)
    for number, gap in enumerate(group.gaps):
        low, high = gap.addresses.low, gap.addresses.high
        path = f"{group.place.path}/gaps/{number}"
        yield row("gap", path, group.sources, name=group.name, address=low, words=high - low + 1)
    for register in group.registers:
        yield from shared.rows(register, partial(_register, register))


def _register(register: Register) -> Iterator[FactRow]:
    if register.count > 1:
        return _series(register)
    return of_fact("register", register, register.value, **_cells(register))


def _has_words(register: Register) -> bool:
    return register.unit_size > 1 and register.value.type.name != BIT


def _cells(register: Register) -> FactRow:
    return {
        "address": register.address,
        "position": register.space,
        "words": register.width if _has_words(register) else None,
        "access": register.access,
        "number": register.number,
        "restart": of_flag(register.restart),
    }


def _series(register: Register) -> Iterator[FactRow]:
    """A row for several equal registers, and one for each of them, with its own source if the spec has it."""
    words = register.end - register.address if _has_words(register) else None
    whole: FactRow = {"address": register.address, "words": words, "count": register.count}
    whole |= {"position": register.space}
    yield from of_fact("register_series", register, register.value, **whole)
    for number in range(register.count):
        index = register.index_from + number
        sources = register.element_sources[number : number + 1] or register.sources
        printed = register.element_name.format(n=index) if register.element_name else register.printed_name
        cells: FactRow = {
            **of_value(register.value),
            **_cells(register),
            "name": f"{register.name}_{index}",
            "printed_name": printed,
            "label": register.label,
            "address": register.address + number * register.stride,
        }
        yield row("register", f"{register.place.path}/{index}", sources, **cells)


def _tables(layout: DeviceLayout) -> Iterator[FactRow]:
    done: set[str] = set()
    for table_layout in layout.tables.values():
        table = table_layout.table
        cells: FactRow = {
            "address": table.base,
            "words": table_layout.words,
            "access": table.access,
            "count": table.count,
        }
        cells |= {"position": table.space}
        yield from of_fact("table", table, None, **cells)
        yield from _elements(table_layout)
        if table_layout.record.name not in done:
            done.add(table_layout.record.name)
            yield from of_fact(
                "record", table_layout.record.record, words=table_layout.words, bytes=table_layout.record.size
            )
            yield from fields("table_field", table_layout.record, base=table.base, access=table.access)


def _elements(table_layout: TableLayout) -> Iterator[FactRow]:
    """The rows of the elements whose addresses the manual prints."""
    for element in table_layout.table.elements:
        name = f"{table_layout.name}_{element.index}"
        cells: FactRow = {
            "name": name,
            "address": table_layout.table.address(element.index),
            "words": table_layout.words,
        }
        yield row("table_element", element.place.path, element.sources, **cells)


def _parameters(device: Device, shared: SharedRows) -> Iterator[FactRow]:
    for parameter_set in device.parameters.values():
        yield from of_fact(
            "parameter_set", parameter_set, None, number=parameter_set.base, **of_ranges(parameter_set.numbers)
        )
        for parameter in parameter_set.parameters:
            yield from shared.rows(parameter, partial(_parameter, parameter_set, parameter), parameter_set.base)


def _parameter(parameter_set: ParameterSet, parameter: Parameter) -> Iterator[FactRow]:
    """The rows of a parameter, or of a run of equal ones, of its elements, and of what it applies to."""
    kind = "parameter" if parameter.count == 1 else "parameter_series"
    cells: FactRow = {
        "code": parameter.number,
        "number": parameter_set.base + parameter.number,
        "access": parameter.access,
    }
    cells.update(restart=of_flag(parameter.restart), count=parameter.elements)
    if parameter.count > 1:
        cells.update(count=parameter.count)
    yield from of_fact(kind, parameter, parameter.value, **cells)
    path, sources = parameter.place.path, parameter.sources
    for number in range(parameter.number, parameter.number + parameter.count) if parameter.count > 1 else ():
        name = f"{parameter.name}_{number}"
        own: FactRow = {
            **of_value(parameter.value),
            **cells,
            "code": number,
            "number": parameter_set.base + number,
            "name": name,
        }
        own.update(count=parameter.elements)
        yield row("parameter", f"{path}/{number}", sources, **own)
    for inner in parameter.subindices:
        element_count = sum(high - low + 1 for low, high in inner.indices.intervals)
        own = {
            "code": parameter.number,
            "number": inner.indices.low,
            "count": element_count if element_count > 1 else None,
        }
        own |= {"access": inner.access} if inner.access else {}
        yield from of_fact("subindex", inner, inner.value, **own)
    for kind, key, names in (
        ("applies_to", "applies_to", parameter.applies_to),
        ("effective_with", "messages", parameter.messages),
    ):
        for name in names:
            yield row(kind, f"{path}/{key}/{name}", sources, code=parameter.number, name=name)
