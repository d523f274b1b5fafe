"""Walks over what a device holds, for checks that look at every fact, field or value."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from fieldspec.model.device import Device
from fieldspec.model.fact import Fact
from fieldspec.model.record import Field, Record
from fieldspec.model.value import Value


def layers(device: Device) -> Iterator[Record]:
    """Everything that is made of fields: the records, and the data of requests and responses."""
    yield from device.records.values()
    for message in device.messages.values():
        yield message.request
        yield message.response


def fields(device: Device) -> Iterator[Field]:
    """The fields of all records and messages."""
    for layer in layers(device):
        yield from layer.fields


def lists(device: Device) -> Iterator[Sequence[Fact]]:
    """The rows of every list that is transcribed in the order of the print; enums may be in another order."""
    for group in device.groups:
        yield group.registers
    for layer in layers(device):
        yield layer.fields
    for word in device.flags.values():
        yield word.bits
    for held in device.parameters.values():
        yield held.parameters


def values(device: Device) -> Iterator[tuple[Fact, Value]]:
    """Everything that holds a value, with the value: parts of frames, fields, registers and parameters."""
    for link in device.links.values():
        for part in (*link.request, *link.response):
            if part.value is not None:
                yield part, part.value
    for field in fields(device):
        if field.value is not None:
            yield field, field.value
        for case in field.choice.cases if field.choice is not None else ():
            yield case, case.value
    for signal in device.signals.values():
        yield signal, signal.value
    for register in device.registers():
        yield register, register.value
    for held in device.parameters.values():
        for parameter in held.parameters:
            yield parameter, parameter.value
            for inner in parameter.subindices:
                yield inner, inner.value


def facts(device: Device) -> Iterator[Fact]:
    """All facts in the order of the spec's sections, each before those that it holds."""
    for link in device.links.values():
        yield link
        yield from link.request
        yield from link.response
    for message in device.messages.values():
        yield message
        yield from message.request.fields
        yield from message.response.fields
    for record in device.records.values():
        yield record
        yield from record.fields
    for field in fields(device):
        yield from field.choice.cases if field.choice is not None else ()
    yield from device.signals.values()
    yield from device.conversions.values()
    for enum in device.enums.values():
        yield enum
        yield from enum.members
    for flags in device.flags.values():
        yield flags
        yield from flags.bits
        yield from flags.states
    for group in device.groups:
        yield group
        yield from group.registers
    yield from device.tables.values()
    for held in device.parameters.values():
        yield held
        yield from held.parameters
        for parameter in held.parameters:
            yield from parameter.subindices
    yield from device.lookups
    yield from device.limits
