"""A choice is the last field of its record. The field that decides it comes before it and is a single
unsigned number with an enum; each member of that enum is in at most one case.

Why: a decoder reads the deciding field first and then knows the layout of the rest. It rejects members without a case,
because the data after them is unknown.

Example: `choice: {by: format, cases: [...]}` where two cases have `when: [unsigned16]`, or where the field
`format` comes after the values.

Fix: List the fields in the order of the wire, name a deciding field with an enum, or remove the member from
one of the cases. A record with a choice is the data of a message or of an exception response, and is not part
of another record.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.language.checks.facts import fields, layers
from fieldspec.language.checks.finding import finding, label
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_count, is_signed
from fieldspec.language.model.record import Case, Choice, Field, Record
from fieldspec.language.model.registers import Table
from fieldspec.language.model.value import Value

_CODE = "choices_complete"


def choices_complete(device: Device) -> Iterator[Diagnostic]:
    for layer in layers(device):
        for field in layer.fields:
            if field.choice is not None:
                yield from _check_place(layer, field)
                yield from _decided(device, layer, field, field.choice)
                yield from _apart(field.choice)
    choosing = {name: record for name, record in device.records.items() if any(f.choice for f in record.fields)}
    holders: list[Field | Table] = [*fields(device), *device.tables.values()]
    for holder in holders:
        record = choosing.get(holder.record)
        if record is not None:
            text = f"{record.name} has a choice, so it cannot be part of {holder.name}"
            help = "move the choice to the data of a message"
            related_label = label(record.place, "fields", record.name)
            yield finding(_CODE, holder.place, "record", text, help, related_label)


def _check_place(layer: Record, field: Field) -> Iterator[Diagnostic]:
    if field is not layer.fields[-1]:
        last_field = layer.fields[-1]
        text = f"{last_field.name} comes after {field.name}, whose size depends on another field"
        related_label = label(last_field.place, "name", "comes after it")
        selector = field.choice.by if field.choice else ""
        help = (
            "list the fields in the order of the wire"
            if selector in [other.name for other in layer.fields[layer.fields.index(field) :]]
            else f"where the device has fields after it, write a message for each case, with a `const` for {selector}"
        )
        yield finding(_CODE, field.place, "choice", text, help, related_label)
    if field.count is not None:
        text = f"{field.name} has a choice and a `count`"
        yield finding(_CODE, field.place, "count", text, "use `repeat` to the end of the data, or remove `count`")


def _decided(device: Device, layer: Record, field: Field, choice: Choice) -> Iterator[Diagnostic]:
    names = [other.name for other in layer.fields]
    selector = layer.named(choice.by)
    if selector is None:
        return
    if names.index(selector.name) >= names.index(field.name):
        text = f"{selector.name} decides {field.name}, but does not come before it"
        help = "list the fields in the order of the wire"
        yield finding(_CODE, field.place, "choice", text, help, label(selector.place, "name", selector.name))
    objection = _objection(device, selector)
    if objection:
        text = f"{selector.name} cannot decide {field.name}: {objection}"
        help = "name one unsigned number that has an enum"
        yield finding(_CODE, field.place, "choice", text, help, label(selector.place, "name", selector.name))


def _objection(device: Device, selector: Field) -> str:
    """The reason why a field cannot decide another one, or an empty text."""
    value = selector.value
    if value is None or selector.count is not None or selector.repeat is not None:
        return "it is not a single value"
    if not is_count(value.encoding) or is_signed(value.encoding):
        return f"it is {value.type.name}"
    if not value.enum:
        return "it has no enum"
    return "its word order differs from its byte order" if _mixed(device, value) else ""


def _mixed(device: Device, value: Value) -> bool:
    words = device.word_order
    return value.size > 2 and bool(words) and words != (value.byte_order or device.byte_order)


def _apart(choice: Choice) -> Iterator[Diagnostic]:
    first: dict[str, Case] = {}
    for case in choice.cases:
        for member in case.when:
            if member in first:
                other = first[member]
                text = f"`{member}` is in the case {case.name} and in {other.name}"
                related_label = label(other.place, "when", other.name)
                yield finding(_CODE, case.place, "when", text, "remove it from one of them", related_label)
            first[member] = case
