"""Registers, tables, gaps and parameters as data of the explainer."""

from __future__ import annotations

from fieldspec.codec.explain.errata import citations
from fieldspec.codec.layout.device import DeviceLayout, TableLayout
from fieldspec.codec.layout.nested_fields import NestedField, nested_fields
from fieldspec.codec.layout.record import RegisterLayout
from fieldspec.language.model.device import Device
from fieldspec.language.model.registers import Parameter, ParameterSet, Table
from fieldspec.targets.explainer.literals import Data
from fieldspec.targets.explainer.values import fact_data, intervals, stated, value_data


def register_data(device: Device, layout: RegisterLayout) -> dict[str, Data]:
    """A register with all of its elements."""
    register = layout.register
    return {
        **fact_data(register),
        "name": layout.name,
        "address": layout.address,
        "words": layout.words,
        "count": layout.count,
        "stride": layout.stride,
        "first": register.index_from,
        "value": value_data(register.value, layout.order, layout.swapped),
        **stated(
            {
                "space": device.space_name(register.space),
                "access": register.access,
                "atomic": register.atomic,
                "trigger": register.trigger,
                "elementSources": [citations([source]) for source in register.element_sources],
            }
        ),
    }


def table_data(device: Device, layout: TableLayout) -> dict[str, Data]:
    """A table of records in registers as data of the explainer."""
    table = layout.table
    return {
        **fact_data(table),
        "base": table.base,
        "stride": table.stride,
        "count": table.count,
        "first": table.index_from,
        "words": layout.words,
        "fields": [_table_field(table, nested) for nested in nested_fields(layout.record)],
        **stated({"space": device.space_name(table.space), "countBy": table.count_by, "baseBy": table.base_by}),
    }


def _table_field(table: Table, nested: NestedField) -> dict[str, Data]:
    """A field of the record in a table; `exponent` is that of the same record with the exponent of its scale."""
    own = nested.field
    exponent = nested.beside(own.value.scale_by) if own.value is not None else None
    return {
        "path": nested.path,
        "record": nested.record.name,
        "field": own.name,
        "offset": nested.offset,
        "words": nested.words,
        **stated(
            {
                "access": nested.access(table.access),
                "atomic": own.field.atomic,
                "exponent": [exponent.offset, exponent.field.name] if exponent is not None else None,
            }
        ),
    }


def gaps_data(layout: DeviceLayout) -> list[Data]:
    """The addresses that the manual leaves out, with the reasons."""
    device = layout.device
    return [
        {"space": device.space_name(group.space), "addresses": intervals(gap.addresses), "reason": gap.reason}
        for group in device.groups
        for gap in group.gaps
    ]


def set_data(words: ParameterSet) -> dict[str, Data]:
    """A set of parameters as data of the explainer."""
    return {
        **fact_data(words),
        "base": words.base,
        **stated(
            {"space": words.space, "numbers": intervals(words.numbers), "printedAs": words.printed_as.partition("{")[0]}
        ),
        **({"digits": _digits(words.printed_as)} if words.printed_as else {}),
        "parameters": [_parameter(parameter) for parameter in words.parameters],
    }


def _digits(form: str) -> list[Data]:
    """How a number is printed: the digits at least, their base, and the text after them."""
    inner, _, suffix = form.partition("{")[2].partition("}")
    code = inner.partition(":")[2]
    upper, base = code[-1:] == "X", 16 if code[-1:] in ("x", "X") else 10
    return [int(code.rstrip("xXd") or "0"), base, upper, suffix]


def _parameter(parameter: Parameter) -> dict[str, Data]:
    return {
        **fact_data(parameter),
        "number": parameter.number,
        "value": value_data(parameter.value),
        **stated({"byteOrder": parameter.value.byte_order}),
        **stated(
            {
                "count": parameter.count if parameter.count != 1 else None,
                "elements": parameter.elements,
                "trigger": parameter.trigger,
                "reserved": parameter.reserved,
                "subindices": [
                    {
                        **fact_data(subindex),
                        "indices": intervals(subindex.indices),
                        "value": value_data(subindex.value),
                        **stated({"byteOrder": subindex.value.byte_order, "reserved": subindex.reserved}),
                    }
                    for subindex in parameter.subindices
                ],
            }
        ),
    }
