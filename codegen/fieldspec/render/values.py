"""How values, fields and members are shown to people."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.layout.explaining.worded import range_in_unit
from fieldspec.layout.record import FieldLayout, RecordLayout
from fieldspec.model.enum import Enum
from fieldspec.model.value import Value
from fieldspec.render.blocks import Block, Line, Table, narrowed


def value_details(value: Value) -> Iterator[tuple[str, str]]:
    """What is said of a value, key by key; keys without a text are left out by who prints."""
    yield "type", value.type.name if value.type.size else f"{value.type.name}, {value.size} bytes"
    yield "unit", unit_text(value)
    yield "range", range_text(value)
    yield "written", "" if value.write_ranges is None else range_text(value.as_written())
    yield "default", "" if value.default is None else str(value.default)
    yield "always", "" if value.const is None else str(value.const)
    yield "values", ", ".join(f"{sentinel.text} = {sentinel.name}" for sentinel in value.sentinels)


def unit_text(value: Value) -> str:
    """`0.01 mm`, and the offset where there is one."""
    scale = value.scale_text if "/" in value.scale_text else f"{value.scale:f}"
    text = f"{scale} {value.unit}".strip() if value.scaled else value.unit
    return text if value.offset == 0 else f"{text}, {value.offset:+f}"


def range_text(value: Value) -> str:
    """The intervals in counts, and in the unit where that is something else."""
    if value.ranges is None:
        return ""
    counts = value.ranges.text()
    if not value.scaled:
        return counts
    return f"{counts} ({range_in_unit(value, value.ranges)})"


def field_table(record: RecordLayout, base: int | None = None) -> Block:
    """The fields of a record: where they are, and what they hold; `base` is the address of the first word."""
    if not record.fields:
        return Line("no data")
    rows = [row for field in record.fields for row in _rows(field, base)]
    headings = ("at" if base is None else "address", "type", "name", "label", "unit", "range", "default", "names")
    return narrowed(Table(headings, tuple(rows)))


def _rows(field: FieldLayout, base: int | None) -> Iterator[tuple[str, ...]]:
    """The row of a field, or of the types that it has by cases."""
    at = f"+{field.offset}" if base is None else f"0x{base + field.offset // 2:04X}"
    label = " ".join(text for text in (field.field.printed_name, field.field.label) if text)
    name = "reserved" if field.field.reserved and not field.name else field.name
    choice = field.field.choice
    if choice is None:
        yield (at, _type(field, field.record.name if field.record else ""), name, label, *_value(field.value))
        return
    for case in field.cases:
        when = " or ".join(case.case.when)
        yield (at, _type(field, case.value.type.name), f"{name}, {choice.by} {when}", label, *_value(case.value))
        at = label = ""


def _type(field: FieldLayout, name: str) -> str:
    repeat = field.field.repeat
    times = f" x {repeat.text() if repeat else field.count}" if field.listed else ""
    return (name or field.primitive.name) + times


def _value(value: Value | None) -> tuple[str, ...]:
    if value is None:
        return "", "", "", ""
    default = value.default if value.const is None else f"always {value.const}"
    names = value.enum or value.flags or ", ".join(f"{held.text} = {held.name}" for held in value.sentinels)
    written = "" if value.write_ranges is None else f"; written: {range_text(value.as_written())}"
    return unit_text(value), range_text(value) + written, "" if default is None else str(default), names


def member_table(enum: Enum) -> Table:
    """The members of an enum, or the rows of a table of codes."""
    rows = []
    for member in enum.members:
        name = member.name + (" (not available)" if member.unavailable else "")
        label = " ".join(text for text in (member.printed_name, member.label) if text)
        number = "" if member.number is None else str(member.number)
        rows.append((str(member.value), number, name, label, member.problem or member.doc))
    return narrowed(Table(("value", "number", "name", "label", "meaning"), tuple(rows)))
