"""Devices whose numbers a dialect has no types for: wide whole ones become two of half the width, others are refused.

A sentinel that is not a number is refused too: functions cannot tell it from a disturbance.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.device import DeviceLayout, TableLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.record import FieldLayout, RecordLayout, RegisterLayout
from fieldspec.codec.layout.refusal import Refusal
from fieldspec.foundation.classes import replace
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.diagnostics import LEAVE_OUT, Diagnostic
from fieldspec.language.model.encoding import (
    Digits,
    Encoding,
    Octets,
    OfSign,
    Real,
    Text,
    Truth,
    Whole,
    has_magnitude,
    is_array,
    is_odd,
    is_real,
    number_of,
)
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.primitives import PRIMITIVES, Primitive
from fieldspec.language.model.record import Measure
from fieldspec.language.model.registers import Register
from fieldspec.language.model.value import Value
from fieldspec.targets.controllers.dialects import Dialect
from fieldspec.targets.controllers.routines.world import every_record
from fieldspec.targets.controllers.statements.numbers import is_single, whole_type


def _upper_half(encoding: Encoding) -> Primitive | None:
    """The type of the upper half of a whole number of 64 bits, whose lower half is a `u32`; None where it has none.

    A sign and a magnitude have none: the sign of a small number would be lost in an upper half that is 0.
    """
    match encoding:
        case Whole():
            return _half_of_sign(encoding.sign) if encoding.bits == 64 else None
        case Real() | Truth() | Digits() | Text() | Octets():
            return None
        case _:
            assert_never(encoding)


_half_of_sign: OfSign[Primitive | None] = OfSign(none=PRIMITIVES["u32"], complement=PRIMITIVES["i32"], magnitude=None)


def number_refusals(layout: DeviceLayout, dialect: Dialect) -> list[Refusal]:
    """A refusal of each fact with numbers, or a list of texts, that the dialect can neither have nor split."""
    refusals = [] if dialect.nested_arrays else [_nested(field, dialect) for field in _lists_of_texts(layout)]
    refusals += [_unknown(fact, kind, dialect) for fact, kind in _unknown_numbers(layout, dialect)]
    if dialect.widest < 8:
        refusals += [
            _refused(field, dialect)
            for record in every_record(layout)
            for field in record.fields
            if (_wide(field.value) and not _is_split(field)) or any(_wide(case.value) for case in field.cases)
        ]
    return refusals


def narrowed(layout: DeviceLayout, dialect: Dialect) -> DeviceLayout:
    """The layout with whole numbers that the dialect has, of one without those that cannot be split.

    A number `turns` becomes `turns_high` and `turns_low`, in the order of the wire: turns = high * 2^32 + low. The
    halves are plain counts, because a scale or a range is one of the whole.
    """
    if dialect.widest >= 8:
        return layout
    split_records: dict[int, RecordLayout] = {}
    records = {record.name: _record(record, split_records) for record in layout.records.values()}
    messages = {
        message.name: MessageLayout(
            message.message,
            message.name,
            _record(message.request, split_records),
            _record(message.response, split_records),
        )
        for message in layout.messages.values()
    }
    registers = [(register, tuple(_registers(register))) for register in layout.registers]
    halves = {id(register.register): [half.register for half in registers] for register, registers in registers}
    groups = tuple(
        replace(
            group,
            registers=tuple(half for register in group.registers for half in halves.get(id(register), [register])),
        )
        for group in layout.device.groups
    )
    links = {
        link.name: replace(
            link,
            messages={name: messages[name] for name in link.messages},
            known={name: messages.get(name, message) for name, message in link.known.items()},
        )
        for link in layout.links.values()
    }
    tables = {
        table.name: TableLayout(table.table, table.name, records[table.record.name], table.words)
        for table in layout.tables.values()
    }
    return replace(
        layout,
        device=replace(layout.device, groups=groups),
        records=records,
        messages=messages,
        links=links,
        registers=tuple(half for _, register_halves in registers for half in register_halves),
        tables=tables,
    )


def _lists_of_texts(layout: DeviceLayout) -> Iterator[FieldLayout]:
    for record in every_record(layout):
        for field in record.fields:
            if field.is_list and field.value is not None and is_array(field.value.encoding):
                yield field


def _unknown_numbers(layout: DeviceLayout, dialect: Dialect) -> Iterator[tuple[Fact, Primitive]]:
    """The facts with numbers that the functions of the dialect do not convert: 64-bit reals, and odd ones too wide.

    The numbers of parts and conversions are not split: the caller of a function passes them as a whole.
    """
    unknown_facts: set[int] = set()
    for fact, value in stated_values(layout):
        if _is_unknown(value.type.encoding, dialect) and id(fact) not in unknown_facts:
            unknown_facts.add(id(fact))
            yield fact, value.type
    parts = [part for link in layout.links.values() for part in (*link.request.parts, *link.response.parts)]
    wholes: list[tuple[Fact, Primitive]] = [
        *((part.part, part.value.type) for part in parts if part.value is not None and not part.value.digits),
        *((conversion, conversion.type) for conversion in layout.device.conversions.values()),
    ]
    for fact, kind in wholes:
        if _is_wide(kind.encoding, dialect) and id(fact) not in unknown_facts:
            unknown_facts.add(id(fact))
            yield fact, kind


def _is_unknown(encoding: Encoding, dialect: Dialect) -> bool:
    if is_real(encoding):
        return not is_single(encoding)
    return (is_odd(encoding) or has_magnitude(encoding)) and _is_wide(encoding, dialect)


def _is_wide(encoding: Encoding, dialect: Dialect) -> bool:
    """Whether the type of a variable for a number is wider than all that a dialect has."""
    return number_of(encoding) is not None and whole_type(encoding).size > dialect.widest


def _unknown(fact: Fact, kind: Primitive, dialect: Dialect) -> Refusal:
    code = "plc_reals_fit" if is_real(kind.encoding) else "plc_numbers_fit"
    text = f"{fact.name} is {kind.name}, a number that the functions for {dialect.title} cannot convert"
    return _refuse(code, fact, text)


def _refuse(code: str, fact: Fact, text: str) -> Refusal:
    place = fact.place["type" if "type" in fact.place else "name"]
    return Refusal(fact, Diagnostic(code, text, place, help=LEAVE_OUT))


def _wide(value: Value | None) -> bool:
    return value is not None and _upper_half(value.encoding) is not None


def _is_split(field: FieldLayout) -> bool:
    """Whether a field has a number that is too wide and is split into halves."""
    return _wide(field.value) and not field.is_list and field.field.measures is None


def _record(record: RecordLayout, split_records: dict[int, RecordLayout]) -> RecordLayout:
    """A record with split numbers, and the records in it; a record that is used twice is converted once."""
    if id(record) not in split_records:
        split_records[id(record)] = _split(record, split_records)
    return split_records[id(record)]


def _split(record: RecordLayout, split_records: dict[int, RecordLayout]) -> RecordLayout:
    split = {field.name: list(_fields(field)) for field in record.fields if _is_split(field)}
    fields: list[FieldLayout] = []
    for field in record.fields:
        measure = field.field.measures
        if field.record is not None:
            fields.append(replace(field, record=_record(field.record, split_records)))
        elif field.name in split:
            fields += split[field.name]
        elif measure is not None and measure.field in split:
            fields.append(_measuring(field, measure, split[measure.field]))
        else:
            fields.append(field)
    return replace(record, fields=tuple(fields))


def _measuring(field: FieldLayout, measure: Measure, halves: list[FieldLayout]) -> FieldLayout:
    """A field that measures a number which becomes two: it measures the first of them, and contains the same."""
    first = halves[0]
    other = measure.number(1, sum(half.size for half in halves)) - measure.number(1, first.size)
    own = replace(measure, field=first.name, plus=measure.plus + other)
    return replace(field, field=replace(field.field, measures=own))


def _halves(value: Value, order: str, swapped: bool) -> list[tuple[str, Value]]:
    """The suffixes and values of the halves in the order of the wire."""
    upper = _upper_half(value.encoding)
    assert upper is not None
    kinds = (("high", upper), ("low", PRIMITIVES["u32"]))
    const = value.const
    shifted = {"high": None if const is None else const >> 32, "low": None if const is None else const & 0xFFFFFFFF}
    halves = [
        (
            word,
            replace(
                value,
                type=kind,
                size=4,
                scale=type(value.scale)(1),
                scale_text="",
                offset=type(value.offset)(0),
                unit="",
                ranges=None,
                default=None,
                const=shifted[word],
                enum="",
                flags="",
                sentinels=(),
                parameter=None,
            ),
        )
        for word, kind in kinds
    ]
    return halves if (order == "big") != swapped else halves[::-1]


def _fields(field: FieldLayout) -> Iterator[FieldLayout]:
    assert field.value is not None
    for number, (word, half) in enumerate(_halves(field.value, field.order, field.swapped)):
        name = f"{field.name}_{word}"
        model = replace(field.field, name=name, value=half, doc=_doc(field.name, word, field.field.doc))
        yield replace(field, field=model, name=name, offset=field.offset + 4 * number, size=4, value=half)


def _registers(layout: RegisterLayout) -> Iterator[RegisterLayout]:
    if not _wide(layout.register.value):
        yield layout
        return
    for number, (word, half) in enumerate(_halves(layout.register.value, layout.order, layout.swapped)):
        name, address = f"{layout.name}_{word}", layout.address + 2 * number
        stated = layout.register
        doc = _doc(stated.name, word, stated.doc)
        register: Register = replace(stated, name=name, address=address, value=half, words=2, doc=doc)
        yield replace(layout, register=register, name=name, address=address, words=2)


def _doc(name: str, word: str, doc: str) -> str:
    other = "lower" if word == "low" else "upper"
    return f"The {other} half of {name}. {doc}".strip()


def _refused(field: FieldLayout, dialect: Dialect) -> Refusal:
    text = f"{field.name} holds numbers of 64 bits in a list, which {dialect.title} can neither hold nor split"
    return _refuse("plc_numbers_fit", field.field, text)


def _nested(field: FieldLayout, dialect: Dialect) -> Refusal:
    text = f"{field.name} is a list of texts, and {dialect.title} has no arrays of arrays"
    return _refuse("plc_arrays_flat", field.field, text)


def absent_reals(layout: DeviceLayout, dialect: Dialect) -> list[Refusal]:
    """A refusal of each value of which a NaN is a sentinel."""
    refusals = []
    refused_facts: set[int] = set()
    for fact, value in stated_values(layout):
        sentinel = next((sentinel for sentinel in value.sentinels if sentinel.is_nan), None)
        if sentinel is not None and id(fact) not in refused_facts:
            refused_facts.add(id(fact))
            text = f"the sentinel {sentinel.name} of {fact.name} is a NaN, which {dialect.title} refuses as no number"
            finding = Diagnostic("plc_reals_present", text, fact.place["sentinels"], help=LEAVE_OUT)
            refusals.append(Refusal(fact, finding))
    return refusals


def stated_values(layout: DeviceLayout) -> Iterator[tuple[Fact, Value]]:
    """Every fact with a value that functions convert."""
    for register in layout.registers:
        yield register.register, register.register.value
    for record in every_record(layout):
        for field in record.fields:
            if field.value is not None:
                yield field.field, field.value
            yield from ((case.case, case.value) for case in field.cases)
    for parameter_set in layout.device.parameters.values():
        for parameter in parameter_set.parameters:
            yield parameter, parameter.value
            yield from ((inner, inner.value) for inner in parameter.subindices)
