"""Printed positions of bytes and words, counted from 1 at the start of the data, match the preceding fields
and the type. Fields after one without a fixed size have no printed position.

Why: the manual prints the position of each field. If it is not the end of the preceding fields, a width is
wrong, a field is missing, or the column means something else.

Example: `span: "2"` for a field of two bytes at the start of the data; `word_span: 7` for a field of 32 bits.

Fix: Correct a type or the span, and write an erratum if the manual prints it that way.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from fieldspec.language.checks.facts import layers
from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Place
from fieldspec.language.model.record import Field, Record
from fieldspec.language.model.sizes import RecordSizes

_SPAN = re.compile(r"([0-9]{1,18})(?:-([0-9]{1,18}))?")
_UNITS = {"span": ("byte", 1), "word_span": ("word", 2)}
"""The unit that a key counts, and its size in bytes."""
_MOST_ENDS = 65536

_Span = tuple[int, int]


def spans_match_layout(device: Device) -> Findings:
    sizes = RecordSizes(device)
    starts = _starts(device, sizes)
    for layer in layers(device):
        layer_starts = starts[layer.name] if device.records.get(layer.name) is layer else [0]
        yield from _without_place(layer, sizes)
        for field, offset in sizes.offsets(layer):
            for place, key, printed in () if _has_no_end(field) else _printed(field):
                fitting = (_spans(field, start + offset, sizes, _UNITS[key][1]) for start in layer_starts)
                if not any(printed in spans for spans in fitting):
                    first = _spans(field, layer_starts[0] + offset, sizes, _UNITS[key][1])
                    yield _finding(field, place, key, printed, first)


def _has_no_end(field: Field) -> bool:
    """Whether a field is a text whose characters vary in number."""
    return field.value is not None and field.value.width > 0


def _without_place(layer: Record, sizes: RecordSizes) -> Findings:
    """The findings of the fields of a record that have no place in all data, but a printed one."""
    placed = [field for field, _ in sizes.offsets(layer)]
    if not placed or placed[-1].record in sizes.endless:
        return
    before = placed[-1]
    for field in layer.fields[len(placed) - _has_no_end(before) :]:
        problem = f"no place of its own, as {before.name} before it has no fixed size"
        for place, key, _ in _printed(field):
            text = f"{field.name} has {'no last byte, as it varies in width' if field is before else problem}"
            yield finding(place, key, text, "remove it")


def _starts(device: Device, sizes: RecordSizes) -> dict[str, list[int]]:
    """At which bytes of the data each record may begin: 0, and where messages hold it."""
    starts: dict[str, list[int]] = {name: [0] for name in device.records}
    for layer in layers(device):
        if device.records.get(layer.name) is not layer:
            for field, offset in sizes.offsets(layer):
                if field.record in starts:
                    starts[field.record].append(offset)
    return starts


def _spans(field: Field, offset: int, sizes: RecordSizes, unit: int) -> list[_Span]:
    """The first and last unit of a field, counted from 1; for a repeated field, for each number of elements."""
    bounds = sizes.field(field)
    if bounds is None or offset % unit:
        return []
    ends: set[int] = set()
    elements = sizes.elements(field)
    for element in elements or (1,):
        low, high = bounds
        if field.repeat is not None and elements:
            low, high = field.repeat.low * element, field.repeat.high * element
        elif field.choice is not None:
            low = high = element
        ends.update(range(max(1, low), min(high, low + _MOST_ENDS) + 1, max(1, element)))
    return [(offset // unit + 1, (offset + end) // unit) for end in sorted(ends) if end % unit == 0]


def _printed(field: Field) -> Iterator[tuple[Place, str, _Span]]:
    for key, own in (("span", field.span), ("word_span", field.word_span)):
        if own is not None:
            yield field.place, key, own
        for claim in field.restated:
            span = _parse_span(claim.values.get(key))
            if span is not None:
                yield claim.place, key, span


def _finding(field: Field, place: Place, key: str, printed: _Span, fitting: list[_Span]) -> Diagnostic:
    unit = _UNITS[key][0]
    right = _span_text(fitting[0], unit) if fitting else f"no fixed {unit}s"
    if len(fitting) > 1:
        right += f", up to {_span_text(fitting[-1], unit)}"
    text = f"{field.name} is printed at {_span_text(printed, unit)}, but it is at {right}"
    holder = "type" if field.value is not None else "record" if field.record else "choice"
    help = "correct a type or the span"
    return finding(place, key, text, help, label(field.place, holder, "the field"))


def _span_text(span: _Span, unit: str) -> str:
    return f"{unit} {span[0]}" if span[0] == span[1] else f"{unit}s {span[0]}-{span[1]}"


def _parse_span(text: object) -> _Span | None:
    """`1-4` as its first and last number; None where nothing is written."""
    match = _SPAN.fullmatch(str(text)) if text is not None else None
    return (int(match[1]), int(match[2] or match[1])) if match else None
