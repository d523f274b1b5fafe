"""Enums and flags in the words of Python."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from fieldspec.backends.python.lines import chained, listed
from fieldspec.backends.python.naming import FLAGS, TYPES, Scope
from fieldspec.backends.python.text import described, docstring, sentence
from fieldspec.model.enum import Enum, Member
from fieldspec.model.flags import Bit, Flags
from fieldspec.names import Name


@dataclass(frozen=True, slots=True)
class MemberView:
    """A member: its name, its value, and its docstring."""

    name: str
    value: str
    doc: list[str]


@dataclass(frozen=True, slots=True)
class EnumView:
    """An IntEnum. `table` is the name of the dict from its values to its members."""

    name: str
    table: str
    title: str
    open: bool
    doc: list[str]
    members: list[MemberView]

    @property
    def type(self) -> str:
        """The type of a decoded value."""
        return f"{self.name} | int" if self.open else self.name


@dataclass(frozen=True, slots=True)
class BitView:
    """A bit or a field of bits: the type of its property, and the expressions that read and set it."""

    name: str
    type: str
    argument: str
    default: str
    read: str
    snapshot: str
    write: str
    doc: list[str]


@dataclass(frozen=True, slots=True)
class FlagsView:
    """A word of flags, with the lines of its constructor from keywords."""

    name: str
    bits: list[BitView]
    of: list[str]
    combined: list[str]
    doc: list[str]


def enum_view(enum: Enum, scope: Scope) -> EnumView:
    """The view of an enum."""
    taken = Name.of(enum.name)
    name = scope.take(taken.pascal(), taken.pascal() + "Code")
    members = Scope(frozenset({"mro"}))
    kind = "" if enum.kind == "enum" else f"{enum.kind.capitalize()} codes. "
    others = "Other values are passed on as numbers." if enum.open else "Other values are refused."
    left_out = [f"{m.value} ({m.name})" for m in enum.members if m.unavailable]
    missing = f"Not available: {', '.join(left_out)}." if left_out else ""
    return EnumView(
        name=name,
        table=f"_{taken.upper()}_MEMBERS",
        title=enum.name,
        open=enum.open,
        doc=docstring(described(enum.title or taken.title(), enum, f"{kind}{others} {missing}".strip()), 4),
        members=[
            MemberView(members.take(Name.of(m.name).upper()), str(m.value), docstring(_member(m), 4))
            for m in enum.members
            if not m.unavailable
        ],
    )


def _member(member: Member) -> list[str]:
    causes = [f" Cause: {sentence(cause.cause)} {' '.join(map(sentence, cause.remedies))}" for cause in member.causes]
    remedies = [f" Remedy: {sentence(remedy)}" for remedy in member.remedies]
    head = described(Name.of(member.name).title(), member, sentence(member.problem))
    return [*head[:3], *causes, *remedies, *head[3:]]


def flags_view(flags: Flags, enums: Mapping[str, EnumView], scope: Scope) -> FlagsView:
    """The view of a word of flags."""
    taken = Name.of(flags.name)
    name = scope.take(taken.pascal(), taken.pascal() + "Flags")
    names = Scope(FLAGS, TYPES)
    bits = [_bit(bit, names.take(bit.name), enums) for bit in flags.bits if not bit.reserved]
    more = f"{8 * flags.type.size} bits; those without a name are kept in `raw`."
    keywords = [f"{bit.name}: {bit.argument} = {bit.default}" for bit in bits]
    return FlagsView(
        name=name,
        bits=bits,
        of=listed("def of(", ["cls", *(["*"] if keywords else []), *keywords], ") -> _Self:", 4),
        combined=chained("word = ", [bit.write for bit in bits], "|", "0", 8),
        doc=docstring(described(taken.title(), flags, more), 4),
    )


def _bit(bit: Bit, name: str, enums: Mapping[str, EnumView]) -> BitView:
    number = f"bit {bit.first}" if bit.width == 1 else f"bits {bit.first}..{bit.last}"
    meanings = [f"{value} = {text}" for value, text in ((0, bit.zero), (1, bit.one)) if text]
    facts = [f" {meaning}" for meaning in meanings]
    if bit.edge:
        facts.append(f" The {bit.edge} edge has the effect.")
    if bit.active == "low":
        facts.append(" It is 0 while that is so.")
    if bit.when:
        facts.append(f" When {sentence(bit.when)}")
    doc = docstring(described(f"{Name.of(bit.name).title()}, {number}", bit, *facts), 8)
    if bit.width == 1:
        return _view(name, "bool", "False", f"{{raw}} & {bit.mask:#x} != 0", f"({bit.mask:#x} if {name} else 0)", doc)
    most = bit.mask >> bit.first
    read = f"{{raw}} >> {bit.first} & {most:#x}" if bit.first else f"{{raw}} & {most:#x}"
    write = f'_field_of_bits("{bit.name}", {name}, {most})' + (f" << {bit.first}" if bit.first else "")
    if not bit.enum:
        return _view(name, "int", "0", read, write, doc)
    enum = enums[bit.enum]
    return _view(name, f"{enum.name} | int", "0", f"{enum.table}.get({read}, {read})", write, doc)


def _view(name: str, type_: str, default: str, read: str, write: str, doc: list[str]) -> BitView:
    argument = "bool" if type_ == "bool" else "int"
    return BitView(name, type_, argument, default, read.format(raw="self.raw"), read.format(raw="raw"), write, doc)
