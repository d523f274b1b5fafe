"""The functions that read a record: `b` are the bytes, the record goes from `o` to `end`."""

from __future__ import annotations

from collections.abc import Callable

from fieldspec.codec.layout.inner_lists import InnerList
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.targets.js.declaration import Names
from fieldspec.targets.js.members import Member, members_of, shapes_of, slot_of
from fieldspec.targets.js.number_bytes import LONGEST, place, with_offset
from fieldspec.targets.js.presences import bit_count_check, bits_of, is_present, presence_check
from fieldspec.targets.js.text import function, literal, plus
from fieldspec.targets.js.values import throw_wrong_number

CHOOSES_NOTHING = "which chooses nothing that may follow"


def read_functions(record: RecordLayout, name: str, names: Names) -> list[str]:
    """The function that reads a record from all of its bytes, or those that read its layouts if it has several."""
    if record.selector is not None:
        return [line for suffix, shape in shapes_of(record) for line in _reader(shape, f"read{name}{suffix}", names)]
    if not record.spans and record.inner_lists is None:
        return _reader(record, f"read{name}", names)
    call = f"readImage(widths{name}" if record.spans else f"readAround(inner{name}"
    return [
        *_reader(record.image, f"image{name}", names),
        *function(f"read{name}", "b, o, end", [f"return {call}, image{name}, b, o, end);"]),
    ]


def _reader(record: RecordLayout, name: str, names: Names) -> list[str]:
    """The function that checks the size, reads the fields in order, and compares them with what they measure.

    So the first wrong one is reported.
    """
    lines = [size_check(record)]
    properties: list[str] = []
    last = record.fields[-1] if record.fields else None
    if last is not None and last.count is None and last.size > 1:
        rest = f"end - o - {last.offset}"
        lines.append(f"if (({rest}) % {last.size}) throw brokenList({literal(last.name)}, {rest}, end);")
    for member in members_of(record):
        statements, expression = _read_member(record, member, names)
        lines += statements
        if member.key:
            properties.append(f"{member.key}: {expression},")
    lines += _measure_checks(record, names)
    result = ["return {", *(f"  {row}" for row in properties), "};"] if properties else ["return {};"]
    return function(name, "b, o, end", with_offset([*lines, *result]))


def size_check(record: RecordLayout) -> str:
    """The statement that refuses data of a wrong size."""
    minimum, maximum = record.least, LONGEST if record.most is None else min(record.most, LONGEST)
    tests = (
        [f"end - o !== {minimum}"]
        if minimum == maximum
        else [f"end - o < {minimum}"] * (minimum > 0) + [f"end - o > {maximum}"]
    )
    test = " || ".join(tests)
    return f"if ({test}) throw wrongSize({literal(record.name)}, {minimum}, {maximum}, end - o, o);"


def _read_member(record: RecordLayout, member: Member, names: Names) -> tuple[list[str], str]:
    """The statements that read and check a field, and the expression of its value."""
    field = member.field
    if field.field.reserved and not member.key:
        return [], ""
    if field.selector is not None:
        return _read_decided(field, field.selector, member.variable, names), member.variable
    if field.is_list:
        return _read_list(record, member, names), member.variable
    if field.record is not None:
        inner = names.records[field.record.record.name]
        expression = _element(record, field, inner, names, place("o", field.offset))
        return [f"const {member.variable} = {expression};"], member.variable
    reading = slot_of(field, names).read(member.variable, "o", field.offset)
    if reading.throws and not reading.lines:
        return [f"const {member.variable} = {reading.expression};"], member.variable
    return list(reading.lines), reading.expression


def _read_decided(field: FieldLayout, selector: FieldLayout, variable: str, names: Names) -> list[str]:
    """The statements that read a field of the type that another one decides."""
    number = slot_of(selector, names).number("o", selector.offset)

    def branch(form: FieldLayout) -> list[str]:
        reading = slot_of(form, names).read(f"{variable}of", "o", form.offset)
        return [*reading.lines, f"{variable} = {reading.expression};"]

    return [f"let {variable};", *by_selector(field, selector, number, names, branch, place("o", selector.offset))]


def by_selector(
    field: FieldLayout,
    selector: FieldLayout,
    number: str,
    names: Names,
    branch: Callable[[FieldLayout], list[str]],
    position: str,
) -> list[str]:
    """A `switch` with the statements for each type of a field, by the number of its selector or some bits of it."""
    suffix = "n" if slot_of(selector, names).wide else ""
    bits = number if field.deciding_bits is None else f"({number} & {field.deciding_bits}) >>> 0"
    lines = [f"switch ({bits}) {{"]
    for case in field.cases:
        labels = " ".join(f"case {own}{suffix}:" for own in sorted(case.numbers))
        statements = branch(field.forms[min(case.numbers)])
        lines += [f"  {labels} {{", *(f"    {line}" for line in statements), "    break;", "  }"]
    wrong = throw_wrong_number("unknown_value", selector.name, number, literal(CHOOSES_NOTHING), position)
    return [*lines, f"  default: {wrong}", "}"]


def _read_list(record: RecordLayout, member: Member, names: Names) -> list[str]:
    field = member.field
    start = place("o", field.offset)
    count = str(field.count) if field.count is not None else f"Math.floor((end - ({start})) / {field.size})"
    room = record.room_of(field)
    items = "1"
    if room is not None and room.continuation is not None:
        items = count = f"elementsInImage({_list_data(record, field, names)}, b, {start})"
    if room is not None and room.count:
        number = _count_number(record, room, names)
        if room.presence is not None and room.presence.numbers:
            count = f"{is_present(room.presence, number)} ? {items} : 0"
        else:
            number = bits_of(room.presence, number) if room.presence is not None else number
            number = f"({plus(number, -room.plus)})" if room.plus else number
            count = number if room.unit == room.element else f"{number} / {room.element}"
    if field.record is not None:
        element, checks = _element(record, field, names.records[field.record.record.name], names, "at"), []
    else:
        reading = slot_of(field, names).read("item", "at", 0)
        element, checks = reading.expression, list(reading.lines)
    push = [f"{member.variable}.push({element});"] if member.key else []
    return [
        *([f"const {member.variable} = [];"] if member.key else []),
        f"for (let at = {start}, left = {count}; left > 0; left--, at += {field.size}) {{",
        *(f"  {line}" for line in [*checks, *push]),
        "}",
    ]


def _element(record: RecordLayout, field: FieldLayout, name: str, names: Names, start: str) -> str:
    """The expression of an element that is a record, with the bytes that it has where these differ."""
    assert field.record is not None
    if field.record.size is not None:
        return f"read{name}(b, {start}, {plus(start, field.size)})"
    size = f"elementBytes({_list_data(record, field, names)}.parts, b.subarray({start}, {plus(start, field.size)}))"
    return f"read{name}(b, {start}, {start} + {size})"


def _list_data(record: RecordLayout, field: FieldLayout, names: Names) -> str:
    """The expression of what programs know of a list."""
    return f"inner{names.records[record.name]}.lists[{record.rooms_before(field)}]"


def _measure_checks(record: RecordLayout, names: Names) -> list[str]:
    """The statements that compare the sizes in the fields with the fields that they measure."""
    checks = [line for field in record.fields for line in _measure_check(record, field, names)]
    for field in record.fields:
        if (room := record.room_of(field)) is None or not room.count:
            left = f"(end - o - {field.offset}) / {field.size}"
            decider = record.named(field.presence.by) if field.presence is not None else None
            position = place("o", decider.offset) if decider is not None else ""
            checks += presence_check(record, field, names, left, position)
    return checks


def _measure_check(record: RecordLayout, field: FieldLayout, names: Names) -> list[str]:
    packed = record.named(field.bits_of) if field.bits_of else None
    if packed is not None:
        return bit_count_check(field, names, f"(end - o - {packed.offset})", place("o", field.offset))
    measure = field.measure
    other = record.named(measure.field) if measure is not None else None
    if measure is None or other is None:
        return []
    slot = slot_of(field, names)
    number, position = slot.number("o", field.offset), place("o", field.offset)
    if other.count is not None:
        measured = str(measure.number(other.count if other.is_list else 1, other.size))
    elif (room := record.room_of(other)) is not None and room.count:
        if room.count == field.name:
            return []
        unit = room.unit if measure.of == "bytes" else room.unit / room.element
        units = _count_number(record, room, names)
        units = f"({plus(units, -room.plus)})" if room.plus else units
        measured = units if unit == 1 else f"{units} * {room.unit}" if unit > 1 else f"{units} / {room.element}"
        measured = plus(measured, measure.plus)
    else:
        left = f"(end - o - {other.offset})"
        measured = left if measure.of == "bytes" or other.size == 1 else f"{left} / {other.size}"
        measured = plus(measured, measure.plus)
    expected = f"BigInt({measured})" if slot.wide else measured
    detail = f"`but there are ${{{measured}}}`"
    wrong = throw_wrong_number("wrong_measure", field.name, number, detail, position)
    return [f"if ({number} !== {expected}) {wrong}"]


def _count_number(record: RecordLayout, room: InnerList, names: Names) -> str:
    """The expression of the number in an image that counts a list followed by another list."""
    count = record.named(room.count)
    assert count is not None
    return slot_of(count, names).number("o", count.offset)
