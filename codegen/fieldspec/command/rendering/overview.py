"""Tables of a device: registers, parameters, values, fields and members."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from fieldspec.codec.explain.values import range_in_unit
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.command.rendering.blocks import Block, Line, Table, narrowed
from fieldspec.language.model.device import Device
from fieldspec.language.model.digits import digits_text
from fieldspec.language.model.encoding import is_count
from fieldspec.language.model.enums import Enum
from fieldspec.language.model.registers import ParameterSet, Register
from fieldspec.language.model.value import Value


def value_details(value: Value) -> Iterator[tuple[str, str]]:
    """The details of a value as keys with texts. Callers leave out keys without a text."""
    yield "type", value.type.name if value.type.size else f"{value.type.name}, {value.size} bytes"
    yield "unit", unit_text(value)
    yield "range", range_text(value)
    yield "written", "" if value.write_ranges is None else range_text(value.for_writing())
    yield "words", value.write_order_text
    yield "default", "" if value.default is None else str(value.default)
    yield "digits", digits_text(value) if value.digits else ""
    yield "always", constant_text(value)
    yield "values", ", ".join(f"{sentinel.text} = {sentinel.name}" for sentinel in value.sentinels)


def constant_text(value: Value) -> str:
    """A constant with all its bytes, `0x00010000`; as a number if it is negative or has one digit; empty for others."""
    if value.const is None:
        return ""
    is_short = value.const < 10 or not is_count(value.encoding)
    return str(value.const) if is_short else f"0x{value.const:0{2 * value.size}X}"


def unit_text(value: Value) -> str:
    """`0.01 mm`, with the offset of a value that has one."""
    exact = value.scale_number
    scale = value.scale_text if "/" in value.scale_text or isinstance(exact, str) else f"{exact:f}"
    text = f"{scale} {value.unit}".strip() if value.scaled else value.unit
    return text if value.offset == 0 else f"{text}, {value.offset:+f}"


def range_text(value: Value) -> str:
    """The intervals of raw values, and as quantities where these differ."""
    if value.ranges is None:
        return ""
    counts = value.ranges.text()
    if not value.scaled:
        return counts
    return f"{counts} ({range_in_unit(value, value.ranges)})"


def field_table(record: RecordLayout, base: int | None = None) -> Block:
    """The fields of a record with their places and values; `base` is the address of the first word."""
    if not record.fields:
        return Line("no data")
    rows = [
        row
        for field in record.sent_fields
        if not field.field.is_implied
        for row in _rows(field, base, record.has_place(field))
    ]
    headings = ("at" if base is None else "address", "type", "name", "label", "unit", "range", "default", "names")
    return narrowed(Table(headings, tuple(rows)))


def _rows(field: FieldLayout, base: int | None, has_place: bool) -> Iterator[tuple[str, ...]]:
    """The row of a field, or of the types that it has by cases; after a value that varies in width it has no place."""
    place_text = f"+{field.offset}" if base is None else f"0x{base + field.offset // 2:04X}"
    place_text = place_text if has_place else ""
    label = " ".join(text for text in (field.field.printed_name, field.field.label) if text)
    name = "reserved" if field.field.reserved and not field.name else field.name
    choice = field.field.choice
    if field.field.presence is not None:
        name = f"{name}, if {field.field.presence.condition}"
    if field.field.continuation is not None:
        name = f"{name}, and another one if {field.field.continuation.condition}"
    if choice is None:
        yield (place_text, _type(field, field.record.name if field.record else ""), name, label, *_value(field.value))
        return
    for case in field.cases:
        condition = " or ".join(case.case.when)
        yield (
            place_text,
            _type(field, case.value.type.name),
            f"{name}, {choice.subject} {condition}",
            label,
            *_value(case.value),
        )
        place_text = label = ""


def _type(field: FieldLayout, name: str) -> str:
    repeat = field.field.repeat
    times = f" x {repeat.text() if repeat else field.count}" if field.is_list else ""
    value = field.value
    digits = f" as {digits_text(value)}" if value is not None and value.digits else ""
    packed = f" {value.packed_text}" if value is not None and value.packed_bits else ""
    return (name or field.primitive.name) + digits + packed + times


def _value(value: Value | None) -> tuple[str, ...]:
    if value is None:
        return "", "", "", ""
    default = value.default if value.const is None else f"always {constant_text(value)}"
    names = value.enum or value.flags or ", ".join(f"{sentinel.text} = {sentinel.name}" for sentinel in value.sentinels)
    write_range = "" if value.write_ranges is None else f"; written: {range_text(value.for_writing())}"
    return unit_text(value), range_text(value) + write_range, "" if default is None else str(default), names


def member_table(enum: Enum) -> Table:
    """The members of an enum, or the rows of a table of codes."""
    rows = []
    for member in enum.members:
        also = f", also {', '.join(member.aliases)}" if member.aliases else ""
        name = member.name + also + (" (not available)" if member.unavailable else "")
        label = " ".join(text for text in (member.printed_name, member.label) if text)
        number = "" if member.number is None else str(member.number)
        rows.append((str(member.value), number, name, label, member.problem or member.doc))
    return narrowed(Table(("value", "number", "name", "label", "meaning"), tuple(rows)))


def overview(layout: DeviceLayout) -> Iterator[Block]:
    """The whole device: what it is, its registers, tables, messages and parameters, and the names of the rest."""
    device = layout.device
    yield Line(f"{device.name} ({device.vendor}), version {device.version}, identity {layout.identity}", "bold")
    if device.title:
        yield Line(device.title)
    yield Line(f"versions {', '.join(version.id for line in device.lines for version in line.versions) or '1'}")
    tables = (
        _links(device),
        register_table(device, device.registers()),
        _tables(device),
        _messages(device),
        _signals(device),
        *(parameter_table(parameter_set) for parameter_set in device.parameters.values()),
    )
    for table in tables:
        if table.rows:
            yield Line("")
            yield table
    yield Line("")
    for title, names in _names(device):
        if names:
            yield Line(f"{title}: {', '.join(names)}")


def register_table(device: Device, registers: Iterable[Register]) -> Table:
    """Registers by address, name, type and unit; with the space where there are several, and with printed numbers."""
    rows = []
    for register in registers:
        space = device.space(register.space)
        number = str(space.first_number + register.address) if space.first_number else ""
        times = f" x {register.count}" if register.count > 1 else ""
        kind = register.value.type.name + times
        label = " ".join(text for text in (register.printed_name, register.label) if text)
        names = register.value.enum or register.value.flags
        place = (space.name if device.several_spaces else "", f"0x{register.address:04X}", number)
        rows.append((*place, register.name, label, kind, register.access or "?", register.value.unit, names))
    headings = ("space", "address", "number", "register", "label", "type", "access", "unit", "names")
    return narrowed(Table(headings, tuple(rows)))


def parameter_table(parameter_set: ParameterSet) -> Table:
    """Parameters by number, in the manual and on the wire."""
    rows = []
    for parameter in parameter_set.parameters:
        label = " ".join(text for text in (parameter.printed_name, parameter.label) if text)
        value = parameter.value
        last = parameter.number + parameter.count - 1
        number = _span(parameter_set.number_text(parameter.number), parameter_set.number_text(last))
        wire = (
            _span(f"0x{parameter_set.base + parameter.number:04X}", f"0x{parameter_set.base + last:04X}")
            if parameter_set.base
            else ""
        )
        kind = value.type.name + (f" x {parameter.elements}" if parameter.elements is not None else "")
        name = parameter.name or "reserved"
        first = (number, wire, name, label, kind, parameter.access or "?")
        rows.append((*first, value.unit, value.enum or value.flags))
    return narrowed(Table(("number", "wire", "parameter", "label", "type", "access", "unit", "names"), tuple(rows)))


def _span(first: str, last: str) -> str:
    return first if first == last else f"{first}..{last}"


def _links(device: Device) -> Table:
    """The links with their words for messages and directions."""
    rows = []
    for link in device.links.values():
        ways = " / ".join((link.request_name, link.response_name))
        rows.append((link.name, link.title, link.message_name, ways))
    return Table(("link", "title", "sends", "to / from the device"), tuple(rows))


def _signals(device: Device) -> Table:
    """The signals with their units."""
    rows = []
    for signal in device.signals.values():
        label = " ".join(text for text in (signal.printed_name, signal.label) if text)
        direction_text = {"request": "to", "response": "from"}.get(signal.direction, "")
        names = signal.value.enum or signal.value.flags
        rows.append((signal.name, label, signal.value.type.name, direction_text, unit_text(signal.value), names))
    return narrowed(Table(("signal", "label", "type", "way", "unit", "names"), tuple(rows)))


def _tables(device: Device) -> Table:
    rows = tuple(
        (
            f"0x{table.base:04X}",
            table.name,
            table.label,
            f"{table.indexes[0]}..{table.indexes[-1]}",
            table.count_by,
            table.base_by,
            f"{table.stride}",
        )
        for table in device.tables.values()
    )
    return narrowed(Table(("address", "table", "label", "elements", "how many", "begins at", "words apart"), rows))


def _messages(device: Device) -> Table:
    rows = []
    for message in device.messages.values():
        code = "" if message.code is None else f"0x{message.code:02X}"
        number = "" if message.number is None else str(message.number)
        rows.append((code, number, message.name, message.label, message.title))
    return narrowed(Table(("code", "number", "message", "label", "what"), tuple(rows)))


def _names(device: Device) -> Iterator[tuple[str, list[str]]]:
    yield "conversions", list(device.conversions)
    yield "records", list(device.records)
    yield "enums", list(device.enums)
    yield "flags", list(device.flags)
    yield "look-up tables", [lookup.name for lookup in device.lookups]
    yield "limits", [limit.name for limit in device.limits]
    yield "tasks", [task.name for task in device.tasks]
    yield "notes", [note.name for note in device.notes]
    counts = ((len(device.examples), "examples"), (len(device.errata), "errata"))
    yield "and", [f"{number} {noun}" for number, noun in counts if number]
