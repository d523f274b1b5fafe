"""Printed byte positions, counted from 1 in the data, are those that the fields before and the type make.

Why: the manual prints where each field lies. Where that is not where the fields before it end, one of
the widths is wrong, a field is missing, or the column holds something else.

Example: `span: "2"` for a field of two bytes that begins with the data.

Cure: Put a type or the span right, and write an erratum if it is printed so.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from fieldspec.checks.finding import finding, label
from fieldspec.checks.sizes import Sizes
from fieldspec.checks.walking import layers
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device
from fieldspec.model.place import Place
from fieldspec.model.record import Field

_SPAN = re.compile(r"([0-9]{1,18})(?:-([0-9]{1,18}))?")


def spans_match_layout(device: Device) -> Iterator[Diagnostic]:
    sizes = Sizes(device)
    starts = _starts(device, sizes)
    for layer in layers(device):
        begins = starts[layer.name] if device.records.get(layer.name) is layer else [0]
        for field, offset in sizes.offsets(layer):
            for place, printed in _printed(field):
                fitting = [_spans(field, start + offset, sizes) for start in begins]
                if not any(printed in spans for spans in fitting):
                    yield _finding(field, place, printed, fitting[0])


def _starts(device: Device, sizes: Sizes) -> dict[str, list[int]]:
    """At which bytes of the data each record may begin: 0, and where messages hold it."""
    starts: dict[str, list[int]] = {name: [0] for name in device.records}
    for layer in layers(device):
        if device.records.get(layer.name) is not layer:
            for field, offset in sizes.offsets(layer):
                if field.record in starts:
                    starts[field.record].append(offset)
    return starts


def _spans(field: Field, offset: int, sizes: Sizes) -> list[tuple[int, int]]:
    """The first and last byte of a field, counted from 1; those of a repeated one for each number of elements."""
    both = sizes.field(field)
    if both is None:
        return []
    element = max(1, sizes.element(field) or 1)
    ends = range(both[0], min(both[1], both[0] + 65536) + 1, element)
    return [(offset + 1, offset + end) for end in ends]


def _printed(field: Field) -> Iterator[tuple[Place, tuple[int, int]]]:
    if field.span is not None:
        yield field.place, field.span
    for claim in field.restated:
        span = _read(claim.values.get("span"))
        if span is not None:
            yield claim.place, span


def _finding(field: Field, place: Place, printed: tuple[int, int], fitting: list[tuple[int, int]]) -> Diagnostic:
    right = _text(fitting[0]) if fitting else "no fixed place"
    if len(fitting) > 1:
        right += f", up to {_text(fitting[-1])}"
    text = f"{field.name} is printed at {_text(printed)}; it lies at {right}"
    key = "type" if field.value is not None else "record"
    help = "put a type or the span right"
    return finding("spans_match_layout", place, "span", text, help, label(field.place, key, "what lies here"))


def _text(span: tuple[int, int]) -> str:
    return f"byte {span[0]}" if span[0] == span[1] else f"bytes {span[0]}-{span[1]}"


def _read(written: object) -> tuple[int, int] | None:
    """`1-4` as its first and last byte; None where nothing is written."""
    match = _SPAN.fullmatch(str(written)) if written is not None else None
    return (int(match[1]), int(match[2] or match[1])) if match else None
