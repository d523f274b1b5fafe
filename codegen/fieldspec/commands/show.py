"""`fieldspec show`: a device, or one item of it, with its bits drawn."""

from __future__ import annotations

import argparse
from collections.abc import Iterator

from fieldspec.commands import specs
from fieldspec.commands.output import print_table
from fieldspec.commands.usage import unknown
from fieldspec.layout.device import DeviceLayout, MessageLayout, TableLayout
from fieldspec.layout.record import RecordLayout
from fieldspec.model.enum import Enum
from fieldspec.model.fact import Fact
from fieldspec.model.flags import Flags
from fieldspec.model.parameter import Parameter
from fieldspec.model.register import Register
from fieldspec.model.value import Value

Item = Register | MessageLayout | RecordLayout | TableLayout | Parameter | Enum | Flags


def run(arguments: argparse.Namespace) -> int:
    """Prints an overview of the device, or every item that the given text means."""
    layout = specs.layout(arguments.specs, arguments.device)
    if arguments.item is None:
        _overview(layout)
        return 0
    items = [item for item in _items(layout) if arguments.item in _handles(item)]
    number = _number(arguments.item)
    if not items and number is not None:
        items = [item for item in _items(layout) if _numbered(item, number)]
    if not items:
        known = {handle for item in _items(layout) for handle in _handles(item) if handle}
        raise unknown(f"item of {layout.device.id}", arguments.item, known)
    for at, item in enumerate(items):
        if at:
            print()
        _show(layout, item)
    return 0


def _number(text: str) -> int | None:
    digits = text[:-1] if text[-1:] in "hH" else text
    try:
        return int(digits, 16) if digits != text else int(text, 0)
    except ValueError:
        return None


def _items(layout: DeviceLayout) -> Iterator[Item]:
    yield from layout.device.registers()
    yield from layout.tables.values()
    yield from layout.messages.values()
    yield from layout.records.values()
    for parameters in layout.device.parameters.values():
        yield from parameters.parameters
    yield from layout.device.enums.values()
    yield from layout.device.flags.values()


def _fact(item: Item) -> Fact:
    if isinstance(item, MessageLayout):
        return item.message
    if isinstance(item, RecordLayout):
        return item.record
    return item.table if isinstance(item, TableLayout) else item


def _handles(item: Item) -> tuple[str, ...]:
    fact = _fact(item)
    return fact.name, fact.printed_name, fact.label


def _numbered(item: Item, number: int) -> bool:
    """Whether an address lies in the item, or a code is the item's."""
    if isinstance(item, Register):
        return item.address <= number < item.end
    if isinstance(item, TableLayout):
        table = item.table
        return table.base <= number < table.base + table.stride * table.count
    return isinstance(item, MessageLayout) and item.message.code == number


def _overview(layout: DeviceLayout) -> None:
    device = layout.device
    print(f"{device.name} ({device.vendor}), version {device.version}, identity {layout.identity}")
    print(f"{device.title}\n" if device.title else "")
    rows = [
        [f"0x{r.address:04X}", r.name, r.printed_name, r.value.type.name, r.access or "?", r.value.unit]
        for r in device.registers()
    ]
    if rows:
        print_table(["address", "register", "printed", "type", "access", "unit"], rows)
        print()
    tables = [[f"0x{t.base:04X}", t.name, str(t.count), f"{t.stride} words"] for t in device.tables.values()]
    if tables:
        print_table(["address", "table", "count", "apart"], tables)
        print()
    codes = [["" if m.code is None else f"0x{m.code:02X}", m.name, m.label] for m in device.messages.values()]
    if codes:
        print_table(["code", "message", "label"], codes)
        print()
    others = [
        ("records", layout.records),
        ("enums", device.enums),
        ("flags", device.flags),
        ("parameters", device.parameters),
    ]
    for title, held in others:
        if held:
            print(f"{title}: {', '.join(held)}")


def _show(layout: DeviceLayout, item: Item) -> None:
    fact = _fact(item)
    beside = " ".join(text for text in (fact.printed_name, fact.label) if text)
    print(fact.name + (f"  {beside}" if beside else ""))
    for key, text in _lines(item):
        if text:
            print(f"  {key:<9} {text}")
    for note in fact.notes:
        print(f"  note      {note}")
    for key, reason in fact.inferred.items():
        print(f"  inferred  {key}: {reason}")
    if isinstance(item, MessageLayout):
        for direction in ("request", "response"):
            print(f"  {direction}")
            _fields(layout, item.data(direction), 4)
    elif isinstance(item, RecordLayout):
        _fields(layout, item, 2)
    elif isinstance(item, TableLayout):
        _fields(layout, item.record, 2)
    elif isinstance(item, Enum):
        _members(item)
    elif isinstance(item, Flags):
        print(drawn(item))
    else:
        _meaning(layout, item.value)


def _lines(item: Item) -> Iterator[tuple[str, str]]:
    fact = _fact(item)
    yield "what", fact.doc
    if isinstance(item, Register):
        many = f", {item.count} of them, {item.stride} words apart" if item.count > 1 else ""
        words = "1 word" if item.width == 1 else f"{item.width} words"
        yield "address", f"0x{item.address:04X} ({item.address}), {words}{many}"
        yield "access", item.access or "not printed"
    if isinstance(item, TableLayout):
        table = item.table
        yield (
            "address",
            f"0x{table.base:04X} + 0x{table.stride:X} * (n - {table.index_from}), "
            f"n = {table.index_from}..{table.indexes[-1]}",
        )
    if isinstance(item, MessageLayout) and item.message.code is not None:
        yield "code", f"0x{item.message.code:02X}"
    if isinstance(item, Parameter):
        yield "number", str(item.number)
        yield "access", item.access or "not printed"
    if isinstance(item, Register | Parameter):
        yield from _value_lines(item.value)
        yield "restart", {True: "needed", False: "not needed", None: ""}[item.restart]
    yield "source", "; ".join(citation.text() for citation in fact.sources)


def _value_lines(value: Value) -> Iterator[tuple[str, str]]:
    yield "type", value.type.name
    yield "unit", f"{value.scale} {value.unit}" if value.scaled else value.unit
    yield "range", value.ranges.text() if value.ranges else ""
    yield "default", "" if value.default is None else str(value.default)
    yield "values", ", ".join(f"{s.value} = {s.name}" for s in value.sentinels)


def _meaning(layout: DeviceLayout, value: Value) -> None:
    if value.enum:
        _members(layout.device.enums[value.enum])
    if value.flags:
        print(drawn(layout.device.flags[value.flags]))


def _members(enum: Enum) -> None:
    rows = [
        [str(m.value), m.name + (" (not available)" if m.unavailable else ""), m.label, m.problem or m.doc]
        for m in enum.members
    ]
    print_table(["value", "name", "label", "meaning"], rows)


def _fields(layout: DeviceLayout, record: RecordLayout, indent: int) -> None:
    if not record.fields:
        print(" " * indent + "no data")
    for field in record.fields:
        kind = field.record.name if field.record else field.primitive.name
        times = "" if not field.listed else f" x {field.count or field.field.repeat.text()}"  # type: ignore[union-attr]
        value = field.value
        extra = [] if value is None else [text for key, text in _value_lines(value) if text and key != "type"]
        enum = f"{value.enum or value.flags}" if value and (value.enum or value.flags) else ""
        parts = [f"+{field.offset}", kind + times, field.name, field.field.label, enum, *extra]
        print(" " * indent + "  ".join(part for part in parts if part))


def drawn(word: Flags) -> str:
    """The word with one box a bit, the highest first, and a line from each to its name."""
    width = word.type.size * 8
    holders = {number: bit for bit in word.bits for number in range(bit.first, bit.last + 1)}
    lines = ["  " + "".join(f"{number:>4}" for number in reversed(range(width)))]
    lines.append("  " + "+---" * width + "+")
    lines.append(
        "  "
        + "".join(
            "| x " if number in holders and not holders[number].reserved else "|   "
            for number in reversed(range(width))
        )
        + "|"
    )
    lines.append("  " + "+---" * width + "+")
    named = [bit for bit in word.bits if not bit.reserved]
    for at, bit in enumerate(named):
        column = 2 + 4 * (width - 1 - bit.first) + 2
        line = [" "] * column
        for later in named[at + 1 :]:
            line[2 + 4 * (width - 1 - later.first) + 2] = "|" if later.first > bit.first else " "
        states = " / ".join(f"{n}: {text}" for n, text in ((0, bit.zero), (1, bit.one)) if text)
        span = f"{bit.first}" if bit.width == 1 else f"{bit.first}..{bit.last}"
        lines.append("".join(line) + f"+- {span} {bit.name}" + (f" ({states})" if states else ""))
    return "\n".join(lines)
