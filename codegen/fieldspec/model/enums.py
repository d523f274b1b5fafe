"""Enums, code tables and bit fields."""

from __future__ import annotations

from decimal import Decimal

from fieldspec.classes import TYPE_CHECKING, dataclass
from fieldspec.model.fact import Citation, Fact
from fieldspec.model.ranges import Ranges
from fieldspec.model.value import PRIMITIVES, Handling, Primitive, Value

if TYPE_CHECKING:
    from fractions import Fraction


@dataclass(frozen=True, slots=True)
class Cause:
    """A possible cause of a code, and what to do about it."""

    cause: str
    remedies: tuple[str, ...]
    sources: tuple[Citation, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Member(Fact):
    """One value, or one code. `number` is a second number that the manual gives it. `aliases` are its other names."""

    value: int
    number: int | None
    unavailable: bool
    problem: str
    causes: tuple[Cause, ...]
    remedies: tuple[str, ...]
    aliases: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class Enum(Fact):
    """Values by name. An open enum passes on values that it does not list; a closed one refuses them.

    `printed_as` is the form of its members' printed names, empty where they have none. `derived` names the word of
    flags, or the enum, that its members follow from; empty where they are listed. A `sparse` enum has no list of the
    values that are missing between its members.
    """

    kind: str
    title: str
    open: bool
    gaps: str
    printed_as: str
    derived: str
    members: tuple[Member, ...]
    sparse: bool = False

    def member(self, value: int) -> Member | None:
        """The member with a value, None if there is none."""
        return next((member for member in self.members if member.value == value), None)

    def named(self, name: str) -> Member | None:
        """The member with a name, or with an alias; None if there is none."""
        return next((member for member in self.members if name in (member.name, *member.aliases)), None)


@dataclass(frozen=True, slots=True, kw_only=True)
class Bit(Fact):
    """Bit `first`, or the bits `first` to `last`; bit 0 is the least significant.

    A field of several bits may be `signed`, in two's complement, and count in parts of a unit: its number in the
    unit is count * scale + offset.
    """

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
    signed: bool = False
    scale: Decimal | Fraction = Decimal(1)
    scale_text: str = ""
    offset: Decimal = Decimal(0)
    unit: str = ""

    @property
    def as_value(self) -> Value:
        """The number in a field of bits as a value: its scale, its unit, and the counts that it can be."""
        high = (1 << max(self.width - self.signed, 0)) - 1
        return Value(
            type=PRIMITIVES["i64" if self.signed else "u64"],
            size=8,
            characters=None,
            byte_order="",
            scale=self.scale,
            scale_text=self.scale_text,
            offset=self.offset,
            unit=self.unit,
            ranges=Ranges(((-high - 1 if self.signed else 0, high),)),
            default=None,
            const=None,
            enum=self.enum,
            flags="",
            parameter=None,
            sentinels=(),
        )

    @property
    def is_number(self) -> bool:
        """Whether it is a number with a sign, a scale or a unit."""
        return self.signed or bool(self.unit) or self.scale != 1 or self.offset != 0

    def number_in(self, word: int) -> int:
        """Its number in a word."""
        number = (word & self.mask) >> self.first
        return number - (1 << self.width) if self.signed and number >> (self.width - 1) else number

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
    """A word and its bits, lowest first. `bit_0` is the bit that the manual counts as 0, `least` or `most`."""

    type: Primitive
    ranges: Ranges | None
    bits: tuple[Bit, ...]
    states: tuple[State, ...]
    bit_0: str = "least"

    def named(self, name: str) -> Bit | None:
        """The bit, or field of bits, with a name, None if there is none."""
        return next((bit for bit in self.bits if bit.name == name), None)

    def masked(self, state: State) -> tuple[int, int]:
        """The bits that decide a state, and their values in it."""
        value = sum(bit.mask for bit in self.bits if bit.name in state.set)
        return value | sum(bit.mask for bit in self.bits if bit.name in state.clear), value
