"""Whether the value that identifies the version of a device is read alike in all of its versions."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from fieldspec.codec.layout.detection import detecting_fact
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import Orders, RecordLayout
from fieldspec.language.checks.finding import finding_of, hexadecimal, label
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.record import Message
from fieldspec.language.model.registers import Parameter, Register
from fieldspec.language.model.value import Value

_CODE = "detections_apply"
_HELP = "name a value that all versions have at one place, or remove `detected_by` and say in `doc` how users tell them"


def detections_alike(layouts: Mapping[str, DeviceLayout]) -> Iterator[Diagnostic]:
    """A finding if a version has the identifying value at a different address, or interprets its numbers differently.

    `layouts` are the layouts of the versions with outputs. A program reads the value before it knows the version.
    """
    versions = list(layouts)
    newest = layouts[versions[-1]] if versions else None
    detection = newest.device.detection if newest is not None else None
    if newest is None or detection is None:
        return
    known = _reading(newest, detection.fact)
    for version in versions[-2::-1]:
        layout = layouts[version]
        other = layout.device.detection
        if other is None or other.fact != detection.fact:
            continue
        own = _reading(layout, detection.fact)
        differing = [key for key in known if key in own and own[key] != known[key]]
        if differing:
            key = differing[0]
            text = f"{detection.fact} identifies the version, but its {key} is {own[key]} in {version}"
            text += f", and {known[key]} in {versions[-1]}: a program reads it before it knows the version"
            fact = detecting_fact(layout.device, detection)
            labels = [label(fact.place, "name", f"in {version}")] if fact is not None else []
            yield finding_of(_CODE, detection.place, "fact", text, _HELP, *labels)
            return


def _reading(layout: DeviceLayout, path: str) -> dict[str, str]:
    """How a program reads the value with a path: each key in words, with its text."""
    device = layout.device
    orders = Orders(device.byte_order, device.word_order)
    for register in device.registers():
        if register.place.path == path:
            return {**_place_of(layout, register), **_value(register.value, orders)}
    for parameter_set in device.parameters.values():
        for parameter in parameter_set.parameters:
            if parameter.place.path == path:
                return {**_number_of(parameter_set.base, parameter), **_value(parameter.value, orders)}
    for message in layout.messages.values():
        for fact_path, offset, value in _fields(message.response):
            if fact_path == path:
                return {**_message(message.message), "offset": f"{offset} bytes", **_value(value, orders)}
    for table in layout.tables.values():
        for fact_path, offset, value in _fields(table.record):
            if fact_path == path:
                own = table.table
                places = {"address space": device.space_name(own.space), "address": hexadecimal(own.base)}
                return {**places, "offset": f"{offset} bytes", **_value(value, orders)}
    return {}


def _place_of(layout: DeviceLayout, register: Register) -> dict[str, str]:
    return {
        "address space": layout.device.space_name(register.space),
        "address": hexadecimal(register.address),
    }


def _number_of(base: int, parameter: Parameter) -> dict[str, str]:
    return {"number on the wire": str(base + parameter.number)}


def _message(message: Message) -> dict[str, str]:
    """The constant content of a request for the message."""
    constants = [
        f"{field.name} {field.value.const}"
        for field in message.request.fields
        if field.value is not None and field.value.const is not None
    ]
    return {"code": str(message.code), "request": ", ".join(constants) or "empty"}


def _fields(record: RecordLayout) -> Iterator[tuple[str, int, Value]]:
    for field in record.fields:
        if field.value is not None:
            yield field.field.place.path, field.offset, field.value


def _value(value: Value, orders: Orders) -> dict[str, str]:
    """The number in the bytes, and what it stands for."""
    order, swapped = orders.of(value)
    last = "little" if order == "big" else "big"
    return {
        "type": value.type.name,
        "size": f"{value.size} bytes",
        "digits": value.codec or value.digits or "binary",
        "byte order": order if value.has_order else "",
        "word order": (last if swapped else order) if value.has_words else "",
        "scale": value.scale_text or str(value.scale),
    }
