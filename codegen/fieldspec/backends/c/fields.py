"""Fields of records as members of structs."""

from __future__ import annotations

from fieldspec.backends.c.naming import member
from fieldspec.backends.c.values import Wire
from fieldspec.layout.record import FieldLayout, RecordLayout


def wire(field: FieldLayout) -> Wire:
    """The value of a field that holds one."""
    assert field.value is not None
    return Wire(field.value, field.order, field.swapped)


def given(field: FieldLayout) -> bool:
    """Whether users give the field: it is no constant, measures nothing, and has a meaning."""
    constant = field.value is not None and field.value.const is not None
    return not (constant or field.field.measures or field.field.reserved)


def members(record: RecordLayout) -> list[FieldLayout]:
    """The fields that are members of the struct."""
    return [field for field in record.fields if given(field)]


def most(field: FieldLayout) -> int:
    """How many elements a list can have."""
    repeat = field.field.repeat
    return repeat.high if repeat is not None else field.count or 1


def count_member(record: RecordLayout, field: FieldLayout) -> str:
    """The member that holds how many elements a list has; a field that is called so keeps the name for itself."""
    name = f"{field.name}_count"
    return f"{name}_" if name in {member(other.name) for other in members(record)} else name
