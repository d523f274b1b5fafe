"""A register or field with `same_as` has the type, scale, unit and range of the register or field that it names. If a
record has `same_as`, this applies to the fields with the same name in both records; at least one name is in both.

Why: two descriptions of one value must agree. If they differ, one is misprinted, or the two are not the same
value.

Example: a register with `same_as: target_position` and type `u32`, where the target position is `i32`.

Fix: Correct one of them and write an erratum, or remove `same_as`.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, finding, label, range_key
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.link import Part
from fieldspec.language.model.record import Field
from fieldspec.language.model.value import Value

_HELP = "correct one of them, or remove `same_as`"


def aliases_agree(device: Device) -> Findings:
    registers = {register.name: register for register in device.registers()}
    for register in device.registers():
        other = registers.get(register.same_as)
        if other is register:
            yield finding(register.place, "same_as", f"{register.name} is itself", "remove `same_as`")
        elif other is not None:
            yield from _compare_values(f"{register.name} is {other.name}", register, register.value, other, other.value)
    for record in device.records.values():
        alike = device.records.get(record.same_as)
        if alike is not None and (alike is record or not any(alike.named(field.name) for field in record.fields)):
            text = f"{record.name} is itself" if alike is record else f"no field of {record.name} is in {alike.name}"
            yield finding(record.place, "same_as", text, "give both the same names, or remove `same_as`")
        for field in record.fields:
            same = alike.named(field.name) if alike is not None else None
            yield from _echo(field, same, f"{field.name} is the same as in {record.same_as}")
    for message in device.messages.values():
        request_fields = {field.name: field for field in message.request.fields}
        for field in message.response.fields:
            text = f"{field.name} repeats {field.same_as} of the request"
            yield from _echo(field, request_fields.get(field.same_as), text)
            yield from _repeats(field, request_fields.get(field.same_as), text)
    for link in device.links.values():
        parts = {part.name: part for part in link.request}
        for part in link.response:
            yield from _echo(part, parts.get(part.same_as), f"{part.name} repeats {part.same_as} of the request")
        refusal = device.records.get(link.exception_response.record) if link.exception_response is not None else None
        for field in refusal.fields if refusal is not None else ():
            yield from _echo(field, parts.get(field.same_as), f"{field.name} repeats {field.same_as} of the request")


def _echo(field: Field | Part, same: Field | Part | None, text: str) -> Findings:
    if same is not None and field.value is not None and same.value is not None:
        yield from _compare_values(text, field, field.value, same, same.value)


def _repeats(field: Field, same: Field | None, text: str) -> Findings:
    """A field of a response can have the values of the request: the same number of elements, and the same constant."""
    if same is None:
        return
    if _elements(field) != _elements(same):
        key, related_label = _elements_key(field), label(same.place, _elements_key(same), f"in {same.name}")
        yield finding(field.place, key, f"{text}, but has a different number of elements", _HELP, related_label)
    mine = field.value.const if field.value is not None else None
    if mine is not None and same.value is not None and mine != same.value.const:
        related_label = label(same.place, "const" if "const" in same.place else "name", f"in {same.name}")
        yield finding(field.place, "const", f"{text}, but is always the same", _HELP, related_label)


def _elements(field: Field) -> object:
    """How many elements a field has: a number, or the bounds of a list; None for a single value."""
    return field.count if field.repeat is None else field.repeat


def _elements_key(field: Field) -> str:
    return next((key for key in ("count", "repeat") if key in field.place), "type")


def _compare_values(text: str, fact: Fact, value: Value, other: Fact, same: Value) -> Findings:
    for key, mine, theirs in (
        ("type", (value.type.name, value.size), (same.type.name, same.size)),
        ("scale", (value.scale, value.offset), (same.scale, same.offset)),
        ("unit", value.unit, same.unit),
        (range_key(fact.place), value.ranges, same.ranges),
        ("write_range", value.write_ranges, same.write_ranges),
        ("write_word_order", value.write_word_order, same.write_word_order),
        ("enum", value.enum, same.enum),
        ("flags", value.flags, same.flags),
    ):
        if mine != theirs and mine and theirs:
            yield finding(
                fact.place,
                key,
                f"{text}, but has a different {key.removeprefix('unit_')}",
                _HELP,
                label(other.place, range_key(other.place) if "range" in key else key, f"in {other.name}"),
            )
