"""Registers, tables and parameters as constants."""

from __future__ import annotations

from dataclasses import dataclass

from fieldspec.backends.python.naming import PARAMETERS, TYPES, Scope
from fieldspec.backends.python.slots import Words
from fieldspec.backends.python.text import described, docstring, literal
from fieldspec.backends.python.values import value_expression, value_facts
from fieldspec.layout.device import DeviceLayout, RegisterLayout, TableLayout
from fieldspec.layout.record import FieldLayout
from fieldspec.model.parameter import Parameter, ParameterSet
from fieldspec.model.value import Value
from fieldspec.names import Name

ACCESS = {"ro": "read only", "rw": "read and write", "wo": "write only"}


@dataclass(frozen=True, slots=True)
class ConstantView:
    """A constant: its name, the call that makes it, and its docstring."""

    name: str
    call: str
    doc: list[str]


@dataclass(frozen=True, slots=True)
class TableView:
    """A table: its variable, its class, and the arguments of the class."""

    name: str
    type: str
    record: str
    arguments: str
    doc: list[str]


@dataclass(frozen=True, slots=True)
class ParameterMessageView:
    """A message that reads or writes one parameter: its classes, and the attributes that carry number and value."""

    request: str
    response: str
    number: str
    value: str


@dataclass(frozen=True, slots=True)
class ParameterSetView:
    """A set of parameters."""

    name: str
    type: str
    doc: list[str]
    parameters: list[ConstantView]
    read: ParameterMessageView | None
    write: ParameterMessageView | None


def register_view(laid: RegisterLayout, words: Words, order: str, scope: Scope) -> ConstantView:
    """The view of a register, or of an array of registers. `order` is the byte order of the device."""
    register = laid.register
    name = scope.take(Name.of(laid.name).upper())
    value = value_expression(register.value, 2 * laid.words, laid.order, laid.swapped, words)
    arguments = [literal(laid.name), f"0x{laid.address:04X}", str(laid.words), value, literal(register.access)]
    if laid.count > 1:
        arguments += [f"count={laid.count}", f"first={register.index_from}", f"stride={laid.stride}"]
    arguments += [f"{key}=True" for key, held in (("atomic", register.atomic), ("trigger", register.trigger)) if held]
    if order == "little":
        arguments.append('order="<"')
    facts = [f"0x{laid.address:04X}", f"{laid.words} word{'s' if laid.words > 1 else ''}"]
    if register.access:
        facts.append(ACCESS[register.access])
    facts.append(register.value.type.name)
    facts += value_facts(register.value)
    if register.restart:
        facts.append("takes effect after a restart")
    if register.atomic:
        facts.append("all words in one request")
    if register.trigger:
        facts.append("writing starts an action")
    if register.same_as:
        facts.append(f"the same as {Name.of(register.same_as).upper()}")
    if laid.count > 1:
        last = register.index_from + laid.count - 1
        facts.append(f"{laid.count} of them, {register.index_from} to {last}")
    doc = docstring(described(Name.of(laid.name).title(), register, f"{', '.join(facts)}."))
    return ConstantView(name, f"{'_RegisterArray' if laid.count > 1 else '_Register'}({', '.join(arguments)})", doc)


def table_view(laid: TableLayout, words: Words, order: str, scope: Scope) -> TableView:
    """The view of a table of records."""
    table = laid.table
    record = words.records[table.record]
    arguments = [
        literal(laid.name),
        record,
        f"base=0x{table.base:04X}",
        f"words={laid.words}",
        f"stride={table.stride}",
        f"count={table.count}",
        f"first={table.index_from}",
    ]
    if table.access:
        arguments.append(f"access={literal(table.access)}")
    if order == "little":
        arguments.append('order="<"')
    last = table.index_from + table.count - 1
    facts = [
        f"{table.count} records of {laid.words} words, {table.index_from} to {last}",
        f"the first at 0x{table.base:04X}, each {table.stride} words behind the one before",
    ]
    if table.access:
        facts.append(ACCESS[table.access])
    doc = docstring(described(table.title or Name.of(table.name).title(), table, f"{', '.join(facts)}."), 4)
    name = scope.take(laid.name)
    return TableView(name, scope.take(f"{Name.of(laid.name).pascal()}Table"), record, ", ".join(arguments), doc)


def parameter_set_view(
    held: ParameterSet,
    layout: DeviceLayout,
    words: Words,
    read: ParameterMessageView | None,
    write: ParameterMessageView | None,
    scope: Scope,
) -> ParameterSetView:
    """The view of a set of parameters; `read` and `write` are the messages for one parameter, where there are any."""
    carrier = _carrier(layout, held)
    names = Scope(PARAMETERS, TYPES)
    name = scope.take(held.name)
    return ParameterSetView(
        name=name,
        type=scope.take(f"{Name.of(held.name).pascal()}Set", f"{Name.of(held.name).pascal()}ParameterSet"),
        doc=docstring(described(held.title or Name.of(held.name).title(), held), 4),
        parameters=[_parameter(parameter, carrier, layout, words, names) for parameter in held.parameters],
        read=read,
        write=write,
    )


def _carrier(layout: DeviceLayout, held: ParameterSet) -> FieldLayout | None:
    """A field of a message that carries values of a set."""
    for message in layout.messages.values():
        for record in (message.request, message.response):
            for field in record.fields:
                part = field.value.parameter if field.value else None
                if part is not None and part.set == held.name and part.part in ("value", "values"):
                    return field
    return None


def _parameter(
    parameter: Parameter, carrier: FieldLayout | None, layout: DeviceLayout, words: Words, names: Scope
) -> ConstantView:
    value: Value = parameter.value
    order = carrier.order if carrier else layout.device.byte_order
    letter = value.type.letter
    if carrier is not None and carrier.value is not None and carrier.size == value.size:
        letter = carrier.value.type.letter
    if letter == "s":
        letter = f"{value.size}s"
    arguments = [
        literal(parameter.name),
        str(parameter.number),
        value_expression(value, value.size, order, False, words),
        literal(parameter.access),
        f'carrier="{">" if order == "big" else "<"}{letter}"',
    ]
    if parameter.reserved:
        arguments.append("reserved=True")
    facts = [f"Number {parameter.number}", value.type.name, *value_facts(value)]
    if parameter.access:
        facts.append(ACCESS[parameter.access])
    if parameter.restart:
        facts.append("takes effect after a restart")
    doc = docstring(described(Name.of(parameter.name).title(), parameter, f"{', '.join(facts)}."), 4)
    return ConstantView(names.take(Name.of(parameter.name).upper()), f"_Parameter({', '.join(arguments)})", doc)
