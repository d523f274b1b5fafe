"""Hazards of reading and writing values, and the section of the report about them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.language.checks.facts import layers
from fieldspec.language.model.access import narrowed, writable
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_array
from fieldspec.language.model.enums import Bit, Flags
from fieldspec.language.model.fact import Citation, Fact, Place
from fieldspec.language.model.record import Field, Message
from fieldspec.language.model.registers import Parameter, ParameterSet, Register
from fieldspec.language.model.table_records import TableRecord, table_records
from fieldspec.language.model.value import UNSPECIFIED, Handling, Value
from fieldspec.tools.audit.section import Figure, Section, SectionTable, Subject


@dataclass(frozen=True, slots=True)
class Kind:
    """A kind of hazard, with advice for all of this kind.

    A kind is `unsafe` where a program must not simply write back what it has read.
    """

    name: str
    title: str
    advice: str
    unsafe: bool = False


KINDS = {
    kind.name: kind
    for kind in (
        Kind(
            "trigger",
            "Writing starts an action",
            "Reading does not return the written value. Never write back a value that was read; write only to "
            "start the action.",
            True,
        ),
        Kind(
            "write_only",
            "Can only be written",
            "Reading is refused or has no meaning, so a written value cannot be verified.",
            True,
        ),
        Kind(
            "clears_on_read",
            "Reading changes the value",
            "Only the first reader gets the value: read it at one place of the program, and never in a block of "
            "the read plan.",
            True,
        ),
        Kind(
            "shared_word",
            "Several values share one write",
            "To change one of them, write the others unchanged; bits without a meaning keep their values.",
            True,
        ),
        Kind(
            "alias",
            "One value at two addresses",
            "Writing one changes the other; if a program stores both, one of them becomes wrong.",
            True,
        ),
        Kind(
            "atomic",
            "All words must be accessed in one request",
            "Read and write all words in one request; otherwise parts of two values are combined.",
        ),
        Kind(
            "opposite",
            "Opposite senses",
            "1 in one of them is 0 in the other: do not compare them, and do not copy one to the other.",
        ),
        Kind("active_low", "True at 0", "The name is true while the bit is 0."),
        Kind(
            "edge",
            "The edge has the effect, not the level",
            "Reset the bit before you use it again.",
        ),
        Kind("restart", "Takes effect after a restart", "The device uses the old value until it is restarted."),
        Kind("save", "Must be saved", "Without the second step, the value is lost when the power is switched off."),
        Kind(
            "wear",
            "Writes to nonvolatile memory",
            "Do not write cyclically to memory that wears out. If no number is printed, ask the manufacturer.",
        ),
    )
}
"""The kinds of hazards by name, the gravest first."""


@dataclass(frozen=True, slots=True)
class Hazard:
    """A hazard of a fact: its kind, the address, and the reason in a few words.

    `key` is the key of the spec that says so.
    """

    kind: Kind
    name: str
    where: str
    why: str
    path: str
    place: Place
    key: str
    sources: tuple[Citation, ...]


def hazards(layout: DeviceLayout) -> list[Hazard]:
    """All hazards of a device, the gravest kind first, each kind in the order of the spec."""
    order = list(KINDS)
    return sorted(_all_hazards(layout), key=lambda hazard: order.index(hazard.kind.name))


def _all_hazards(layout: DeviceLayout) -> Iterator[Hazard]:
    device = layout.device
    alone = _alone(device)
    for register in device.registers():
        yield from _of_register(device, register, alone)
    for table in device.tables.values():
        yield from _handled(table, table.handling, f"0x{table.base:04X}, {table.count} times", device)
    placed = {field.field.place.path for record_layout in layout.records.values() for field in record_layout.fields}
    uses = table_records(device)
    for record in layers(device):
        for field in record.fields:
            yield from _of_field(device, field, uses.get(record.name, ()), field.place.path in placed)
    for parameter_set in device.parameters.values():
        for parameter in parameter_set.parameters:
            yield from _of_parameter(device, parameter_set, parameter)
    for message in device.messages.values():
        yield from _handled(message, message.handling, _code(message), device)
    for word in device.flags.values():
        for bit in word.bits:
            yield from _of_bit(device, word, bit)


def _of_register(device: Device, register: Register, alone: frozenset[str]) -> Iterator[Hazard]:
    place = f" of {device.space_name(register.space)}" if device.several_spaces else ""
    place_text = f"0x{register.address:04X}{place}"
    if register.trigger:
        yield _hazard("trigger", register, place_text, _started(register.value), key="trigger")
    if register.access == "wo":
        yield _hazard("write_only", register, place_text, "access wo", key="access")
    yield from _shared(device, register, register.value, register.access, place_text, alone)
    if register.same_as:
        yield _hazard("alias", register, place_text, f"the same as {register.same_as}", "same_as")
    if register.atomic and register.width > 1:
        last = register.address + register.width - 1
        span = f"0x{register.address:04X}..0x{last:04X}{place}"
        unit = device.space(register.space).unit
        yield _hazard("atomic", register, span, f"{register.width} {unit}s", key="atomic")
    if register.restart:
        yield _hazard("restart", register, place_text, "restart", key="restart")
    yield from _handled(register, register.handling, place_text, device)


def _of_field(device: Device, field: Field, uses: Sequence[TableRecord], in_record: bool) -> Iterator[Hazard]:
    place_text = ", ".join(dict.fromkeys(use.name for use in uses)) or field.place.path.rpartition("/")[0]
    accesses = [narrowed(use.access, field.access) for use in uses]
    if "wo" in (field.access, *accesses):
        yield _hazard("write_only", field, place_text, "access wo", key="access")
    if field.restart:
        yield _hazard("restart", field, place_text, "restart", key="restart")
    if field.atomic and field.value is not None and field.value.size > 2:
        yield _hazard("atomic", field, place_text, f"{(field.value.size + 1) // 2} words", key="atomic")
    if field.value is not None and uses and in_record:
        access = next(filter(writable, accesses), "")
        yield from _shared(device, field, field.value, access, place_text)
    yield from _handled(field, field.handling, place_text, device)


def _of_parameter(device: Device, parameter_set: ParameterSet, parameter: Parameter) -> Iterator[Hazard]:
    place_text = parameter_set.number_text(parameter.number)
    if parameter.trigger:
        yield _hazard("trigger", parameter, place_text, _started(parameter.value), key="trigger")
    if parameter.access == "wo":
        yield _hazard("write_only", parameter, place_text, "access wo", key="access")
    for inner in parameter.subindices:
        if inner.access == "wo":
            yield _hazard("write_only", inner, f"{place_text}[{inner.indices.text()}]", "access wo", key="access")
    yield from _shared(device, parameter, parameter.value, parameter.access, place_text)
    if parameter.restart:
        yield _hazard("restart", parameter, place_text, "restart", key="restart")
    yield from _handled(parameter, parameter.handling, place_text, device)


def _of_bit(device: Device, word: Flags, bit: Bit) -> Iterator[Hazard]:
    place_text = f"{word.name}, bit {bit.number_text}"
    if bit.edge:
        yield _hazard("edge", bit, place_text, f"its {bit.edge} edge", key="edge")
    if bit.active == "low" and not bit.reserved:
        yield _hazard("active_low", bit, place_text, "0 while it holds", key="active")
    yield from _handled(bit, bit.handling, place_text, device)


def _handled(fact: Fact, handling: Handling, place_text: str, device: Device) -> Iterator[Hazard]:
    """The hazards that the keys of handling declare."""
    if handling == UNSPECIFIED:
        return
    if handling.clears_on_read:
        yield _hazard("clears_on_read", fact, place_text, "cleared by reading", key="clears_on_read")
    if handling.opposite_of:
        yield _hazard("opposite", fact, place_text, f"against {handling.opposite_of}", "opposite_of")
    if handling.saved_by:
        condition = "lost when the power is switched off, unless " if handling.memory == "volatile" else ""
        yield _hazard("save", fact, place_text, f"{condition}saved by {handling.saved_by}", "saved_by")
    access = getattr(fact, "access", "")
    if handling.endurance or (handling.memory == "nonvolatile" and access != "ro"):
        yield _hazard(
            "wear",
            fact,
            place_text,
            _endurance(handling.endurance),
            key="endurance" if handling.endurance else "memory",
        )


def _endurance(endurance: str) -> str:
    """How often a value may be written, as the manual says."""
    words = {
        "limited": "a limited number of writes; the number is not printed",
        "unlimited": "an unlimited number of writes",
    }
    return words.get(endurance, f"{endurance} writes") if endurance else "the permitted number of writes is not printed"


def _started(value: Value) -> str:
    """How a write starts the action of a trigger."""
    if value.const is not None:
        return f"started by {value.const:#x}"
    return f"started by a value of {value.enum}" if value.enum else "started by writing"


def _shared(
    device: Device, fact: Fact, value: Value, access: str, place_text: str, registers: frozenset[str] = frozenset()
) -> Iterator[Hazard]:
    """The hazard of a word with several bits that is written as a whole.

    `registers` are the names of registers that write a single bit.
    """
    word = device.flags.get(value.flags)
    if word is None or not writable(access):
        return
    meaningful_bits = [bit for bit in word.bits if not bit.reserved]
    used = sum(bit.mask for bit in meaningful_bits)
    spare = (8 * word.type.size) - used.bit_count()
    if len(meaningful_bits) > 1 or spare:
        alone = sum(bit.name in registers for bit in meaningful_bits)
        spare_text = f", {spare} bits without a meaning" if spare else ""
        also = f", {alone} of them with registers of their own" if alone else ""
        reason = f"{len(meaningful_bits)} things{spare_text}{also}"
        yield _hazard("shared_word", fact, place_text, reason, "flags")


def _alone(device: Device) -> frozenset[str]:
    """The names of writable registers; array names with the index of each element."""
    return frozenset(
        f"{register.name}_{register.index_from + number}" if register.count > 1 else register.name
        for register in device.registers()
        if register.access != "ro"
        for number in range(register.count)
    )


def _code(message: Message) -> str:
    number = message.code if message.code is not None else message.number
    return "" if number is None else f"0x{number:02X}" if message.code is not None else str(number)


def _hazard(kind: str, fact: Fact, place_text: str, reason: str, key: str = "name") -> Hazard:
    return Hazard(KINDS[kind], fact.name, place_text, reason, fact.place.path, fact.place, key, fact.sources)


def undivided(device: Device) -> list[Register]:
    """The registers with several words that the manual does not require to be accessed in one request."""
    return [
        register
        for register in device.registers()
        if register.width > 1
        and not (register.atomic or register.reserved)
        and not (is_array(register.value.encoding) or register.value.digits)
    ]


COLUMNS = ("where", "fact", "why", "spec", "source")
_LONG = 30

_INTRODUCTION = (
    "What may go wrong although all addresses and values are right. The list contains only what the manual states."
)


def access(subject: Subject) -> Section:
    """The section about hazards of reading and writing."""
    all_hazards = hazards(subject.layout)
    unsafe = {hazard.path for hazard in all_hazards if hazard.kind.unsafe}
    paragraphs = [_INTRODUCTION]
    open_ones = undivided(subject.device)
    if open_ones:
        names = ", ".join(register.name for register in open_ones[:6]) + (", …" if len(open_ones) > 6 else "")
        paragraphs.append(
            f"Of {len(open_ones)} registers with several words the manual does not say whether they can be read "
            f"in parts ({names}); no block of the read plan divides them."
        )
    figures = [Figure("facts cannot safely be read and written back", len(unsafe))]
    tables = []
    for kind in KINDS.values():
        of_kind = [hazard for hazard in all_hazards if hazard.kind == kind]
        if of_kind:
            figures.append(
                Figure(f"{'hazard' if len(of_kind) == 1 else 'hazards'}: {kind.title.lower()}", len(of_kind))
            )
        tables.append(_table(kind, of_kind))
    return Section("access", "Access hazards", tuple(paragraphs), tuple(figures), tuple(tables))


def _table(kind: Kind, hazards: list[Hazard]) -> SectionTable:
    rows = tuple(
        (
            hazard.where,
            hazard.path,
            hazard.why,
            hazard.place[hazard.key],
            hazard.sources[0] if hazard.sources else None,
        )
        for hazard in hazards
    )
    kinds = ("warning" if kind.unsafe else "",) * len(rows)
    return SectionTable(kind.name, f"{kind.title}. {kind.advice}", COLUMNS, rows, kinds, detail=len(rows) > _LONG)
