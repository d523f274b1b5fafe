"""Raw values in the type of a field, and the type that a selector chooses."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, MutableMapping

from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.codec.layout.value_texts import spec_text
from fieldspec.foundation.classes import TYPE_CHECKING
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import Digits, Octets, Real, Text, Truth, Whole, is_array, is_signed
from fieldspec.language.model.value import Value
from fieldspec.tools.simulator.memory import default_raw
from fieldspec.tools.simulator.refusal import Refusal

if TYPE_CHECKING:
    from typing import Any


NOTHING: Mapping[str, Any] = {}
"""The values where no field is before another one."""


def chosen_kind(record: RecordLayout, values: Mapping[str, Any]) -> str | None:
    """The type that the selector of a record chooses; None where it has no selector."""
    if record.selector is None:
        return None
    number = values.get(record.selector.name)
    for field in record.fields:
        for case in field.cases:
            if number in case.numbers:
                return case.value.type.name
    return ""


def number_of_kind(record: RecordLayout, kind: str) -> int | None:
    """The number of the selector that chooses a type."""
    for field in record.fields:
        for case in field.cases:
            if case.value.type.name == kind or (kind.startswith("bool") and case.value.type.name.startswith("bool")):
                return min(case.numbers)
    return None


def initial_value(device: Device, field: FieldLayout, values: Mapping[str, Any] = NOTHING) -> Any:
    """The value of a field of a response where nothing else states it; `values` has the fields before it.

    A list of any length has the least number of records that it can have, and of values the same, but one at least.
    """
    if field.presence is not None and field.presence.numbers and not field.least_count(values):
        return []
    minimum = field.least_count(values)
    if field.record is not None:
        if not field.is_list:
            return initial_values(device, field.record)
        return [initial_values(device, field.record) for _ in range(minimum)]
    raw = in_type(default_raw(device, field.value), field) if field.value is not None else 0
    return [raw] * max(minimum, 1) if field.is_list else raw


def initial_values(device: Device, record: RecordLayout) -> dict[str, Any]:
    """The values of a record within a response where nothing else states them."""
    values: dict[str, Any] = {}
    for field in decided_fields(record, values):
        if field.field.measures is None:
            values[field.name] = initial_value(device, field, values)
    return record.with_list_bits(values)


def decided_fields(record: RecordLayout, values: MutableMapping[str, Any]) -> Iterator[FieldLayout]:
    """The fields of a record. Each has its values in `values` before the iterator gives the next field.

    A field with cases has the type that the value of the selector decides. Where other fields may follow it, a
    selector that decides nothing is set to a number that decides a type.
    """
    for index, field in enumerate(record.fields):
        if field.selector is not None:
            values[field.selector.name] = field.deciding(values)
        yield record.decided_by(values).fields[index] if field.cases else field


def permits(value: Value | None, raw: Any) -> bool:
    """Whether no printed range excludes the number."""
    return value is None or value.ranges is None or raw in value.ranges


def signed(raw: Any, size: int, is_signed: bool) -> Any:
    """A number of a field, read as the type of a parameter has it."""
    if not isinstance(raw, int) or isinstance(raw, bool):
        return raw
    whole = raw & ((1 << 8 * size) - 1)
    return whole - (1 << 8 * size) if is_signed and whole >> (8 * size - 1) else whole


def in_parameter(raw: Any, field: FieldLayout, value: Value) -> Any:
    """A number that a field carries, as the type of a parameter has it. Raises Refusal for one that the type lacks.

    A field without a sign that is wider than the type may carry the bits of a negative number with zeros before them.
    """
    number = signed(raw, value.size, is_signed(value.encoding))
    if number == raw or field.size <= value.size:
        return number
    is_bits = isinstance(raw, int) and field.value is not None and not is_signed(field.value.encoding)
    if is_bits and raw in (number & (1 << 8 * value.size) - 1, number & (1 << 8 * field.size) - 1):
        return number
    raise Refusal("value_invalid", f"{value.type.name} does not have {spec_text(raw)}")


def in_type(raw: Any, field: FieldLayout) -> Any:
    """A raw value as the type of a field has it."""
    value = field.value
    if value is None or not isinstance(raw, int | float):
        return raw
    encoding = value.encoding
    match encoding:
        case Real() | Text() | Octets():
            return raw
        case Truth():
            return bool(raw)
        case Whole() | Digits():
            if raw < 0 and not is_signed(encoding):
                raw = signed(round(raw), value.size, False)
            return min(max(round(raw), value.low), value.high)
        case _:
            assert_never(encoding)


def in_case(device: Device, raw: Any, field: FieldLayout) -> Any:
    """A raw value in the type of a field; what the field has at first where it is a value of another case."""
    is_text = field.value is not None and is_array(field.value.encoding)
    return in_type(raw, field) if isinstance(raw, str | bytes) == is_text else initial_value(device, field)
