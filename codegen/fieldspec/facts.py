"""One row a fact, for audits and other programs. The columns are documented in docs/facts.md and stable."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from decimal import Decimal
from typing import TypeAlias

from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.record import FieldLayout, RecordLayout
from fieldspec.model.device import Device
from fieldspec.model.enum import Enum
from fieldspec.model.fact import Citation, Claim, Fact
from fieldspec.model.link import Link
from fieldspec.model.register import Register
from fieldspec.model.value import Value

COLUMNS = (
    "kind",
    "path",
    "code",
    "address",
    "words",
    "bytes",
    "bit",
    "name",
    "printed_name",
    "label",
    "type",
    "access",
    "unit",
    "scale",
    "min",
    "max",
    "ranges",
    "default",
    "section",
    "line",
    "printed",
    "errata",
)

Cell: TypeAlias = int | Decimal | str | list[str] | dict[str, object] | None
Row: TypeAlias = dict[str, Cell]


def rows(layout: DeviceLayout) -> list[Row]:
    """All facts of a device at one version, in the order of the spec's sections."""
    device = layout.device
    found = [
        *_links(device),
        *_messages(layout),
        *_records(layout),
        *_registers(device),
        *_tables(layout),
        *_parameters(device),
        *_enums(device),
        *_flags(device),
        *_lookups(device),
        *_limits(device),
        *_notes(device),
        *_examples(layout),
    ]
    _add_errata(device, found)
    return found


def _row(kind: str, path: str, sources: tuple[Citation, ...], **cells: Cell) -> Row:
    row: Row = dict.fromkeys(COLUMNS)
    row.update(kind=kind, path=path, errata=[])
    if sources:
        row.update(section=sources[0].section or None, line=sources[0].line())
    row.update({key: cell for key, cell in cells.items() if cell not in ("", None)})
    return row


def _fact(kind: str, fact: Fact, **cells: Cell) -> Iterator[Row]:
    """The row of a fact, then one for each place of the manual that states it again."""
    named: dict[str, Cell] = {"name": fact.name, "printed_name": fact.printed_name, "label": fact.label}
    yield _row(kind, fact.place.path, fact.sources, **{**named, **cells})
    for claim in fact.restated:
        yield _restated(kind, fact, claim)


_CLAIMED = {"words", "bit", "type", "access", "unit", "scale", "code", "printed_name", "label", "default"}


def _restated(kind: str, fact: Fact, claim: Claim) -> Row:
    cells: dict[str, Cell] = {"name": fact.name, "printed_name": fact.printed_name, "label": fact.label}
    for key, value in claim.values.items():
        if key in _CLAIMED and not isinstance(value, bool):
            cells[key] = value
        elif key == "at" and isinstance(value, int):
            cells["address"] = value
        elif key == "value" and isinstance(value, int):
            cells["code"] = value
        elif key in ("range", "unit_range", "enum_values", "repeat"):
            cells["ranges"] = str(value)
    return _row(kind, claim.place.path, claim.sources, **cells)


def _value(value: Value | None) -> dict[str, Cell]:
    if value is None:
        return {}
    cells: dict[str, Cell] = {
        "type": value.type.name,
        "bytes": value.size,
        "unit": value.unit,
        "scale": value.scale if value.scaled else None,
        "default": value.default,
    }
    if value.ranges is not None:
        cells.update(min=value.ranges.low, max=value.ranges.high, ranges=value.ranges.text())
    return cells


def _links(device: Device) -> Iterator[Row]:
    for link in device.links.values():
        yield from _fact("link", link)
        yield from _stations(link)
        for direction in ("request", "response"):
            for part in link.parts(direction):
                yield from _fact("frame_part", part, **_value(part.value))


def _stations(link: Link) -> Iterator[Row]:
    if link.stations is not None:
        ranges = link.stations.ranges
        cells: dict[str, Cell] = {}
        if ranges is not None:
            cells = {"min": ranges.low, "max": ranges.high, "ranges": ranges.text()}
        yield _row("station", link.stations.place.path, link.stations.sources, name="stations", **cells)
    if link.serial is not None:
        path = f"{link.place.path}/serial"
        for name, numbers in (
            ("baud", link.serial.baud),
            ("data_bits", link.serial.data_bits),
            ("stop_bits", link.serial.stop_bits),
        ):
            if numbers:
                text = ", ".join(map(str, numbers))
                yield _row("serial", path, link.serial.sources, name=name, ranges=text)
        if link.serial.parity:
            yield _row("serial", path, link.serial.sources, name="parity", ranges=", ".join(link.serial.parity))


def _message_kind(layout: DeviceLayout) -> str:
    """What the device's frames call a message's code: a function, a command."""
    for link in layout.links.values():
        part = link.request.role("code")
        if part is not None:
            return part.name
    return "message"


def _messages(layout: DeviceLayout) -> Iterator[Row]:
    kind = _message_kind(layout)
    for laid in layout.messages.values():
        yield from _fact(kind, laid.message, code=laid.message.code)
        for data in (laid.request, laid.response):
            yield from _fields(f"{kind}_field", data, laid.message.code)


def _fields(kind: str, record: RecordLayout, code: int | None = None, base: int | None = None) -> Iterator[Row]:
    for field in record.fields:
        cells = {**_value(field.value), **_placed(field, base)}
        if field.record is not None:
            cells["type"] = field.record.name
            cells["bytes"] = field.record.size
        yield from _fact(kind, field.field, code=code, access=field.field.access, **cells)


def _placed(field: FieldLayout, base: int | None) -> dict[str, Cell]:
    if base is None:
        return {}
    return {"address": base + field.offset // 2, "words": field.size // 2}


def _records(layout: DeviceLayout) -> Iterator[Row]:
    in_tables = {table.record.name for table in layout.tables.values()}
    for record in layout.records.values():
        if record.name not in in_tables:
            yield from _fact("record", record.record, bytes=record.size)
            yield from _fields(f"{record.name}_field", record)


def _registers(device: Device) -> Iterator[Row]:
    for register in device.registers():
        cells = {**_value(register.value), "words": register.width, "access": register.access}
        if register.count == 1:
            yield from _fact("register", register, address=register.address, **cells)
        else:
            yield from _elements(register, cells)


def _elements(register: Register, cells: dict[str, Cell]) -> Iterator[Row]:
    """A row for each of several equal registers, with its own line where the spec has it."""
    for number in range(register.count):
        index = register.index_from + number
        sources = register.element_sources[number : number + 1] or register.sources
        printed = register.element_name.format(n=index) if register.element_name else register.printed_name
        yield _row(
            "register",
            f"{register.place.path}/{index}",
            sources,
            name=f"{register.name}_{index}",
            printed_name=printed,
            label=register.label,
            address=register.address + number * register.stride,
            **cells,
        )


def _tables(layout: DeviceLayout) -> Iterator[Row]:
    done = set()
    for laid in layout.tables.values():
        table = laid.table
        yield from _fact("table", table, address=table.base, words=laid.words, access=table.access)
        for element in table.elements:
            path = element.place.path
            yield _row(
                "table_element",
                path,
                element.sources,
                name=f"{table.name}_{element.index}",
                address=table.address(element.index),
                words=laid.words,
            )
        if laid.record.name not in done:
            done.add(laid.record.name)
            yield from _fact("record", laid.record.record, words=laid.words, bytes=laid.record.size)
            yield from _fields("table_field", laid.record, base=table.base)


def _parameters(device: Device) -> Iterator[Row]:
    for words in device.parameters.values():
        for parameter in words.parameters:
            cells = _value(parameter.value)
            yield from _fact("parameter", parameter, code=parameter.number, access=parameter.access, **cells)


def _enums(device: Device) -> Iterator[Row]:
    for enum in device.enums.values():
        kind = "enum_value" if enum.kind == "enum" else enum.kind
        yield from _fact("enum", enum, **_bounds(enum))
        for member in enum.members:
            yield from _fact(kind, member, code=member.value)
            for number, cause in enumerate(member.causes):
                path = f"{member.place.path}/causes/{number}"
                yield _row("cause", path, cause.sources, code=member.value, name=f"{member.name}_cause_{number + 1}")


def _bounds(enum: Enum) -> dict[str, Cell]:
    values = [member.value for member in enum.members]
    return {"min": min(values), "max": max(values)}


def _flags(device: Device) -> Iterator[Row]:
    for word in device.flags.values():
        yield from _fact("flags", word, type=word.type.name, bytes=word.type.size)
        for bit in word.bits:
            number: Cell = bit.first if bit.width == 1 else f"{bit.first}..{bit.last}"
            yield from _fact("bit", bit, bit=number)


def _lookups(device: Device) -> Iterator[Row]:
    for lookup in device.lookups:
        for number, row in enumerate(lookup.rows):
            cells = [str(cell) for cell in row.cells if cell is not None]
            name = f"{lookup.name}_{number + 1}"
            yield _row(lookup.kind, row.place.path, row.sources, name=name, label=" | ".join(cells))


def _limits(device: Device) -> Iterator[Row]:
    for limit in device.limits:
        low = limit.low if limit.low is not None else limit.value
        high = limit.high if limit.high is not None else limit.value
        yield from _fact(limit.kind, limit, unit=limit.unit, min=low, max=high, default=limit.text)


def _notes(device: Device) -> Iterator[Row]:
    for note in device.notes:
        yield _row("note", note.place.path, note.sources, name=note.name, label=note.title)


def _examples(layout: DeviceLayout) -> Iterator[Row]:
    for example in layout.device.examples.values():
        message = layout.messages.get(example.message)
        yield _row(
            "example",
            example.place.path,
            example.sources,
            code=message.message.code if message else None,
            bytes=len(example.frame),
            name=example.id,
            printed_name=example.frame.hex(" ").upper(),
            label=example.title,
        )


def _add_errata(device: Device, found: list[Row]) -> None:
    """Adds every erratum to the row of the innermost fact that it is about."""
    by_path: dict[str, Row] = {}
    for listed in found:
        by_path.setdefault(str(listed["path"]), listed)
    for erratum in device.errata:
        path = erratum.fact
        while path and path not in by_path:
            path = path.rpartition("/")[0]
        row = by_path.get(path)
        if row is None:
            cells: Mapping[str, Cell] = {"name": erratum.fact.rpartition("/")[2]}
            row = _row("fact", erratum.fact, erratum.sources, **cells)
            by_path[erratum.fact] = row
            found.append(row)
        held = row["errata"]
        assert isinstance(held, list)
        held.append(erratum.id)
        if erratum.printed:
            before = row["printed"]
            row["printed"] = {**(before if isinstance(before, dict) else {}), **erratum.printed}
