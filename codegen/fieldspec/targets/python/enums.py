"""Enums and bit fields as Python classes."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import partial

from fieldspec.codec.layout.needed_bits import needed_bits
from fieldspec.foundation.classes import dataclass, field, replace
from fieldspec.foundation.names import Name
from fieldspec.language.model.device import Device
from fieldspec.language.model.enums import Bit, Enum, Flags, Member, State
from fieldspec.targets.fact_texts import described, sentence, unit_word
from fieldspec.targets.pieces import piece
from fieldspec.targets.python.naming import FLAGS, STATES, TYPES, Scope
from fieldspec.targets.python.runs import joined, runs_of
from fieldspec.targets.python.scaling import in_unit, quantity, ratio
from fieldspec.targets.python.text import docstring, filled, item_lines, literal

LEAST = 3
"""The number of named single bits of a byte from which a table is faster than a test of each bit."""


def from_tables(named_bits: Sequence[tuple[Bit, str]]) -> tuple[list[str], frozenset[str]]:
    """Lines that bind bits of `raw` to locals of their names, and which bits those are."""
    lines: list[str] = []
    bound: set[str] = set()
    single = {bit.first: name for bit, name in named_bits if bit.width == 1}
    for start in range(0, max(single, default=0) + 1, 8):
        names = [single.get(place) for place in range(start, start + 8)]
        bound_names = [name for name in names if name]
        if len(bound_names) >= LEAST:
            lines.append(f"{_targets(names)} = _BITS_OF[{f'raw >> {start}' if start else 'raw'} & 255]")
            bound.update(bound_names)
    return lines, frozenset(bound)


def _targets(names: Iterable[str | None]) -> str:
    return ", ".join(name or "_" for name in names)


CODES = ("alarm", "error", "exception", "fault", "warning")
"""The kinds of enums whose members people look up."""


@dataclass(frozen=True, slots=True)
class MemberView:
    """A member: its name, its value, and its docstring."""

    name: str
    value: str
    doc: list[str]


@dataclass(frozen=True, slots=True)
class EnumView:
    """An IntEnum. The names of its tables have a `prefix`; `table` is the one from its values to its members, if any.

    `aliases` are other names of members, with their values. `printed_names` and `numbers` are the lines of the dicts
    with these by the values of members, empty where the enum has none.
    """

    name: str
    prefix: str
    table: str
    title: str
    open: bool
    doc: list[str]
    members: list[MemberView]
    aliases: list[MemberView] = field(default_factory=list)
    printed_names: list[str] = field(default_factory=list)
    numbers: list[str] = field(default_factory=list)

    @property
    def type(self) -> str:
        """The type of a decoded value."""
        return f"{self.name} | int" if self.open else self.name

    @property
    def values(self) -> list[int]:
        """The values of its members."""
        return [int(member.value) for member in self.members]


@dataclass(frozen=True, slots=True)
class BitView:
    """A bit or a field of bits: the type of its property, of its argument, and the expressions that read it."""

    name: str
    type: str
    argument: str
    read: str
    snapshot: str
    doc: list[str]


@dataclass(frozen=True, slots=True)
class FlagsView:
    """A word of flags: the tables of its bits, the constructor for type checkers, and the states of the bits.

    `fitting` has the mask, the value and the member of each state. `taken` are the lines of a snapshot that read the
    bits of a byte at once. `scaled` are the properties of fields of bits in their units. `base` is the class that it
    extends.
    """

    name: str
    base: str
    bits: list[BitView]
    table: list[str]
    init: list[str]
    states: EnumView | None
    fitting: list[str]
    taken: list[str]
    scaled: list[BitView]
    doc: list[str]


def enum_view(enum: Enum, scope: Scope) -> EnumView:
    """The view of an enum."""
    pascal = Name.of(enum.name).pascal()
    name = scope.take(pascal, pascal + "Code")
    return piece("python enum", (enum,), (name,), partial(_enum_view, enum, name))


def _enum_view(enum: Enum, name: str) -> EnumView:
    base_name = Name.of(enum.name)
    members = Scope(frozenset({"mro"}))
    kind = "" if enum.kind == "enum" else f"{enum.kind.capitalize()} codes. "
    remark = "Other values are passed on as numbers." if enum.open else "Other values are refused."
    available = [member for member in enum.members if not member.unavailable]
    printed = [
        f"{m.value}: {literal(m.printed_name)}" for m in available if m.printed_name and _has_displayed_names(enum)
    ]
    numbers = [f"{m.value}: {m.number}" for m in available if m.number is not None]
    upper = base_name.upper()
    left_out = [f"{m.value} ({m.name})" for m in enum.members if m.unavailable]
    missing = f"Not available: {', '.join(left_out)}." if left_out else ""
    member_names = {m.name: members.take(Name.of(m.name).upper()) for m in available}
    return EnumView(
        name=name,
        prefix=f"_{upper}",
        table=f"_{upper}_MEMBERS",
        title=enum.name,
        open=enum.open,
        doc=docstring(described(enum.title or base_name.title(), enum, f"{kind}{remark} {missing}".strip()), 4),
        members=[MemberView(member_names[m.name], str(m.value), docstring(_member(m), 4)) for m in available],
        aliases=[
            MemberView(
                members.take(Name.of(alias).upper()),
                member_names[m.name],
                docstring([f"See {member_names[m.name]}."], 4),
            )
            for m in available
            for alias in m.aliases
        ],
        printed_names=item_lines(f"_{upper}_PRINTED_NAMES: dict[int, str] = {{", printed, "}", 0) if printed else [],
        numbers=filled(f"_{upper}_NUMBERS: dict[int, int] = {{", numbers, "}", 0) if numbers else [],
    )


def _has_displayed_names(enum: Enum) -> bool:
    """Whether a display, or a list of codes, shows the printed names of the members."""
    return bool(enum.printed_as) or enum.kind in CODES


def _member(member: Member) -> list[str]:
    causes = [f" Cause: {sentence(cause.cause)} {' '.join(map(sentence, cause.remedies))}" for cause in member.causes]
    remedies = [f" Remedy: {sentence(remedy)}" for remedy in member.remedies]
    head = described(Name.of(member.name).title(), member, sentence(member.problem))
    return [*head[:3], *causes, *remedies, *head[3:]]


def flags_view(flags: Flags, device: Device, enums: Mapping[str, EnumView], scope: Scope) -> FlagsView:
    """The view of a word of flags."""
    pascal = Name.of(flags.name).pascal()
    name = scope.take(pascal, pascal + "Flags")
    states = scope.take(f"{name}State", f"{name}StateCode") if flags.states else ""
    used = [bit.enum for bit in flags.bits if bit.enum]
    facts = (flags, *map(device.enums.get, used), *map(enums.get, used))
    return piece("python flags", facts, (name, states), partial(_flags_view, flags, device, enums, name, states))


def _flags_view(
    flags: Flags, device: Device, enums: Mapping[str, EnumView], name: str, name_of_states: str
) -> FlagsView:
    base_name = Name.of(flags.name)
    states = _states(flags, name, name_of_states) if flags.states else None
    names = Scope(FLAGS, TYPES, STATES if states else frozenset())
    bit_names = [(bit, names.take(bit.name)) for bit in flags.bits if not bit.reserved]
    lines, bound = from_tables(bit_names)
    bits = [_bit(bit, taken_name, device, enums) for bit, taken_name in bit_names]
    bits = [replace(bit, snapshot=bit.name) if bit.name in bound else bit for bit in bits]
    remark = f"{8 * flags.type.size} bits; those without a name are kept in `raw`."
    table = [f'"{taken_name}": ({bit.first}, {(1 << bit.width) - 1:#x})' for bit, taken_name in bit_names]
    runs = [f"{literal(taken_name)}: {runs_of(bit)}" for bit, taken_name in bit_names if bit.pieces]
    signed = [literal(taken_name) for bit, taken_name in bit_names if bit.signed]
    scaled = [
        (bit, view.name, _scaled(bit, view, names))
        for (bit, _), view in zip(bit_names, bits, strict=True)
        if bit.as_value.scaled
    ]
    units = [f'"{view.name}": ("{raw}", {ratio(bit.as_value)})' for bit, raw, view in scaled]
    in_unit_of = {id(bit): view.name for bit, _, view in scaled}
    keys = {id(bit): [key for key in (raw, in_unit_of.get(id(bit))) if key] for bit, raw in bit_names}
    required = [(own, [key for bit in own.bits for key in keys[id(bit)]]) for own in needed_bits(flags, device.enums)]
    is_preset = bool(required) or flags.initial != 0
    entries = [
        f"{literal(keys[id(own.bit)][0])}: ({literal(own.reason)}, ({', '.join(map(literal, names))},))"
        for own, names in required
    ]
    open_bits = {id(own.bit) for own, _ in required}
    arguments = [_argument(bit, view, id(bit) in open_bits) for (bit, _), view in zip(bit_names, bits, strict=True)]
    arguments += [
        f"{view.name}: {view.argument} = {'...' if bit.default is not None or id(bit) in open_bits else '0'}"
        for bit, _, view in scaled
    ]
    first = "raw: int | None = None" if is_preset else "raw: int = 0"
    return FlagsView(
        name=name,
        base="_PresetFlags" if is_preset else "_Flags",
        bits=bits,
        table=[
            *item_lines("_BITS = {", table, "}", 4),
            *(item_lines("_RUNS = {", runs, "}", 4) if runs else []),
            *(filled("_SIGNED = frozenset({", signed, "})", 4) if signed else []),
            *(item_lines("_QUANTITIES = {", units, "}", 4) if units else []),
            *([f"_INITIAL = {flags.initial:#x}"] if flags.initial else []),
            *(item_lines("_NEEDED = {", entries, "}", 4) if entries else []),
        ],
        scaled=[view for _, _, view in scaled],
        init=item_lines("def __init__(", ["self", first, "*", *arguments], ") -> None: ...", 8),
        states=states,
        fitting=[_fitting(flags, state, number, states) for number, state in enumerate(flags.states)] if states else [],
        taken=lines,
        doc=docstring(described(base_name.title(), flags, remark), 4),
    )


def _argument(bit: Bit, view: BitView, is_needed: bool) -> str:
    """The argument for a bit field: `level: int = 3`, or `level: int = ...` where users must pass it."""
    number = bit.default or 0
    default = str(bool(number)) if view.argument == "bool" else str(number)
    return f"{view.name}: {view.argument} = {'...' if is_needed else default}"


def _states(flags: Flags, name: str, name_of_states: str) -> EnumView:
    """The states that several bits form together, numbered from 1 so that each is true."""
    members = Scope(frozenset({"mro"}))
    return EnumView(
        name=name_of_states,
        prefix="",
        table="",
        title=f"{flags.name}_state",
        open=False,
        doc=docstring([f"The states that the bits of {name} form together."], 4),
        members=[
            MemberView(members.take(Name.of(state.name).upper()), str(number), docstring(_state(state), 4))
            for number, state in enumerate(flags.states, 1)
        ],
    )


def _state(state: State) -> list[str]:
    bits = [f"{', '.join(names)} {value}" for names, value in ((state.set, 1), (state.clear, 0)) if names]
    return described(Name.of(state.name).title(), state, sentence(f"Bits: {'; '.join(bits)}"))


def _fitting(flags: Flags, state: State, number: int, states: EnumView) -> str:
    mask, value = flags.masked(state)
    return f"({mask:#x}, {value:#x}, {states.name}.{states.members[number].name})"


def _bit(bit: Bit, name: str, device: Device, enums: Mapping[str, EnumView]) -> BitView:
    number = f"bit{'s' * (bit.width > 1)} {bit.number_text}"
    meanings = [f"{value} = {text}" for value, text in ((0, bit.zero), (1, bit.one)) if text]
    facts = [f" {meaning}" for meaning in meanings]
    if bit.edge:
        facts.append(f" The {bit.edge} edge has the effect.")
    if bit.active == "low":
        facts.append(" It is 0 while that is so.")
    if bit.when:
        facts.append(f" When {sentence(bit.when)}")
    if bit.default is not None:
        facts.append(f" {bit.default} where it is left out.")
    if reason := bit.reason_to_give(device.enums.get(bit.enum)):
        facts.append(f" It has to be given: its {sentence(reason)}")
    if quantity(bit.as_value):
        facts.append(f" It counts {sentence(quantity(bit.as_value))}")
    doc = docstring(described(f"{Name.of(bit.name).title()}, {number}", bit, *facts), 8)
    if bit.width == 1:
        return _view(name, "bool", f"{{raw}} & {bit.mask:#x} != 0", doc)
    read = joined("{raw}", bit)
    if not bit.enum:
        sign = 1 << bit.width - 1
        return _view(name, "int", f"(({read}) ^ {sign:#x}) - {sign:#x}" if bit.signed else read, doc)
    enum = enums[bit.enum]
    return _view(name, f"{enum.name} | int", f"{enum.table}.get({read}, {read})", doc)


def _scaled(bit: Bit, view: BitView, names: Scope) -> BitView:
    """The property of a field of bits in its unit."""
    value = bit.as_value
    name = names.take(f"{bit.name}_{unit_word(value.unit)}")
    unit = f" in {value.unit}" if value.unit else ""
    doc = docstring([f"`{view.name}`{unit}."], 8)
    return BitView(name, "float", "_Quantity", in_unit(f"self.{view.name}", ratio(value)), "", doc)


def _view(name: str, type_: str, read: str, doc: list[str]) -> BitView:
    argument = "bool" if type_ == "bool" else "int"
    return BitView(name, type_, argument, read.format(raw="self.raw"), read.format(raw="raw"), doc)
