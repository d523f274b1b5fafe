"""The hash of everything that gives bytes their meaning, and of nothing else."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator, Mapping
from itertools import chain

from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.part import PartLayout
from fieldspec.codec.layout.record import FieldLayout, RecordLayout, RegisterLayout
from fieldspec.language.model.access import narrowed
from fieldspec.language.model.device import Device
from fieldspec.language.model.record import STEP_FIELDS, RegisterAccess, Segments
from fieldspec.language.model.value import ParameterPart, Sentinel, Value

Words = tuple[object, ...]

_HASHED_ROLES = {"checksum": "check", "unit_address": "station"}
"""The words for roles in the hash. With them, a rename of a role changes no identity."""


def identity(
    device: Device,
    records: Mapping[str, RecordLayout],
    links: Mapping[str, LinkLayout],
    messages: Mapping[str, MessageLayout],
    registers: tuple[RegisterLayout, ...],
) -> str:
    """Sixteen hexadecimal digits. Two layouts have the same ones if and only if they exchange the same bytes."""
    digest = hashlib.sha256()
    for words in chain(
        _links(links),
        *map(_record, records.values()),
        _messages(messages),
        _units(device),
        _spaces(device),
        _registers(registers),
        _tables(device),
        _parameters(device),
        _conversions(device),
        _words(device),
    ):
        digest.update(("\x1f".join(map(str, words)) + "\n").encode())
    return digest.hexdigest()[:16]


def _last(sentinel: Sentinel) -> Words:
    if sentinel.is_nan:
        return ("NaN",)
    return () if sentinel.last is None else (sentinel.last,)


def _value(value: Value | None) -> Words:
    if value is None:
        return ()
    sentinels = [(sentinel.value, sentinel.name, *_last(sentinel)) for sentinel in value.sentinels]
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
        _part(value.parameter),
        *((value.write_ranges,) if value.write_ranges is not None else ()),
        *((value.digits, value.places) if value.digits else ()),
        *(("blanks",) if value.has_blanks else ()),
        *((value.text_form,) if value.text_form is not None else ()),
        *(("turned",) if value.text_form is not None and value.text_form.is_turned else ()),
        *(("width", value.width) if value.width else ()),
    )


def _part(part: ParameterPart | None) -> str | None:
    """The part that a value has in an access to parameters: number, subindex or value."""
    if part is None:
        return None
    text = f"ParameterPart(set={part.set!r}, part={part.part!r}, number={part.number!r})"
    if part.sizes is None:
        return text
    return f"{text} by {part.sizes.by}: {[(case.bytes, case.when) for case in part.sizes.cases]}"


def _links(links: Mapping[str, LinkLayout]) -> Iterator[Words]:
    for link_layout in links.values():
        link = link_layout.link
        addresses = (link.unit_addresses.ranges, link.unit_addresses.broadcast) if link.unit_addresses else ()
        error = (link.exception_response.flag, link.exception_response.record) if link.exception_response else ()
        if link.exception_response is not None and not link.exception_response.flag:
            error = (*error, link.exception_response.code, link.exception_response.part, link.exception_response.normal)
            error = (*error, link.exception_response.field) if link.exception_response.field else error
        yield (
            "link",
            link.name,
            link.encoding,
            link.start.hex(),
            link.end.hex(),
            error,
            addresses,
            list(link_layout.messages),
        )
        if not link.has_common_delimiters:
            yield "response_delimiters", *(mark.hex() for mark in link.delimiters("response"))
        unanswered = link_layout.messages.keys() - link_layout.carried("response").keys()
        if unanswered:
            yield "unanswered", sorted(unanswered)
        own_accord = link_layout.messages.keys() - link_layout.carried("request").keys()
        if own_accord:
            yield "not requested", sorted(own_accord)
        if link_layout.barred_messages:
            yield "not broadcast", sorted(link_layout.barred_messages)
        if link.escape is not None:
            yield "escape", link.escape
        for frame in (link_layout.request, link_layout.response):
            for part in frame.parts:
                role = _HASHED_ROLES.get(part.role, part.role)
                yield part.name, role, part.offset, part.size, part.algorithm, part.order, *_value(part.value)
                yield from _span(part)


def _span(part: PartLayout) -> Iterator[Words]:
    """What a part counts, covers or repeats, and whether it is reserved; nothing for what most frames have."""
    usual = part.role != "checksum" or (part.start, part.stop) == (0, part.offset)
    if not usual or (part.unit_size, part.base, part.reserved) != (1, 0, False):
        yield "span", part.start, part.stop, part.unit_size, part.base, part.reserved
    if part.digits:
        yield "digits", part.digits
    if part.before_escape and not part.escaped:
        yield ("before escape",)
    if part.part.same_as:
        yield "repeats", part.part.same_as


def _record(record: RecordLayout) -> Iterator[Words]:
    yield "record", record.name
    if record.inner_lists is not None:
        yield "inner lists", [inner.first for inner in record.inner_lists.lists]
    for field in record.fields:
        yield from _field(field)


def _field(field: FieldLayout) -> Iterator[Words]:
    inner = field.record.name if field.record else ""
    yield "field", field.name, field.offset, field.size, field.count, inner, field.order, field.swapped
    spec = field.field
    filled = spec.value.default if spec.value and spec.reserved else None
    measures = spec.measures
    text = None if measures is None else f"Measure(of={measures.of!r}, field={measures.field!r})"
    if measures is not None and measures.plus:
        yield "plus", measures.plus
    if field.bits_of:
        yield "bits of", field.bits_of
    yield text, spec.reserved, spec.repeat, spec.same_as, filled, *_value(field.value)
    for case in field.cases:
        yield "case", sorted(case.numbers), case.order, case.swapped, *_value(case.value)


def _access(access: RegisterAccess | None) -> str | None:
    """How a message accesses registers. Its space is stated with the spaces."""
    if access is None:
        return None
    parts = (access.operation, access.start, access.count, access.values)
    text = "RegisterAccess(operation={!r}, start={!r}, count={!r}, values={!r})".format(*parts)
    return text if access.set is None else f"{text} set={access.set} clear={access.clear}"


def _step(step: RegisterAccess) -> tuple[str, ...]:
    """A step of a message that accesses registers in several ones."""
    return ("step", step.operation, step.space, *(getattr(step, key) for key in STEP_FIELDS))


def _segments(segments: Segments | None) -> Iterator[object]:
    """The form in which a value follows a message in pieces; empty where none does."""
    if segments is not None:
        yield "segments"
        yield from (segments.message, segments.when, segments.size, segments.unsized, segments.data)
        yield from (segments.counter, segments.unused, segments.last)
        if segments.abort is not None:
            own = segments.abort
            yield from ("abort", own.message, own.reason, own.counter, own.size)


def _messages(messages: Mapping[str, MessageLayout]) -> Iterator[Words]:
    for message_layout in messages.values():
        message = message_layout.message
        yield (
            "message",
            message.name,
            message.code,
            message.number,
            *((message.response_code,) if message.response_code is not None else ()),
            message.broadcast is True,
            _access(message.accesses),
            *_segments(message.segments),
            *(_step(step) for step in message.access_steps),
        )
        for data in message_layout.bodies:
            yield from _record(data)


def _units(device: Device) -> Iterator[Words]:
    """What the units that the spec declares are worth."""
    for declared in device.units.values():
        yield "unit", declared.symbol, declared.quantity, declared.factor


def _spaces(device: Device) -> Iterator[Words]:
    """The spaces with their contents, if there are several."""
    for space in device.spaces.values() if device.several_spaces else ():
        yield "space", space.name, space.unit
        yield (
            "registers",
            [register.name for register in device.registers() if device.space_name(register.space) == space.name],
        )
        yield "tables", [table.name for table in device.tables.values() if device.space_name(table.space) == space.name]
        yield (
            "messages",
            [
                message.name
                for message in device.messages.values()
                if message.accesses is not None and device.space_name(message.accesses.space) == space.name
            ],
        )


def _registers(registers: tuple[RegisterLayout, ...]) -> Iterator[Words]:
    for register_layout in registers:
        register = register_layout.register
        yield (
            "register",
            register_layout.name,
            register_layout.address,
            register_layout.words,
            register_layout.count,
            register_layout.stride,
            register_layout.order,
            register_layout.swapped,
        )
        yield register.index_from, register.access, register.trigger, register.atomic, *_value(register.value)


def _tables(device: Device) -> Iterator[Words]:
    for table in device.tables.values():
        yield "table", table.name, table.base, table.stride, table.count, table.index_from, table.record, table.access
        if table.count_by:
            yield "elements of table", table.count_by
        if table.base_by:
            yield "base of table", table.base_by
        for field in device.records[table.record].fields:
            access = narrowed(table.access, field.access)
            if access in ("ro", "wo") and access != table.access:
                yield "field of table", field.name, access


def _parameters(device: Device) -> Iterator[Words]:
    for parameter_set in device.parameters.values():
        yield "parameters", parameter_set.name, parameter_set.space, parameter_set.base, parameter_set.numbers
        for parameter in parameter_set.parameters:
            yield (
                "parameter",
                parameter.number,
                parameter.name,
                parameter.access,
                parameter.count,
                parameter.elements,
                parameter.reserved,
                *_value(parameter.value),
            )
            yield (parameter.value.byte_order,)
            for inner in parameter.subindices:
                yield "subindex", inner.name, inner.indices, inner.reserved, *_value(inner.value)
                if inner.access:
                    yield "access", inner.access


def _conversions(device: Device) -> Iterator[Words]:
    for conversion in device.conversions.values():
        yield (
            "conversion",
            conversion.name,
            conversion.type.name,
            conversion.full_scale,
            conversion.complement,
            conversion.signals,
            conversion.references,
        )


def _words(device: Device) -> Iterator[Words]:
    for enum in device.enums.values():
        yield "enum", enum.name, enum.open, [(m.name, m.value, m.unavailable, *m.aliases) for m in enum.members]
    for flags in device.flags.values():
        bits = [
            (bit.name, bit.first, bit.last, bit.enum, bit.active, bit.reserved, bit.edge)
            + ((bit.signed, str(bit.scale), str(bit.offset), bit.unit) if bit.is_number else ())
            + ((bit.ranges,) if bit.ranges is not None else ())
            for bit in flags.bits
        ]
        states = [(state.name, flags.masked(state)) for state in flags.states]
        yield "flags", flags.name, flags.type.name, bits, states
