"""An item as lines and tables."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from fieldspec.codec.layout.device import DeviceLayout, TableLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.command.rendering.blocks import Block, Line, Table, drawn, narrowed
from fieldspec.command.rendering.item import Item, ParameterNumber, fact_details, fact_of, handles
from fieldspec.command.rendering.item_details import details
from fieldspec.command.rendering.overview import (
    constant_text,
    field_table,
    member_table,
    parameter_table,
    range_text,
    register_table,
    unit_text,
)
from fieldspec.language.model.enums import Enum, Flags
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.link import Link
from fieldspec.language.model.registers import Parameter, ParameterSet, Register, RegisterGroup
from fieldspec.language.model.texts import Lookup
from fieldspec.language.model.value import Signal, Value

_NARROWEST = 9
"""The characters of the column with the names of details; longer names widen it."""


_MOST_EXAMPLES = 3


def blocks(layout: DeviceLayout, item: Item, number: int | None = None, users: Sequence[str] = ()) -> Iterator[Block]:
    """An item as lines and tables.

    `number` is the address or number that a user asked for, `users` are the paths of the facts that refer to the item.
    """
    fact = fact_of(item)
    names = handles(item)
    yield Line("  ".join(dict.fromkeys(name for name in names if name)) or fact_name(fact), "bold")
    pairs = [*details(layout, item, number)]
    if isinstance(fact, Fact):
        pairs += fact_details(layout.device, fact)
    pairs.append(("used by", _users_text(users)))
    width = max(_NARROWEST, *(len(key) for key, text in pairs if text), 0)
    for key, text in pairs:
        if text:
            yield Line(f"  {key:<{width}} {text}", drawn=True)
    yield from _inner_blocks(layout, item)


def _users_text(users: Sequence[str]) -> str:
    """The facts that refer to an item; of many examples the first ones."""
    examples = [path for path in users if path.startswith("examples/")]
    paths = [path for path in users if path not in examples[_MOST_EXAMPLES:]]
    remarks = [f"{len(examples) - _MOST_EXAMPLES} more examples"] * (len(examples) > _MOST_EXAMPLES)
    return ", ".join([*paths, *remarks])


def fact_name(fact: object) -> str:
    """The name of a fact; empty for one without a name."""
    return fact.name if isinstance(fact, Fact) else ""


def _inner_blocks(layout: DeviceLayout, item: Item) -> Iterator[Block]:
    match item:
        case MessageLayout():
            yield from _message(layout, item)
        case RecordLayout():
            yield from _record(layout, item)
        case TableLayout():
            yield from _record(layout, item.record, item.table.base)
        case Register() | Signal():
            yield from _names(layout, item.value)
        case ParameterNumber():
            if item.parameter is not None:
                yield from _subindices(item.parameter)
                yield from _names(layout, item.parameter.value)
        case Enum():
            yield member_table(item)
        case Flags():
            yield from _word(item)
        case RegisterGroup():
            yield register_table(layout.device, item.registers)
        case ParameterSet():
            yield parameter_table(item)
        case Link():
            for direction in ("request", "response"):
                yield Line(f"{item.direction_name(direction)}: {_parts(item, direction)}")
        case Lookup():
            yield narrowed(
                Table(
                    tuple(" ".join(text for text in (c.title or c.name, c.label) if text) for c in item.columns),
                    tuple(tuple("" if cell is None else str(cell) for cell in row.cells) for row in item.rows),
                )
            )


def _parts(link: Link, direction: str) -> str:
    return ", ".join(part.name for part in link.parts(direction))


def _message(layout: DeviceLayout, message: MessageLayout) -> Iterator[Block]:
    for direction, _ in zip(message.message.directions, message.bodies, strict=True):
        links = [link.link for link in layout.links.values() if message.name in link.carried(direction)]
        names = dict.fromkeys(link.direction_name(direction) for link in links)
        yield Line(f"{' or '.join(names) or direction} data", "bold")
        yield from _record(layout, message.data(direction))


def _record(layout: DeviceLayout, record: RecordLayout, base: int | None = None) -> Iterator[Block]:
    """The fields of a record, and drawings of the words of bits in it."""
    yield field_table(record, base)
    if record.record.separator:
        yield Line(f"{record.record.separator.hex(' ').upper()} between each two fields")
    words = dict.fromkeys(field.value.flags for field in record.fields if field.value and field.value.flags)
    for word in words:
        yield Line(word, "bold")
        yield from _word(layout.device.flags[word])


def _word(word: Flags) -> Iterator[Block]:
    """The drawing of a word of bits, and the states that its bits show together."""
    yield from (Line(line, drawn=True) for line in drawn(word))
    rows = []
    for state in word.states:
        label = " ".join(text for text in (state.printed_name, state.label) if text)
        mask, value = word.masked(state)
        digits = 2 * word.type.size
        bits = f"0x{value:0{digits}X} of 0x{mask:0{digits}X}"
        rows.append((state.name, label, ", ".join(state.set), ", ".join(state.clear), bits))
    if rows:
        yield narrowed(Table(("state", "label", "set", "clear", "word"), tuple(rows)))


def _names(layout: DeviceLayout, value: Value) -> Iterator[Block]:
    if value.enum:
        yield member_table(layout.device.enums[value.enum])
    if value.flags:
        yield from _word(layout.device.flags[value.flags])


def _subindices(parameter: Parameter) -> Iterator[Block]:
    """The elements of a parameter with their own meanings."""
    rows = []
    for inner in parameter.subindices:
        label = " ".join(text for text in (inner.printed_name, inner.label) if text)
        value, name = inner.value, "reserved" if inner.reserved else inner.name
        always = constant_text(value)
        first = (inner.indices.text(), name, label, value.type.name, inner.access)
        rows.append((*first, unit_text(value), range_text(value), always, value.enum or value.flags, inner.doc))
    if rows:
        headings = ("index", "element", "label", "type", "access", "unit", "range", "always", "names", "what")
        yield narrowed(Table(headings, tuple(rows)))
