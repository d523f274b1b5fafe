"""One item of a device: register, message, record or any other, with its texts."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.classes import TYPE_CHECKING, dataclass
from fieldspec.explain.parameters import number_of_text
from fieldspec.explain.row import citations
from fieldspec.layout.device import DeviceLayout, TableLayout
from fieldspec.layout.frame import MessageLayout
from fieldspec.layout.record import RecordLayout
from fieldspec.model.address_space import AddressSpace
from fieldspec.model.device import Device
from fieldspec.model.enums import Enum, Flags, Member, State
from fieldspec.model.fact import Claim, Fact
from fieldspec.model.link import Link
from fieldspec.model.registers import Parameter, ParameterSet, Register, RegisterGroup
from fieldspec.model.task import Task
from fieldspec.model.texts import Erratum, Example, Limit, Lookup, Note
from fieldspec.model.value import UNSPECIFIED, Conversion, Handling, Signal

if TYPE_CHECKING:
    from typing import TypeAlias


@dataclass(frozen=True, slots=True)
class Numbered:
    """A number of a set and its parameter; None where it has no row, and the first of a run has it for all."""

    words: ParameterSet
    number: int
    parameter: Parameter | None

    @property
    def printed_text(self) -> str:
        """The number as the manual writes it, where that is not in digits."""
        return self.words.number_text(self.number) if self.words.printed_as else ""


@dataclass(frozen=True, slots=True)
class Coded:
    """A row of a table of codes."""

    enum: Enum
    member: Member

    @property
    def printed_text(self) -> str:
        """The code as the manual, or the device, shows it, where that is not in digits."""
        member = self.member
        form = self.enum.printed_as
        return member.printed_name or (form.format(value=member.value, number=member.number) if form else "")


@dataclass(frozen=True, slots=True)
class DisplayedState:
    """A state that a word shows."""

    word: Flags
    state: State


Item: TypeAlias = (
    AddressSpace
    | Register
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
    | DisplayedState
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
    yield from device.spaces.values()
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
        yield from (DisplayedState(word, state) for state in word.states)
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
        own = number_of_text(words, text)
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
        case DisplayedState():
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
        return ("", item.printed_text, "")
    written = item.printed_text if isinstance(item, Numbered | Coded) else ""
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


Details = Iterator[tuple[str, str]]

_MEMORY = {"volatile": "lost with the power", "nonvolatile": "kept without power"}
_ENDURANCE = {"limited": "a limited number of writes, which is not printed", "unlimited": "as many writes as one likes"}


def fact_details(device: Device, fact: Fact) -> Details:
    """What every fact has: its text, the versions that it holds for, its places in the manual, and the caveats."""
    yield "doc", fact.doc
    yield "since", ", ".join(fact.since)
    yield "until", ", ".join(fact.until)
    yield "only", ", ".join(fact.only)
    yield from _handling(getattr(fact, "handling", UNSPECIFIED))
    yield "source", citations(fact.sources)
    for claim in fact.restated:
        yield "also", _claim(claim)
    for note in fact.notes:
        yield "note", note
    for key, reason in fact.inferred.items():
        yield "inferred", f"{key}: {reason}"
    if fact.unverified:
        yield "unverified", "nobody has compared it with the manual yet"
    for key, reason in fact.allowed.items():
        yield "allowed", f"{key}: {reason}"
    for general in device.notes:
        if fact.place.path in general.about:
            yield "note", f"{general.title}: {general.text}"
    for erratum in device.errata:
        if erratum.fact == fact.place.path or erratum.fact.startswith(f"{fact.place.path}/"):
            yield "erratum", f"{erratum.id}: {_printed(erratum)}{erratum.reason}"


def _handling(said: Handling) -> Details:
    """What whoever reads or writes the value must know."""
    yield "reading", "clears it: only the first reader gets it" if said.clears_on_read else ""
    yield "memory", _MEMORY.get(said.memory, "")
    yield "saved by", said.saved_by
    yield "endurance", _ENDURANCE.get(said.endurance, f"{said.endurance} writes" if said.endurance else "")
    yield "opposite of", said.opposite_of


def erratum_details(erratum: Erratum) -> Details:
    """What an erratum says."""
    yield "fact", erratum.fact
    yield "printed", _printed(erratum).removesuffix(". ").removeprefix("printed ")
    yield "literally", erratum.literal
    yield "reason", erratum.reason
    yield "sure", erratum.confidence
    yield "effect", erratum.effect
    yield "proof", erratum.proof
    yield "source", citations(erratum.sources)


def example_details(example: Example) -> Details:
    """What an example says; `decode` explains its bytes."""
    yield "title", example.title
    yield (
        "message",
        f"{example.message or 'unknown'} {'refusal' if example.exception_response else example.direction}",
    )
    yield "link", example.link
    yield "frame", example.frame.hex(" ").upper()
    yield "answers", example.reply_to
    yield "refused", example.refused
    yield "values", ", ".join(f"{name} {value}" for name, value in example.values.items())
    yield "source", citations(example.sources)
    for note in example.notes:
        yield "note", note


def note_details(note: Note) -> Details:
    """What a note says."""
    yield "title", note.title
    yield "text", note.text
    yield "about", ", ".join(note.about)
    yield "source", citations(note.sources)


def _printed(erratum: Erratum) -> str:
    keys = ", ".join(f"{key} {'absent' if value is None else value}" for key, value in erratum.printed.items())
    return f"printed {keys}. " if keys else ""


def _claim(claim: Claim) -> str:
    said = ", ".join(f"{key} {value}" for key, value in claim.values.items())
    return f"{citations(claim.sources)}" + (f": {said}" if said else "")
