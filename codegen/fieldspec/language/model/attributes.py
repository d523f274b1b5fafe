"""The classes of the model: what each contains, what identifies its objects, and which attributes only document."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from operator import attrgetter
from typing import Any

from fieldspec.foundation import classes
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.address_space import AddressSpace
from fieldspec.language.model.device import Device, Version, VersionLine
from fieldspec.language.model.enums import Bit, Enum, Flags, Member, State
from fieldspec.language.model.link import Link, Part
from fieldspec.language.model.record import Case, Field, Message, Record
from fieldspec.language.model.registers import Parameter, ParameterSet, Register, RegisterGroup, Subindex, Table
from fieldspec.language.model.task import Task
from fieldspec.language.model.texts import Acceptance, Erratum, Example, Limit, Lookup, Note, StatedChange
from fieldspec.language.model.units import DeclaredUnit
from fieldspec.language.model.value import Conversion, Signal

# Whoever walks a device, compares two of them, or describes an object reads this table. A new class of the model, or a
# new list in one of them, is entered here and nowhere else.


@dataclass(frozen=True, slots=True)
class Content:
    """The objects of class `type` that an attribute contains, as a list or as a mapping by name.

    `attribute` is a path of attributes (`request.fields`); the first one is `container`. `direction` is the direction
    of the parts of a frame or of the fields of a message, else empty. `has_more` says that the container states more
    than these objects.
    """

    type: type
    attribute: str
    direction: str = ""
    has_more: bool = False

    @property
    def container(self) -> str:
        """The attribute of the class in which the objects are."""
        return self.attribute.partition(".")[0]

    def of(self, container: Any) -> Collection[Any]:
        """The objects, in the order of the spec."""
        value = container
        for name in self.attribute.split("."):
            value = getattr(value, name)
            if value is None:
                return ()
        objects: Collection[Any] = value.values() if isinstance(value, Mapping) else value
        return objects


@dataclass(frozen=True, slots=True)
class ModelClass:
    """What users call a class (`title`), what it contains, and which attributes give no byte a meaning.

    `key` identifies an object among those in one attribute. `documentation` names texts, sources and printed
    numbers: two devices that differ only in them exchange the same bytes.
    """

    title: str
    contents: tuple[Content, ...] = ()
    documentation: tuple[str, ...] = ()
    key: Callable[[Any], object] = attrgetter("name")


def _subindex_key(subindex: Subindex) -> str:
    return subindex.name or subindex.indices.text()


_FACT = (
    "printed_name",
    "label",
    "doc",
    "sources",
    "notes",
    "inferred",
    "standard",
    "roles",
    "unverified",
    "since",
    "until",
    "only",
    "reported",
    "restated",
)
"""The attributes of every fact that only document it."""

_PRINTED_ADDRESS = ("decimal", "words")

MODEL_CLASSES: dict[type, ModelClass] = {
    Device: ModelClass(
        "device",
        (
            Content(VersionLine, "lines"),
            Content(Link, "links"),
            Content(Message, "messages"),
            Content(Record, "records"),
            Content(Enum, "enums"),
            Content(Flags, "flags"),
            Content(DeclaredUnit, "units"),
            Content(AddressSpace, "spaces"),
            Content(RegisterGroup, "groups"),
            Content(Table, "tables"),
            Content(ParameterSet, "parameters"),
            Content(Signal, "signals"),
            Content(Conversion, "conversions"),
            Content(Lookup, "lookups"),
            Content(Limit, "limits"),
            Content(Task, "tasks"),
            Content(Note, "notes"),
            Content(Example, "examples"),
            Content(Erratum, "errata"),
            Content(Acceptance, "accepts"),
            Content(StatedChange, "stated_changes"),
        ),
        ("name", "vendor", "title", "doc", "manual", "machines"),
        key=attrgetter("id"),
    ),
    VersionLine: ModelClass("line of versions", (Content(Version, "versions"),), ("title", "like", "inferred")),
    Version: ModelClass("version", documentation=("title", "doc", "inferred", "sources"), key=attrgetter("id")),
    Link: ModelClass(
        "link",
        (Content(Part, "request", "request"), Content(Part, "response", "response")),
        (*_FACT, "title", "message_name", "request_name", "response_name", "silence_sources"),
    ),
    Part: ModelClass("part of the frame", documentation=_FACT),
    Message: ModelClass(
        "message",
        (Content(Field, "request.fields", "request"), Content(Field, "response.fields", "response")),
        (*_FACT, "title", "group", "request_length", "response_length", "request_words", "response_words"),
    ),
    Record: ModelClass("record", (Content(Field, "fields"),), (*_FACT, "size", "words", "same_as")),
    Field: ModelClass(
        "field",
        (Content(Case, "choice.cases", has_more=True),),
        (*_FACT, "at", "words", "span", "word_span", "signal", "is_implied"),
    ),
    Case: ModelClass("case", documentation=_FACT),
    Enum: ModelClass(
        "enum", (Content(Member, "members"),), (*_FACT, "kind", "title", "gaps", "sparse", "printed_as", "derived")
    ),
    Member: ModelClass("member", documentation=(*_FACT, "number", "problem", "causes", "remedies")),
    Flags: ModelClass("word of flags", (Content(Bit, "bits"), Content(State, "states")), (*_FACT, "bit_0")),
    Bit: ModelClass("bit", documentation=(*_FACT, "zero", "one", "when", "scale_text")),
    State: ModelClass("state", documentation=_FACT),
    DeclaredUnit: ModelClass("unit", documentation=(*_FACT, "title", "ucum")),
    AddressSpace: ModelClass("address space", documentation=(*_FACT, "title")),
    RegisterGroup: ModelClass(
        "group of registers", (Content(Register, "registers"),), (*_FACT, "title", "section", "gaps")
    ),
    Register: ModelClass(
        "register",
        documentation=(*_FACT, *_PRINTED_ADDRESS, "number", "same_as", "copy_of", "element_name", "element_sources"),
    ),
    Table: ModelClass("table", documentation=(*_FACT, "title", *_PRINTED_ADDRESS, "elements")),
    ParameterSet: ModelClass("set of parameters", (Content(Parameter, "parameters"),), (*_FACT, "title", "printed_as")),
    Parameter: ModelClass("parameter", (Content(Subindex, "subindices"),), (*_FACT, "wire_number")),
    Subindex: ModelClass("sub-index", documentation=_FACT, key=_subindex_key),
    Signal: ModelClass("signal", documentation=(*_FACT, "direction")),
    Conversion: ModelClass("conversion", documentation=(*_FACT, "title", "printed")),
    Lookup: ModelClass("table to look up", documentation=(*_FACT, "title", "kind", "columns", "rows")),
    Limit: ModelClass("limit", documentation=(*_FACT, "sum_of", "within", "transmits")),
    Task: ModelClass(
        "task",
        documentation=(*_FACT, "direction", "halt", "kind", "messages", "not_applicable", "open", "steps"),
    ),
    Note: ModelClass("note", documentation=("title", "text", "about", "statements", "sources")),
    Example: ModelClass("example", documentation=("title", "sources", "notes"), key=attrgetter("id")),
    Erratum: ModelClass(
        "erratum",
        documentation=("fact", "printed", "literal", "illegible", "reason", "confidence", "effect", "proof", "sources"),
        key=attrgetter("id"),
    ),
    Acceptance: ModelClass("accepted change", documentation=("rule", "path", "reason", "date", "since")),
    StatedChange: ModelClass("stated change", documentation=("kind", "path", "to", "reason", "sources")),
}
"""Every class whose objects a device contains, in lists of its own or of others."""


def own_attributes(model_class: type) -> tuple[str, ...]:
    """The attributes of a class without its place, and without those that are only containers of other objects."""
    containers = {content.container for content in MODEL_CLASSES[model_class].contents if not content.has_more}
    return tuple(name for name in classes.attributes(model_class) if name not in {"place", *containers})


def descendants(item: Any) -> Iterator[Any]:
    """Everything that a device, or an object of the model, contains: in the order of the table above, each object
    before what it contains itself."""
    for content in MODEL_CLASSES[item.__class__].contents:
        for inner in content.of(item):
            yield inner
            yield from descendants(inner)
