"""A repeated field permits at least one element, and its end is known: by the end of the data, less the fixed bytes
after it, by an earlier field that `measures` it, or by its elements with `more_if`. If data of varying size follows, or
if the list is in a record within another record, the measuring field is an unsigned number: binary, in one or two
bytes, or a fixed number of decimal or hexadecimal digits without blanks, at most nine and seven.
A record of varying size can be part of messages and of other such records, once, `count` times or repeated, if an
earlier field in it, or `more_if`, determines the end of each of its lists and texts of varying width. A field that
counts the bytes of such records is also such a number, and has no `range`. The data of exception responses, and of
messages that access registers, has lists only at its end.

Why: without a field that counts the elements, their number follows only from the end of the data. Records that differ
in size can be separated only by counts within them.

Example: a list of points with `repeat: 1..15` and another list after it, without a field that measures either.

Fix: State the number of elements as `count`, the field that counts them as `measures`, or list the fields in the order
of the wire.
"""

from __future__ import annotations

from fieldspec.language.checks.facts import layers
from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.counts import COUNTING, list_count
from fieldspec.language.model.device import Device
from fieldspec.language.model.record import Field, Message, Record
from fieldspec.language.model.sizes import RecordSizes


def repeat_last(device: Device) -> Findings:
    sizes = RecordSizes(device)
    bodies = {id(body): message for message in device.messages.values() for body in (message.request, message.response)}
    refusing = {link.exception_response.record for link in device.links.values() if link.exception_response is not None}
    for layer in layers(device):
        for field in layer.fields:
            if field.repeat is not None:
                if field.repeat.high == 0:
                    text = f"{field.name} never has an element"
                    yield finding(field.place, "repeat", text, "correct the repetitions, or remove the field")
                if field.count is not None:
                    text = f"{field.name} has a `count` and a `repeat`"
                    yield finding(field.place, "count", text, "remove one of them")
            if field.record in sizes.endless or (field.value and field.value.width):
                continue
            is_element = bool(field.record) and sizes.element(field) is None
            if is_element:
                yield from _differing(sizes, device.records.get(field.record), layer, field)
            is_packed = field.value is not None and field.value.packed_bits > 0
            differs = is_element or field.choice is not None
            if field is not layer.fields[-1] and (differs or field.repeat is not None):
                yield from _followed(sizes, layer, field, id(layer) in bodies)
            elif not is_element and not is_packed and not (field.choice and field.choice.has_widths):
                continue
            yield from _at_the_end(layer, field, bodies.get(id(layer)), layer.name in refusing)


def _differing(sizes: RecordSizes, inner: Record | None, layer: Record, field: Field) -> Findings:
    """The findings of a field with a record that has no fixed size."""
    if inner is None:
        return
    untold = sizes.untold(inner)
    # `varying_widths_end` says what to do about a text.
    if untold is not None and not (untold.value is not None and untold.value.width):
        text = f"{inner.name} has no fixed size, and nothing in it marks the end of {untold.name}"
        help = f"let {COUNTING} before it count it with `measures`, or let a message have its fields"
        yield finding(field.place, "record", text, help, label(untold.place, "name", "has no fixed size"))
    for other in layer.fields:
        measures = other.measures
        if measures is None or measures.field != field.name or measures.of != "bytes":
            continue
        is_number = other.value is not None and other.value.ranges is None
        if not is_number or list_count(layer, field) is not other:
            text = f"{other.name} counts the bytes of {field.name}, whose elements differ in size"
            text += f", and is not the first to count it without a `range`, as {COUNTING}"
            help = f"state it so, or count the elements: `measures: {{items: {field.name}}}`"
            yield finding(other.place, "measures", text, help)


def _followed(sizes: RecordSizes, layer: Record, field: Field, is_body: bool) -> Findings:
    """The findings of fields after a list, a choice, or a record that differs in size."""
    index = next(number for number, other in enumerate(layer.fields) if other is field)
    later_fields = layer.fields[index + 1 :]
    counts = [
        other for other in layer.fields[:index] if (own := other.stated_measure) is not None and own.field == field.name
    ]
    varying = next((other for other in later_fields if not sizes.is_fixed(other)), None)
    is_open = field.repeat is not None and not field.tells_end and field.choice is None
    is_open &= varying is not None or not is_body
    last = varying or later_fields[-1]
    if is_open and not counts:
        problem = "after it has no fixed size" if varying is not None else "comes after it in a record"
        text = f"the end of {field.name} is unknown, because {last.name} {problem}"
        help = "state its `count`, the field before it that `measures` it, or the fields in the order of the wire"
        yield finding(field.place, "repeat", text, help, label(last.place, "name", "comes after it"))
    elif is_open and list_count(layer, field) is None:
        text = f"{counts[0].name} counts {field.name}, which {last.name} follows, and is not {COUNTING}"
        help = "state the number so, or a message of its own"
        yield finding(counts[0].place, "type", text, help, label(last.place, "name", "follows it"))


def _at_the_end(layer: Record, field: Field, message: Message | None, refuses: bool) -> Findings:
    """The finding of a list with fields after it, or of a record that differs in size, where a last list may be."""
    last = layer.fields[-1]
    is_packed = field.value is not None and field.value.packed_bits > 0
    problem = f"{field.name} {'has packed numbers' if is_packed else 'differs in size'}"
    problem = f"{last.name} comes after {field.name}" if last is not field else problem
    if message is not None and message.accesses:
        text = f"{message.name} reads or writes registers, and {problem}"
        yield finding(field.place, "name", text, "list the repeated field last, or remove `accesses`")
    if refuses and message is None:
        text = f"{layer.name} is the data of exceptions, and {problem}"
        yield finding(field.place, "name", text, "state a fixed `count`, or list the repeated field last")
