"""Records: a codec with generated functions, and the interface of its values with the same name."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.exponents import exponent_of
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.foundation.names import Name
from fieldspec.language.model.value import Value
from fieldspec.targets.fact_texts import cited, described, sentence
from fieldspec.targets.js.declaration import Declaration, Names
from fieldspec.targets.js.images import list_table, width_table
from fieldspec.targets.js.members import Member, members_of, most_bytes
from fieldspec.targets.js.record_choices import choosing_functions
from fieldspec.targets.js.record_reading import read_functions
from fieldspec.targets.js.record_writing import write_functions
from fieldspec.targets.js.text import comment, literal, object_of
from fieldspec.targets.js.units import ABSENT_VALUES, POWER_UNIT, absent_of, power_unit_of, unit_of


def declare_record(record: RecordLayout, name: str, names: Names, head: str) -> Declaration:
    """The codec of a record, `name`, and the interface of its values; `head` begins its documentation."""
    members = [member for member in members_of(record) if member.key]
    units = {member.key: unit for member in members if (unit := _unit(record, member.field, names)) is not None}
    absent = {member.key: table for member in members if (table := _absent(names, member.field)) is not None}
    code = [
        *width_table(record, name),
        *list_table(record, name),
        *read_functions(record, name, names),
        *write_functions(record, name, names),
        *choosing_functions(record, name, names),
        f"export const {name} = /* @__PURE__ */ record({{",
        f"  name: {literal(record.name)},",
        f"  least: {record.least},",
        f"  most: {most_bytes(record)},",
        f"  read: read{name},",
        f"  write: write{name},",
        f"  size: {'null' if record.size is not None else f'size{name}'},",
        f"  keys: {{ __proto__: null{''.join(f', {member.key}: 0' for member in members)} }},",
        f"  units: {object_of({key: call for key, (call, _) in units.items()})},",
        *([f"  absent: {object_of({key: table for key, (table, _) in absent.items()})},"] if absent else []),
        "});",
        "",
    ]
    unit_types = " ".join(f"readonly {key}: {kind};" for key, (_, kind) in units.items())
    unit_type = f"{{ {unit_types} }}" if units else "Record<string, never>"
    if absent:
        absent_types = " ".join(f"readonly {key}: {kind};" for key, (_, kind) in absent.items())
        unit_type += f", {{ {absent_types} }}"
    types = [
        *comment([head, sentence(record.record.doc), cited(record.record.sources)]),
        f"export interface {name} {{",
        *(line for member in members for line in _property(member, names)),
        "}",
        f"export declare const {name}: RecordCodec<{name}, {unit_type}>;",
        "",
    ]
    return Declaration(code, types)


def _unit(record: RecordLayout, field: FieldLayout, names: Names) -> tuple[str, str] | None:
    """The call that makes the unit of a field, and its type; None where its counts have neither scale nor unit."""
    if field.value is None:
        return None
    exponent = exponent_of(field.value, names.layout.registers, record)
    if exponent is not None:
        return power_unit_of(field.value, exponent.value), POWER_UNIT
    call = unit_of(field.value)
    return (call, "Unit") if call else None


def _absent(names: Names, field: FieldLayout) -> tuple[str, str] | None:
    """The states of a field, and their type; by the name of the type where it has several."""
    if field.value is not None:
        table = absent_of(names.layout.device, field.value)
        return (table, ABSENT_VALUES) if table else None
    device = names.layout.device
    tables = {case.name: table for case in field.cases if (table := absent_of(device, case.value))}
    kinds = " ".join(f"readonly {name}: {ABSENT_VALUES};" for name in tables)
    return (object_of(tables), f"{{ {kinds} }}") if tables else None


def _property(member: Member, names: Names) -> Iterator[str]:
    """The property of a field in the interface."""
    field = member.field
    if field.record is not None:
        kinds = [names.records[field.record.record.name]]
    elif field.cases:
        kinds = list(dict.fromkeys(names.type_of(case.value) for case in field.cases))
    else:
        assert field.value is not None
        kinds = [names.type_of(field.value)]
    kind = " | ".join(f"readonly {kind}[]" for kind in kinds) if field.is_list else " | ".join(kinds)
    facts = [_facts(field.value)] if field.value is not None else []
    facts += [f"Sent if {field.field.presence.condition}."] if field.field.presence is not None else []
    if (continuation := field.field.continuation) is not None:
        facts.append(f"After an element, another one follows if {continuation.condition}.")
    facts += [f"Contains {field.field.bit_measure.text}."] if field.field.bit_measure is not None else []
    yield from comment(described(Name.of(field.name).title(), field.field, *facts), 2)
    yield f"  readonly {member.key}{'?' * field.field.may_be_empty}: {kind};"


def _facts(value: Value) -> str:
    """The unit, the range, the sentinels and the flags of a value, as sentences of a comment."""
    facts = []
    if value.unit:
        facts.append(f"In counts of {value.scale_text} {value.unit}" if value.scaled else f"In {value.unit}")
    if value.writable_ranges is not None:
        facts.append(f"Range {value.writable_ranges.text()}")
    facts += [f"{sentinel.text} means {Name.of(sentinel.name).title().lower()}" for sentinel in value.sentinels]
    if value.flags:
        facts.append(f"A word of {Name.of(value.flags).pascal()}")
    return " ".join(f"{fact}." for fact in facts)
