"""The items of a device that a user can ask for: registers, messages, records and others, with their texts."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.explain.entered import number_of_text
from fieldspec.codec.explain.errata import citations
from fieldspec.codec.layout.device import DeviceLayout, TableLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.codec.layout.value_texts import spec_text
from fieldspec.foundation.classes import TYPE_CHECKING, dataclass
from fieldspec.language.model.address_space import AddressSpace
from fieldspec.language.model.device import Device
from fieldspec.language.model.enums import Enum, Flags, Member, State
from fieldspec.language.model.fact import Claim, Fact
from fieldspec.language.model.link import Link
from fieldspec.language.model.registers import Parameter, ParameterSet, Register, RegisterGroup
from fieldspec.language.model.task import Task
from fieldspec.language.model.texts import Erratum, Example, Limit, Lookup, Note
from fieldspec.language.model.value import UNSPECIFIED, Conversion, Handling, Signal

if TYPE_CHECKING:
    from typing import TypeAlias


@dataclass(frozen=True, slots=True)
class ParameterNumber:
    """A number of a parameter set, and its parameter; None where the manual has no row for the number."""

    parameter_set: ParameterSet
    number: int
    parameter: Parameter | None

    @property
    def printed_text(self) -> str:
        """The number as the manual writes it; empty where that is in digits."""
        return self.parameter_set.number_text(self.number) if self.parameter_set.printed_as else ""


@dataclass(frozen=True, slots=True)
class CodeRow:
    """A row of a table of codes."""

    enum: Enum
    member: Member

    @property
    def printed_text(self) -> str:
        """The code as the manual or the device shows it; empty where that is in digits."""
        member = self.member
        form = self.enum.printed_as
        return member.printed_name or (form.format(value=member.value, number=member.number) if form else "")


@dataclass(frozen=True, slots=True)
class WordState:
    """A state that the bits of a word show together."""

    flags: Flags
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
    | ParameterNumber
    | ParameterSet
    | Enum
    | CodeRow
    | Flags
    | WordState
    | Link
    | Lookup
    | Limit
    | Task
    | Note
    | Example
    | Erratum
)


def items(layout: DeviceLayout) -> Iterator[Item]:
    """All items of a device, in the order of the sections of a spec."""
    device = layout.device
    yield from device.spaces.values()
    yield from device.registers()
    yield from device.groups
    yield from layout.tables.values()
    yield from layout.messages.values()
    yield from layout.records.values()
    yield from device.signals.values()
    yield from device.conversions.values()
    for parameter_set in device.parameters.values():
        yield parameter_set
        yield from (
            ParameterNumber(parameter_set, parameter.number, parameter) for parameter in parameter_set.parameters
        )
    for enum in device.enums.values():
        yield enum
        base = device.enums.get(enum.derived.rpartition("/")[2])
        if enum.kind != "enum":
            yield from (
                CodeRow(enum, member) for member in enum.members if base is None or base.named(member.name) is None
            )
    for word in device.flags.values():
        yield word
        yield from (WordState(word, state) for state in word.states)
    yield from device.links.values()
    yield from device.lookups
    yield from device.limits
    yield from device.tasks
    yield from device.notes
    yield from device.examples.values()
    yield from device.errata


def unnamed(layout: DeviceLayout, text: str, number: int | None) -> Iterator[ParameterNumber]:
    """The numbers of parameter sets that a text means: as the manual writes them, or on the wire."""
    for parameter_set in layout.device.parameters.values():
        own = number_of_text(parameter_set, text)
        if own is None and number is not None:
            own = number - parameter_set.base
        if own is not None and parameter_set.holds(own):
            yield ParameterNumber(parameter_set, own, parameter_set.numbered(own))


def fact_of(item: Item) -> Fact | Note | Example | Erratum:
    """The fact of an item, also of an item that is a layout."""
    match item:
        case MessageLayout():
            return item.message
        case RecordLayout():
            return item.record
        case TableLayout():
            return item.table
        case ParameterNumber():
            return item.parameter or item.parameter_set
        case CodeRow():
            return item.member
        case WordState():
            return item.state
        case _:
            return item


def handles(item: Item) -> tuple[str, ...]:
    """The texts by which a user may name an item: its name, the identifier of the manual, and its label."""
    fact = fact_of(item)
    if isinstance(fact, Example | Erratum):
        return (fact.id,)
    if isinstance(fact, Note):
        return (fact.name,)
    if isinstance(item, ParameterNumber) and item.parameter is None:
        return ("", item.printed_text, "")
    printed_text = item.printed_text if isinstance(item, ParameterNumber | CodeRow) else ""
    return fact.name, fact.printed_name or printed_text, fact.label


def numbered(item: Item, number: int) -> bool:
    """Whether a number is an address within an item, or its number or code."""
    match item:
        case Register():
            steps = (number - item.address) // item.stride
            is_inside = 0 <= steps < item.count and number < item.address + steps * item.stride + item.width
            return is_inside or number == item.number
        case TableLayout():
            table = item.table
            return table.base <= number < table.base + table.stride * (table.count - 1) + item.words
        case MessageLayout():
            return number in (item.message.code, item.message.response_code, item.message.number)
        case ParameterNumber():
            count = item.parameter.count if item.parameter is not None else 1
            return any(0 <= number - first < count for first in (item.number, item.parameter_set.base + item.number))
        case CodeRow():
            return number in (item.member.value, item.member.number)
        case _:
            return False


Details = Iterator[tuple[str, str]]

_MEMORY = {"volatile": "lost when the power is switched off", "nonvolatile": "nonvolatile"}
_ENDURANCE = {"limited": "a limited number of writes; the number is not printed", "unlimited": "any number of writes"}


def fact_details(device: Device, fact: Fact) -> Details:
    """The details that every fact has: text, versions, citations, notes, and everything that limits its certainty."""
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
        yield "unverified", "not compared with the manual yet"
    for key, reason in fact.allowed.items():
        yield "allowed", f"{key}: {reason}"
    for general in device.notes:
        if fact.place.path in general.about:
            yield "note", f"{general.title}: {general.text}"
    for erratum in device.errata:
        if erratum.fact == fact.place.path or erratum.fact.startswith(f"{fact.place.path}/"):
            yield "erratum", f"{erratum.id}: {_printed(erratum)}{erratum.reason}"


def _handling(handling: Handling) -> Details:
    """Notes for readers and writers of a value."""
    yield "reading", "clears it: only the first reader gets it" if handling.clears_on_read else ""
    yield "memory", _MEMORY.get(handling.memory, "")
    yield "saved by", handling.saved_by
    yield "endurance", _ENDURANCE.get(handling.endurance, f"{handling.endurance} writes" if handling.endurance else "")
    yield "opposite of", handling.opposite_of


def erratum_details(erratum: Erratum) -> Details:
    """The details of an erratum."""
    yield "fact", erratum.fact
    yield "printed", _printed(erratum).removesuffix(". ").removeprefix("printed ")
    yield "literally", erratum.literal
    yield "reason", erratum.reason
    yield "sure", erratum.confidence
    yield "effect", erratum.effect
    yield "proof", erratum.proof
    yield "source", citations(erratum.sources)


def example_details(example: Example) -> Details:
    """The details of an example; `decode` explains its bytes."""
    yield "title", example.title
    yield (
        "message",
        f"{example.message or 'unknown'} {'refusal' if example.exception_response else example.direction}",
    )
    yield "link", example.link
    yield "frame", example.frame.hex(" ").upper()
    yield "answers", example.reply_to
    yield "refused", example.refused
    texts = {name: value if isinstance(value, str) else spec_text(value) for name, value in example.values.items()}
    yield "values", ", ".join(f"{name} {text}" for name, text in texts.items())
    yield "source", citations(example.sources)
    for note in example.notes:
        yield "note", note


def note_details(note: Note) -> Details:
    """The details of a note."""
    yield "title", note.title
    yield "text", note.text
    yield "about", ", ".join(note.about)
    yield "source", citations(note.sources)


def _printed(erratum: Erratum) -> str:
    keys = ", ".join(f"{key} {'absent' if value is None else value}" for key, value in erratum.printed.items())
    return f"printed {keys}. " if keys else ""


def _claim(claim: Claim) -> str:
    values_text = ", ".join(f"{key} {value}" for key, value in claim.values.items())
    return f"{citations(claim.sources)}" + (f": {values_text}" if values_text else "")
