"""A word whose bits have meanings of their own."""

from __future__ import annotations

from fieldspec.classes import dataclass
from fieldspec.model.fact import Fact
from fieldspec.model.handling import Handling
from fieldspec.model.primitive import Primitive
from fieldspec.model.ranges import Ranges


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
        """How many bits it has."""
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
        """The bit, or field of bits, with a name."""
        return next((bit for bit in self.bits if bit.name == name), None)

    def masked(self, state: State) -> tuple[int, int]:
        """The bits that decide a state, and their values in it."""
        value = sum(bit.mask for bit in self.bits if bit.name in state.set)
        return value | sum(bit.mask for bit in self.bits if bit.name in state.clear), value
