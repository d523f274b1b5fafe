"""A range of writing stands at a whole number that a device holds, and that can be written.

Why: a request is always written and a response always read, so that the fields of messages have one range, and what can
only be read has none of writing. A record with a range of writing may lie in tables of registers, not in messages.

Example: a register with `access: ro` and `write_range: 0..1`.

Cure: Give the field of a message its `range`, or take `write_range` out. Give a message a record of its own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.facts import values
from fieldspec.checks.finding import finding, label
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device
from fieldspec.model.fact import Fact
from fieldspec.model.record import Field, Record
from fieldspec.model.value import Kind, Value

_CODE = "write_range_applies"


def write_range_applies(device: Device) -> Iterator[Diagnostic]:
    for fact, value in values(device):
        if value.write_ranges is not None:
            yield from _of_value(fact, value)
    for message in device.messages.values():
        for layer in (message.request, message.response):
            for field in layer.fields:
                yield from _in_frame(device, field, field)
    for link in device.links.values():
        record = device.records.get(link.exception_response.record) if link.exception_response is not None else None
        for field in record.fields if record is not None else ():
            yield from _in_frame(device, field, field)


def _of_value(fact: Fact, value: Value) -> Iterator[Diagnostic]:
    if value.type.kind is not Kind.INTEGER or value.flags:
        text = f"{fact.name} is no whole number, for which alone there is a range of writing"
        yield finding(_CODE, fact.place, "write_range", text, "take it out")
    elif value.const is not None:
        text = f"{fact.name} is always {value.const} when it is written"
        there = label(fact.place, "const", "all that may be written")
        yield finding(_CODE, fact.place, "write_range", text, "take one of them out", there)
    elif getattr(fact, "access", "") == "ro":
        text = f"{fact.name} can only be read, so no value may be written"
        there = label(fact.place, "access", "its access")
        yield finding(_CODE, fact.place, "write_range", text, "put one of them right", there)


def _in_frame(device: Device, outer: Field, field: Field, depth: int = 8) -> Iterator[Diagnostic]:
    """What is wrong with a field of a message, or with one of the records that lie in it."""
    values_here = [field.value] if field.value is not None else []
    values_here += [case.value for case in field.choice.cases] if field.choice is not None else []
    if any(value.write_ranges is not None for value in values_here):
        text = f"{field.name} lies in a message, and is either written or read"
        there = label(outer.place, "name", "the field of the message")
        help = "give the message a field of its own, with the `range` that it has there"
        yield finding(_CODE, field.place, "write_range", text, help, *([there] if outer is not field else []))
    record: Record | None = device.records.get(field.record)
    for inner in record.fields if record is not None and depth else ():
        yield from _in_frame(device, outer, inner, depth - 1)
