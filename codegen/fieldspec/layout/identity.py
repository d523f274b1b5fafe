"""A hash over everything that decides what bytes mean, and over nothing else."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator, Mapping
from itertools import chain

from fieldspec.layout.frame import LinkLayout, MessageLayout, PartLayout
from fieldspec.layout.record import FieldLayout, RecordLayout, RegisterLayout
from fieldspec.model.access import narrowed
from fieldspec.model.device import Device
from fieldspec.model.record import RegisterAccess
from fieldspec.model.value import Value

Words = tuple[object, ...]

_HASHED_ROLES = {"checksum": "check", "unit_address": "station"}
"""Words that the hash has in place of roles: another name for a role is no change on the wire."""


def identity(
    device: Device,
    records: Mapping[str, RecordLayout],
    links: Mapping[str, LinkLayout],
    messages: Mapping[str, MessageLayout],
    registers: tuple[RegisterLayout, ...],
) -> str:
    """Sixteen hexadecimal digits that are the same for two layouts if and only if what is on the wire is."""
    digest = hashlib.sha256()
    for words in chain(
        _links(links),
        *map(_record, records.values()),
        _messages(messages),
        _spaces(device),
        _registers(registers),
        _tables(device),
        _parameters(device),
        _conversions(device),
        _words(device),
    ):
        digest.update(("\x1f".join(map(str, words)) + "\n").encode())
    return digest.hexdigest()[:16]


def _value(value: Value | None) -> Words:
    if value is None:
        return ()
    sentinels = [(one.value, one.name, "NaN") if one.is_nan else (one.value, one.name) for one in value.sentinels]
    scaled = (value.scale, value.offset, value.unit)
    return (
        value.type.name,
        value.size,
        *scaled,
        value.ranges,
        value.const,
        value.enum,
        value.flags,
        sentinels,
        value.parameter,
        *((value.write_ranges,) if value.write_ranges is not None else ()),
    )


def _links(links: Mapping[str, LinkLayout]) -> Iterator[Words]:
    for laid in links.values():
        link = laid.link
        stations = (link.unit_addresses.ranges, link.unit_addresses.broadcast) if link.unit_addresses else ()
        error = (link.exception_response.flag, link.exception_response.record) if link.exception_response else ()
        yield "link", link.name, link.encoding, link.start.hex(), link.end.hex(), error, stations, list(laid.messages)
        for frame in (laid.request, laid.response):
            for part in frame.parts:
                role = _HASHED_ROLES.get(part.role, part.role)
                yield part.name, role, part.offset, part.size, part.algorithm, part.order, *_value(part.value)
                yield from _span(part)


def _span(part: PartLayout) -> Iterator[Words]:
    """What a part counts or covers, and whether it is reserved; nothing where it is as in most frames."""
    usual = part.role != "checksum" or (part.start, part.stop) == (0, part.offset)
    if not usual or (part.unit_size, part.base, part.reserved) != (1, 0, False):
        yield "span", part.start, part.stop, part.unit_size, part.base, part.reserved


def _record(record: RecordLayout) -> Iterator[Words]:
    yield "record", record.name
    for field in record.fields:
        yield from _field(field)


def _field(field: FieldLayout) -> Iterator[Words]:
    inner = field.record.name if field.record else ""
    yield "field", field.name, field.offset, field.size, field.count, inner, field.order, field.swapped
    spec = field.field
    filled = spec.value.default if spec.value and spec.reserved else None
    yield spec.measures, spec.reserved, spec.repeat, spec.same_as, filled, *_value(field.value)
    for case in field.cases:
        yield "case", sorted(case.numbers), case.order, case.swapped, *_value(case.value)


def _access(access: RegisterAccess | None) -> str | None:
    """What a message does with registers; in which space is said of the spaces."""
    if access is None:
        return None
    parts = (access.operation, access.start, access.count, access.values)
    return "RegisterAccess(operation={!r}, start={!r}, count={!r}, values={!r})".format(*parts)


def _messages(messages: Mapping[str, MessageLayout]) -> Iterator[Words]:
    for laid in messages.values():
        message = laid.message
        yield "message", message.name, message.code, message.number, message.broadcast, _access(message.accesses)
        for data in (laid.request, laid.response):
            yield from _record(data)


def _spaces(device: Device) -> Iterator[Words]:
    """The spaces, and what lies in each, as far as there are several."""
    for space in device.spaces.values() if device.several_spaces else ():
        yield "space", space.name, space.unit
        yield "registers", [one.name for one in device.registers() if device.space_name(one.space) == space.name]
        yield "tables", [one.name for one in device.tables.values() if device.space_name(one.space) == space.name]
        yield (
            "messages",
            [
                one.name
                for one in device.messages.values()
                if one.accesses is not None and device.space_name(one.accesses.space) == space.name
            ],
        )


def _registers(registers: tuple[RegisterLayout, ...]) -> Iterator[Words]:
    for laid in registers:
        register = laid.register
        yield "register", laid.name, laid.address, laid.words, laid.count, laid.stride, laid.order, laid.swapped
        yield register.index_from, register.access, register.trigger, register.atomic, *_value(register.value)


def _tables(device: Device) -> Iterator[Words]:
    for table in device.tables.values():
        yield "table", table.name, table.base, table.stride, table.count, table.index_from, table.record, table.access
        for field in device.records[table.record].fields:
            access = narrowed(table.access, field.access)
            if access in ("ro", "wo") and access != table.access:
                yield "field of table", field.name, access


def _parameters(device: Device) -> Iterator[Words]:
    for held in device.parameters.values():
        yield "parameters", held.name, held.space, held.base, held.numbers
        for one in held.parameters:
            yield (
                "parameter",
                one.number,
                one.name,
                one.access,
                one.count,
                one.elements,
                one.reserved,
                *_value(one.value),
            )
            yield (one.value.byte_order,)
            for inner in one.subindices:
                yield "subindex", inner.name, inner.indices, inner.reserved, *_value(inner.value)


def _conversions(device: Device) -> Iterator[Words]:
    for one in device.conversions.values():
        yield "conversion", one.name, one.type.name, one.full_scale, one.complement, one.signals, one.references


def _words(device: Device) -> Iterator[Words]:
    for enum in device.enums.values():
        yield "enum", enum.name, enum.open, [(m.name, m.value, m.unavailable) for m in enum.members]
    for flags in device.flags.values():
        bits = [(bit.name, bit.first, bit.last, bit.enum, bit.active, bit.reserved, bit.edge) for bit in flags.bits]
        states = [(state.name, flags.masked(state)) for state in flags.states]
        yield "flags", flags.name, flags.type.name, bits, states
