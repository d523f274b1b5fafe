"""Values of parameters in pieces, for clients: the arguments of `Segments`."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.codec.layout.segments import SegmentsLayout, segments_of
from fieldspec.language.model.enums import Flags
from fieldspec.language.model.registers import ParameterSet
from fieldspec.language.model.segments import NumberPlace, initial_number
from fieldspec.targets.python.client_names import CODEC
from fieldspec.targets.python.links import Exchange
from fieldspec.targets.python.record_shape import RecordShape
from fieldspec.targets.python.text import literal
from fieldspec.targets.python.writing import tuple_of


def client_segments(
    layout: DeviceLayout, parameter_set: ParameterSet, exchanges: Mapping[str, Exchange]
) -> Iterator[str]:
    """The arguments of a set's access that say how its values follow in pieces, where some do."""
    names = (parameter_set.name, parameter_set.space)
    for key, reads in (("reads", True), ("writes", False)):
        for message in layout.messages.values():
            pieces = segments_of(layout, message)
            number = _part(message.request, "number", names)
            if pieces is not None and pieces.reads is reads and number and message.name in exchanges:
                yield f"{key}=_Segments({', '.join(_arguments(layout, pieces, names, exchanges))})"
                break


def _arguments(
    layout: DeviceLayout, pieces: SegmentsLayout, names: tuple[str, str], exchanges: Mapping[str, Exchange]
) -> Iterator[str]:
    first, piece = exchanges[pieces.first.name], exchanges[pieces.piece.name]
    carrier = piece.response if pieces.reads else piece.request
    yield f"{CODEC}.{piece.request_name}"
    yield literal(_attribute(carrier, pieces.data.name))
    yield str(pieces.data.size)
    if not pieces.reads:
        yield f"first={_first(pieces, names, first)}"
        yield f"whole={_numbers(_whole(layout, names))}"
    fixed = [
        f"{literal(field.name)}: {initial_number(field.field.field, pieces.flags)}"
        for field in piece.request.stored
        if field.field.value is not None and not (not pieces.reads and field.title == pieces.data.name)
    ]
    if fixed:
        yield f"fields={{{', '.join(fixed)}}}"
    if pieces.reads:
        yield f"number_name={literal(_attribute(first.response, pieces.by))}"
        yield f"numbers={_numbers(pieces.numbers)}"
        if pieces.unsized:
            yield f"unsized={_numbers(sorted(pieces.unsized))}"
        if pieces.size is not None:
            yield f"size={literal(_attribute(first.response, pieces.size.name))}"
            yield f"order={literal('little' if pieces.size.order == 'little' else 'big')}"
    if pieces.abort is not None and pieces.abort.message.name in exchanges:
        yield f"abort={_abort(pieces, first, exchanges[pieces.abort.message.name])}"
        yield f'reasons={{"counter": {pieces.abort.counter}, "size": {pieces.abort.size}}}'
    for key, place, shape in (
        ("request_place", pieces.asked, piece.request),
        ("response_place", pieces.answered, piece.response),
        ("unused", pieces.unused, carrier),
        ("last", pieces.last, carrier),
    ):
        if place is not None:
            yield f"{key}={_place(place, shape, pieces.flags)}"


def _first(pieces: SegmentsLayout, names: tuple[str, str], first: Exchange) -> str:
    """The function that makes the request which begins to write."""
    number, index = (_part(pieces.first.request, part, names) for part in ("number", "subindex"))
    size = pieces.size.name if pieces.size is not None else ""
    arguments = []
    for field in first.request.stored:
        own = {number: "parameter.wire_number", index: "subindex", size: "size"}.get(field.title)
        arguments.append(f"{field.name}={own or initial_number(field.field.field, pieces.flags)}")
    return f"lambda parameter, subindex, size: {CODEC}.{first.request_name}({', '.join(arguments)})"


def _abort(pieces: SegmentsLayout, first: Exchange, end: Exchange) -> str:
    """The function that makes the request which ends a transfer."""
    assert pieces.abort is not None
    repeated = {field.title: f"first.{field.name}" for field in first.request.stored}
    arguments = []
    for field in end.request.stored:
        own = "reason" if field.title == pieces.abort.reason else repeated.get(field.title)
        arguments.append(f"{field.name}={own or initial_number(field.field.field, pieces.flags)}")
    return f"lambda first, reason: {CODEC}.{end.request_name}({', '.join(arguments)})"


def _whole(layout: DeviceLayout, names: tuple[str, str]) -> list[int]:
    """The numbers of bytes of values that a message alone writes."""
    sizes: set[int] = set()
    for message in layout.messages.values():
        for field in message.request.fields:
            part = field.value.parameter if field.value is not None else None
            if part is not None and part.part == "value" and part.set in names and field.carries_bytes:
                sizes |= set(field.sizes.values()) or {field.size}
    return sorted(sizes)


def _part(record: RecordLayout, part: str, names: tuple[str, str]) -> str:
    """The name of the field that is a part of an access to a set; empty without one."""
    for field in record.fields:
        own = field.value.parameter if field.value is not None else None
        if own is not None and own.part == part and own.set in names:
            return field.name
    return ""


def _place(place: NumberPlace, shape: RecordShape, flags: Mapping[str, Flags]) -> str:
    value = place.field.value
    ranges = value.ranges.intervals if value is not None and value.ranges is not None else ()
    options = f", initial={initial_number(place.field, flags)}"
    if ranges:
        options += f", ranges={tuple_of([f'({low}, {high})' for low, high in ranges])}"
    name = literal(_attribute(shape, place.field.name))
    return f"_Place({name}, {place.shift}, {place.width}, {place.low}, {place.high}{options})"


def _numbers(numbers: tuple[int, ...] | list[int]) -> str:
    return tuple_of([str(number) for number in numbers])


def _attribute(shape: RecordShape, title: str) -> str:
    """The attribute of a field in the class of a record."""
    return next(field.name for field in shape.fields if field.title == title)
