"""How the classes of the model are compared: contents, own attributes and texts, and whom a new object affects."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from operator import attrgetter
from typing import Any, TypeAlias

from fieldspec.foundation.classes import attributes, dataclass
from fieldspec.language.changes.change import Effect
from fieldspec.language.model.address_space import AddressSpace
from fieldspec.language.model.attributes import MODEL_CLASSES, own_attributes
from fieldspec.language.model.device import Device, Version, VersionLine
from fieldspec.language.model.enums import Bit, Enum, Flags, Member, State
from fieldspec.language.model.fact import Place
from fieldspec.language.model.link import Link, Part
from fieldspec.language.model.record import Case, Field, Message, Record
from fieldspec.language.model.registers import Parameter, ParameterSet, Register, RegisterGroup, Subindex, Table
from fieldspec.language.model.task import Task
from fieldspec.language.model.texts import Acceptance, Erratum, Example, Limit, Lookup, Note, StatedChange
from fieldspec.language.model.units import DeclaredUnit
from fieldspec.language.model.value import Conversion, Signal

PYTHON, C, PLC = "Python", "C", "PLC"
ALL = (PYTHON, C, PLC)

_W, _S, _B, _D = Effect


@dataclass(frozen=True, slots=True)
class Consequences:
    """The effect of a new object of a class, and of one that is gone. `outputs` have its name."""

    adding: Effect
    removing: Effect
    outputs: tuple[str, ...] = ()

    @property
    def renaming(self) -> Effect:
        """The effect of another name."""
        return Effect.SOURCE if self.outputs else Effect.DOCS


CONSEQUENCES: dict[type, Consequences] = {
    Device: Consequences(_B, _S, ALL),
    VersionLine: Consequences(_D, _D),
    Version: Consequences(_D, _D),
    Link: Consequences(_B, _W, (PYTHON, C)),
    Part: Consequences(_W, _W, (PYTHON, C)),
    Message: Consequences(_B, _W, ALL),
    Record: Consequences(_B, _S, ALL),
    Field: Consequences(_W, _W, ALL),
    Case: Consequences(_B, _W),
    Enum: Consequences(_B, _S, ALL),
    Member: Consequences(_B, _W, ALL),
    Flags: Consequences(_B, _S, ALL),
    Bit: Consequences(_B, _W, ALL),
    State: Consequences(_B, _S, ALL),
    DeclaredUnit: Consequences(_B, _B),
    AddressSpace: Consequences(_B, _S, (PYTHON,)),
    RegisterGroup: Consequences(_D, _D),
    Register: Consequences(_B, _W, ALL),
    Table: Consequences(_B, _W, ALL),
    ParameterSet: Consequences(_B, _W, ALL),
    Parameter: Consequences(_B, _W, ALL),
    Subindex: Consequences(_B, _W, ALL),
    Signal: Consequences(_B, _S, ALL),
    Conversion: Consequences(_B, _S, (PYTHON, C)),
    Lookup: Consequences(_D, _D),
    Limit: Consequences(_B, _B),
    Task: Consequences(_D, _D),
    Note: Consequences(_D, _D),
    Example: Consequences(_D, _D),
    Erratum: Consequences(_D, _D),
}
"""The classes that are compared: all but what a spec says of changes, which is not a part of the device."""

Objects: TypeAlias = Callable[[Any], Iterable[Any]]


def _contents(model_class: type) -> Iterator[tuple[type, Objects, str]]:
    for content in MODEL_CLASSES[model_class].contents:
        if content.type not in (Register, Acceptance, StatedChange):
            yield content.type, content.of, content.direction
    if model_class is Device:  # a register that moves to another group stays the same register
        yield Register, Device.registers, ""


CONTENTS: dict[type, tuple[tuple[type, Objects, str], ...]] = {
    model_class: tuple(_contents(model_class)) for model_class in CONSEQUENCES
}
"""By class, what its objects contain: the class, the objects in the order of the spec, and the direction."""

OWN_VALUES: dict[type, Callable[[Any], tuple[object, ...]]] = {
    model_class: attrgetter(*own_attributes(model_class)) for model_class in CONSEQUENCES
}
"""By class, the values of its own attributes as one tuple."""

Text: TypeAlias = Callable[[Any], Any]


def _text_of(name: str) -> Text:
    get = attrgetter(name)
    return lambda fact: _without_places(get(fact))


def _of(name: str, *attributes: str) -> Text:
    """The documentation of an optional part of a fact."""
    get = attrgetter(name)

    def texts(fact: Any) -> object:
        part = get(fact)
        return tuple(getattr(part, attribute) for attribute in attributes) if part is not None else ()

    return texts


def _without_places(value: Any) -> Any:
    """A value of the model without the places of its objects in the spec, which are not a difference."""
    if isinstance(value, tuple):
        return tuple(map(_without_places, value))
    if isinstance(getattr(value, "place", None), Place):
        return tuple(_without_places(getattr(value, name)) for name in attributes(value.__class__) if name != "place")
    return value


def _scale(fact: Any) -> str:
    return fact.value.scale_text if fact.value is not None else ""


def _sentinels(fact: Any) -> dict[str, object]:
    value = fact.value
    return {sentinel.text: (sentinel.doc, sentinel.sources) for sentinel in value.sentinels} if value else {}


_HAVE_VALUES = (Part, Field, Case, Register, Parameter, Subindex, Signal)
_KEYS = {"sources": "source", "silence_sources": "silence", "scale_text": "scale", "machines": "behaviour"}
"""Attributes whose keys in the spec have other names."""

_TEXTS_OF_LINKS: dict[str, Text] = {
    "unit_addresses": _of("unit_addresses", "rule", "notes", "sources"),
    "serial": _of("serial", "sources"),
    "network": _of("network", "sources"),
    "exception_response": _of("exception_response", "sources"),
}


def _texts(model_class: type) -> Iterator[tuple[str, Text]]:
    for name in MODEL_CLASSES[model_class].documentation:
        yield _KEYS.get(name, name), _text_of(name)
        if name == "restated" and model_class in _HAVE_VALUES:
            yield from (("scale", _scale), ("sentinels", _sentinels))
    if model_class is Link:
        yield from _TEXTS_OF_LINKS.items()
    if model_class is VersionLine:
        yield "detected_by", _of("detected_by", "doc", "inferred", "sources")


TEXTS: dict[type, dict[str, Text]] = {model_class: dict(_texts(model_class)) for model_class in CONSEQUENCES}
"""By class, the keys of the spec that document an object, with the functions that give their texts."""
