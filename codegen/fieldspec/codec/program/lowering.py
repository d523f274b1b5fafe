"""The programs of values, of fields, and of the records in these."""

from __future__ import annotations

from fieldspec.codec.layout.accepted import accepted
from fieldspec.codec.layout.list_places import inner_lists_of
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.codec.program.operations import (
    Decided,
    Each,
    Inner,
    Load,
    LoadPacked,
    LoadVarying,
    Operation,
    Places,
    Program,
    Remark,
    Require,
    Variable,
)
from fieldspec.foundation import classes
from fieldspec.foundation.caches import ByIdentity
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import Digits, Octets, Real, Text, Truth, Whole
from fieldspec.language.model.raw_numbers import byte_places
from fieldspec.language.model.text_form import UTF_16
from fieldspec.language.model.value import Value

_MOST_PROGRAMS = 4096
_MOST_DEVICES = 4


@dataclass(frozen=True, slots=True)
class _Programs:
    """The programs of one device. Versions of a device share values, but not what the names of these stand for."""

    by_value: ByIdentity[Value, dict[tuple[str, bool, bool], Program]] = classes.field(
        default_factory=lambda: ByIdentity(_MOST_PROGRAMS)
    )
    by_field: ByIdentity[FieldLayout, Each] = classes.field(default_factory=lambda: ByIdentity(_MOST_PROGRAMS))


_PROGRAMS: ByIdentity[Device, _Programs] = ByIdentity(_MOST_DEVICES)


def value_program(device: Device, value: Value, order: str, swapped: bool, is_reserved: bool) -> Program:
    """The program of a value that is not a field."""
    programs = _PROGRAMS.get_or_compute(device, lambda _: _Programs()).by_value.get_or_compute(value, lambda _: {})
    program = programs.get((order, swapped, is_reserved))
    if program is None:
        variable = Variable("", None, value, is_reserved)
        program = programs[order, swapped, is_reserved] = _judged(device, variable, _load(variable, order, swapped))
    return program


def field_program(device: Device, record: RecordLayout, field: FieldLayout) -> Each:
    """The program of a field of a record. The type of the field is known."""
    programs = _PROGRAMS.get_or_compute(device, lambda _: _Programs())
    return programs.by_field.get_or_compute(field, lambda own: _each(device, record, own))


def _each(device: Device, record: RecordLayout, field: FieldLayout) -> Each:
    element = _element(device, record, field)
    return Each(field.name, field.size, field.count, field.is_list, element, field.packing)


def _element(device: Device, record: RecordLayout, field: FieldLayout) -> Program:
    inner = field.record
    if inner is not None:
        lists = inner_lists_of(inner, is_element=True) if inner.size is None else None
        return (Inner(field.name, tuple(_part(device, inner, own) for own in inner.sent_fields), lists),)
    assert field.value is not None
    # What varies in width moves what is after it.
    exponent = field.value.scale_by if not record.spans and record.named(field.value.scale_by) is not None else ""
    variable = Variable(field.name, field, field.value, field.field.reserved, exponent)
    if field.packing is not None:
        return _judged(device, variable, LoadPacked(variable, field.packing))
    varies = bool(field.value.width)
    return _judged(device, variable, LoadVarying(variable) if varies else _load(variable, field.order, field.swapped))


def _part(device: Device, record: RecordLayout, field: FieldLayout) -> Each | Decided:
    """The program of a field of a record within another, whose type another field may decide."""
    if field.selector is None:
        return field_program(device, record, field)
    forms = {number: field_program(device, record, form) for number, form in field.forms.items()}
    return Decided(field.name, field.selector.name, forms, field.deciding_bits)


def _load(variable: Variable, order: str, swapped: bool) -> Load:
    return Load(variable, places_of(variable.value, order, swapped))


def places_of(value: Value, order: str, swapped: bool) -> Places:
    """Where the bytes of a value are; `swapped` words of 16 bits are in the other order than the bytes of each."""
    encoding = value.encoding
    match encoding:
        case Text():
            is_turned = encoding.form is not None and encoding.form.encoding == UTF_16 and order != "big"
            return byte_places(value.size, "little", True) if is_turned else tuple(range(value.size))
        case Octets():
            return tuple(range(value.size))
        case Whole() | Real() | Truth() | Digits():
            return byte_places(value.size, order, swapped)
        case _:
            assert_never(encoding)


def _judged(device: Device, variable: Variable, load: Operation) -> Program:
    """The program that loads and judges a variable."""
    if variable.is_reserved:
        return (load,)
    conditions = accepted(device, variable.value)
    return (load, *map(Require, conditions.reading), *map(Remark, conditions.remarked))
