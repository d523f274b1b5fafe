"""Everything of a device that has a path and a source, for links, corrections and the list of sources."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TypeAlias

from fieldspec.model.device import Device
from fieldspec.model.example import Example
from fieldspec.model.fact import Claim, Fact
from fieldspec.model.link import Stations
from fieldspec.model.lookup import Row
from fieldspec.model.note import Note, Statement
from fieldspec.model.record import Record
from fieldspec.model.table import PrintedElement

Holder: TypeAlias = Fact | Claim | Example | Note | Statement | Stations | PrintedElement | Row


def holders(device: Device) -> dict[str, Holder]:
    """What a device says, by path, in the order of the spec's sections."""
    return {holder.place.path: holder for holder in _all(device)}


def _all(device: Device) -> Iterator[Holder]:
    for fact in _facts(device):
        yield fact
        yield from fact.restated
    for link in device.links.values():
        if link.stations is not None:
            yield link.stations
    for table in device.tables.values():
        yield from table.elements
    for lookup in device.lookups:
        yield from lookup.rows
    for note in device.notes:
        yield note
        yield from note.statements
    yield from device.examples.values()


def _facts(device: Device) -> Iterator[Fact]:
    for link in device.links.values():
        yield link
        yield from link.request
        yield from link.response
    for message in device.messages.values():
        yield message
        yield from message.request.fields
        yield from message.response.fields
        yield from _cases(message.request)
        yield from _cases(message.response)
    for record in device.records.values():
        yield record
        yield from record.fields
    yield from device.signals.values()
    yield from device.conversions.values()
    for group in device.groups:
        yield group
        yield from group.registers
    yield from device.tables.values()
    for parameters in device.parameters.values():
        yield parameters
        yield from parameters.parameters
        for parameter in parameters.parameters:
            yield from parameter.subindices
    for enum in device.enums.values():
        yield enum
        yield from enum.members
    for flags in device.flags.values():
        yield flags
        yield from flags.bits
        yield from flags.states
    yield from device.lookups
    yield from device.limits
    yield from device.tasks


def _cases(record: Record) -> Iterator[Fact]:
    for field in record.fields:
        if field.choice is not None:
            yield from field.choice.cases
