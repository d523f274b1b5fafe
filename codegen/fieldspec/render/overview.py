"""What a device has, shown to people."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from fieldspec.layout.device import DeviceLayout
from fieldspec.model.device import Device
from fieldspec.model.parameter import ParameterSet
from fieldspec.model.register import Register
from fieldspec.render.blocks import Block, Line, Table, narrowed
from fieldspec.render.values import unit_text


def overview(layout: DeviceLayout) -> Iterator[Block]:
    """The whole device: what it is, its registers, tables, messages and parameters, and the names of the rest."""
    device = layout.device
    yield Line(f"{device.name} ({device.vendor}), version {device.version}, identity {layout.identity}", "bold")
    if device.title:
        yield Line(device.title)
    yield Line(f"versions {', '.join(version.id for line in device.lines for version in line.versions) or '1'}")
    tables = (
        _links(device),
        register_table(device.registers()),
        _tables(device),
        _messages(device),
        _signals(device),
        *(parameter_table(words) for words in device.parameters.values()),
    )
    for table in tables:
        if table.rows:
            yield Line("")
            yield table
    yield Line("")
    for title, names in _names(device):
        if names:
            yield Line(f"{title}: {', '.join(names)}")


def register_table(registers: Iterable[Register]) -> Table:
    """Registers by address, name, type and unit."""
    rows = []
    for register in registers:
        times = f" x {register.count}" if register.count > 1 else ""
        kind = register.value.type.name + times
        label = " ".join(text for text in (register.printed_name, register.label) if text)
        names = register.value.enum or register.value.flags
        first = (f"0x{register.address:04X}", register.name, label, kind, register.access or "?")
        rows.append((*first, register.value.unit, names))
    return narrowed(Table(("address", "register", "label", "type", "access", "unit", "names"), tuple(rows)))


def parameter_table(words: ParameterSet) -> Table:
    """Parameters by number, as the manual counts and on the wire."""
    rows = []
    for parameter in words.parameters:
        label = " ".join(text for text in (parameter.printed_name, parameter.label) if text)
        value = parameter.value
        last = parameter.number + parameter.count - 1
        number = _span(words.written(parameter.number), words.written(last))
        wire = _span(f"0x{words.base + parameter.number:04X}", f"0x{words.base + last:04X}") if words.base else ""
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
        way = {"request": "to", "response": "from"}.get(signal.direction, "")
        names = signal.value.enum or signal.value.flags
        rows.append((signal.name, label, signal.value.type.name, way, unit_text(signal.value), names))
    return narrowed(Table(("signal", "label", "type", "way", "unit", "names"), tuple(rows)))


def _tables(device: Device) -> Table:
    rows = tuple(
        (f"0x{table.base:04X}", table.name, table.label, f"{table.indexes[0]}..{table.indexes[-1]}", f"{table.stride}")
        for table in device.tables.values()
    )
    return narrowed(Table(("address", "table", "label", "elements", "words apart"), rows))


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
