"""The facts of frames: links with their parts, messages, and records."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.facts.row import Cell, Row, of_fact, of_ranges, row
from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.record import FieldLayout, RecordLayout
from fieldspec.model.link import Link
from fieldspec.model.message import Message


def wire(layout: DeviceLayout) -> Iterator[Row]:
    """The rows of links, messages and of records that no table holds."""
    for link in layout.device.links.values():
        yield from _link(link)
    kind = _message_kind(layout)
    for laid in layout.messages.values():
        yield from of_fact(kind, laid.message, code=laid.message.code)
        yield from _lengths(laid.message)
        for data in (laid.request, laid.response):
            yield from fields(f"{kind}_field", data, laid.message.code)
    in_tables = {table.record.name for table in layout.tables.values()}
    for record in layout.records.values():
        if record.name not in in_tables:
            yield from of_fact("record", record.record, bytes=record.size)
            yield from fields(f"{record.name}_field", record)


def fields(kind: str, record: RecordLayout, code: int | None = None, base: int | None = None) -> Iterator[Row]:
    """The rows of a record's fields; `base` is the address of the first element of a table of such records."""
    for field in record.fields:
        cells: Row = {"code": code, "access": field.field.access, **_placed(field, base)}
        if field.record is not None:
            cells.update(type=field.record.name, bytes=field.record.size)
        if field.field.repeat is not None:
            cells["ranges"] = field.field.repeat.text()
        yield from of_fact(kind, field.field, field.value, **cells)


def _placed(field: FieldLayout, base: int | None) -> Row:
    if base is None:
        return {}
    return {"address": base + field.offset // 2, "words": (field.size * (field.count or 1) + 1) // 2}


def _message_kind(layout: DeviceLayout) -> str:
    """What the device's frames call a message's code: a function, a command."""
    for link in layout.links.values():
        part = link.request.role("code")
        if part is not None:
            return part.name
    return "message"


def _lengths(message: Message) -> Iterator[Row]:
    """The printed lengths of a message's frames."""
    for direction, length in (("request", message.request_length), ("response", message.response_length)):
        if length is not None:
            path = f"{message.place.path}/frame_length/{direction}"
            yield row("frame_length", path, message.sources, code=message.code, bytes=length, name=direction)


def _link(link: Link) -> Iterator[Row]:
    path = link.place.path
    yield from of_fact("link", link)
    for name, mark in (("start", link.start), ("end", link.end)):
        if mark:
            cells: Row = {"name": name, "bytes": len(mark), "printed_name": mark.hex(" ").upper()}
            yield row("mark", f"{path}/{name}", link.sources, **cells)
    if link.error is not None:
        cells = {"name": "error", "code": link.error.flag, "type": link.error.record}
        yield row("refusal", f"{path}/error", link.error.sources or link.sources, **cells)
    for name, silence, unit in (
        ("characters", link.silence_characters, "character"),
        ("milliseconds", link.silence_milliseconds, "ms"),
    ):
        if silence is not None:
            cells = {"name": "silence", "min": silence, "unit": unit}
            yield row("timing", f"{path}/silence/{name}", link.silence_sources or link.sources, **cells)
    yield from _stations(link)
    yield from _serial(link)
    for direction in ("request", "response"):
        for part in link.parts(direction):
            yield from of_fact("frame_part", part, part.value)


def _stations(link: Link) -> Iterator[Row]:
    stations = link.stations
    if stations is None:
        return
    path, sources = stations.place.path, stations.sources or link.sources
    yield row("station", path, sources, name="stations", **of_ranges(stations.ranges))
    if stations.broadcast is not None:
        yield row("station", f"{path}/broadcast", sources, name="broadcast", code=stations.broadcast)


def _serial(link: Link) -> Iterator[Row]:
    serial = link.serial
    if serial is None:
        return
    settings: tuple[tuple[str, tuple[object, ...], Cell], ...] = (
        ("baud", serial.baud, serial.default_baud),
        ("start_bits", () if serial.start_bits is None else (serial.start_bits,), None),
        ("data_bits", serial.data_bits, None),
        ("parity", serial.parity, None),
        ("stop_bits", serial.stop_bits, None),
    )
    for name, held, default in settings:
        if held:
            text = ", ".join(map(str, held))
            path = f"{link.place.path}/serial/{name}"
            yield row("serial", path, serial.sources or link.sources, name=name, ranges=text, default=default)
