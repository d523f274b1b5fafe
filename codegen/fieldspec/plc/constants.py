"""Constants: addresses, numbers of parameters, codes of messages, masks of bits, limits, ranges, numbers of members."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from decimal import Decimal

from fieldspec.classes import dataclass
from fieldspec.layout.device import DeviceLayout
from fieldspec.model.fact import Fact
from fieldspec.model.registers import Parameter, ParameterSet
from fieldspec.model.value import Kind, Value
from fieldspec.plc.enums import available
from fieldspec.plc.routines.expressions import BITS, LREAL, SIGNED, UINT, UNSIGNED, Elementary
from fieldspec.plc.routines.remarks import count_of, source
from fieldspec.plc.routines.world import narrowest


@dataclass(frozen=True, slots=True)
class Constant:
    """A number by name. `hexadecimal` says how people know it."""

    name: str
    type: Elementary
    value: int | Decimal
    remark: str
    fact: Fact | None
    hexadecimal: bool = False


@dataclass(frozen=True, slots=True)
class ConstantList:
    """Constants of one kind, by the name of their list. `key` is one of those of `LISTS`."""

    name: str
    key: str
    title: str
    constants: tuple[Constant, ...]


@dataclass(frozen=True, slots=True)
class Draft:
    """A constant before it has a name in a dialect. A `derived` name gives way where it is taken; `fact` is None for
    a number of our own."""

    name: str
    type: Elementary
    value: int | Decimal
    remark: str
    fact: Fact | None
    hexadecimal: bool = False
    derived: bool = False


# What makes the constants of one kind; the enums that are types have no constants of their own.
_Make = Callable[[DeviceLayout, frozenset[str]], Iterator[Draft]]


def _addresses(layout: DeviceLayout, types: frozenset[str]) -> Iterator[Draft]:
    for laid in layout.registers:
        if laid.register.reserved:
            continue
        space = _space(layout, laid.register.space)
        beside = f"{_printed(laid.register)} {laid.register.access} {space}".strip()
        yield Draft(laid.name, UINT, laid.address, _comment(beside, laid.register), laid.register, hexadecimal=True)
        if laid.count > 1:
            for word, number in (("count", laid.count), ("stride", laid.stride)):
                yield Draft(f"{laid.name}_{word}", UINT, number, _OF_SEVERAL[word], laid.register, derived=True)
    for table in layout.tables.values():
        held = table.table
        beside = f"{held.title} {_space(layout, held.space)}".strip()
        yield Draft(f"{held.name}_base", UINT, held.base, _comment(beside, held), held, hexadecimal=True)
        for word, number in (("stride", held.stride), ("count", held.count), ("first_index", held.index_from)):
            yield Draft(f"{held.name}_{word}", UINT, number, _OF_SEVERAL[word], held, derived=True)


def _space(layout: DeviceLayout, name: str) -> str:
    """`in input_registers`; empty where the device has only one space."""
    device = layout.device
    return f"in {device.space_name(name)}" if device.several_spaces else ""


_OF_SEVERAL = {
    "count": "how many there are",
    "stride": "words from one to the next",
    "first_index": "number of the first one",
}


def _parameters(layout: DeviceLayout, types: frozenset[str]) -> Iterator[Draft]:
    for held in layout.device.parameters.values():
        for one in held.parameters:
            if not one.reserved:
                number = held.base + one.number
                yield Draft(one.name, UINT, number, _comment(_numbered(held, one), one), one, hexadecimal=held.base > 0)
                if one.count > 1:
                    yield Draft(f"{one.name}_count", UINT, one.count, _OF_SEVERAL["count"], one, derived=True)


def _numbered(held: ParameterSet, one: Parameter) -> str:
    """What a parameter is called, with its printed number where neither the constant nor the printed name says it."""
    number, printed = held.number_text(one.number), _printed(one)
    known = (str(held.base + one.number), *printed.split())
    return printed if number in known else f"{number} {printed}"


def _messages(layout: DeviceLayout, types: frozenset[str]) -> Iterator[Draft]:
    for message in layout.messages.values():
        held = message.message
        for word, number in (("code", held.code), ("number", held.number)):
            if number is not None:
                hexadecimal = word == "code"
                yield Draft(f"{held.name}_{word}", UINT, number, _comment(held.title, held), held, hexadecimal)
        for data in (message.request, message.response):
            if data.size:
                remark = "bytes of its data"
                yield Draft(f"{data.name}_size", UINT, data.size, remark, held, derived=True)


def _masks(layout: DeviceLayout, types: frozenset[str]) -> Iterator[Draft]:
    for word in layout.device.flags.values():
        kind = BITS[word.type.size]
        for bit in word.bits:
            if bit.reserved:
                continue
            text = "; ".join(f"{n} = {meaning}" for n, meaning in enumerate((bit.zero, bit.one)) if meaning)
            place = f"bit {bit.first}" if bit.width == 1 else f"bits {bit.first}..{bit.last}"
            told = _comment(f"{place} {_printed(bit)} {text}", bit)
            yield Draft(f"{word.name}_{bit.name}", kind, bit.mask, told, bit, hexadecimal=True)
            if bit.width > 1:
                yield Draft(f"{word.name}_{bit.name}_first", UINT, bit.first, "its lowest bit", bit, derived=True)
        for state in word.states:
            mask, value = word.masked(state)
            name = f"{word.name}_{state.name}"
            told = _comment(f"{_printed(state)} the bits that show it", state)
            yield Draft(f"{name}_mask", kind, mask, told, state, hexadecimal=True)
            yield Draft(f"{name}_value", kind, value, "what these are in it", state, True, derived=True)


def _codes(layout: DeviceLayout, types: frozenset[str]) -> Iterator[Draft]:
    for enum in layout.device.enums.values():
        members = [] if enum.name in types else available(enum)
        if members:
            kind = narrowest(min(0, *(one.value for one in members)), max(one.value for one in members))
            for member in members:
                told = _comment(_printed(member), member)
                yield Draft(f"{enum.name}_{member.name}", kind, member.value, told, member)


def _ranges(layout: DeviceLayout, types: frozenset[str]) -> Iterator[Draft]:
    for name, fact, value in _ranged(layout):
        kind = (SIGNED if value.type.signed else UNSIGNED)[value.size]
        unit = f"1 count = {count_of(value)}." if value.scaled or value.unit else ""
        for word, ranges in (("", value.ranges), ("write_", value.write_ranges)):
            if ranges is not None and (ranges.low, ranges.high) != (value.type.low, value.type.high):
                yield Draft(f"{name}_{word}min", kind, ranges.low, _comment(unit, fact), fact)
                yield Draft(f"{name}_{word}max", kind, ranges.high, _comment(unit, fact), fact)


def _ranged(layout: DeviceLayout) -> Iterator[tuple[str, Fact, Value]]:
    """The values of registers, of records and of signals that have a range narrower than their type."""
    for laid in layout.registers:
        yield from _narrow(laid.name, laid.register, laid.register.value)
    for record in layout.records.values():
        for field in record.fields:
            yield from _narrow(f"{record.name}_{field.name}", field.field, field.value)
    for signal in layout.device.signals.values():
        yield from _narrow(signal.name, signal, signal.value)


def _narrow(name: str, fact: Fact, value: Value | None) -> Iterator[tuple[str, Fact, Value]]:
    if value is not None and value.type.kind is Kind.INTEGER and value.const is None:
        yield name, fact, value


def _limits(layout: DeviceLayout, types: frozenset[str]) -> Iterator[Draft]:
    for limit in layout.device.limits:
        known = {"": limit.value, "min": limit.low, "max": limit.high}
        for word, number in known.items():
            if number is not None:
                kind = _of_limit(number)
                whole = kind is not LREAL
                told = _comment(limit.unit, limit)
                name = f"{limit.name}_{word}" if word else limit.name
                yield Draft(name, kind, int(number) if whole else number, told, limit)


def _of_limit(number: Decimal) -> Elementary:
    whole = number == number.to_integral_value() and abs(number) < 1 << 31
    return narrowest(min(0, int(number)), max(0, int(number))) if whole else LREAL


def _printed(fact: Fact) -> str:
    return " ".join(text for text in (fact.printed_name, fact.label) if text)


def _comment(text: str, fact: Fact) -> str:
    return " ".join(part for part in (*text.split(), source(fact)) if part)


LISTS: Mapping[str, tuple[str, str, _Make]] = {
    "addresses": ("reg", "Addresses of registers and tables", _addresses),
    "parameters": ("par", "Numbers of parameters on the wire", _parameters),
    "messages": ("msg", "Codes and numbers of messages, and bytes of their data", _messages),
    "masks": ("mask", "Masks of bits, and the lowest bits of fields of several bits", _masks),
    "codes": ("", "Numbers of what enums list", _codes),
    "ranges": ("range", "Least and greatest counts of values", _ranges),
    "limits": ("limit", "Limits of the device", _limits),
}
"""The lists of constants: the word in names that stand alone, if they need one, what the list is, and what makes it."""
