"""Registers, the fields of tables, and parameters as data of the dissector."""

from __future__ import annotations

from fieldspec.codec.layout.device import DeviceLayout, TableLayout
from fieldspec.codec.layout.nested_fields import NestedField, nested_fields
from fieldspec.codec.layout.record import RegisterLayout
from fieldspec.language.model.device import Device
from fieldspec.language.model.registers import Parameter, ParameterSet, Subindex
from fieldspec.targets.wireshark.filters import Filters, title_of
from fieldspec.targets.wireshark.text import Data, line_text
from fieldspec.targets.wireshark.values import errata_data, intervals, value_data


def register_data(filters: Filters, device: Device, layout: RegisterLayout) -> dict[str, Data]:
    """A register with all of its elements."""
    register, value = layout.register, layout.register.value
    names = (layout.name, f"register.{layout.name}")
    data = value_data(value, layout.order, layout.swapped, filters.digits.get(register.place.path))
    return {
        "name": layout.name,
        "title": title_of(register),
        "filter": filters.of_value(names, register, value),
        "quantity": filters.of_quantity(names, register, value),
        "bits": filters.of_bits(names, value),
        "value": data,
        "show": filters.functions.number(data, False),
        "space": device.space_name(register.space),
        "address": layout.address,
        "words": layout.words,
        "count": layout.count,
        "stride": layout.stride,
        "index_from": register.index_from if layout.count > 1 else None,
        "access": register.access or None,
        "turns_writes": bool(value.write_word_order) or None,
        "trigger": register.trigger,
        "errata": errata_data(device, register),
    }


def table_data(filters: Filters, device: Device, layout: TableLayout) -> list[Data]:
    """The fields of a table of records in registers, each element of a list by itself."""
    rows: list[Data] = []
    entries: dict[str, dict[str, Data]] = {}
    for nested in nested_fields(layout.record):
        entry = entries.get(nested.name)
        if entry is None:
            entry = entries[nested.name] = _table_field(filters, device, layout, nested)
        element = nested.path.removeprefix(f"{nested.before}{nested.field.name}")
        holder = f"{nested.before[:-1]} of {layout.name}" if nested.before else layout.name
        rows.append(
            {
                "name": f"{layout.name}.{nested.path}",
                "title": f"{title_of(nested.field.field)}{element} of {holder}",
                **entry,
                "address": layout.table.base + nested.offset // 2,
                "words": nested.words,
                "skip": nested.offset % 2 or None,
            }
        )
    return rows


def _table_field(filters: Filters, device: Device, layout: TableLayout, nested: NestedField) -> dict[str, Data]:
    """The data that all elements of a field of a table share."""
    table, field = layout.table, nested.field
    names = (f"{layout.name}.{nested.name}", f"table.{layout.name}.{nested.name}")
    assert field.value is not None
    data = value_data(field.value, field.order, field.swapped, filters.digits.get(field.field.place.path))
    return {
        "filter": filters.of_value(names, field.field, field.value),
        "quantity": filters.of_quantity(names, field.field, field.value),
        "bits": filters.of_bits(names, field.value),
        "value": data,
        "show": filters.functions.number(data, field.field.reserved),
        "space": device.space_name(table.space),
        "count": table.count,
        "stride": table.stride,
        "index_from": table.index_from,
        "access": nested.access(table.access) or None,
        "reserved": field.field.reserved,
        "errata": errata_data(device, field.field),
    }


def parameter_sets(filters: Filters, layout: DeviceLayout) -> dict[str, Data]:
    """The sets of parameters by the names that values refer to: that of a set, or of a space with several sets."""
    device = layout.device
    rows = {name: set_data(filters, device, words) for name, words in device.parameters.items()}
    names = dict.fromkeys([*device.parameters, *(words.space for words in device.parameters.values())])
    return {name: [rows[words.name] for words in device.sets(name)] for name in names if name}


def set_data(filters: Filters, device: Device, words: ParameterSet) -> dict[str, Data]:
    """The data of one set of parameters for the dissector."""
    return {"base": words.base, "rows": [_parameter(filters, device, words, row) for row in words.parameters]}


def _parameter(filters: Filters, device: Device, words: ParameterSet, parameter: Parameter) -> dict[str, Data]:
    has_elements = parameter.elements is not None or bool(parameter.subindices)
    return {
        **_entry(filters, device, f"{words.name}.{parameter.name}", words, parameter, parameter),
        "number": parameter.number,
        "count": parameter.count,
        "several": has_elements,
        "trigger": parameter.trigger,
        "subindices": [
            {
                **_entry(filters, device, f"{words.name}.{parameter.name}.{inner.name}", words, parameter, inner),
                "indices": intervals(inner.indices),
            }
            for inner in parameter.subindices
        ],
    }


def _entry(
    filters: Filters, device: Device, name: str, words: ParameterSet, parameter: Parameter, fact: Parameter | Subindex
) -> dict[str, Data]:
    names, value = (name.rstrip("."), f"parameter.{name}".rstrip(".")), fact.value
    number = line_text(words.number_text(parameter.number))
    inner = f", {title_of(fact)}" if fact is not parameter and fact.name else ""
    title = title_of(parameter) if parameter.name else "Parameter"
    data = value_data(value, "big", False)
    return {
        "name": names[0],
        "title": f"{number} {title}{inner}",
        "filter": filters.of_value(names, fact, value),
        "quantity": filters.of_quantity(names, fact, value),
        "bits": filters.of_bits(names, value),
        "value": data,
        "show": filters.functions.number(data, fact.reserved),
        "reserved": fact.reserved,
        "errata": errata_data(device, parameter),
    }
