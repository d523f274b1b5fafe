"""The occupant of an address: a register, a field of a record table, a parameter, or a message by its code."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from fieldspec.codec.layout.device import TableLayout
from fieldspec.codec.layout.record import FieldLayout
from fieldspec.foundation.classes import dataclass, field, replace
from fieldspec.language.model.fact import Citation, Fact, Place
from fieldspec.language.model.record import Message
from fieldspec.language.model.registers import Parameter, Register


@dataclass(frozen=True, slots=True)
class Occupant:
    """A fact that has addresses. `about` is its type and access in a few words."""

    name: str
    printed_name: str
    about: str
    path: str
    place: Place
    sources: tuple[Citation, ...]
    reserved: bool = False
    allowed: Mapping[str, str] = field(default_factory=dict, compare=False)

    @classmethod
    def of(cls, fact: Fact, description: str, name: str = "") -> Occupant:
        """A fact as an occupant; `name` replaces the name of the fact."""
        return cls(
            name or fact.name,
            fact.printed_name,
            description,
            fact.place.path,
            fact.place,
            fact.sources,
            bool(getattr(fact, "reserved", False)),
            fact.allowed,
        )


def of_register(register: Register) -> Iterator[tuple[int, int, Occupant]]:
    """The first and the last address of a register, or of each element where elements do not touch."""
    description = _about(register.value.type.name, register.access)
    width = max(1, register.width)
    if register.count == 1 or register.stride == width:
        last = register.index_from + register.count - 1
        name = f"{register.name}[{register.index_from}..{last}]" if register.count > 1 else ""
        yield register.address, register.address + register.count * width - 1, Occupant.of(register, description, name)
        return
    for number in range(register.count):
        first = register.address + number * register.stride
        yield (
            first,
            first + width - 1,
            Occupant.of(register, description, f"{register.name}[{register.index_from + number}]"),
        )


def of_parameter(parameter: Parameter) -> Iterator[tuple[int, int, Occupant]]:
    """The first and the last number of a parameter within its set."""
    description = _about(parameter.value.type.name, parameter.access)
    yield parameter.number, parameter.number + parameter.count - 1, Occupant.of(parameter, description)


def of_message(message: Message) -> Occupant:
    """A message as the occupant of its code."""
    return Occupant.of(message, message.title)


def element_runs(table: TableLayout) -> Iterator[tuple[int, int, Occupant]]:
    """The addresses of the fields of a table's first element; fields that share a word are one occupant together."""
    for first, words, fields in table.word_runs():
        yield table.table.base + first, table.table.base + first + words - 1, _joined(table, fields)


def _joined(table: TableLayout, fields: tuple[FieldLayout, ...]) -> Occupant:
    first = fields[0]
    type_name = first.value.type.name if first.value is not None else first.record.name if first.record else ""
    description = _about(type_name, table.access(first.field))
    name = ", ".join(f"{field.name}[{field.count}]" if field.is_list else field.name for field in fields)
    return replace(Occupant.of(first.field, description, name), reserved=all(field.field.reserved for field in fields))


def _about(type_name: str, access: str) -> str:
    return f"{type_name} {access}".strip()
