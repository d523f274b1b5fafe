"""All facts, fields, values and lists of a device, for checks that look at each."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from fieldspec.model.device import Device
from fieldspec.model.fact import Fact
from fieldspec.model.record import Case, Field, Record
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


def cases(field: Field) -> tuple[Case, ...]:
    """What may lie in a field; nothing where it has a type of its own."""
    return field.choice.cases if field.choice is not None else ()


def lists(device: Device) -> Iterator[Sequence[Fact]]:
    """The rows of every list that is transcribed in the order of the print; enums may be in another order."""
    for group in device.groups:
        yield group.registers
    for layer in layers(device):
        yield layer.fields
    for word in device.flags.values():
        yield word.bits
        yield word.states
    for held in device.parameters.values():
        yield held.parameters
        for parameter in held.parameters:
            yield parameter.subindices
    yield tuple(device.signals.values())


def values(device: Device) -> Iterator[tuple[Fact, Value]]:
    """Everything that states a value, with the value: parts of frames, signals, fields, registers and parameters.

    What a field takes as a whole from its signal, and a register from the one of which it is a copy, is stated there.
    """
    for link in device.links.values():
        for part in (*link.request, *link.response):
            if part.value is not None:
                yield part, part.value
    for signal in device.signals.values():
        yield signal, signal.value
    for field in fields(device):
        placed = device.signals.get(field.signal)
        if field.value is not None and (placed is None or placed.value != field.value):
            yield field, field.value
        for case in cases(field):
            yield case, case.value
    registers = list(device.registers())
    originals = {}
    if any(register.copy_of for register in registers):
        originals = {register.name: register for register in registers}
    for register in registers:
        original = originals.get(register.copy_of)
        if original is None or original.value != register.value:
            yield register, register.value
    for held in device.parameters.values():
        for parameter in held.parameters:
            yield parameter, parameter.value
            for subindex in parameter.subindices:
                yield subindex, subindex.value


def facts(device: Device) -> Iterator[Fact]:
    """All facts in the order of the spec's sections, each before those that it holds."""
    for link in device.links.values():
        yield link
        yield from link.request
        yield from link.response
    for message in device.messages.values():
        yield message
        yield from _of_layer(message.request)
        yield from _of_layer(message.response)
    for record in device.records.values():
        yield record
        yield from _of_layer(record)
    for enum in device.enums.values():
        yield enum
        yield from enum.members
    for flags in device.flags.values():
        yield flags
        yield from flags.bits
        yield from flags.states
    yield from device.spaces.values()
    for group in device.groups:
        yield group
        yield from group.registers
    yield from device.tables.values()
    for held in device.parameters.values():
        yield held
        for parameter in held.parameters:
            yield parameter
            yield from parameter.subindices
    yield from device.signals.values()
    yield from device.conversions.values()
    yield from device.lookups
    yield from device.limits
    yield from device.tasks


def _of_layer(layer: Record) -> Iterator[Fact]:
    for field in layer.fields:
        yield field
        yield from cases(field)
