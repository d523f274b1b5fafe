"""Sets of numbered parameters, and the spaces in which they share the numbers on the wire."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import FieldLayout, Orders
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.names import Name
from fieldspec.language.model.encoding import struct_letter
from fieldspec.language.model.registers import Parameter, ParameterSet, Subindex
from fieldspec.language.model.value import Value
from fieldspec.targets.fact_texts import described, places
from fieldspec.targets.python.links import Exchange
from fieldspec.targets.python.naming import PARAMETERS, TYPES, Scope
from fieldspec.targets.python.parameter_requests import ParameterMessageView, parameter_messages
from fieldspec.targets.python.registers import ACCESS, register_value, value_facts
from fieldspec.targets.python.slots import Words, value_type
from fieldspec.targets.python.text import docstring, filled, literal
from fieldspec.targets.python.writing import pairs, tuple_of


@dataclass(frozen=True, slots=True)
class RowView:
    """A parameter, or a run of them: its attribute, the attribute's type, the lines that make it, its docstring."""

    name: str
    type: str
    lines: list[str]
    doc: list[str]


@dataclass(frozen=True, slots=True)
class NumberView:
    """A number on the wire as a constant."""

    name: str
    number: str
    doc: list[str]


@dataclass(frozen=True, slots=True)
class ParameterSetView:
    """A set of parameters; `make` is the function that creates its rows. `numbers` are empty where sets share them."""

    name: str
    type: str
    make: str
    doc: list[str]
    construction: list[str]
    rows: list[RowView]
    constants: str
    numbers: list[NumberView]
    read: ParameterMessageView | None
    write: ParameterMessageView | None

    @property
    def tables(self) -> list[list[str]]:
        """The lines of each table that the messages need."""
        return _tables(self.read, self.write)


@dataclass(frozen=True, slots=True)
class SpaceView:
    """Sets that share the numbers on the wire."""

    name: str
    title: str
    type: str
    doc: list[str]
    sets: str
    constants: str
    numbers: list[NumberView]
    read: ParameterMessageView | None
    write: ParameterMessageView | None

    @property
    def tables(self) -> list[list[str]]:
        """The lines of each table that the messages need."""
        return _tables(self.read, self.write)


def _tables(*messages: ParameterMessageView | None) -> list[list[str]]:
    return [message.table for message in messages if message is not None and message.table]


def parameter_set_view(
    parameter_set: ParameterSet, layout: DeviceLayout, words: Words, exchanges: Sequence[Exchange], scope: Scope
) -> ParameterSetView:
    """The view of a set of parameters."""
    carrier = _carrier(layout, parameter_set)
    names = Scope(PARAMETERS, TYPES)
    constant_name, pascal = scope.take(parameter_set.name), Name.of(parameter_set.name).pascal()
    alone = _alone(parameter_set, layout)
    arguments = [literal(parameter_set.name), f"_{parameter_set.name}_rows"]
    arguments += [f"title={literal(parameter_set.title)}"] if parameter_set.title else []
    arguments += [] if alone else [f"space={literal(parameter_set.space)}"]
    arguments += [f"base=0x{parameter_set.base:X}"] if parameter_set.base else []
    arguments += [f"numbers={pairs(parameter_set.numbers)}"] if parameter_set.numbers else []
    arguments += [f"printed_as={literal(parameter_set.printed_as)}"] if parameter_set.printed_as else []
    read, write = parameter_messages(exchanges, parameter_set.name, layout, words)
    kind = scope.take(f"{pascal}Set", f"{pascal}ParameterSet")
    return ParameterSetView(
        name=constant_name,
        type=kind,
        make=f"_{parameter_set.name}_rows",
        doc=docstring(described(parameter_set.title or Name.of(parameter_set.name).title(), parameter_set), 4),
        construction=filled(f"{constant_name}: _Final = {kind}(", arguments, ")", 0),
        rows=[_parameter_row(row, parameter_set, carrier, layout, words, names) for row in parameter_set.parameters],
        constants=scope.take(f"{pascal}Number", f"{pascal}ParameterNumber") if alone else "",
        numbers=_numbers([parameter_set]) if alone else [],
        read=read,
        write=write,
    )


def space_views(
    layout: DeviceLayout, sets: Sequence[ParameterSetView], words: Words, exchanges: Sequence[Exchange], scope: Scope
) -> list[SpaceView]:
    """The views of the spaces that several sets share, or whose name differs from their set's."""
    views = []
    device = layout.device
    names = {
        parameter_set.name: view.name for parameter_set, view in zip(device.parameters.values(), sets, strict=True)
    }
    shared = dict.fromkeys(
        parameter_set.space for parameter_set in device.parameters.values() if not _alone(parameter_set, layout)
    )
    for space in shared:
        members = [parameter_set for parameter_set in device.parameters.values() if parameter_set.space == space]
        read, write = (None, None)
        if space not in device.parameters:
            read, write = parameter_messages(exchanges, space, layout, words)
        pascal = Name.of(space).pascal()
        set_names = ", ".join(names[parameter_set.name] for parameter_set in members)
        views.append(
            SpaceView(
                name=scope.take(space, f"{space}_space"),
                title=space,
                type=scope.take(f"{pascal}Space", f"{pascal}ParameterSpace"),
                doc=docstring([f"The parameters of {set_names}, by the numbers on the wire."], 4),
                sets=set_names,
                constants=scope.take(f"{pascal}Number", f"{pascal}ParameterNumber"),
                numbers=_numbers(members),
                read=read,
                write=write,
            )
        )
    return views


def _alone(parameter_set: ParameterSet, layout: DeviceLayout) -> bool:
    """Whether a set fills its space alone, and has its name."""
    sharing = [other for other in layout.device.parameters.values() if other.space == parameter_set.space]
    return parameter_set.name == parameter_set.space and len(sharing) == 1


def _numbers(sets: Sequence[ParameterSet]) -> list[NumberView]:
    scope = Scope(frozenset({"mro"}))
    return [
        NumberView(
            scope.take(Name.of(row.name).upper(), f"{Name.of(parameter_set.name).upper()}_{Name.of(row.name).upper()}"),
            _digits(parameter_set.base + row.number, parameter_set),
            docstring([f"{row.printed_name or parameter_set.number_text(row.number)} of `{parameter_set.name}`."], 4),
        )
        for parameter_set in sets
        for row in parameter_set.parameters
    ]


def _digits(number: int, parameter_set: ParameterSet) -> str:
    """A number in the base in which the manual writes the numbers of its set."""
    return (
        f"0x{number:X}"
        if "x}" in parameter_set.printed_as.lower() or (parameter_set.base and not parameter_set.printed_as)
        else str(number)
    )


def _carrier(layout: DeviceLayout, parameter_set: ParameterSet) -> FieldLayout | None:
    """The field of a message that carries the values of a set, all in one type."""
    for message in layout.messages.values():
        for record in message.bodies:
            for field in record.fields:
                part = field.value.parameter if field.value else None
                if (
                    part is not None
                    and part.set in (parameter_set.name, parameter_set.space)
                    and part.part in ("value", "values")
                ):
                    return field
    return None


def _parameter_row(
    row: Parameter,
    parameter_set: ParameterSet,
    carrier: FieldLayout | None,
    layout: DeviceLayout,
    words: Words,
    names: Scope,
) -> RowView:
    value, run = row.value, row.count > 1
    orders = Orders(layout.device.byte_order, layout.device.word_order)
    order, swapped = orders.of(value)
    number, name = _digits(row.number, parameter_set), literal(row.name)
    printed_name = literal(row.printed_name or parameter_set.number_text(row.number))
    if run:
        number, name = f"{number} + place", f'f"{row.name}[{{place}}]"'
        printed_name = (
            f"{literal(parameter_set.printed_as)}.format(number={number})"
            if parameter_set.printed_as
            else f"str({number})"
        )
    properties = {
        "type": literal(value.type.name),
        "carrier": literal(_letters(row, carrier, (order == "big") != swapped)),
        "printed_name": printed_name if run or row.printed_name or parameter_set.printed_as else "",
        "default": _default(row),
        "elements": "" if row.elements is None else str(row.elements),
        "subindices": tuple_of(_subindex(row, subindex, orders, words) for subindex in row.subindices),
        "restart": "" if row.restart is None else str(row.restart),
        "applies_to": tuple_of(map(literal, row.applies_to)),
        "messages": tuple_of(map(literal, row.messages)),
        "only": tuple_of(map(literal, row.only)),
        "reserved": "True" if row.reserved else "",
        "source": literal(places(row.sources)) if row.sources else "",
        "set": literal(parameter_set.name),
        "base": f"0x{parameter_set.base:X}" if parameter_set.base else "",
    }
    keywords = [f"{key}={text}" for key, text in properties.items() if text not in ("", "()", '""')]
    arguments = [
        name,
        number,
        register_value(value, order, swapped, words, row.trigger),
        literal(row.access),
        *keywords,
    ]
    call = filled("_Parameter(", arguments, ")", 16 if run else 12)
    lines = ["tuple(", *(f"    {line}" for line in call), f"    for place in range({row.count})", ")"] if run else call
    kind = f"_Parameter[{_type(row, words)}]"
    return RowView(
        names.take(Name.of(row.name).upper()), f"tuple[{kind}, ...]" if run else kind, lines, _doc(row, parameter_set)
    )


def _letters(row: Parameter, carrier: FieldLayout | None, big: bool) -> str:
    """The Struct that turns a value into the number in a message, in its own order; empty where there is none."""
    if carrier is None or carrier.value is None:
        return ""
    kind = carrier.value.type if carrier.size == row.value.size else row.value.type
    if row.subindices or not kind.is_number or carrier.carries_bytes:
        return ""
    return f"{'>' if big else '<'}{struct_letter(kind.encoding) or kind.name}"


def _default(row: Parameter) -> str:
    default = row.value.default
    return "" if default is None else literal(default) if isinstance(default, str) else str(default)


def _subindex(row: Parameter, subindex: Subindex, orders: Orders, words: Words) -> str:
    order, swapped = orders.of(subindex.value)
    value = register_value(subindex.value, order, swapped, words, row.trigger)
    arguments = [f"type={literal(subindex.value.type.name)}"]
    arguments += [f"access={literal(subindex.access)}"] if subindex.access else []
    arguments += ["reserved=True"] if subindex.reserved else []
    arguments += [f"source={literal(places(subindex.sources))}"] if subindex.sources else []
    return f"_Subindex({', '.join([literal(subindex.name), pairs(subindex.indices), value, *arguments])})"


def _type(row: Parameter, words: Words) -> str:
    """The type of the values of a parameter and of all its elements."""
    values = [row.value, *(subindex.value for subindex in row.subindices)]
    return " | ".join(dict.fromkeys(_answer_value(value, words, row.trigger) for value in values))


def _answer_value(value: Value, words: Words, trigger: bool) -> str:
    """The type of a parameter that is read: of a trigger, any number beside the members of a closed enum."""
    suffix = " | int" if value.as_answer(trigger).enum != value.enum and not value.sentinels else ""
    return value_type(value, words) + suffix


def _doc(row: Parameter, parameter_set: ParameterSet) -> list[str]:
    last = row.number + row.count - 1
    facts = [
        f"Number {_digits(row.number, parameter_set)}"
        + (f" to {_digits(last, parameter_set)}" if row.count > 1 else "")
    ]
    if parameter_set.base:
        further = f" to 0x{parameter_set.base + last:X}" if row.count > 1 else ""
        facts.append(f"0x{parameter_set.base + row.number:X}{further} on the wire")
    facts += [row.value.type.name, *value_facts(row.value)]
    if row.elements is not None:
        facts.append(f"{row.elements} elements")
    if row.access:
        facts.append(ACCESS[row.access])
    if row.restart:
        facts.append("takes effect after a restart")
    facts += [f"for {', '.join(row.applies_to)}"] if row.applies_to else []
    facts += [f"with {', '.join(row.messages)}"] if row.messages else []
    facts += ["reserved"] if row.reserved else []
    elements = [
        f" {subindex.indices.text()} {subindex.name}: {', '.join(_element(subindex))}." for subindex in row.subindices
    ]
    head = described(Name.of(row.name).title(), row, f"{', '.join(facts)}.", *elements)
    return docstring(head, 8)


def _element(subindex: Subindex) -> list[str]:
    const = [] if subindex.value.const is None else [f"always {subindex.value.const}"]
    return [
        subindex.value.type.name,
        *value_facts(subindex.value),
        *const,
        *([ACCESS[subindex.access]] if subindex.access else []),
        *(["reserved"] if subindex.reserved else []),
    ]
