"""What a device is made of, for comparing: which nouns there are, what they hold, and who is hurt when one goes.

The table `NOUNS` is the one place that knows the shape of the model. A noun is compared with the one of the same key
in the same holder.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from operator import attrgetter
from typing import Any

from fieldspec import classes
from fieldspec.changes.change import Effect
from fieldspec.classes import dataclass
from fieldspec.model.device import Device, Version, VersionLine
from fieldspec.model.enum import Enum, Member
from fieldspec.model.erratum import Erratum
from fieldspec.model.example import Example
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
from fieldspec.model.task import Task

PYTHON, C, PLC = "Python", "C", "PLC"
ALL = (PYTHON, C, PLC)

Items = Callable[[Any], Iterable[Any]]


@dataclass(frozen=True, slots=True)
class Noun:
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


def _listed(name: str) -> Items:
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

NOUNS: dict[type, Noun] = {
    Device: Noun(
        "device",
        _B,
        _S,
        ALL,
        key=attrgetter("id"),
        holds=(
            *((noun, _listed(name), "") for noun, name in _OF_DEVICE),
            (Register, lambda device: device.registers(), ""),
        ),
        within=(*(name for _, name in _OF_DEVICE), "accepts"),
    ),
    VersionLine: Noun("line of versions", _D, _D, holds=((Version, _listed("versions"), ""),), within=("versions",)),
    Version: Noun("version", _D, _D, key=attrgetter("id")),
    Link: Noun(
        "link",
        _B,
        _W,
        (PYTHON, C),
        holds=((Part, _listed("request"), "request"), (Part, _listed("response"), "response")),
        within=("request", "response"),
    ),
    Part: Noun("part of the frame", _W, _W, (PYTHON, C)),
    Message: Noun(
        "message",
        _B,
        _W,
        ALL,
        holds=((Field, _listed("request.fields"), "request"), (Field, _listed("response.fields"), "response")),
        within=("request", "response"),
    ),
    Record: Noun("record", _B, _S, ALL, holds=((Field, _listed("fields"), ""),), within=("fields",)),
    Field: Noun("field", _W, _W, ALL, holds=((Case, _cases, ""),)),
    Case: Noun("case", _B, _W, (PYTHON,)),
    Enum: Noun("enum", _B, _S, ALL, holds=((Member, _listed("members"), ""),), within=("members",)),
    Member: Noun("member", _B, _W, ALL),
    Flags: Noun(
        "word of flags",
        _B,
        _S,
        ALL,
        holds=((Bit, _listed("bits"), ""), (State, _listed("states"), "")),
        within=("bits", "states"),
    ),
    Bit: Noun("bit", _B, _W, ALL),
    State: Noun("state", _B, _S, ALL),
    RegisterGroup: Noun("group of registers", _D, _D, within=("registers",)),
    Register: Noun("register", _B, _W, ALL),
    Table: Noun("table", _B, _W, ALL),
    ParameterSet: Noun(
        "set of parameters", _B, _W, ALL, holds=((Parameter, _listed("parameters"), ""),), within=("parameters",)
    ),
    Parameter: Noun("parameter", _B, _W, ALL, holds=((Subindex, _listed("subindices"), ""),), within=("subindices",)),
    Subindex: Noun("sub-index", _B, _W, ALL, key=_subindex),
    Signal: Noun("signal", _B, _S, ALL),
    Conversion: Noun("conversion", _B, _S, (PYTHON, C)),
    Lookup: Noun("table to look up", _D, _D),
    Limit: Noun("limit", _B, _B),
    Task: Noun("task", _D, _D),
    Note: Noun("note", _D, _D),
    Example: Noun("example", _D, _D, key=attrgetter("id")),
    Erratum: Noun("erratum", _D, _D, key=attrgetter("id")),
}

_NEVER = ("place",)


def attributes(noun: type) -> tuple[str, ...]:
    """The attributes of a noun that are its own: neither its place nor what it holds."""
    return tuple(name for name in classes.attributes(noun) if name not in (*_NEVER, *NOUNS[noun].within))


OWN: dict[type, Callable[[Any], tuple[object, ...]]] = {noun: attrgetter(*attributes(noun)) for noun in NOUNS}
"""The own attributes of a noun as one tuple."""
