"""The texts of each class of the model: what no output computes with, and people read."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from operator import attrgetter
from typing import Any, TypeAlias

from fieldspec.classes import attributes
from fieldspec.model.device import Device, Version, VersionLine
from fieldspec.model.enum import Enum, Member
from fieldspec.model.erratum import Erratum
from fieldspec.model.example import Example
from fieldspec.model.fact import Claim
from fieldspec.model.flags import Bit, Flags, State
from fieldspec.model.limit import Limit
from fieldspec.model.link import Link, Part
from fieldspec.model.lookup import Lookup
from fieldspec.model.message import Message
from fieldspec.model.note import Note
from fieldspec.model.parameter import Parameter, ParameterSet, Subindex
from fieldspec.model.record import Case, Field, Record
from fieldspec.model.register import Register, RegisterGroup
from fieldspec.model.signal import Conversion, Signal
from fieldspec.model.table import Table
from fieldspec.model.task import Step, Task

STEP = tuple(name for name in attributes(Step) if name != "place")
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
        "stations": _beside("stations", "rule", "notes", "sources"),
        "serial": _beside("serial", "sources"),
        "error": _beside("error", "sources"),
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
