"""The type of a parameter has as many bytes as a field that carries its value.

Why: a parameter of four bytes cannot be read by a message whose value has two. The manual prints the sizes in the
list of parameters and again with the messages, so a misprint in one of them shows.

Example: a parameter of the type `u32`, and messages that all have its value as `u16`.

Cure: Correct the type of the parameter, or that of the field.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.facts import cases, fields
from fieldspec.checks.finding import finding, label
from fieldspec.diagnostics import Diagnostic, Severity
from fieldspec.model.device import Device
from fieldspec.model.record import Field
from fieldspec.model.value import Kind
from fieldspec.source import Span

_VALUES = ("value", "values")


def parameters_fit_messages(device: Device) -> Iterator[Diagnostic]:
    carriers: dict[str, list[tuple[int, Field]]] = {}
    for field in fields(device):
        for value in (field.value, *(case.value for case in cases(field))):
            if value is not None and value.parameter is not None and value.parameter.part in _VALUES:
                if value.type.kind is Kind.BYTES:
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
                there = label(field.place, "name", "a field with the values of these parameters")
                help = "correct the type of the parameter or of the field"
                yield finding(
                    "parameters_fit_messages", parameter.place, "type", text, help, there, severity=Severity.WARNING
                )
