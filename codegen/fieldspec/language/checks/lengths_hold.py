"""A part or field that carries a length is wide enough for the longest frame.

Why: a frame that is longer than its length field can express cannot exist. The printed number of elements is
too high, or the type is too narrow. A field that counts the bytes of records of varying size only needs room for the
shortest ones, and for one element: encoders refuse longer data.

Example: up to 16 points of 16 bytes in a packet whose length is one byte.

Fix: Correct the number of elements or the type, and write an erratum if the manual prints it that way.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.foundation.classes import dataclass, replace
from fieldspec.foundation.source import Span
from fieldspec.language.checks.facts import layers
from fieldspec.language.checks.finding import Findings, finding, interval, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_count
from fieldspec.language.model.fact import Place
from fieldspec.language.model.link import Part, PartSpan
from fieldspec.language.model.record import Field, Measure
from fieldspec.language.model.sizes import RecordSizes, messages_sent, shapes
from fieldspec.language.model.value import Value

_HELP = "correct the number of elements or the type"


def lengths_hold(device: Device) -> Findings:
    sizes = RecordSizes(device)
    for layer in layers(device):
        fields = {field.name: field for field in layer.fields}
        for field in layer.fields:
            measure = field.stated_measure
            measured = fields.get(measure.field) if measure is not None else None
            if measure is not None and measured is not None:
                yield from _of_field(field, measure, measured, sizes)
    frames = [frame for direction in ("request", "response") for frame in _frames(device, direction, sizes)]
    for frame in frames:
        yield from _of_data(frame)
    yield from _of_words([frame for frame in frames if frame.least == frame.most])


@dataclass(frozen=True, slots=True, eq=False)
class _Frame:
    """Frames with the same data, where a finding of them has its place, and the least and the most counted bytes."""

    name: str
    place: Place
    key: str
    part: Part
    value: Value
    least: int
    most: int


def _of_field(field: Field, measure: Measure, measured: Field, sizes: RecordSizes) -> Findings:
    if field.value is None or not is_count(field.value.encoding):
        return
    if measure.of == "bytes":
        bounds = sizes.field(measured)
    elif measured.repeat is not None:
        bounds = measured.repeat.low, measured.repeat.high
    else:
        bounds = measured.count or 1, measured.count or 1
    if bounds is None:
        return
    minimum, maximum = (size + measure.plus for size in bounds)
    if measure.of == "bytes" and measured.record and sizes.element(measured) is None:
        single = sizes.field(replace(measured, repeat=None, count=None))
        maximum = max(minimum, single[0] + measure.plus) if single is not None else minimum
    unit = "bytes" if measure.of == "bytes" else "elements"
    related_label = label(measured.place, "repeat" if "repeat" in measured.place else "name", "what it measures")
    plus = f" plus {measure.plus}" if measure.plus else ""
    text = f"{field.name} counts {interval(minimum, maximum)} {unit} of {measured.name}{plus}"
    if minimum < 0:
        help = "correct `plus` or the number of elements"
        yield finding(field.place, "measures", f"{text}, but no number of {unit} is below zero", help, related_label)
    type_text, limit = field.value.type.name, field.value.high
    if measure.bits is not None:
        low, high = measure.bits
        type_text, limit = f"bits {low}..{high}", (2 << high - low) - 1
    if maximum > limit:
        text += f", but the maximum of {type_text} is {limit}"
        yield finding(field.place, "type" if measure.bits is None else "measures", text, _HELP, related_label)


def _frames(device: Device, direction: str, sizes: RecordSizes) -> Iterator[_Frame]:
    """The frames with a length part, by what they contain."""
    for shape in shapes(device, direction):
        data = [
            (f"{direction} of {message.name}", message.place, direction, getattr(message, direction))
            for message in messages_sent(device, shape.link, direction)
        ]
        error = shape.link.exception_response
        if direction == "response" and error is not None and error.record in device.records:
            name = f"exception response on {shape.link.name}"
            data.append((name, shape.link.place, "exception_response", device.records[error.record]))
        for part in shape.link.parts(direction):
            if part.role != "length" or part.value is None or not is_count(part.value.encoding):
                continue
            for name, place, key, record in data:
                bounds = sizes.bounds(record)
                if bounds is not None:
                    minimum, maximum = (shape.span_size(part, size) for size in bounds)
                    yield _Frame(name, place, key, part, part.value, minimum, maximum)


def _of_data(frame: _Frame) -> Findings:
    """The findings of a length part that cannot have the length of frames with some data."""
    value, unit, part, frame_name = frame.value, frame.part.unit_size, frame.part, frame.name
    low, high = (value.low, value.high) if value.ranges is None else (value.ranges.low, value.ranges.high)
    related_label = label(part.place, "type", part.name)
    longest, shortest = -(-frame.most // unit) + part.plus, frame.least // unit + part.plus
    if longest > high:
        text = f"{part.name} would be {longest} in the longest {frame_name}"
        if (part.span, unit, part.plus) == (PartSpan("", ""), 1, 0):
            text = f"the longest {frame_name} has {longest} bytes"
        text = f"{text}; the maximum of {part.name} is {high}"
        yield finding(frame.place, frame.key, text, _help(part), related_label)
    if shortest < low:
        text = f"{part.name} would be {shortest} in the shortest {frame_name}; its minimum is {low}"
        yield finding(frame.place, frame.key, text, _help(part), related_label)


def _help(part: Part) -> str:
    """The help for a length part that cannot have the length of its frames."""
    return "correct `plus`, the number of elements or the type" if part.plus else _HELP


def _of_words(frames: list[_Frame]) -> Findings:
    """Whether frames of one size have whole words where words are counted: if none has, the length part is wrong."""
    by_part: dict[Span, list[_Frame]] = {}
    for frame in frames:
        by_part.setdefault(frame.part.place.whole, []).append(frame)
    for alike in by_part.values():
        part = alike[0].part
        odd = [frame for frame in alike if frame.least % part.unit_size]
        if len(odd) == len(alike) > 1:
            text = f"{part.name} counts words, but no frame has a whole number of them: the {odd[0].name}"
            text += f" has {odd[0].least} counted bytes"
            help = "remove `in: words`, or correct the parts that are counted"
            yield finding(part.place, "measures", text, help)
            continue
        for frame in odd:
            text = f"the {frame.name} has {frame.least} counted bytes, which is not a whole number of words"
            help = "add a field that fills the last word, or exclude the link with the message's `links`"
            yield finding(frame.place, frame.key, text, help, label(part.place, "type", part.name))
