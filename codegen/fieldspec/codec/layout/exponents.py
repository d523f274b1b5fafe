"""The exponents of scales that are read from the device: each is a field of the same record, or a register."""

from __future__ import annotations

from collections.abc import Iterable

from fieldspec.codec.layout.record import FieldLayout, RecordLayout, RegisterLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.value import Value


@dataclass(frozen=True, slots=True)
class ExponentLayout:
    """The field of the same record, else the register, that has the exponent of a scale."""

    name: str
    value: Value
    field: FieldLayout | None = None
    register: RegisterLayout | None = None


def exponent_of(
    value: Value, registers: Iterable[RegisterLayout], record: RecordLayout | None = None
) -> ExponentLayout | None:
    """The exponent of the scale of a register, or of a field of a record; None for a value with no such scale."""
    if not value.scale_by:
        return None
    field = record.named(value.scale_by) if record is not None else None
    if field is not None and field.value is not None:
        return ExponentLayout(field.name, field.value, field=field)
    register = next(row for row in registers if row.name == value.scale_by)
    return ExponentLayout(register.name, register.register.value, register=register)
