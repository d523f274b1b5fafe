"""The hash of everything that a program must be told of a device, and of nothing else.

That is what a comparison of two devices calls a change of more than documentation. A key that equals its default, such
as the whole range of a type, counts as left out, and lists whose order has no meaning are sorted.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterator, Mapping
from itertools import chain
from operator import attrgetter
from typing import Any, TypeVar

from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.identity_parts import part_words
from fieldspec.codec.layout.identity_words import Words, bounding, order_of, orders_in, shortest, value_words
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.record import FieldLayout, RecordLayout, RegisterLayout
from fieldspec.foundation.caches import ByIdentity
from fieldspec.foundation.classes import attributes
from fieldspec.language.model.address_space import WHOLE, WORD
from fieldspec.language.model.attributes import descendants
from fieldspec.language.model.device import Device
from fieldspec.language.model.enums import Enum, Flags
from fieldspec.language.model.link import Serial
from fieldspec.language.model.record import STEP_FIELDS, Field, RegisterAccess, Segments
from fieldspec.language.model.texts import Limit
from fieldspec.language.model.value import HANDLING_KEYS, UNSPECIFIED

T = TypeVar("T")


def identity(
    device: Device,
    records: Mapping[str, RecordLayout],
    links: Mapping[str, LinkLayout],
    messages: Mapping[str, MessageLayout],
    registers: tuple[RegisterLayout, ...],
) -> str:
    """Sixteen hexadecimal digits. Two layouts have the same ones if what programs must be told of both is the same."""
    frames = chain(
        _links(links),
        [("order of words", device.word_order or device.byte_order)],
        *map(_record, _by_name(records)),
        _messages(messages),
        _units(device),
        _spaces(device),
    )
    values = chain(_tables(device), _signals(device, records, messages), _parameters(device), _conversions(device))
    texts = chain(
        map(_text, frames),
        _registers(registers),
        map(_text, values),
        _enums_and_flags(device),
        map(_text, sorted(_operation(device))),
    )
    return hashlib.sha256("".join(texts).encode()).hexdigest()[:16]


def _text(words: Words) -> str:
    return "\x1f".join(map(str, words)) + "\n"


def _links(links: Mapping[str, LinkLayout]) -> Iterator[Words]:
    for link_layout in _by_name(links):
        link = link_layout.link
        addresses = (link.unit_addresses.ranges, link.unit_addresses.broadcast) if link.unit_addresses else ()
        error = (link.exception_response.flag, link.exception_response.record) if link.exception_response else ()
        if link.exception_response is not None and not link.exception_response.flag:
            error = (*error, link.exception_response.code, link.exception_response.part, link.exception_response.normal)
            error = (*error, link.exception_response.field) if link.exception_response.field else error
        yield (
            "link",
            link.name,
            link.transmission,
            link.start.hex(),
            link.end.hex(),
            error,
            addresses,
            sorted(link_layout.messages),
        )
        if not link.has_common_delimiters:
            yield "response_delimiters", *(mark.hex() for mark in link.delimiters("response"))
        if link.preamble is not None:
            yield "preamble", link.preamble.byte, link.preamble.least, link.preamble.most, link.preamble.sent
        unanswered = link_layout.messages.keys() - link_layout.carried("response").keys()
        if unanswered:
            yield "unanswered", sorted(unanswered)
        own_accord = link_layout.messages.keys() - link_layout.carried("request").keys()
        if own_accord:
            yield "not requested", sorted(own_accord)
        if link_layout.barred_messages:
            yield "not broadcast", sorted(link_layout.barred_messages)
        if link.serial is not None:
            yield "serial", *(getattr(link.serial, name) for name in attributes(Serial) if name != "sources")
        if link.network is not None:
            yield "network", link.network.tcp, link.network.udp
        yield "silence", *map(str, (link.silence_characters, link.silence_milliseconds)), link.is_default
        if link.escape is not None:
            yield "escape", link.escape
        for frame in (link_layout.request, link_layout.response):
            for part in frame.parts:
                yield from part_words(part)


def _record(record: RecordLayout) -> Iterator[Words]:
    yield "record", record.name
    if record.inner_lists is not None:
        yield "inner lists", [inner.first for inner in record.inner_lists.lists]
    yield "size", record.size
    for field in record.fields:
        if not field.field.reserved or field.count != 1:
            yield from _field(field)
        elif field.value is not None and (field.value.const or field.value.default):
            yield "filled", field.offset, field.size, field.order, field.value.const, field.value.default


def _field(field: FieldLayout) -> Iterator[Words]:
    inner = field.record.name if field.record else ""
    order = order_of(field.value, field.order)
    yield "field", field.name, field.offset, field.size, field.count, inner, order, field.swapped
    spec = field.field
    filled = spec.value.default if spec.value and spec.reserved else None
    measures = spec.measures
    text = None if measures is None else f"Measure(of={measures.of!r}, field={measures.field!r})"
    if measures is not None and measures.plus:
        yield "plus", measures.plus
    if field.bits_of:
        yield "bits of", field.bits_of
    if spec.count == 1:
        yield ("a list",)
    yield text, spec.reserved, spec.repeat, spec.same_as, filled, *value_words(field.value)
    if field.selector is not None:
        yield "decided by", field.selector.name, *(() if field.deciding_bits is None else (field.deciding_bits,))
    if field.presence is not None and field.presence.numbers:
        yield "present by", field.presence.by, field.presence.mask, field.presence.number_list
    if field.continuation is not None:
        continuation = field.continuation.presence
        yield "more if", continuation.by, continuation.mask, continuation.number_list
    if spec.bit_measure is not None:
        yield "counts in bits", spec.bit_measure.text
    for case in sorted(field.cases, key=lambda case: sorted(case.numbers)):
        yield "case", sorted(case.numbers), order_of(case.value, case.order), case.swapped, *value_words(case.value)


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
    for message_layout in _by_name(messages):
        message = message_layout.message
        yield (
            "message",
            message.name,
            message.code,
            message.number if message.code is None else None,
            *((message.response_code,) if message.response_code not in (None, message.code) else ()),
            *(("remote", message.remote) if message.remote is not None else ()),
            message.broadcast is True,
            _access(message.single_access),
            *_segments(message.segments),
            *(_step(step) for step in message.access_steps),
        )
        for data in message_layout.bodies:
            yield from _record(data)


def _units(device: Device) -> Iterator[Words]:
    """The factors of the units that the spec declares."""
    for declared in _by_name(device.units):
        yield "unit", declared.symbol, declared.quantity, declared.factor


def _spaces(device: Device) -> Iterator[Words]:
    """The spaces with their contents, if there are several; of a single one, what is not usual of it."""
    for space in _by_name(device.spaces):
        if not device.several_spaces and space.unit != WORD:
            yield "addresses of", space.unit
        if space.bounds != WHOLE:
            yield "addresses", space.bounds
    for space in _by_name(device.spaces) if device.several_spaces else ():
        yield "space", space.name, space.unit
        yield (
            "registers",
            sorted(register.name for register in device.registers() if device.space_name(register.space) == space.name),
        )
        yield (
            "tables",
            [table.name for table in _by_name(device.tables) if device.space_name(table.space) == space.name],
        )
        yield (
            "messages",
            [
                message.name
                for message in _by_name(device.messages)
                if message.single_access is not None and device.space_name(message.single_access.space) == space.name
            ],
        )


def _registers(registers: tuple[RegisterLayout, ...]) -> Iterator[str]:
    for register_layout in sorted(registers, key=attrgetter("name")):
        if not register_layout.register.reserved:
            yield _TEXTS.get_or_compute(register_layout, _register_text)


def _register_text(register_layout: RegisterLayout) -> str:
    register = register_layout.register
    place = (
        "register",
        register_layout.name,
        register_layout.address,
        register_layout.words,
        register_layout.count,
        register_layout.stride if register_layout.count > 1 else register_layout.words,
        order_of(register.value, register_layout.order),
        register_layout.swapped,
    )
    use = register.index_from, register.access, register.trigger, register.atomic, *value_words(register.value)
    if not register.value.write_word_order:
        return _text(place) + _text(use)
    order = "words of a write", register.value.write_swapped(register_layout.swapped)
    return _text(place) + _text(use) + _text(order)


def _tables(device: Device) -> Iterator[Words]:
    for table in _by_name(device.tables):
        yield "table", table.name, table.base, table.stride, table.count, table.index_from, table.record, table.access
        if table.count_by:
            yield "elements of table", table.count_by
        if table.base_by:
            yield "base of table", table.base_by


def _signals(
    device: Device, records: Mapping[str, RecordLayout], messages: Mapping[str, MessageLayout]
) -> Iterator[Words]:
    """Signals that no field has with their name and their value, and fields that have one under another name."""
    bodies = (*records.values(), *(body for message in messages.values() for body in message.bodies))
    fields = [field.field for body in bodies for field in body.fields if field.field.signal]
    alike = {
        field.signal for field in fields if value_words(field.value) == value_words(device.signals[field.signal].value)
    }
    renamed = {(field.name, field.signal) for field in fields if field.name != field.signal}
    yield from (("field of signal", *names) for names in sorted(renamed))
    yield from (
        ("signal", name, *value_words(signal.value)) for name, signal in device.signals.items() if name not in alike
    )


def _parameters(device: Device) -> Iterator[Words]:
    for parameter_set in _by_name(device.parameters):
        yield "parameters", parameter_set.name, parameter_set.space, parameter_set.base, parameter_set.numbers
        for parameter in sorted(parameter_set.parameters, key=attrgetter("number")):
            if parameter.reserved:
                continue
            yield (
                "parameter",
                parameter.number,
                parameter.name,
                parameter.access,
                parameter.count,
                parameter.elements or 1,
                *value_words(parameter.value),
            )
            yield orders_in(device, parameter.value)
            for inner in sorted(parameter.subindices, key=lambda inner: inner.indices.intervals):
                if inner.reserved:
                    continue
                yield "subindex", inner.name, inner.indices, *value_words(inner.value), *orders_in(device, inner.value)
                if inner.access:
                    yield "access", inner.access


def _conversions(device: Device) -> Iterator[Words]:
    for conversion in _by_name(device.conversions):
        yield (
            "conversion",
            conversion.name,
            conversion.type.name,
            conversion.full_scale,
            conversion.complement,
            conversion.signals,
            conversion.references,
        )


def _enums_and_flags(device: Device) -> Iterator[str]:
    for enum in _by_name(device.enums):
        yield _TEXTS.get_or_compute(enum, _enum_text)
    for flags in _by_name(device.flags):
        yield _TEXTS.get_or_compute(flags, _flags_text)


_TEXTS: ByIdentity[Any, str] = ByIdentity(limit=30_000)
"""The texts of registers, enums and flags, which versions share, and mostly the next build too."""


def _enum_text(enum: Enum) -> str:
    members = [
        (member.value, member.name, *sorted(member.aliases)) for member in enum.members if not member.unavailable
    ]
    return _text(("enum", enum.name, enum.open, sorted(members)))


def _flags_text(flags: Flags) -> str:
    bits = [
        (bit.name, bit.first, bit.last, bit.enum, bit.active, bit.edge)
        + ((bit.signed, str(shortest(bit.scale)), str(shortest(bit.offset)), bit.unit) if bit.is_number else ())
        + ((ranges,) if (ranges := bounding(bit.ranges, bit.low, bit.high)) is not None else ())
        + (("default", bit.default) if bit.default is not None else ())
        + (("pieces", *bit.pieces) if bit.pieces else ())
        for bit in sorted(flags.bits, key=attrgetter("first", "name"))
        if not bit.reserved
    ]
    states = sorted((state.name, flags.masked(state)) for state in flags.states)
    is_bounded = bounding(flags.ranges, flags.type.low, flags.type.high) is not None
    words = "flags", flags.name, flags.type.name, bits, states
    return _text(words) + (_text(("range", flags.ranges)) if is_bounded else "")


_ASKED = ("trigger", "atomic", "applies_to", "messages", "supplements")
"""What facts state of their use, besides their handling."""


def _operation(device: Device) -> Iterator[tuple[str, ...]]:
    """The relevant data of facts and of the device besides its frames: limits, restarts and storage of values."""
    for item in descendants(device):
        yield from _USES.get_or_compute(item, lambda item: tuple(_uses(item)))


_USES: ByIdentity[Any, tuple[tuple[str, ...], ...]] = ByIdentity(limit=50_000)
"""The relevant data of model objects, which versions share, and mostly the next build too."""


def _uses(item: Any) -> Iterator[tuple[str, ...]]:
    if isinstance(item, Limit):
        yield "limit", item.name, *map(str, (item.value, item.low, item.high)), item.text, item.unit
    stated = [(key, value) for key in _ASKED if (value := getattr(item, key, None)) not in (None, False, ())]
    restart = getattr(item, "restart", None)
    stated += [("restart", restart)] if restart is not None else []
    stated += [("access", item.access)] if isinstance(item, Field) and item.access else []
    handling = getattr(item, "handling", UNSPECIFIED)
    if (stated or handling != UNSPECIFIED) and not getattr(item, "reserved", False):
        yield type(item).__name__, item.place.path, str(stated), *(str(getattr(handling, key)) for key in HANDLING_KEYS)


def _by_name(items: Mapping[str, T]) -> list[T]:
    """The items of a mapping in an order that does not depend on that of the spec."""
    return [items[name] for name in sorted(items)]
