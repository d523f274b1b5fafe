"""The columns that a query must have, from the values of the reference and the model."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from decimal import Context, Decimal, Inexact
from fractions import Fraction
from typing import Any

from fieldspec.codec.layout.accepted import stated_numbers
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.codec.reference.bits import number_of_bits
from fieldspec.codec.reference.quantities import quantity, scale_of, special_name, state_name
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_count, is_octets, is_real, is_text
from fieldspec.language.model.value import Value
from fieldspec.targets.fact_texts import unit_word

Columns = dict[str, Any]
Exponent = tuple[Value, Any]
"""The value with the exponent of a scale, and its number."""


def record_columns(
    device: Device, record: RecordLayout, values: Mapping[str, Any], registers: Mapping[str, Exponent] | None = None
) -> Columns:
    """The columns of a record. What another choice would have is null and left out.

    `registers` has the registers with exponents that a payload has, too.
    """
    chosen = record
    suffix = ""
    if record.selector is not None:
        chosen = record.of_number(values[record.selector.name]) or record
        number = values[record.selector.name]
        suffix = "_" + next(case.name for case in record.fields[-1].cases if number in first_of(record, case.numbers))
    columns: Columns = {}
    for place, field in enumerate(chosen.fields):
        is_choice = record.selector is not None and place == len(chosen.fields) - 1
        name = field.name + (suffix if is_choice else "")
        power = exponent_of(chosen, field, values, registers)
        for key, value in field_columns(device, name, field, values[field.name], power):
            while key in columns:
                key += "_"
            columns[key] = value
    return columns


def first_of(record: RecordLayout, numbers: frozenset[int]) -> frozenset[int]:
    """The numbers that choose the same layout as the first of some numbers."""
    shape = record.chosen[min(numbers)]
    return frozenset(number for number, other in record.chosen.items() if other is shape)


def exponent_of(
    record: RecordLayout,
    field: FieldLayout,
    values: Mapping[str, Any],
    registers: Mapping[str, Exponent] | None = None,
) -> Exponent | None:
    """The exponent of a field in another field of its record, or in a register; None without one, and for a list."""
    if field.value is not None and field.value.scale_by in (registers or {}) and not field.is_list:
        return (registers or {})[field.value.scale_by]
    beside = record.named(field.value.scale_by) if field.value is not None and field.value.scale_by else None
    if beside is None or beside.value is None or field.is_list:
        return None
    return beside.value, values[beside.name]


def field_columns(
    device: Device, name: str, field: FieldLayout, value: Any, power: Exponent | None = None
) -> Iterator[tuple[str, Any]]:
    """The columns of a field, and its quantity where `power` has the exponent of its scale."""
    if field.field.reserved:
        return
    if field.record is not None:
        yield from _inner_columns(device, name, field, value)
    elif not field.is_list:
        yield from value_columns(device, name, field.value, value, power)
    else:
        rows = [dict(value_columns(device, name, field.value, item)) for item in value]
        for key in dict(value_columns(device, name, field.value, _any_of(field.value))):
            yield key, [row[key] for row in rows]


def _inner_columns(device: Device, name: str, field: FieldLayout, value: Any) -> Iterator[tuple[str, Any]]:
    assert field.record is not None
    if not field.is_list:
        for inner in field.record.fields:
            power = exponent_of(field.record, inner, value)
            yield from field_columns(device, f"{name}_{inner.name}", inner, value[inner.name], power)
    elif field.count is not None:
        for place, item in enumerate(value):
            for inner in field.record.fields:
                power = exponent_of(field.record, inner, item)
                yield from field_columns(device, f"{name}_{place}_{inner.name}", inner, item[inner.name], power)
    else:
        yield from _repeated_columns(device, name, field.record, value)


def _repeated_columns(device: Device, name: str, record: RecordLayout, items: list[Any]) -> Iterator[tuple[str, Any]]:
    rows = [dict(_flat(device, name, record, item)) for item in items]
    for key in dict.fromkeys(key for row in rows for key in row):
        yield key, [row[key] for row in rows]


def _flat(device: Device, name: str, record: RecordLayout, item: Mapping[str, Any]) -> Iterator[tuple[str, Any]]:
    for inner in record.fields:
        own = f"{name}_{inner.name}"
        if inner.field.reserved:
            continue
        if inner.is_list and inner.record is None:
            for place, element in enumerate(item[inner.name]):
                yield from value_columns(device, f"{own}_{place}", inner.value, element)
        elif inner.record is not None:
            elements = item[inner.name] if inner.is_list else [item[inner.name]]
            for place, element in enumerate(elements):
                yield from _flat(device, f"{own}_{place}" if inner.is_list else own, inner.record, element)
        else:
            yield from value_columns(device, own, inner.value, item[inner.name], exponent_of(record, inner, item))


def _any_of(value: Value | None) -> Any:
    assert value is not None
    encoding = value.encoding
    return "" if is_text(encoding) else b"" if is_octets(encoding) else 0.0 if is_real(encoding) else 0


def value_columns(
    device: Device, name: str, value: Value | None, raw: Any, power: Exponent | None = None, trigger: bool = False
) -> Iterator[tuple[str, Any]]:
    """The columns of a value by its raw value. Nothing is stated of what is read of a `trigger`."""
    assert value is not None
    encoding = value.encoding
    is_number = is_count(encoding) or is_real(encoding)
    sentinel = special_name(value, raw) if is_number else ""
    if value.enum:
        member = device.enums[value.enum].member(int(raw))
        yield name, None if member is None else member.name
        yield f"{name}_raw", int(raw)
    elif value.flags:
        word = raw % (1 << 8 * value.size)
        yield name, word
        yield from _bit_columns(device, name, value, word)
    elif power is not None:
        exponent, number = power
        is_known = not sentinel and exponent.ranges is not None and number in exponent.ranges
        yield f"{name}_{unit_word(value.quantity_unit)}", _share(value.scaled_by(number), raw) if is_known else None
        yield f"{name}_raw", raw
    elif is_count(encoding) and value.scaled:
        exact = quantity(value, raw) if isinstance(value.scale, Decimal) else None
        exact_value = exact_decimal(exact) if exact is not None else _share(value, raw)
        yield f"{name}_{unit_word(value.unit)}", None if sentinel else exact_value
        yield f"{name}_raw", raw
    elif value.sentinels:
        yield name, None if sentinel else raw
        yield f"{name}_raw", raw
    else:
        yield name, raw
    if stated_numbers(device, value, trigger) is not None:
        yield f"{name}_state", state_name(device, value, raw) or None
    elif value.sentinels:
        yield f"{name}_state", sentinel or None


def _share(value: Value, raw: int) -> float:
    return float(Fraction(raw) * scale_of(value) + Fraction(value.offset))


def exact_decimal(number: Fraction | None) -> Decimal | None:
    """A fraction that is a decimal number as one."""
    if number is None:
        return None
    exact = Context(prec=200, traps=[Inexact])
    return exact.divide(Decimal(number.numerator), Decimal(number.denominator))


def _bit_columns(device: Device, name: str, value: Value, word: int) -> Iterator[tuple[str, Any]]:
    for bit in device.flags[value.flags].bits:
        if bit.reserved:
            continue
        own, number = f"{name}_{bit.name}", number_of_bits(device.flags[value.flags], bit, word)
        if bit.enum:
            member = device.enums[bit.enum].member(number)
            yield own, None if member is None else member.name
            yield f"{own}_raw", number
        elif bit.scale != 1 or bit.offset != 0:
            exact = isinstance(bit.scale, Decimal)
            yield (
                f"{own}_{unit_word(bit.unit)}",
                exact_decimal(quantity(bit.as_value, number)) if exact else _share(bit.as_value, number),
            )
            yield f"{own}_raw", number
        else:
            yield own, number if bit.width > 1 or bit.is_number else bool(number)


def is_equal(expected: Any, actual: Any) -> bool:
    """Whether a column has the value: exact numbers are equal, floating-point ones nearly."""
    if isinstance(expected, list) or isinstance(actual, list):
        if not isinstance(expected, list) or not isinstance(actual, list) or len(expected) != len(actual):
            return False
        return all(map(is_equal, expected, actual))
    if expected is None or actual is None:
        return expected is actual
    if isinstance(expected, bool) or isinstance(actual, bool):
        return expected is actual
    if isinstance(actual, float):
        number = float(expected)
        return (math.isnan(number) and math.isnan(actual)) or number == actual or math.isclose(number, actual)
    return type(expected) is not float and expected == actual
