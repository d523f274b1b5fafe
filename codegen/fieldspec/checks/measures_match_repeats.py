"""The range of a field that holds another field's size goes from its least size to its greatest.

Why: the number of bytes, or of elements, follows from how often an element may be repeated. Where the
print gives the two limits apart, a slip in one of them shows against the other.

Example: `values` are 1 to 60 words, and the byte count has the range `2..127`: 120 bytes are the most.

Cure: Put the range, or the repetitions, right, and write an erratum for the one that is misprinted.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.facts import layers
from fieldspec.checks.finding import finding, interval, label, range_key
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device
from fieldspec.model.record import Field, Record
from fieldspec.model.sizes import RecordSizes


def measures_match_repeats(device: Device) -> Iterator[Diagnostic]:
    sizes = RecordSizes(device)
    for layer in layers(device):
        for field in layer.fields:
            yield from _compared(layer, field, sizes)


def _compared(layer: Record, field: Field, sizes: RecordSizes) -> Iterator[Diagnostic]:
    ranges = field.value.ranges if field.value is not None else None
    measured = layer.named(field.measures.field) if field.measures is not None else None
    if ranges is None or measured is None or measured.repeat is None or field.measures is None:
        return
    size = sizes.element(measured) if field.measures.of == "bytes" else 1
    if size is None:
        return
    low, high = measured.repeat.low * size, measured.repeat.high * size
    if (ranges.low, ranges.high) != (low, high):
        yield finding(
            "measures_match_repeats",
            field.place,
            range_key(field.place),
            f"{field.name} goes over {ranges.text()}; {measured.name} has {interval(low, high)} {field.measures.of}",
            "put the range or the repetitions right",
            label(measured.place, "repeat", f"{measured.name} is repeated"),
        )
