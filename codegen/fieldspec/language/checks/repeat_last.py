"""A field that repeats may have an element, comes last, and its elements have a fixed size. In a message, other fields
may follow such a field, if a field before it measures it; where one of them repeats too, that field is a binary
number of one or two bytes without a sign. The elements of such a list in a message may be records that differ in size,
each of which ends with a list, or a text that `varies`, that a field of it counts in the same way.

Why: without a field that counts the elements, only the end of the data gives their number, and nothing can follow them.
Elements that differ in size are separated by their own counts.

Example: a list of points with `repeat: 1..15` and a field after it, which nothing measures.

Cure: State the number of elements as `count`, the field that counts them as `measures`, or list the fields in the order
of the wire.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.language.checks.facts import layers
from fieldspec.language.checks.finding import finding, label
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.device import Device
from fieldspec.language.model.record import Field, Message, Record, list_count
from fieldspec.language.model.sizes import RecordSizes

_CODE = "repeat_last"


def repeat_last(device: Device) -> Iterator[Diagnostic]:
    sizes = RecordSizes(device)
    bodies = {id(body): message for message in device.messages.values() for body in (message.request, message.response)}
    for layer in layers(device):
        for field in layer.fields:
            if field.repeat is not None:
                if field is not layer.fields[-1]:
                    yield from _inner(layer, field, bodies.get(id(layer)))
                if field.repeat.high == 0:
                    text = f"{field.name} never has an element"
                    yield finding(_CODE, field.place, "repeat", text, "correct the repetitions, or remove the field")
                if field.count is not None:
                    text = f"{field.name} has a `count` and a `repeat`"
                    yield finding(_CODE, field.place, "count", text, "remove one of them")
            inner = device.records.get(field.record)
            if inner is None or inner.name in sizes.endless or sizes.element(field) is not None:
                continue
            if field.repeat is not None and id(layer) in bodies and sizes.has_tail(inner.name):
                yield from _differing(layer, field)
            else:
                text = f"{inner.name} has no fixed size, so it cannot be part of another record"
                help = (
                    "list it with `repeat` in a message, and let one field of it, a `u8` or `u16`, count its last one"
                )
                ending = "repeats" if inner.fields[-1].repeat is not None else "varies in width"
                related_label = label(inner.place, "fields", f"its last field {ending}")
                yield finding(_CODE, field.place, "record", text, help, related_label)


def _differing(layer: Record, field: Field) -> Iterator[Diagnostic]:
    """The findings of fields that count the bytes of a list whose elements differ in size."""
    for other in layer.fields:
        if other.measures is not None and other.measures.field == field.name and other.measures.of == "bytes":
            text = f"{other.name} counts the bytes of {field.name}, whose elements differ in size"
            yield finding(
                _CODE, other.place, "measures", text, f"count the elements: `measures: {{items: {field.name}}}`"
            )


def _inner(layer: Record, field: Field, message: Message | None) -> Iterator[Diagnostic]:
    """The findings of a list with fields behind it; `message` is the one of which the fields are the data."""
    index = next(number for number, other in enumerate(layer.fields) if other is field)
    later_fields = layer.fields[index + 1 :]
    last = later_fields[-1]
    counts = [other for other in layer.fields if other.measures is not None and other.measures.field == field.name]
    if message is None:
        text = f"{field.name} repeats to the end of the data, but {last.name} comes after it"
        help = "state its `count`, or list the fields in the order of the wire"
        if counts:
            text = f"{counts[0].name} counts {field.name}, but {last.name} comes after it, which only a message can say"
            help = "state its `count` if it is always the same, or the fields in the message itself; no record has them"
        yield finding(_CODE, field.place, "repeat", text, help, label(last.place, "name", "comes after it"))
        return
    if not any(other in layer.fields[:index] for other in counts):
        text = f"{field.name} repeats to the end of the data, but {last.name} comes after it"
        help = "state its `count`, the field before it that `measures` it, or the fields in the order of the wire"
        yield finding(_CODE, field.place, "repeat", text, help, label(last.place, "name", "comes after it"))
        return
    following = next((other for other in later_fields if other.repeat is not None), None)
    if following is not None and list_count(layer, field) is None:
        count = next(other for other in layer.fields[:index] if other in counts)
        text = f"{count.name} counts {field.name}, which {following.name} follows, and is no binary `u8` or `u16`"
        related_label = label(following.place, "repeat", "repeats too")
        yield finding(
            _CODE,
            count.place,
            "type",
            text,
            "state the number as `u8` or `u16`, or a message of its own",
            related_label,
        )
    for other in later_fields:
        if other.choice is not None:
            text = f"{other.name} has several types behind {field.name}, which repeats"
            related_label = label(field.place, "repeat", "is counted by a field")
            yield finding(_CODE, other.place, "choice", text, "state a message of its own for each", related_label)
        for key in ("span", "word_span"):
            if key in other.place:
                text = f"{other.name} has no place of its own, as {field.name} before it repeats"
                yield finding(_CODE, other.place, key, text, "remove it")
    if message.accesses is not None or message.access_steps:
        text = f"{message.name} reads or writes registers, and {last.name} comes after {field.name}"
        help = "list the repeated field last, or remove `accesses`"
        yield finding(_CODE, field.place, "repeat", text, help, label(last.place, "name", "comes after it"))
