"""A field that repeats to the end of the data comes last, and its elements have a fixed size.

Why: only the end of the data gives the number of elements. Nothing can follow them, and elements of varying
size cannot be separated.

Example: a list of points with `repeat: 1..15` and a field after it.

Cure: State the number of elements as `count`, or list the fields in the order of the wire.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.facts import layers
from fieldspec.checks.finding import finding, label
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device
from fieldspec.model.sizes import RecordSizes

_CODE = "repeat_last"


def repeat_last(device: Device) -> Iterator[Diagnostic]:
    sizes = RecordSizes(device)
    for layer in layers(device):
        for field in layer.fields:
            if field.repeat is not None:
                if field is not layer.fields[-1]:
                    behind = layer.fields[-1]
                    text = f"{field.name} repeats to the end of the data, but {behind.name} comes after it"
                    help = "state its `count`, or list the fields in the order of the wire"
                    there = label(behind.place, "name", "comes after it")
                    yield finding(_CODE, field.place, "repeat", text, help, there)
                if field.count is not None:
                    text = f"{field.name} has a `count` and a `repeat`"
                    yield finding(_CODE, field.place, "count", text, "remove one of them")
            inner = device.records.get(field.record)
            if inner is not None and inner.name not in sizes.endless and sizes.element(field) is None:
                text = f"{inner.name} has no fixed size, so it cannot be part of another record"
                help = "move the repeated field to the outer record"
                there = label(inner.place, "fields", "its last field repeats")
                yield finding(_CODE, field.place, "record", text, help, there)
