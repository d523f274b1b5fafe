"""Facts of frames: links, signals, conversions, messages, records, enums and bit fields."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.record import CaseLayout, FieldLayout, RecordLayout
from fieldspec.language.model.access import narrowed
from fieldspec.language.model.device import Device
from fieldspec.language.model.enums import Enum, Flags, Member
from fieldspec.language.model.fact import STANDARD
from fieldspec.language.model.link import Link
from fieldspec.language.model.record import Message
from fieldspec.language.model.value import Conversion
from fieldspec.tools.facts.row import Cell, FactRow, SharedRows, of_fact, of_flag, of_ranges, row


def codes(device: Device, shared: SharedRows) -> Iterator[FactRow]:
    """The rows of enums and of words of flags."""
    for enum in device.enums.values():
        yield from shared.rows(enum, partial(_enum, enum))
    for word in device.flags.values():
        yield from shared.rows(word, partial(_flags, word))


def _enum(enum: Enum) -> Iterator[FactRow]:
    kind = "enum_value" if enum.kind == "enum" else enum.kind
    values = [member.value for member in enum.members]
    yield from of_fact("enum", enum, min=min(values, default=None), max=max(values, default=None))
    for member in enum.members:
        yield from of_fact(kind, member, code=member.value, number=member.number)
        yield from _remedies(member)


def _remedies(member: Member) -> Iterator[FactRow]:
    """The rows of the causes of a code and of what to do about it, which are in our own words."""
    path = member.place.path
    for number, cause in enumerate(member.causes):
        name, inner = f"{member.name}_cause_{number + 1}", f"{path}/causes/{number}"
        sources = cause.sources or member.sources
        yield row("cause", inner, sources, code=member.value, name=name, label=cause.cause)
        for index, remedy in enumerate(cause.remedies):
            cells: FactRow = {"code": member.value, "name": f"{name}_remedy_{index + 1}", "label": remedy}
            yield row("remedy", f"{inner}/remedies/{index}", sources, **cells)
    for index, remedy in enumerate(member.remedies):
        cells = {"code": member.value, "name": f"{member.name}_remedy_{index + 1}", "label": remedy}
        yield row("remedy", f"{path}/remedies/{index}", member.sources, **cells)


def _flags(word: Flags) -> Iterator[FactRow]:
    cells: FactRow = {"type": word.type.name, "bytes": word.type.size, **of_ranges(word.ranges)}
    yield from of_fact("flags", word, None, **cells)
    for bit in word.bits:
        number: Cell = bit.first if bit.width == 1 else bit.number_text
        cells = {"bit": number, "default": bit.default, **of_ranges(bit.ranges)}
        if bit.is_number:
            scale = bit.as_value.scale_number if bit.as_value.scaled else None
            cells |= {"type": f"{'i' if bit.signed else 'u'}{bit.width}", "unit": bit.unit, "scale": scale}
        yield from of_fact("bit", bit, None, **cells)
    for state in word.states:
        mask, value = word.masked(state)
        yield from of_fact("state", state, code=value, bit=_bits(mask))


def _bits(mask: int) -> str:
    """The bits of a mask as text: `0..2, 6`."""
    bits = [bit for bit in range(mask.bit_length()) if mask >> bit & 1]
    firsts = [bit for bit in bits if bit - 1 not in bits]
    lasts = [bit for bit in bits if bit + 1 not in bits]
    return ", ".join(str(a) if a == b else f"{a}..{b}" for a, b in zip(firsts, lasts, strict=True))


_MESSAGE = "message"


def wire(layout: DeviceLayout) -> Iterator[FactRow]:
    """The rows of links, signals, conversions, messages, and of records that no table has."""
    for link in layout.device.links.values():
        yield from _link(link)
    for signal in layout.device.signals.values():
        yield from of_fact("signal", signal, signal.value, direction=signal.direction)
    for conversion in layout.device.conversions.values():
        yield from _conversion(conversion)
    for message_layout in layout.messages.values():
        yield from _message(layout, message_layout)
    in_tables = {table.record.name for table in layout.tables.values()}
    for record in layout.records.values():
        if record.name not in in_tables:
            yield from of_fact("record", record.record, bytes=record.size)
            yield from fields(f"{record.name}_field", record)


def fields(
    kind: str,
    record: RecordLayout,
    code: int | None = None,
    base: int | None = None,
    direction: str = "",
    access: str = "",
) -> Iterator[FactRow]:
    """The rows of a record's fields.

    `base` is the address of the first element of a table of such records, and `access` that of the table.
    """
    for field in record.stated_fields:
        allowed = narrowed(access, field.field.access)
        cells: FactRow = {"code": code, "access": allowed, "direction": direction, **_address_cells(field, base)}
        cells.update(count=field.field.count, restart=of_flag(field.field.restart), position=_position(field))
        if field.record is not None:
            cells.update(type=field.record.name, bytes=field.record.size)
        if field.field.repeat is not None:
            cells["ranges"] = field.field.repeat.text()
        yield from of_fact(kind, field.field, field.value, **cells)
        for case in field.cases:
            yield from _case(case, code, direction)


def _case(case_layout: CaseLayout, code: int | None, direction: str) -> Iterator[FactRow]:
    """The rows of a case of a field, and of the values of the deciding field that select it."""
    case = case_layout.case
    yield from of_fact("case", case, case.value, code=code, direction=direction)
    for name in case.when:
        yield row("case_value", f"{case.place.path}/when/{name}", case.sources, name=name)


def _position(field: FieldLayout) -> str:
    """The printed position of a field in the data: its words, or else its bytes, counted from 1."""
    span = field.field.word_span or field.field.span
    return "" if span is None else f"{span[0]}" if span[0] == span[1] else f"{span[0]}-{span[1]}"


def _conversion(conversion: Conversion) -> Iterator[FactRow]:
    """The rows of a conversion. Its full scale is the count that stands for the whole reference."""
    cells: FactRow = {"type": conversion.type.name, "bytes": conversion.type.size, "max": conversion.full_scale}
    if conversion.printed:
        cells["printed_name"] = conversion.printed
    yield from of_fact("conversion", conversion, None, **cells)
    path = conversion.place.path
    for kind, key, names in (
        ("conversion_signal", "signals", conversion.signals),
        ("conversion_reference", "references", conversion.references),
    ):
        for number, name in enumerate(names):
            yield row(kind, f"{path}/{key}/{number}", conversion.sources, name=name)


def _message(layout: DeviceLayout, message_layout: MessageLayout) -> Iterator[FactRow]:
    """The rows of a message, of its printed lengths, of the messages that it is sent with, and of its fields."""
    message, kind = message_layout.message, _kind(layout, message_layout.message)
    code = message.number if message.code is None else message.code
    yield from of_fact(kind, message, code=code, number=message.number)
    if message.response_code is not None:
        path = f"{message.place.path}/response_code"
        yield row("response_code", path, message.sources, code=message.response_code, name=message.name)
    if message.remote is not None:
        path = f"{message.place.path}/remote"
        yield row("remote_request", path, message.sources, code=code, name=message.name, bytes=message.remote)
    yield from _lengths(message, code)
    for number, name in enumerate(message.supplements):
        yield row("supplement", f"{message.place.path}/supplements/{number}", message.sources, code=code, name=name)
    for number, name in enumerate(message.answered_on or ()):
        yield row("answered_on", f"{message.place.path}/answered_on/{number}", message.sources, code=code, name=name)
    if not message.is_answered:
        yield row("never_answered", f"{message.place.path}/answered_on", message.sources, code=code, name=message.name)
    if not message.is_requested:
        yield row("never_requested", f"{message.place.path}/requested", message.sources, code=code, name=message.name)
    for direction, record in zip(message_layout.message.directions, message_layout.bodies, strict=True):
        yield from fields(f"{kind}_field", record, code, direction=direction)


def _address_cells(field: FieldLayout, base: int | None) -> FactRow:
    if base is None:
        return {}
    return {"address": base + field.offset // 2, "words": (field.size * (field.count or 1) + 1) // 2}


def _kind(layout: DeviceLayout, message: Message) -> str:
    """What users call a message: the name that its link gives messages, or else that of the code: function, command."""
    sent_on = [link for link in layout.links.values() if message.name in link.messages]
    for link in sent_on:
        if link.link.message_name != _MESSAGE:
            return link.link.message_name
    codes = [part.name for link in sent_on if (part := link.request.role("code")) is not None]
    return codes[0] if codes else _MESSAGE


def _lengths(message: Message, code: int | None) -> Iterator[FactRow]:
    """The rows of the printed lengths of a message's frames, and of the printed words of its data."""
    for direction, length in (("request", message.request_length), ("response", message.response_length)):
        if length is not None:
            path = f"{message.place.path}/frame_length/{direction}"
            cells: FactRow = {"code": code, "bytes": length, "name": direction, "direction": direction}
            yield row("frame_length", path, message.sources, **cells)
    for direction, words in (("request", message.request_words), ("response", message.response_words)):
        if words is not None:
            path = f"{message.place.path}/data_words/{direction}"
            cells = {"code": code, "words": words, "name": direction, "direction": direction}
            yield row("data_words", path, message.sources, **cells)


def _marks(link: Link) -> Iterator[tuple[str, bytes]]:
    """The delimiters of a link with their paths in it."""
    for name, *marks in zip(("start", "end"), link.marks("request"), link.marks("response"), strict=True):
        if marks[0] == marks[1]:
            yield name, marks[0]
        else:
            yield from zip((f"{name}/request", f"{name}/response"), marks, strict=True)


def _link(link: Link) -> Iterator[FactRow]:
    path = link.place.path
    yield from of_fact("link", link)
    for name, mark in _marks(link):
        if mark:
            cells: FactRow = {"name": name, "bytes": len(mark), "printed_name": mark.hex(" ").upper()}
            yield row("mark", f"{path}/{name}", link.sources, **cells)
    if link.preamble is not None:
        cells = {"name": "preamble", "bytes": link.preamble.sent, "printed_name": link.preamble.text()}
        yield row("mark", f"{path}/preamble", link.sources, **cells)
    if link.exception_response is not None:
        error = link.exception_response
        cells = {"name": error.part or "error", "code": error.code or error.flag, "type": error.record}
        yield row("refusal", f"{path}/exception_response", link.exception_response.sources or link.sources, **cells)
    for name, silence, unit in (
        ("characters", link.silence_characters, "character"),
        ("milliseconds", link.silence_milliseconds, "ms"),
    ):
        if silence is not None:
            cells = {"name": "silence", "min": silence, "unit": unit}
            standard = link.standard.get("silence")
            if standard is not None and not link.silence_sources:
                cells.update(provenance=STANDARD, evidence=standard.text())
            sources = link.silence_sources or (() if standard is not None else link.sources)
            yield row("timing", f"{path}/silence/{name}", sources, **cells)
    yield from _unit_addresses(link)
    yield from _serial(link)
    yield from _network(link)
    for direction in ("request", "response"):
        for part in link.parts(direction):
            yield from of_fact("frame_part", part, part.value, direction=direction)


def _unit_addresses(link: Link) -> Iterator[FactRow]:
    addresses = link.unit_addresses
    if addresses is None:
        return
    path, sources = addresses.place.path, addresses.sources or link.sources
    yield row("unit_address", path, sources, name="unit_addresses", **of_ranges(addresses.ranges))
    if addresses.broadcast is not None:
        yield row("unit_address", f"{path}/broadcast", sources, name="broadcast", code=addresses.broadcast)


def _network(link: Link) -> Iterator[FactRow]:
    network = link.network
    if network is None:
        return
    standard = link.standard.get("network")
    for protocol, port in network.ports:
        cells: dict[str, Cell] = {"name": protocol, "ranges": str(port)}
        if standard is not None and not network.sources:
            cells.update(provenance=STANDARD, evidence=standard.text())
        sources = network.sources or (() if standard is not None else link.sources)
        yield row("network", f"{link.place.path}/network/{protocol}", sources, **cells)


def _serial(link: Link) -> Iterator[FactRow]:
    serial = link.serial
    if serial is None:
        return
    settings: tuple[tuple[str, tuple[object, ...], Cell], ...] = (
        ("baud", serial.baud, serial.default_baud),
        ("start_bits", () if serial.start_bits is None else (serial.start_bits,), None),
        ("data_bits", serial.data_bits, serial.default_data_bits),
        ("parity", serial.parity, serial.default_parity or None),
        ("stop_bits", serial.stop_bits, None),
    )
    for name, values, default in settings:
        if values:
            text = ", ".join(map(str, values))
            path = f"{link.place.path}/serial/{name}"
            yield row("serial", path, serial.sources or link.sources, name=name, ranges=text, default=default)
