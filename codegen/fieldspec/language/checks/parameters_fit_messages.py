"""The type of a parameter has the size of the field that carries its value. The `number` of a value names a field with
a number of the same set. A field with a number, a subindex or a value is a single value without a scale or bits.

Why: a parameter of four bytes cannot be read by a message whose value has two. The manual prints the sizes in the
list of parameters and again with the messages, so a misprint in one of them shows. Programs look for a value by its
number, and each parameter has its own scale.

Example: a parameter of the type `u32`, and messages that all carry its value as `u16`, or `number: index` where `index`
has the numbers of a different set.

Fix: Correct the type of the parameter or of the field. Name the field with the number.
"""

from __future__ import annotations

from fieldspec.foundation.source import Span
from fieldspec.language.checks.facts import cases, fields
from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.diagnostics import Severity
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_octets
from fieldspec.language.model.record import Field

_VALUES = ("value", "values")
_BARRED = ("scale", "offset", "flags", "count", "repeat", "reserved")
"""Keys that a field with a single number, subindex or value of a parameter cannot have."""


def parameters_fit_messages(device: Device) -> Findings:
    yield from _references(device)
    carriers: dict[str, list[tuple[int, Field]]] = {}
    for field in fields(device):
        for value in (field.value, *(case.value for case in cases(field))):
            if value is not None and value.parameter is not None and value.parameter.part in _VALUES:
                if is_octets(value.encoding):
                    continue  # parameter_bytes_complete judges them
                for parameter_set in device.sets(value.parameter.set):
                    carriers.setdefault(parameter_set.name, []).append((value.number_size(value.size), field))
    for parameter_set in device.parameters.values():
        known = carriers.get(parameter_set.name, [])
        sizes = {size for size, _ in known}
        stated: set[Span] = set()
        for parameter in parameter_set.parameters if known else ():
            if parameter.value.size not in sizes and parameter.place["type"] not in stated:
                stated.add(parameter.place["type"])  # a type may be stated once for all parameters
                field = known[0][1]
                text = f"{parameter.name} has {parameter.value.size} bytes, which no message can carry"
                related_label = label(field.place, "name", "a field with the values of these parameters")
                help = "correct the type of the parameter or of the field"
                yield finding(parameter.place, "type", text, help, related_label, severity=Severity.WARNING)


def _references(device: Device) -> Findings:
    """The findings of fields with numbers, subindices and values, and of the numbers that they name."""
    for record in device.records.values():
        yield from _of_layer(device, record.fields, record.fields)
    for message in device.messages.values():
        request_fields, response_fields = message.request.fields, message.response.fields
        yield from _of_layer(device, request_fields, request_fields)
        yield from _of_layer(device, response_fields, (*response_fields, *request_fields))


def _of_layer(device: Device, layer: tuple[Field, ...], known: tuple[Field, ...]) -> Findings:
    for field in layer:
        part = field.value.parameter if field.value is not None else None
        if part is None or part.part == "values":
            continue
        for key in _BARRED:
            if key in field.place:
                text = f"{field.name} is the {part.part} of a parameter of {part.set}, to which `{key}` does not apply"
                yield finding(field.place, key, text, f"remove `{key}`; the rows of {part.set} have such keys")
        number_fields = [other for other in known if other.name == part.number]
        if number_fields and not any(_has_number(device, other, part.set) for other in number_fields):
            text = f"{part.number} has no number of {part.set}, of which {field.name} is the {part.part}"
            help = f"name a field with `parameter: {{set: {part.set}, part: number}}`"
            yield finding(field.place, "parameter", text, help, label(number_fields[0].place, "name", "the field"))


def _has_number(device: Device, field: Field, name: str) -> bool:
    """Whether a field has a number of a set, or of one that shares its numbers."""
    part = field.value.parameter if field.value is not None else None
    if part is None or part.part != "number":
        return False
    spaces = {parameter_set.space or parameter_set.name for parameter_set in device.sets(name)}
    return any((own.space or own.name) in spaces for own in device.sets(part.set))
