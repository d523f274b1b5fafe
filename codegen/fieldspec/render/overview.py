"""What a device has, shown to people."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from fieldspec.layout.device import DeviceLayout
from fieldspec.model.device import Device
from fieldspec.model.parameter import ParameterSet
from fieldspec.model.register import Register
from fieldspec.render.blocks import Block, Line, Table, narrowed


def overview(layout: DeviceLayout) -> Iterator[Block]:
    """The whole device: what it is, its registers, tables, messages and parameters, and the names of the rest."""
    device = layout.device
    yield Line(f"{device.name} ({device.vendor}), version {device.version}, identity {layout.identity}", "bold")
    if device.title:
        yield Line(device.title)
    yield Line(f"versions {', '.join(version.id for line in device.lines for version in line.versions) or '1'}")
    yield Line(f"links {', '.join(device.links)}")
    tables = (
        register_table(device.registers()),
        _tables(device),
        _messages(device),
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
    """Parameters by number."""
    rows = []
    for parameter in words.parameters:
        label = " ".join(text for text in (parameter.printed_name, parameter.label) if text)
        value = parameter.value
        first = (str(parameter.number), parameter.name, label, value.type.name, parameter.access or "?")
        rows.append((*first, value.unit, value.enum or value.flags))
    return narrowed(Table(("number", "parameter", "label", "type", "access", "unit", "names"), tuple(rows)))


def _tables(device: Device) -> Table:
    rows = tuple(
        (f"0x{table.base:04X}", table.name, table.label, f"{table.indexes[0]}..{table.indexes[-1]}", f"{table.stride}")
        for table in device.tables.values()
    )
    return narrowed(Table(("address", "table", "label", "elements", "words apart"), rows))


def _messages(device: Device) -> Table:
    rows = tuple(
        ("" if message.code is None else f"0x{message.code:02X}", message.name, message.label, message.title)
        for message in device.messages.values()
    )
    return narrowed(Table(("code", "message", "label", "what"), rows))


def _names(device: Device) -> Iterator[tuple[str, list[str]]]:
    yield "records", list(device.records)
    yield "enums", list(device.enums)
    yield "flags", list(device.flags)
    yield "look-up tables", [lookup.name for lookup in device.lookups]
    yield "limits", [limit.name for limit in device.limits]
    yield "notes", [note.name for note in device.notes]
    counts = ((len(device.examples), "examples"), (len(device.errata), "errata"))
    yield "and", [f"{number} {noun}" for number, noun in counts if number]
