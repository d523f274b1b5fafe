"""Registers and tables as constants."""

from __future__ import annotations

from fieldspec.backends.python.naming import Scope
from fieldspec.backends.python.slots import Words
from fieldspec.backends.python.text import described, docstring, literal
from fieldspec.backends.python.values import register_value, value_facts
from fieldspec.classes import dataclass
from fieldspec.layout.device import TableLayout
from fieldspec.layout.register import RegisterLayout
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


def register_view(laid: RegisterLayout, words: Words, order: str, scope: Scope, space: str = "") -> ConstantView:
    """The view of a register, or of an array of registers.

    `order` is the byte order of the device, `space` the address space where the device has several.
    """
    register = laid.register
    name = scope.take(Name.of(laid.name).upper())
    value = register_value(register.value, 2 * laid.words, laid.order, laid.swapped, words, register.trigger)
    arguments = [literal(laid.name), f"0x{laid.address:04X}", str(laid.words), value, literal(register.access)]
    if laid.count > 1:
        arguments += [f"count={laid.count}", f"first={register.index_from}", f"stride={laid.stride}"]
    arguments += [f"{key}=True" for key, held in (("atomic", register.atomic), ("trigger", register.trigger)) if held]
    arguments += [f"number={register.number}"] if register.number is not None else []
    arguments += [f"copy_of={literal(register.copy_of)}"] if register.copy_of else []
    if order == "little":
        arguments.append('order="<"')
    if space:
        arguments.append(f"space={literal(space)}")
    facts = [
        f"0x{laid.address:04X}",
        *([f"in {space}"] if space else []),
        f"{laid.words} word{'s' if laid.words > 1 else ''}",
    ]
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
    if register.number is not None:
        facts.append(f"number {register.number}")
    if register.copy_of:
        facts.append(f"a copy of {Name.of(register.copy_of).upper()}")
    if register.same_as:
        facts.append(f"the same as {Name.of(register.same_as).upper()}")
    if laid.count > 1:
        last = register.index_from + laid.count - 1
        facts.append(f"{laid.count} of them, {register.index_from} to {last}")
    doc = docstring(described(Name.of(laid.name).title(), register, f"{', '.join(facts)}."))
    return ConstantView(name, f"{'_RegisterArray' if laid.count > 1 else '_Register'}({', '.join(arguments)})", doc)


def table_view(laid: TableLayout, words: Words, order: str, scope: Scope, space: str = "") -> TableView:
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
        arguments.append(f"access={literal(table.access if laid.writable else 'ro')}")
    if order == "little":
        arguments.append('order="<"')
    if space:
        arguments.append(f"space={literal(space)}")
    last = table.index_from + table.count - 1
    facts = [
        f"{table.count} records of {laid.words} words, {table.index_from} to {last}",
        f"the first at 0x{table.base:04X}, each {table.stride} words behind the one before",
    ]
    if space:
        facts.append(f"in {space}")
    if table.access:
        facts.append(ACCESS[table.access])
    if laid.read_only:
        facts.append(f"none as a whole, as these fields are read only: {', '.join(laid.read_only)}")
    doc = docstring(described(table.title or Name.of(table.name).title(), table, f"{', '.join(facts)}."), 4)
    name = scope.take(laid.name)
    return TableView(name, scope.take(f"{Name.of(laid.name).pascal()}Table"), record, ", ".join(arguments), doc)
