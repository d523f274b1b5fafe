"""What shows that two items with different names are the same, and values of the model as text."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping, Sequence
from decimal import Decimal
from typing import Any

from fieldspec.classes import attributes, dataclass
from fieldspec.model.address_space import AddressSpace
from fieldspec.model.device import Manual
from fieldspec.model.enums import Bit, Cause, Enum, Flags, Member, State
from fieldspec.model.fact import Citation, Claim
from fieldspec.model.link import Link, Part
from fieldspec.model.record import Case, Field, Message, Record
from fieldspec.model.registers import Parameter, ParameterSet, Register, RegisterGroup, Subindex, Table
from fieldspec.model.texts import Erratum, Example, Limit, Lookup, LookupColumn, Note
from fieldspec.model.value import Conversion, ParameterPart, Primitive, Ranges, Signal, Value

NOTHING = "nothing"


def hexadecimal(number: int | None) -> str:
    """`0x2011`"""
    return "" if number is None else f"0x{number:04X}" if number > 0xFF else f"0x{number:02X}"


def value_text(held: object) -> str:
    """A value as text; an empty one for nothing."""
    if held is None:
        return ""
    if isinstance(held, bool):
        return "yes" if held else "no"
    if isinstance(held, Decimal):
        return decimal_text(held)
    if isinstance(held, bytes):
        return held.hex(" ").upper()
    if isinstance(held, Ranges | Citation):
        return held.text()
    if isinstance(held, Primitive):
        return held.name
    if isinstance(held, ParameterPart):
        return f"{held.part} of {held.set}" + (f" by {held.number}" if held.number else "")
    if isinstance(held, Claim):
        return f"{value_text(held.values)} in {value_text(held.sources)}"
    if isinstance(held, LookupColumn | Cause | Manual):
        parts = (value_text(getattr(held, name)) for name in attributes(held.__class__))
        return ": ".join(part for part in parts if part)
    if isinstance(held, Mapping):
        return ", ".join(f"{key}: {value_text(value)}" for key, value in held.items())
    if isinstance(held, Sequence) and not isinstance(held, str):
        return ", ".join(map(value_text, held))
    return str(held)


def decimal_text(number: Decimal) -> str:
    """An exact number without an exponent or needless zeros."""
    text = f"{number:f}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def quoted(value: object) -> str:
    """The same for a sentence: `nothing` for nothing."""
    return value_text(value) or NOTHING


def enumeration(words: Sequence[object], most: int = 6) -> str:
    """`a, b and c`, or `a, b, c, d, e and 12 more`"""
    texts = [str(word) for word in words]
    if len(texts) > most:
        texts = [*texts[: most - 1], f"{len(texts) - most + 1} more"]
    return texts[0] if len(texts) == 1 else ", ".join(texts[:-1]) + " and " + texts[-1]


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
    describe: Callable[[Any, Around], str]


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
        lambda case, _: f"the same type for {value_text(case.when)}",
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
        lambda space, _: (space.unit, space.bounds, space.first_number, space.title),
        lambda *_: "the same addresses and title",
    ),
    RegisterGroup: Evidence(
        lambda group, _: tuple(register.address for register in group.registers) or None,
        lambda *_: "the same registers",
    ),
    Register: Evidence(
        lambda register, _: (register.space, register.address, _type(register.value), register.count, register.stride),
        lambda register, _: f"the same address {hexadecimal(register.address)} and type {_type(register.value)}",
    ),
    Table: Evidence(
        lambda table, _: (table.base, table.stride, table.count),
        lambda table, _: f"the same base {hexadecimal(table.base)}, stride and count",
    ),
    ParameterSet: Evidence(
        lambda parameter_set, _: (
            parameter_set.base,
            *((parameter.number, parameter.name) for parameter in parameter_set.parameters),
        ),
        lambda *_: "the same parameters",
    ),
    Parameter: Evidence(
        lambda parameter, _: (parameter.number, _type(parameter.value), parameter.count, parameter.elements),
        lambda parameter, _: f"the same number {parameter.number} and type {_type(parameter.value)}",
    ),
    Subindex: Evidence(
        lambda subindex, _: (subindex.indices, _type(subindex.value)),
        lambda subindex, _: f"the same indices {subindex.indices.text()} and type {_type(subindex.value)}",
    ),
    Signal: Evidence(_signal, lambda *_: "the same type, placed by the same fields"),
    Conversion: Evidence(
        lambda conversion, _: (conversion.type.name, conversion.full_scale, conversion.complement, conversion.signals),
        lambda *_: "the same formula for the same signals",
    ),
    Lookup: Evidence(lambda lookup, _: tuple(row.cells for row in lookup.rows) or None, lambda *_: "the same rows"),
    Limit: Evidence(
        lambda limit, _: (
            limit.kind,
            limit.value,
            limit.low,
            limit.high,
            limit.text,
            limit.unit,
            limit.label,
            limit.printed_name,
        ),
        lambda *_: "the same numbers and labels",
    ),
    Note: Evidence(lambda note, _: note.text, lambda *_: "the same text"),
    Example: Evidence(lambda example, _: (example.frame, example.link, example.direction), lambda *_: "the same frame"),
    Erratum: Evidence(
        lambda erratum, _: (erratum.fact, erratum.literal, repr(erratum.printed)),
        lambda *_: "the same fact with the same print",
    ),
}
"""By the class of the model; a thing whose class is not here is never said to be renamed."""


def bits(bit: Bit) -> str:
    """`bit 3`, or `bits 4..5`"""
    return f"bit {bit.first}" if bit.width == 1 else f"bits {bit.first}..{bit.last}"
