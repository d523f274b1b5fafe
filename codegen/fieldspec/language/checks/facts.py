"""All facts, fields, values and lists of a device, for checks that look at each."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache
from itertools import chain

from fieldspec.foundation.caches import ByIdentity, ObjectsKey
from fieldspec.language.model.attributes import MODEL_CLASSES, descendants
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.record import Case, Field, Record
from fieldspec.language.model.registers import Register
from fieldspec.language.model.value import Signal, Value


def _has_facts(model_class: type) -> bool:
    contents = MODEL_CLASSES[model_class].contents
    return issubclass(model_class, Fact) or any(_has_facts(content.type) for content in contents)


_SECTIONS = tuple(content for content in MODEL_CLASSES[Device].contents if _has_facts(content.type))

_OF_SECTION: ByIdentity[object, tuple[Fact, ...]] = ByIdentity(limit=400)
"""The facts of sections, most of which versions of a device have in common, also with misprints put back."""

_ALLOWING: ByIdentity[tuple[Fact, ...], tuple[Fact, ...]] = ByIdentity(limit=400)
"""Those of the facts of a section that allow findings."""


def facts(device: Device) -> tuple[Fact, ...]:
    """All facts in the order of the spec's sections, each before the facts that it contains; separators
    are not facts.

    Devices with the same sections give the same object.
    """
    return _joined(ObjectsKey(_by_section(device)))


def allowing(device: Device) -> Iterator[Fact]:
    """The facts that allow findings, in the same order."""
    for part in _by_section(device):
        yield from _ALLOWING.get_or_compute(part, lambda part: tuple([fact for fact in part if fact.allowed]))


def _by_section(device: Device) -> Iterator[tuple[Fact, ...]]:
    for content in _SECTIONS:
        section = getattr(device, content.attribute)
        if section not in _OF_SECTION:
            _OF_SECTION[section] = tuple(
                fact
                for item in content.of(device)
                for fact in (item, *descendants(item))
                if isinstance(fact, Fact) and not _is_implied(fact)
            )
        yield _OF_SECTION[section]


@lru_cache(maxsize=8)
def _joined(parts: ObjectsKey) -> tuple[Fact, ...]:
    return tuple(chain.from_iterable(parts.objects))


def _is_implied(fact: Fact) -> bool:
    return isinstance(fact, Field) and fact.is_implied


def values(device: Device) -> tuple[tuple[Fact, Value], ...]:
    """Every fact that states a value, with the value.

    Keys that a field takes as a whole from its signal, or a register from its original, are stated there.
    """
    return _values(ObjectsKey((facts(device), device.groups, device.signals)))


@lru_cache(maxsize=8)
def _values(key: ObjectsKey) -> tuple[tuple[Fact, Value], ...]:
    all_facts, groups, signals = key.objects
    registers = {register.name: register for group in groups for register in group.registers}
    return tuple(_own_values(all_facts, registers, signals))


def _own_values(
    all_facts: Sequence[Fact], registers: Mapping[str, Register], signals: Mapping[str, Signal]
) -> Iterator[tuple[Fact, Value]]:
    for fact in all_facts:
        value = getattr(fact, "value", None)
        if isinstance(value, Value):
            original: Signal | Register | None = None
            if isinstance(fact, Field):
                original = signals.get(fact.signal)
            elif isinstance(fact, Register):
                original = registers.get(fact.copy_of)
            if original is None or original.value != value:
                yield fact, value


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


def nested_fields(device: Device, outer: Sequence[Field]) -> Iterator[Field]:
    """Some fields, each before the fields of the records in it, to any depth.

    The fields of a record come once, so this ends where a record contains itself, and where many hold the same one.
    """
    visited: set[str] = set()
    waiting = [*reversed(outer)]
    while waiting:
        field = waiting.pop()
        yield field
        record = device.records.get(field.record)
        if record is not None and record.name not in visited:
            visited.add(record.name)
            waiting += reversed(record.fields)


def cases(field: Field) -> tuple[Case, ...]:
    """The types that a field can have by another field; nothing where it has a type of its own."""
    return field.choice.cases if field.choice is not None else ()


def lists(device: Device) -> Iterator[Sequence[Fact]]:
    """The rows of every list that is transcribed in the order of the manual; enums may be in a different order."""
    for group in device.groups:
        yield group.registers
    for layer in layers(device):
        yield layer.fields
    for flags in device.flags.values():
        yield flags.bits if flags.bit_0 == "least" else flags.bits[::-1]
        yield flags.states
    for parameter_set in device.parameters.values():
        yield parameter_set.parameters
        for parameter in parameter_set.parameters:
            yield parameter.subindices
    yield tuple(device.signals.values())
