"""Enums, code tables and bit fields."""

from __future__ import annotations

from fieldspec.classes import dataclass
from fieldspec.model.fact import Citation, Fact
from fieldspec.model.value import Handling, Primitive, Ranges


@dataclass(frozen=True, slots=True)
class Cause:
    """A possible cause of a code, and what to do about it."""

    cause: str
    remedies: tuple[str, ...]
    sources: tuple[Citation, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Member(Fact):
    """One value, or one code. `number` is a second number that the manual gives it."""

    value: int
    number: int | None
    unavailable: bool
    problem: str
    causes: tuple[Cause, ...]
    remedies: tuple[str, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Enum(Fact):
    """Values by name. An open enum passes on values that it does not list; a closed one refuses them.

    `printed_as` is the form of its members' printed names, empty where they have none. `derived` names the word of
    flags, or the enum, that its members follow from; empty where they are listed.
    """

    kind: str
    title: str
    open: bool
    gaps: str
    printed_as: str
    derived: str
    members: tuple[Member, ...]

    def member(self, value: int) -> Member | None:
        """The member with a value, None if there is none."""
        return next((member for member in self.members if member.value == value), None)

    def named(self, name: str) -> Member | None:
        """The member with a name, None if there is none."""
        return next((member for member in self.members if member.name == name), None)


@dataclass(frozen=True, slots=True, kw_only=True)
class Bit(Fact):
    """Bit `first`, or the bits `first` to `last`; bit 0 is the least significant."""

    first: int
    last: int
    zero: str
    one: str
    enum: str
    edge: str
    active: str
    reserved: bool
    handling: Handling
    when: str

    @property
    def width(self) -> int:
        """The number of bits."""
        return self.last - self.first + 1

    @property
    def mask(self) -> int:
        """The bits in the word."""
        return ((1 << self.width) - 1) << self.first


@dataclass(frozen=True, slots=True, kw_only=True)
class State(Fact):
    """A state that some bits show together: those of `set` are 1 in it, those of `clear` are 0."""

    set: tuple[str, ...]
    clear: tuple[str, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Flags(Fact):
    """A word and its bits, lowest first."""

    type: Primitive
    ranges: Ranges | None
    bits: tuple[Bit, ...]
    states: tuple[State, ...]

    def named(self, name: str) -> Bit | None:
        """The bit, or field of bits, with a name, None if there is none."""
        return next((bit for bit in self.bits if bit.name == name), None)

    def masked(self, state: State) -> tuple[int, int]:
        """The bits that decide a state, and their values in it."""
        value = sum(bit.mask for bit in self.bits if bit.name in state.set)
        return value | sum(bit.mask for bit in self.bits if bit.name in state.clear), value
