"""Only a whole number in a register, a register table or a parameter has a `write_range`, and only if it can
be written.

Why: a request is always written and a response is always read, so a field of a message has only one range,
and a read-only value has no `write_range`. A record with a `write_range` is used in register tables, not in
messages.

Example: a register with `access: ro` and `write_range: 0..1`.

Fix: Use `range` for the field of a message, or remove `write_range`. Define a separate record for the
message.
"""

from __future__ import annotations

from fieldspec.language.checks.facts import cases, nested_fields, values
from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_count
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.record import Field
from fieldspec.language.model.value import Value


def write_range_applies(device: Device) -> Findings:
    for fact, value in values(device):
        if value.write_ranges is not None:
            yield from _of_value(fact, value)
    for message in device.messages.values():
        for layer in (message.request, message.response):
            for field in layer.fields:
                yield from _in_frame(device, field)
    for link in device.links.values():
        record = device.records.get(link.exception_response.record) if link.exception_response is not None else None
        for field in record.fields if record is not None else ():
            yield from _in_frame(device, field)


def _of_value(fact: Fact, value: Value) -> Findings:
    if not is_count(value.encoding) or value.flags:
        text = f"{fact.name} is not a whole number, so `write_range` does not apply"
        yield finding(fact.place, "write_range", text, "remove it")
    elif value.const is not None:
        text = f"{fact.name} is always {value.const} when it is written"
        related_label = label(fact.place, "const", "the values that can be written")
        yield finding(fact.place, "write_range", text, "remove one of them", related_label)
    elif getattr(fact, "access", "") == "ro":
        text = f"{fact.name} is read-only, so no value can be written"
        related_label = label(fact.place, "access", "its access")
        yield finding(fact.place, "write_range", text, "correct one of them", related_label)


def _in_frame(device: Device, outer: Field) -> Findings:
    """The faults of a field of a message, or of the fields of its record."""
    for field in nested_fields(device, [outer]):
        values_here = [field.value] if field.value is not None else []
        values_here += [case.value for case in cases(field)]
        if any(value.write_ranges is not None for value in values_here):
            text = f"{field.name} is in a message, which is either written or read"
            related_label = label(outer.place, "name", "the field of the message")
            help = "define a separate field for the message, with its own `range`"
            yield finding(field.place, "write_range", text, help, *([related_label] if outer is not field else []))
