"""A part or field that carries a length is wide enough for the longest frame.

Why: a frame that is longer than its length field can express cannot exist. The printed number of elements is
too high, or the type is too narrow.

Example: up to 16 points of 16 bytes in a packet whose length is one byte.

Cure: Correct the number of elements or the type, and write an erratum if the manual prints it that way.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.facts import layers
from fieldspec.checks.finding import finding, interval, label
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device
from fieldspec.model.fact import Place
from fieldspec.model.link import Part, PartSpan
from fieldspec.model.record import Field, Record
from fieldspec.model.sizes import RecordSizes, Shape, messages_on, shapes
from fieldspec.model.value import Kind

_CODE = "lengths_hold"
_HELP = "correct the number of elements or the type"


def lengths_hold(device: Device) -> Iterator[Diagnostic]:
    sizes = RecordSizes(device)
    for layer in layers(device):
        fields = {field.name: field for field in layer.fields}
        for field in layer.fields:
            measured = fields.get(field.measures.field) if field.measures is not None else None
            if measured is not None:
                yield from _of_field(field, measured, sizes)
    for direction in ("request", "response"):
        yield from _of_links(device, direction, sizes)


def _of_field(field: Field, measured: Field, sizes: RecordSizes) -> Iterator[Diagnostic]:
    if field.value is None or field.measures is None or field.value.type.kind is not Kind.INTEGER:
        return
    if field.measures.of == "bytes":
        both = sizes.field(measured)
    elif measured.repeat is not None:
        both = measured.repeat.low, measured.repeat.high
    else:
        both = measured.count or 1, measured.count or 1
    if both is None:
        return
    least, most = (size + field.measures.plus for size in both)
    what = "bytes" if field.measures.of == "bytes" else "elements"
    there = label(measured.place, "repeat" if "repeat" in measured.place else "name", "what it measures")
    plus = f" plus {field.measures.plus}" if field.measures.plus else ""
    text = f"{field.name} counts {interval(least, most)} {what} of {measured.name}{plus}"
    if least < 0:
        help = "correct `plus` or the number of elements"
        yield finding(_CODE, field.place, "measures", f"{text}, but no number of {what} is below zero", help, there)
    if most > field.value.type.high:
        text += f", but the maximum of {field.value.type.name} is {field.value.type.high}"
        yield finding(_CODE, field.place, "type", text, _HELP, there)


def _of_links(device: Device, direction: str, sizes: RecordSizes) -> Iterator[Diagnostic]:
    for shape in shapes(device, direction):
        part = next((part for part in shape.link.parts(direction) if part.role == "length"), None)
        if part is None or part.value is None or part.value.type.kind is not Kind.INTEGER:
            continue
        for message in messages_on(device, shape.link):
            data = message.request if direction == "request" else message.response
            yield from _of_data(shape, part, f"{direction} of {message.name}", (message.place, direction), data, sizes)
        error = shape.link.exception_response
        if direction == "response" and error is not None and error.record in device.records:
            record = device.records[error.record]
            yield from _of_data(
                shape,
                part,
                f"exception response on {shape.link.name}",
                (shape.link.place, "exception_response"),
                record,
                sizes,
            )


def _of_data(
    shape: Shape, part: Part, what: str, at: tuple[Place, str], data: Record, sizes: RecordSizes
) -> Iterator[Diagnostic]:
    """Whether a length part holds what it counts of the frames with some data."""
    both = sizes.bounds(data)
    if both is None or part.value is None:
        return
    value, unit = part.value, part.unit_size
    low, high = (value.low, value.high) if value.ranges is None else (value.ranges.low, value.ranges.high)
    least, most = (shape.span_size(part, size) for size in both)
    there = label(part.place, "type", part.name)
    longest, shortest = -(-most // unit) + part.plus, least // unit + part.plus
    if longest > high:
        text = f"{part.name} would be {longest} in the longest {what}"
        if (part.span, unit, part.plus) == (PartSpan("", ""), 1, 0):
            text = f"the longest {what} has {longest} bytes"
        yield finding(_CODE, *at, f"{text}; the maximum of {part.name} is {high}", _HELP, there)
    if shortest < low:
        text = f"{part.name} would be {shortest} in the shortest {what}; its minimum is {low}"
        yield finding(_CODE, *at, text, _HELP, there)
    if least == most and least % unit:
        text = f"the {what} has {least} counted bytes, which is not a whole number of words"
        help = "add a field that fills the last word, or exclude the link with the message's `links`"
        yield finding(_CODE, *at, text, help, there)
