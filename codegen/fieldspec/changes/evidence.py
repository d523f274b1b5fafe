"""What shows that a thing with another name is the same thing: that by which the wire, or the manual, knows it."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping
from typing import Any

from fieldspec.changes.spelling import hexadecimal, spelled
from fieldspec.classes import dataclass
from fieldspec.model.address_space import AddressSpace
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
from fieldspec.model.value import Value


@dataclass(frozen=True, slots=True)
class Around:
    """What is known of where a thing stands: the runs and offsets of the fields beside it, by their identity in
    memory, and the places of the fields that each signal fills."""

    offsets: Mapping[int, tuple[int, int]]
    placed: Mapping[str, tuple[str, ...]]


@dataclass(frozen=True, slots=True)
class Evidence:
    """What two things must have in common to be one, and how this is said."""

    of: Callable[[Any, Around], Hashable]
    said: Callable[[Any, Around], str]


def _type(value: Value | None, record: str = "") -> str:
    if value is None:
        return record or "choice"
    return value.type.name if value.type.size else f"{value.type.name} of {value.size} bytes"


def _field(field: Field, around: Around) -> Hashable:
    return (around.offsets.get(id(field)), _type(field.value, field.record), field.count, field.repeat)


def _at(field: Field | Part, around: Around) -> int:
    return around.offsets[id(field)][1]


def _members(enum: Enum, _: Around) -> Hashable:
    return tuple((member.value, member.name) for member in enum.members) or None


def _signal(signal: Signal, around: Around) -> Hashable:
    places = around.placed.get(signal.name)
    return (places, _type(signal.value)) if places else None


def _message(message: Message, _: Around) -> Hashable:
    if message.code is not None:
        return ("code", message.code, message.links)
    return ("number", message.number, message.links) if message.number is not None else None


def _coded(message: Message) -> str:
    return f"code {hexadecimal(message.code)}" if message.code is not None else f"number {message.number}"


EVIDENCE: dict[type, Evidence] = {
    Link: Evidence(
        lambda link, _: (
            link.encoding,
            link.start,
            link.end,
            *((part.name, part.role, part.algorithm) for part in (*link.request, *link.response)),
        ),
        lambda *_: "the same marks, and the same parts of its frames",
    ),
    Part: Evidence(
        lambda part, around: (around.offsets.get(id(part)), part.role, part.algorithm, _type(part.value)),
        lambda part, around: f"the same role {part.role} at offset {_at(part, around)}",
    ),
    Message: Evidence(_message, lambda message, _: f"the same {_coded(message)}"),
    Record: Evidence(
        lambda record, _: tuple((field.name, _type(field.value, field.record)) for field in record.fields) or None,
        lambda *_: "the same fields",
    ),
    Field: Evidence(
        _field,
        lambda field, around: f"the same offset {_at(field, around)} and type {_type(field.value, field.record)}",
    ),
    Case: Evidence(
        lambda case, _: (case.when, _type(case.value)),
        lambda case, _: f"the same type for {spelled(case.when)}",
    ),
    Enum: Evidence(_members, lambda *_: "the same members"),
    Member: Evidence(lambda member, _: member.value, lambda member, _: f"the same value {member.value}"),
    Flags: Evidence(
        lambda flags, _: (flags.type.name, *((bit.first, bit.last, bit.name) for bit in flags.bits)),
        lambda *_: "the same bits",
    ),
    Bit: Evidence(
        lambda bit, _: None if bit.reserved else (bit.first, bit.last),
        lambda bit, _: f"the same {bits(bit)}",
    ),
    State: Evidence(lambda state, _: (state.set, state.clear), lambda *_: "the same bits"),
    AddressSpace: Evidence(
        lambda one, _: (one.unit, one.bounds, one.first_number, one.title), lambda *_: "the same addresses and title"
    ),
    RegisterGroup: Evidence(
        lambda group, _: tuple(register.address for register in group.registers) or None,
        lambda *_: "the same registers",
    ),
    Register: Evidence(
        lambda one, _: (one.space, one.address, _type(one.value), one.count, one.stride),
        lambda one, _: f"the same address {hexadecimal(one.address)} and type {_type(one.value)}",
    ),
    Table: Evidence(
        lambda table, _: (table.base, table.stride, table.count),
        lambda table, _: f"the same base {hexadecimal(table.base)}, stride and count",
    ),
    ParameterSet: Evidence(
        lambda held, _: (held.base, *((one.number, one.name) for one in held.parameters)),
        lambda *_: "the same parameters",
    ),
    Parameter: Evidence(
        lambda one, _: (one.number, _type(one.value), one.count, one.elements),
        lambda one, _: f"the same number {one.number} and type {_type(one.value)}",
    ),
    Subindex: Evidence(
        lambda one, _: (one.indices, _type(one.value)),
        lambda one, _: f"the same indices {one.indices.text()} and type {_type(one.value)}",
    ),
    Signal: Evidence(_signal, lambda *_: "the same type, placed by the same fields"),
    Conversion: Evidence(
        lambda one, _: (one.type.name, one.full_scale, one.complement, one.signals),
        lambda *_: "the same formula for the same signals",
    ),
    Lookup: Evidence(lambda one, _: tuple(row.cells for row in one.rows) or None, lambda *_: "the same rows"),
    Limit: Evidence(
        lambda one, _: (one.kind, one.value, one.low, one.high, one.text, one.unit, one.label, one.printed_name),
        lambda *_: "the same numbers and labels",
    ),
    Note: Evidence(lambda note, _: note.text, lambda *_: "the same text"),
    Example: Evidence(lambda one, _: (one.frame, one.link, one.direction), lambda *_: "the same frame"),
    Erratum: Evidence(
        lambda one, _: (one.fact, one.literal, repr(one.printed)), lambda *_: "the same fact with the same print"
    ),
}
"""By the class of the model; a thing whose class is not here is never said to be renamed."""


def bits(bit: Bit) -> str:
    """`bit 3`, or `bits 4..5`"""
    return f"bit {bit.first}" if bit.width == 1 else f"bits {bit.first}..{bit.last}"
