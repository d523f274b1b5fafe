"""One item of a device, shown to people: a register, a message, a record, and whatever else has a name."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.classes import TYPE_CHECKING, dataclass
from fieldspec.layout.device import DeviceLayout, TableLayout
from fieldspec.layout.explaining.numbered import number_written
from fieldspec.layout.message import MessageLayout
from fieldspec.layout.record import RecordLayout
from fieldspec.model.enum import Enum, Member
from fieldspec.model.erratum import Erratum
from fieldspec.model.example import Example
from fieldspec.model.fact import Fact
from fieldspec.model.flags import Flags, State
from fieldspec.model.limit import Limit
from fieldspec.model.link import Link
from fieldspec.model.lookup import Lookup
from fieldspec.model.note import Note
from fieldspec.model.parameter import Parameter, ParameterSet
from fieldspec.model.register import Register, RegisterGroup
from fieldspec.model.signal import Conversion, Signal
from fieldspec.model.task import Task

if TYPE_CHECKING:
    from typing import TypeAlias


@dataclass(frozen=True, slots=True)
class Numbered:
    """A number of a set and its parameter; None where it has no row, and the first of a run has it for all."""

    words: ParameterSet
    number: int
    parameter: Parameter | None

    @property
    def written(self) -> str:
        """The number as the manual writes it, where that is not in digits."""
        return self.words.written(self.number) if self.words.printed_as else ""


@dataclass(frozen=True, slots=True)
class Coded:
    """A row of a table of codes."""

    enum: Enum
    member: Member

    @property
    def written(self) -> str:
        """The code as the manual, or the device, shows it, where that is not in digits."""
        member = self.member
        form = self.enum.printed_as
        return member.printed_name or (form.format(value=member.value, number=member.number) if form else "")


@dataclass(frozen=True, slots=True)
class Shown:
    """A state that a word shows."""

    word: Flags
    state: State


Item: TypeAlias = (
    Register
    | RegisterGroup
    | TableLayout
    | MessageLayout
    | RecordLayout
    | Signal
    | Conversion
    | Numbered
    | ParameterSet
    | Enum
    | Coded
    | Flags
    | Shown
    | Link
    | Lookup
    | Limit
    | Task
    | Note
    | Example
    | Erratum
)


def items(layout: DeviceLayout) -> Iterator[Item]:
    """All items of a device that can be shown, in the order of the spec's sections."""
    device = layout.device
    yield from device.registers()
    yield from device.groups
    yield from layout.tables.values()
    yield from layout.messages.values()
    yield from layout.records.values()
    yield from device.signals.values()
    yield from device.conversions.values()
    for words in device.parameters.values():
        yield words
        yield from (Numbered(words, parameter.number, parameter) for parameter in words.parameters)
    for enum in device.enums.values():
        yield enum
        base = device.enums.get(enum.derived.rpartition("/")[2])
        if enum.kind != "enum":
            yield from (Coded(enum, one) for one in enum.members if base is None or base.named(one.name) is None)
    for word in device.flags.values():
        yield word
        yield from (Shown(word, state) for state in word.states)
    yield from device.links.values()
    yield from device.lookups
    yield from device.limits
    yield from device.tasks
    yield from device.notes
    yield from device.examples.values()
    yield from device.errata


def unnamed(layout: DeviceLayout, text: str, number: int | None) -> Iterator[Numbered]:
    """The parameters without a row of their own that a text is as the manual writes it, or on the wire."""
    for words in layout.device.parameters.values():
        own = number_written(words, text)
        if own is None and number is not None:
            own = number - words.base
        if own is not None and words.holds(own):
            yield Numbered(words, own, words.numbered(own))


def fact_of(item: Item) -> Fact | Note | Example | Erratum:
    """The fact that an item is, or that it lays out."""
    match item:
        case MessageLayout():
            return item.message
        case RecordLayout():
            return item.record
        case TableLayout():
            return item.table
        case Numbered():
            return item.parameter or item.words
        case Coded():
            return item.member
        case Shown():
            return item.state
        case _:
            return item


def handles(item: Item) -> tuple[str, ...]:
    """The texts that mean an item: our name, the manual's identifier, its label."""
    fact = fact_of(item)
    if isinstance(fact, Example | Erratum):
        return (fact.id,)
    if isinstance(fact, Note):
        return (fact.name,)
    if isinstance(item, Numbered) and item.parameter is None:
        return ("", item.written, "")
    written = item.written if isinstance(item, Numbered | Coded) else ""
    return fact.name, fact.printed_name or written, fact.label


def numbered(item: Item, number: int) -> bool:
    """Whether an address lies in the item, or a number or a code is the item's."""
    match item:
        case Register():
            steps = (number - item.address) // item.stride
            inside = 0 <= steps < item.count and number < item.address + steps * item.stride + item.width
            return inside or number == item.number
        case TableLayout():
            table = item.table
            return table.base <= number < table.base + table.stride * (table.count - 1) + item.words
        case MessageLayout():
            return number in (item.message.code, item.message.number)
        case Numbered():
            count = item.parameter.count if item.parameter is not None else 1
            return any(0 <= number - first < count for first in (item.number, item.words.base + item.number))
        case Coded():
            return number in (item.member.value, item.member.number)
        case _:
            return False
