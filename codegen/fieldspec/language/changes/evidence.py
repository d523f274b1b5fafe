"""What proves that two objects with different names are the same, and values of the model as text."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping, Sequence
from decimal import Decimal
from typing import Any

from fieldspec.foundation.classes import attributes, dataclass
from fieldspec.language.model.address_space import AddressSpace
from fieldspec.language.model.device import Manual
from fieldspec.language.model.enums import Bit, Cause, Enum, Flags, Member, State
from fieldspec.language.model.fact import Citation, Claim
from fieldspec.language.model.link import Link, Part
from fieldspec.language.model.primitives import Primitive
from fieldspec.language.model.ranges import Ranges
from fieldspec.language.model.record import Case, Field, Message, Record
from fieldspec.language.model.registers import Parameter, ParameterSet, Register, RegisterGroup, Subindex, Table
from fieldspec.language.model.texts import Erratum, Example, Limit, Lookup, LookupColumn, Note
from fieldspec.language.model.value import Conversion, ParameterPart, ParameterSizes, Signal, Value

NOTHING = "nothing"


def hexadecimal(number: int | None) -> str:
    """An address or a code as in `0x2011` or `0x2F`; empty for None."""
    return "" if number is None else f"0x{number:04X}" if number > 0xFF else f"0x{number:02X}"


def value_text(value: object) -> str:
    """A value of the model as text; empty for None."""
    if value is None:
        return ""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, Decimal):
        return decimal_text(value)
    if isinstance(value, bytes):
        return value.hex(" ").upper()
    if isinstance(value, Ranges | Citation):
        return value.text()
    if isinstance(value, Primitive):
        return value.name
    if isinstance(value, ParameterPart):
        sizes = f", {value_text(value.sizes)}" if value.sizes else ""
        return f"{value.part} of {value.set}" + (f" by {value.number}" if value.number else "") + sizes
    if isinstance(value, ParameterSizes):
        cases = (f"{case.bytes} for {' or '.join(case.when)}" for case in value.cases)
        return f"bytes by {value.by}: {', '.join(cases)}"
    if isinstance(value, Claim):
        return f"{value_text(value.values)} in {value_text(value.sources)}"
    if isinstance(value, LookupColumn | Cause | Manual):
        parts = (value_text(getattr(value, name)) for name in attributes(value.__class__))
        return ": ".join(part for part in parts if part)
    if isinstance(value, Mapping):
        return ", ".join(f"{key}: {value_text(inner)}" for key, inner in value.items())
    if isinstance(value, Sequence) and not isinstance(value, str):
        return ", ".join(map(value_text, value))
    return str(value)


def decimal_text(number: Decimal) -> str:
    """An exact number without an exponent and without zeros at its end."""
    text = f"{number:f}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def quoted(value: object) -> str:
    """A value as text for a sentence: `nothing` where it is empty."""
    return value_text(value) or NOTHING


def enumeration(words: Sequence[object], limit: int = 6) -> str:
    """Words as a list: `a, b and c`, or `a, b, c, d, e and 12 more`."""
    texts = [str(word) for word in words]
    if len(texts) > limit:
        texts = [*texts[: limit - 1], f"{len(texts) - limit + 1} more"]
    return texts[0] if len(texts) == 1 else ", ".join(texts[:-1]) + " and " + texts[-1]


@dataclass(frozen=True, slots=True)
class Surroundings:
    """The data of the objects that surround an object.

    `offsets` are the runs and offsets of the fields beside it, by their identity in memory. `places_of_signals` are the
    places of the fields that carry each signal.
    """

    offsets: Mapping[int, tuple[int, int]]
    places_of_signals: Mapping[str, tuple[str, ...]]


@dataclass(frozen=True, slots=True)
class Evidence:
    """What two objects must have in common to be the same, and how a message describes it."""

    of: Callable[[Any, Surroundings], Hashable]
    describe: Callable[[Any, Surroundings], str]


def _type(value: Value | None, record: str = "") -> str:
    if value is None:
        return record or "choice"
    return value.type.name if value.type.size else f"{value.type.name} of {value.size} bytes"


def _field(field: Field, surroundings: Surroundings) -> Hashable:
    return (surroundings.offsets.get(id(field)), _type(field.value, field.record), field.count, field.repeat)


def _at(field: Field | Part, surroundings: Surroundings) -> int:
    return surroundings.offsets[id(field)][1]


def _members(enum: Enum, _: Surroundings) -> Hashable:
    return tuple((member.value, member.name) for member in enum.members) or None


def _signal(signal: Signal, surroundings: Surroundings) -> Hashable:
    places = surroundings.places_of_signals.get(signal.name)
    return (places, _type(signal.value)) if places else None


def _message(message: Message, _: Surroundings) -> Hashable:
    if message.code is not None:
        return ("code", message.code, message.links)
    return ("number", message.number, message.links) if message.number is not None else None


def _coded(message: Message) -> str:
    return f"code {hexadecimal(message.code)}" if message.code is not None else f"number {message.number}"


EVIDENCE: dict[type, Evidence] = {
    Link: Evidence(
        lambda link, _: (
            link.transmission,
            link.delimiters("request"),
            link.delimiters("response"),
            *((part.name, part.role, part.algorithm) for part in (*link.request, *link.response)),
        ),
        lambda *_: "the same delimiters, and the same parts of its frames",
    ),
    Part: Evidence(
        lambda part, surroundings: (surroundings.offsets.get(id(part)), part.role, part.algorithm, _type(part.value)),
        lambda part, surroundings: f"the same role {part.role} at offset {_at(part, surroundings)}",
    ),
    Message: Evidence(_message, lambda message, _: f"the same {_coded(message)}"),
    Record: Evidence(
        lambda record, _: tuple((field.name, _type(field.value, field.record)) for field in record.fields) or None,
        lambda *_: "the same fields",
    ),
    Field: Evidence(
        _field,
        lambda field, surroundings: (
            f"the same offset {_at(field, surroundings)} and type {_type(field.value, field.record)}"
        ),
    ),
    Case: Evidence(
        lambda case, _: (case.when, _type(case.value)),
        lambda case, _: f"the same type for {value_text(case.when)}",
    ),
    Enum: Evidence(_members, lambda *_: "the same members"),
    Member: Evidence(lambda member, _: member.value, lambda member, _: f"the same value {member.value}"),
    Flags: Evidence(
        lambda flags, _: (flags.type.name, *((bit.number_text, bit.name) for bit in flags.bits)),
        lambda *_: "the same bits",
    ),
    Bit: Evidence(
        lambda bit, _: None if bit.reserved else bit.number_text,
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
"""By class of the model. An object of any other class is never recognised by another name."""


def bits(bit: Bit) -> str:
    """The bits of a field of bits: `bit 3`, or `bits 4..5`."""
    return f"bit{'s' * (bit.width > 1)} {bit.number_text}"
