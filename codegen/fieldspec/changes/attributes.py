"""The classes of the model for comparing: their items, attributes and texts."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from operator import attrgetter
from typing import Any, TypeAlias

from fieldspec import classes
from fieldspec.changes.change import Effect
from fieldspec.classes import dataclass
from fieldspec.model.address_space import AddressSpace
from fieldspec.model.device import Device, Version, VersionLine
from fieldspec.model.enums import Bit, Enum, Flags, Member, State
from fieldspec.model.fact import Claim
from fieldspec.model.link import Link, Part
from fieldspec.model.record import Case, Field, Message, Record
from fieldspec.model.registers import Parameter, ParameterSet, Register, RegisterGroup, Subindex, Table
from fieldspec.model.task import Step, Task
from fieldspec.model.texts import Erratum, Example, Limit, Lookup, Note
from fieldspec.model.value import Conversion, Signal

# The table `NOUNS` is the one place that knows the shape of the model. A noun is compared with the one of the same key
# in the same holder.

PYTHON, C, PLC = "Python", "C", "PLC"
ALL = (PYTHON, C, PLC)

Items = Callable[[Any], Iterable[Any]]


@dataclass(frozen=True, slots=True)
class ModelClass:
    """How one class of the model is compared.

    `kind` is what users call it, `outputs` are those in which its name stands. `adding` and `removing` are the effects
    of a new one and of one that is gone. `holds` gives the nouns in it, list by list, with the direction of those
    of a frame; `within` are the attributes in which they lie, which are not compared as such.
    """

    kind: str
    adding: Effect
    removing: Effect
    outputs: tuple[str, ...] = ()
    key: Callable[[Any], object] = attrgetter("name")
    holds: tuple[tuple[type, Items, str], ...] = ()
    within: tuple[str, ...] = ()

    @property
    def renaming(self) -> Effect:
        """The effect of another name."""
        return Effect.SOURCE if self.outputs else Effect.DOCS


def _attribute_items(name: str) -> Items:
    """The items of a list, or the values of a mapping, that stands in an attribute."""
    get = attrgetter(name)

    def items(holder: Any) -> Iterable[Any]:
        held = get(holder)
        return held.values() if isinstance(held, Mapping) else held

    return items


def _subindex(subindex: Subindex) -> str:
    return subindex.name or subindex.indices.text()


def _cases(field: Field) -> tuple[Case, ...]:
    return field.choice.cases if field.choice is not None else ()


_W, _S, _B, _D = Effect.WIRE, Effect.SOURCE, Effect.BEHAVIOUR, Effect.DOCS

_OF_DEVICE: tuple[tuple[type, str], ...] = (
    (VersionLine, "lines"),
    (Link, "links"),
    (Message, "messages"),
    (Record, "records"),
    (Enum, "enums"),
    (Flags, "flags"),
    (AddressSpace, "spaces"),
    (RegisterGroup, "groups"),
    (Table, "tables"),
    (ParameterSet, "parameters"),
    (Signal, "signals"),
    (Conversion, "conversions"),
    (Lookup, "lookups"),
    (Limit, "limits"),
    (Task, "tasks"),
    (Note, "notes"),
    (Example, "examples"),
    (Erratum, "errata"),
)

MODEL_CLASSES: dict[type, ModelClass] = {
    Device: ModelClass(
        "device",
        _B,
        _S,
        ALL,
        key=attrgetter("id"),
        holds=(
            *((noun, _attribute_items(name), "") for noun, name in _OF_DEVICE),
            (Register, lambda device: device.registers(), ""),
        ),
        within=(*(name for _, name in _OF_DEVICE), "accepts"),
    ),
    VersionLine: ModelClass(
        "line of versions", _D, _D, holds=((Version, _attribute_items("versions"), ""),), within=("versions",)
    ),
    Version: ModelClass("version", _D, _D, key=attrgetter("id")),
    Link: ModelClass(
        "link",
        _B,
        _W,
        (PYTHON, C),
        holds=((Part, _attribute_items("request"), "request"), (Part, _attribute_items("response"), "response")),
        within=("request", "response"),
    ),
    Part: ModelClass("part of the frame", _W, _W, (PYTHON, C)),
    Message: ModelClass(
        "message",
        _B,
        _W,
        ALL,
        holds=(
            (Field, _attribute_items("request.fields"), "request"),
            (Field, _attribute_items("response.fields"), "response"),
        ),
        within=("request", "response"),
    ),
    Record: ModelClass("record", _B, _S, ALL, holds=((Field, _attribute_items("fields"), ""),), within=("fields",)),
    Field: ModelClass("field", _W, _W, ALL, holds=((Case, _cases, ""),)),
    Case: ModelClass("case", _B, _W, (PYTHON,)),
    Enum: ModelClass("enum", _B, _S, ALL, holds=((Member, _attribute_items("members"), ""),), within=("members",)),
    Member: ModelClass("member", _B, _W, ALL),
    Flags: ModelClass(
        "word of flags",
        _B,
        _S,
        ALL,
        holds=((Bit, _attribute_items("bits"), ""), (State, _attribute_items("states"), "")),
        within=("bits", "states"),
    ),
    Bit: ModelClass("bit", _B, _W, ALL),
    State: ModelClass("state", _B, _S, ALL),
    AddressSpace: ModelClass("address space", _B, _S, (PYTHON,)),
    RegisterGroup: ModelClass("group of registers", _D, _D, within=("registers",)),
    Register: ModelClass("register", _B, _W, ALL),
    Table: ModelClass("table", _B, _W, ALL),
    ParameterSet: ModelClass(
        "set of parameters",
        _B,
        _W,
        ALL,
        holds=((Parameter, _attribute_items("parameters"), ""),),
        within=("parameters",),
    ),
    Parameter: ModelClass(
        "parameter", _B, _W, ALL, holds=((Subindex, _attribute_items("subindices"), ""),), within=("subindices",)
    ),
    Subindex: ModelClass("sub-index", _B, _W, ALL, key=_subindex),
    Signal: ModelClass("signal", _B, _S, ALL),
    Conversion: ModelClass("conversion", _B, _S, (PYTHON, C)),
    Lookup: ModelClass("table to look up", _D, _D),
    Limit: ModelClass("limit", _B, _B),
    Task: ModelClass("task", _D, _D),
    Note: ModelClass("note", _D, _D),
    Example: ModelClass("example", _D, _D, key=attrgetter("id")),
    Erratum: ModelClass("erratum", _D, _D, key=attrgetter("id")),
}

_NEVER = ("place",)


def attributes(noun: type) -> tuple[str, ...]:
    """The attributes of a noun that are its own: neither its place nor what it holds."""
    return tuple(name for name in classes.attributes(noun) if name not in (*_NEVER, *MODEL_CLASSES[noun].within))


DEVICE_ATTRIBUTES: dict[type, Callable[[Any], tuple[object, ...]]] = {
    noun: attrgetter(*attributes(noun)) for noun in MODEL_CLASSES
}
"""The own attributes of a noun as one tuple."""


STEP = tuple(name for name in classes.attributes(Step) if name != "place")
"""What is compared of a step."""

Texts: TypeAlias = Mapping[str, Callable[[Any], Any]]

_KEYS = {"sources": "source", "low": "min", "high": "max"}
"""Attributes whose keys have other names."""


def _named(*attributes: str) -> Texts:
    """The values of attributes by the keys of the spec."""
    return {_KEYS.get(name, name): attrgetter(name) for name in attributes}


def _restated(fact: Any) -> object:
    """Claims without their places in the spec."""
    claims: tuple[Claim, ...] = fact.restated
    return tuple((claim.sources, dict(claim.values)) for claim in claims)


def _beside(name: str, *attributes: str) -> Callable[[Any], object]:
    """The texts of something that a fact has or has not."""
    get = attrgetter(name)

    def texts(fact: Any) -> object:
        held = get(fact)
        return tuple(getattr(held, one) for one in attributes) if held is not None else ()

    return texts


def _scale(fact: Any) -> str:
    """The scale as it is written."""
    return fact.value.scale_text if fact.value is not None else ""


def _sentinels(fact: Any) -> dict[int, object]:
    """What is said of each sentinel."""
    return {one.value: (one.doc, one.sources) for one in fact.value.sentinels} if fact.value is not None else {}


_FACT: Texts = {
    **_named(
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
    ),
    "reported": lambda fact: tuple((one.by, one.how, dict(one.values)) for one in fact.reported),
    "restated": _restated,
}
_OF_VALUE: Texts = {**_FACT, "scale": _scale, "sentinels": _sentinels}
_PRINTED_ADDRESS = ("decimal", "words")

TEXTS: dict[type, Texts] = {
    Device: _named("name", "vendor", "title", "doc", "manual"),
    VersionLine: _named("title", "like", "inferred"),
    Version: _named("title", "doc", "inferred", "sources"),
    Link: {
        **_FACT,
        **_named("title", "message_name", "request_name", "response_name"),
        "unit_addresses": _beside("unit_addresses", "rule", "notes", "sources"),
        "serial": _beside("serial", "sources"),
        "exception_response": _beside("exception_response", "sources"),
        "silence": attrgetter("silence_sources"),
    },
    Part: _OF_VALUE,
    Message: {
        **_FACT,
        **_named("title", "group", "request_length", "response_length", "request_words", "response_words"),
    },
    Record: {**_FACT, **_named("size", "words", "same_as")},
    Field: {**_OF_VALUE, **_named("at", "words", "span", "word_span", "signal")},
    Case: _OF_VALUE,
    Enum: {**_FACT, **_named("kind", "title", "gaps", "printed_as", "derived")},
    Member: {
        **_FACT,
        **_named("number", "problem", "causes", "remedies"),
    },
    Flags: _FACT,
    Bit: {**_FACT, **_named("zero", "one", "when")},
    State: _FACT,
    RegisterGroup: {
        **_FACT,
        **_named("title", "section"),
        "gaps": lambda group: tuple((gap.addresses, gap.reason, gap.sources) for gap in group.gaps),
    },
    Register: {
        **_OF_VALUE,
        **_named(*_PRINTED_ADDRESS, "number", "same_as", "copy_of", "element_name", "element_sources"),
    },
    Table: {
        **_FACT,
        **_named("title", *_PRINTED_ADDRESS),
        "elements": lambda table: tuple(
            (one.index, one.first, one.last, one.words, one.sources) for one in table.elements
        ),
    },
    ParameterSet: {**_FACT, **_named("title", "printed_as")},
    Parameter: {**_OF_VALUE, **_named("wire_number")},
    Subindex: _OF_VALUE,
    Signal: {**_OF_VALUE, **_named("direction")},
    Conversion: {**_FACT, **_named("title", "printed")},
    Lookup: {
        **_FACT,
        **_named("title", "kind", "columns"),
        "rows": lambda lookup: tuple((row.cells, row.notes, row.sources, row.only) for row in lookup.rows),
    },
    AddressSpace: {**_FACT, **_named("title")},
    Limit: {**_FACT, **_named("sum_of", "within", "transmits")},
    Task: {
        **_FACT,
        **_named("kind", "messages", "not_applicable", "open"),
        "steps": lambda task: tuple(tuple(getattr(step, name) for name in STEP) for step in task.steps),
    },
    Note: {
        **_named("title", "text", "about", "sources"),
        "statements": lambda note: tuple((one.subject, one.says, one.text, one.sources) for one in note.statements),
    },
    Example: _named("title", "sources", "notes"),
    Erratum: _named("fact", "printed", "literal", "illegible", "reason", "confidence", "effect", "proof", "sources"),
}
"""By class, the keys of the spec with the function that gives the text from the model."""
