"""One item of a device, shown to people: a register, a message, a record, and whatever else has a name."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TypeAlias

from fieldspec.layout.device import DeviceLayout, TableLayout
from fieldspec.layout.message import MessageLayout
from fieldspec.layout.record import RecordLayout
from fieldspec.model.enum import Enum, Member
from fieldspec.model.erratum import Erratum
from fieldspec.model.example import Example
from fieldspec.model.fact import Fact
from fieldspec.model.flags import Flags
from fieldspec.model.limit import Limit
from fieldspec.model.link import Link
from fieldspec.model.lookup import Lookup
from fieldspec.model.note import Note
from fieldspec.model.parameter import Parameter, ParameterSet
from fieldspec.model.register import Register, RegisterGroup
from fieldspec.model.value import Value
from fieldspec.render.blocks import Block, Line, Table, narrowed
from fieldspec.render.drawing import drawn
from fieldspec.render.item_texts import erratum_details, example_details, fact_details, note_details
from fieldspec.render.overview import parameter_table, register_table
from fieldspec.render.values import field_table, member_table, value_details

Item: TypeAlias = (
    Register
    | RegisterGroup
    | TableLayout
    | MessageLayout
    | RecordLayout
    | Parameter
    | ParameterSet
    | Enum
    | Member
    | Flags
    | Link
    | Lookup
    | Limit
    | Note
    | Example
    | Erratum
)
Details: TypeAlias = Iterator[tuple[str, str]]


def items(layout: DeviceLayout) -> Iterator[Item]:
    """All items of a device that can be shown, in the order of the spec's sections."""
    device = layout.device
    yield from device.registers()
    yield from device.groups
    yield from layout.tables.values()
    yield from layout.messages.values()
    yield from layout.records.values()
    for words in device.parameters.values():
        yield words
        yield from words.parameters
    for enum in device.enums.values():
        yield enum
        if enum.kind != "enum":
            yield from enum.members
    yield from device.flags.values()
    yield from device.links.values()
    yield from device.lookups
    yield from device.limits
    yield from device.notes
    yield from device.examples.values()
    yield from device.errata


def fact_of(item: Item) -> Fact | Note | Example | Erratum:
    """The fact that an item is, or that it lays out."""
    if isinstance(item, MessageLayout):
        return item.message
    if isinstance(item, RecordLayout):
        return item.record
    return item.table if isinstance(item, TableLayout) else item


def handles(item: Item) -> tuple[str, ...]:
    """The texts that mean an item: our name, the manual's identifier, its label."""
    fact = fact_of(item)
    if isinstance(fact, Example | Erratum):
        return (fact.id,)
    return (fact.name,) if isinstance(fact, Note) else (fact.name, fact.printed_name, fact.label)


def numbered(item: Item, number: int) -> bool:
    """Whether an address lies in the item, or a code is the item's."""
    if isinstance(item, Register):
        steps = (number - item.address) // item.stride
        return 0 <= steps < item.count and number < item.address + steps * item.stride + item.width
    if isinstance(item, TableLayout):
        table = item.table
        return table.base <= number < table.base + table.stride * (table.count - 1) + item.words
    return isinstance(item, MessageLayout) and item.message.code == number


def blocks(layout: DeviceLayout, item: Item, address: int | None = None) -> Iterator[Block]:
    """An item as lines and tables; an `address` that was asked for is named."""
    fact = fact_of(item)
    names = handles(item)
    yield Line("  ".join(dict.fromkeys(name for name in names if name)), "bold")
    pairs = [*_details(item, address)]
    if isinstance(fact, Fact):
        pairs += fact_details(layout.device, fact)
    for key, text in pairs:
        if text:
            yield Line(f"  {key:<9} {text}", drawn=True)
    yield from _inside(layout, item)


def _details(item: Item, address: int | None) -> Details:
    match item:
        case Register():
            yield from _register(item, address)
        case TableLayout():
            yield from _table(item, address)
        case MessageLayout():
            yield "what", item.message.title
            yield "code", "" if item.message.code is None else f"0x{item.message.code:02X}"
        case RecordLayout() if item.size is not None:
            yield "size", f"{item.size} bytes"
        case Parameter():
            yield "number", str(item.number)
            yield "access", item.access or "not printed"
            yield from value_details(item.value)
            yield "restart", _RESTART[item.restart]
        case Member():
            yield "value", str(item.value)
            yield "problem", item.problem
            for cause in item.causes:
                yield "cause", cause.cause + "".join(f" -> {remedy}" for remedy in cause.remedies)
            for remedy in item.remedies:
                yield "remedy", remedy
        case Link():
            yield "encoding", item.encoding
            yield "marks", " .. ".join(mark.hex(" ").upper() for mark in (item.start, item.end) if mark)
            yield "order", f"bytes {item.byte_order}, words {item.word_order or item.byte_order}"
        case Limit():
            bounds = [str(bound) for bound in (item.low, item.high) if bound is not None]
            number = str(item.value) if item.value is not None else "..".join(bounds)
            yield "value", f"{number or item.text} {item.unit}".strip()
        case Note():
            yield from note_details(item)
        case Example():
            yield from example_details(item)
        case Erratum():
            yield from erratum_details(item)


_RESTART = {True: "needed", False: "not needed", None: ""}


def _register(register: Register, address: int | None) -> Details:
    many = f", {register.count} of them, {register.stride} apart" if register.count > 1 else ""
    words = "1 word" if register.width == 1 else f"{register.width} words"
    yield "address", f"0x{register.address:04X} ({register.address}), {words}{many}"
    if register.count > 1 and address is not None:
        index = register.index_from + (address - register.address) // register.stride
        yield "here", f"0x{address:04X} is {register.name}[{index}]"
    yield "access", register.access or "not printed"
    yield from value_details(register.value)
    yield "restart", _RESTART[register.restart]
    yield "trigger", "writing it starts something; reading gives 0" if register.trigger else ""
    yield "atomic", "its words are read in one request" if register.atomic else ""
    yield "same as", register.same_as


def _table(laid: TableLayout, address: int | None) -> Details:
    table = laid.table
    formula = f"0x{table.base:04X} + 0x{table.stride:X} * (n - {table.index_from})"
    yield "address", f"{formula}, n = {table.index_from}..{table.indexes[-1]}"
    yield "access", table.access or "not printed"
    if address is not None:
        steps, offset = divmod(address - table.base, table.stride)
        held = [field.name for field in laid.record.fields if field.offset <= 2 * offset + 1]
        yield "here", f"0x{address:04X} is in {table.name}[{table.index_from + steps}].{held[-1]}"


def _inside(layout: DeviceLayout, item: Item) -> Iterator[Block]:
    match item:
        case MessageLayout():
            for direction in ("request", "response"):
                yield Line(f"{direction} data", "bold")
                yield from _record(layout, item.data(direction))
        case RecordLayout():
            yield from _record(layout, item)
        case TableLayout():
            yield from _record(layout, item.record, item.table.base)
        case Register() | Parameter():
            yield from _names(layout, item.value)
        case Enum():
            yield member_table(item)
        case Flags():
            yield from (Line(line, drawn=True) for line in drawn(item))
        case RegisterGroup():
            yield register_table(item.registers)
        case ParameterSet():
            yield parameter_table(item)
        case Link():
            for direction in ("request", "response"):
                yield Line(f"{direction}: " + ", ".join(part.name for part in item.parts(direction)))
        case Lookup():
            yield narrowed(
                Table(
                    tuple(" ".join(text for text in (c.title or c.name, c.label) if text) for c in item.columns),
                    tuple(tuple("" if cell is None else str(cell) for cell in row.cells) for row in item.rows),
                )
            )


def _record(layout: DeviceLayout, record: RecordLayout, base: int | None = None) -> Iterator[Block]:
    """The fields of a record, and the words of bits in it, drawn."""
    yield field_table(record, base)
    words = dict.fromkeys(field.value.flags for field in record.fields if field.value and field.value.flags)
    for word in words:
        yield Line(word, "bold")
        yield from (Line(line, drawn=True) for line in drawn(layout.device.flags[word]))


def _names(layout: DeviceLayout, value: Value) -> Iterator[Block]:
    if value.enum:
        yield member_table(layout.device.enums[value.enum])
    if value.flags:
        yield from (Line(line, drawn=True) for line in drawn(layout.device.flags[value.flags]))
