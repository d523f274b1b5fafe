"""The functions that write a record, `value`, to the bytes `b` from `o` on, and count its bytes."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.encoding import Digits, Octets, Real, Text, Truth, Whole
from fieldspec.targets.js.declaration import Names
from fieldspec.targets.js.images import list_length, write_lists, write_widths
from fieldspec.targets.js.members import Member, members_of, shapes_of, slot_of
from fieldspec.targets.js.number_bytes import place, with_offset
from fieldspec.targets.js.presences import bit_count_check, end_check, presence_check
from fieldspec.targets.js.record_reading import by_selector
from fieldspec.targets.js.text import function, literal, plus


def write_functions(record: RecordLayout, name: str, names: Names) -> list[str]:
    """The functions that write a record and count its bytes, for each layout if it has several."""
    if record.spans:
        return [*_write_fields(record, f"writeImage{name}", names), *write_widths(record, name)]
    if record.inner_lists is not None:
        return [*_write_fields(record, f"writeImage{name}", names), *write_lists(record, name, names)]
    lines: list[str] = []
    for suffix, shape in shapes_of(record):
        lines += _write_fields(shape, f"write{name}{suffix}", names)
        if shape.size is None:
            lines += _count_bytes(shape, f"size{name}{suffix}")
    return lines


def _write_fields(record: RecordLayout, name: str, names: Names) -> list[str]:
    """The function that checks the fields of a value and writes them, those that measure others after these.

    So of several mistakes the one is named that other codecs name.
    """
    lines: list[str] = []
    members = members_of(record)
    keys = {member.field.name: member.key for member in members}
    for member in members:
        field = member.field
        if field.field.measures is not None:
            continue
        if not member.key:
            lines += _write_implied(record, member, names, keys)
        elif field.selector is not None:
            lines += _write_decided(field, field.selector, member, keys, names)
        elif field.is_list:
            lines += _write_list(member, names)
        elif field.record is not None:
            inner = names.records[field.record.record.name]
            lines.append(f"{inner}.check(value.{member.key});")
            lines.append(f"write{inner}(value.{member.key}, b, {place('o', field.offset)});")
        else:
            lines.append(f"const {member.variable} = value.{member.key};")
            lines += slot_of(field, names).write(member.variable, "o", field.offset)
    for member in members:
        if member.field.field.measures is not None:
            lines += _write_implied(record, member, names, keys)
        lines += bit_count_check(member.field, names, f"value.{keys.get(member.field.bits_of, '')}.length", "null")
    for member in members:
        lines += presence_check(record, member.field, names, f"value.{member.key}.length", "null")
        lines += end_check(member.field, names, f"value.{member.key}")
    return function(name, "value, b, o", with_offset(lines))


def selector_number(selector: FieldLayout, keys: Mapping[str, str], names: Names) -> str:
    """The expression of the number of a selector of a value, or its constant."""
    key, slot = keys[selector.name], slot_of(selector, names)
    return f"value.{key}" if key else f"{slot.value.const}{'n' * slot.wide}"


def _write_decided(
    field: FieldLayout, selector: FieldLayout, member: Member, keys: Mapping[str, str], names: Names
) -> list[str]:
    """The statements that write a field in the type that another one decides."""

    def branch(form: FieldLayout) -> list[str]:
        return slot_of(form, names).write(member.variable, "o", form.offset)

    number = selector_number(selector, keys, names)
    return [
        f"const {member.variable} = value.{member.key};",
        *by_selector(field, selector, number, names, branch, "null"),
    ]


def _write_list(member: Member, names: Names) -> list[str]:
    field, items = member.field, f"value.{member.key}"
    if field.record is not None:
        inner = names.records[field.record.record.name]
        body = [f"{inner}.check(item);", f"write{inner}(item, b, at);"]
    else:
        body = slot_of(field, names).write("item", "at", 0)
    repeat = field.field.repeat
    lowest_count, highest_count = (field.count, field.count) if repeat is None else (repeat.low, repeat.high)
    start = place("o", field.offset)
    return [
        f"checkList({literal(field.name)}, {items}, {lowest_count}, {highest_count});",
        f"for (let at = {start}, index = 0; index < {items}.length; index++, at += {field.size}) {{",
        f"  const item = {items}[index];",
        *(f"  {line}" for line in body),
        "}",
    ]


def _write_implied(record: RecordLayout, member: Member, names: Names, keys: Mapping[str, str]) -> list[str]:
    """The statements that write a field that follows from others, or has a constant."""
    field, slot = member.field, slot_of(member.field, names)
    measure = field.measure
    other = record.named(measure.field) if measure is not None else None
    if measure is not None and other is not None:
        unit = other.size if measure.of == "bytes" else 1
        if other.count is not None:
            return slot.constant(measure.number(other.count if other.is_list else 1, other.size), "o", field.offset)
        length = f"value.{keys[other.name]}.length"
        count = plus(length if unit == 1 else f"{length} * {unit}", measure.plus)
        count = f"BigInt({count})" if slot.wide else count
        return [f"const {member.variable} = {count};", *slot.write(member.variable, "o", field.offset)]
    number = slot.value.const
    if number is None:
        number = slot.value.default if isinstance(slot.value.default, int) else 0
    encoding = slot.value.encoding
    if not number and not isinstance(encoding, Digits):
        return []
    match encoding:
        case Text() | Octets():
            return []
        case Real():
            return [f"const {member.variable} = {number};", *slot.write(member.variable, "o", field.offset)]
        case Whole() | Truth() | Digits():
            offsets = (field.offset + index * field.size for index in range(field.count or 1))
            return [line for offset in offsets for line in slot.constant(number, "o", offset)]
        case _:
            assert_never(encoding)


def _count_bytes(record: RecordLayout, name: str) -> list[str]:
    """The function that counts the bytes of a value."""
    member = members_of(record)[-1]
    field: FieldLayout = member.field
    repeat = field.field.repeat
    assert repeat is not None
    length = list_length(member.key, repeat.high)
    size = length if field.size == 1 else f"{length} * {field.size}"
    return function(name, "value", [f"return {field.offset} + {size};"])
