"""Enums, code tables and bit fields."""

from __future__ import annotations

from decimal import Decimal

from fieldspec.foundation.classes import TYPE_CHECKING, dataclass
from fieldspec.language.model.fact import Citation, Fact
from fieldspec.language.model.primitives import PRIMITIVES, Primitive
from fieldspec.language.model.ranges import Ranges, merged, uncovered
from fieldspec.language.model.value import Handling, Value

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


@dataclass(frozen=True, slots=True)
class Run:
    """Adjacent bits of a word from `first` on, which hold a number from its bit `weight` on."""

    first: int
    width: int
    weight: int

    @property
    def most(self) -> int:
        """The greatest number of that many bits."""
        return (1 << self.width) - 1


@dataclass(frozen=True, slots=True, kw_only=True)
class Bit(Fact):
    """Bit `first`, or the bits `first` to `last`; bit 0 is the least significant.

    Where the bits of a field lie apart, `pieces` are the first and the last of each run of bits that are adjacent, the
    least significant run of the number first; else it is empty.

    A field of several bits may be `signed`, in two's complement, and count in parts of a unit: its number in the unit
    is count * scale + offset. `ranges` are the permitted counts, None for all that the bits hold, and `default` is the
    count that is sent if none is passed, None if the spec states none.
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
    ranges: Ranges | None = None
    default: int | None = None
    pieces: tuple[tuple[int, int], ...] = ()

    @property
    def as_value(self) -> Value:
        """The number in a field of bits as a value: its scale, its unit, and the counts that it can be."""
        return Value(
            type=PRIMITIVES["i64" if self.signed else "u64"],
            size=8,
            characters=None,
            byte_order="",
            scale=self.scale,
            scale_text=self.scale_text,
            offset=self.offset,
            unit=self.unit,
            ranges=self.ranges or Ranges(((self.low, self.high),)),
            default=self.default,
            const=None,
            enum=self.enum,
            flags="",
            parameter=None,
            sentinels=(),
        )

    @property
    def low(self) -> int:
        """The least number that the bits hold."""
        return -self.high - 1 if self.signed else 0

    @property
    def high(self) -> int:
        """The greatest number that the bits hold."""
        return (1 << max(self.width - self.signed, 0)) - 1

    @property
    def is_bounded(self) -> bool:
        """Whether its range leaves out numbers that the bits hold."""
        return self.ranges is not None and bool(uncovered(self.low, self.high, merged(self.ranges.intervals)))

    @property
    def images(self) -> tuple[tuple[int, int], ...]:
        """The numbers that may be sent as they are in a word whose other bits are 0: intervals in ascending order.

        Those of bits that lie apart are as `joined` has them.
        """
        turn = 1 << self.width
        shift = 0 if self.pieces else self.first
        pairs = [
            pair
            for low, high in (self.ranges or Ranges(((self.low, self.high),))).intervals
            for pair in _unsigned(low, high, turn)
        ]
        return tuple((low << shift, high << shift) for low, high in merged(pairs))

    @property
    def greatest_image(self) -> int:
        """The greatest number in the form of `images` that the bits hold."""
        return (1 << self.width) - 1 if self.pieces else self.mask

    @property
    def is_number(self) -> bool:
        """Whether it is a number with a sign, a scale or a unit."""
        return self.signed or bool(self.unit) or self.scale != 1 or self.offset != 0

    def number_in(self, word: int) -> int:
        """The number that the bit field has in a word."""
        number = self.joined(word)
        return number - (1 << self.width) if self.signed and number >> (self.width - 1) else number

    def reason_to_give(self, enum: Enum | None) -> str:
        """The reason why users must state the bit: the meaning of its 0; empty where it has none, or a default."""
        if self.reserved or self.default is not None:
            return ""
        if self.ranges is not None and 0 not in self.ranges:
            return f"0 is not in {self.ranges.text()}"
        if enum is not None and not enum.open and ((zero := enum.member(0)) is None or zero.unavailable):
            return f"0 is not a member of {enum.name}"
        return f"0 is {self.offset:f} {self.unit}".rstrip() if self.offset else ""

    @property
    def runs(self) -> tuple[Run, ...]:
        """The adjacent bits that the number consists of, the least significant first; one run unless they lie apart."""
        runs: list[Run] = []
        for first, last in self.pieces or ((self.first, self.last),):
            runs.append(Run(first, last - first + 1, sum(run.width for run in runs)))
        return tuple(runs)

    @property
    def places(self) -> tuple[int, ...]:
        """The bits of the word that the bits of the number are, the least significant first."""
        if not self.pieces:
            return tuple(range(self.first, self.last + 1))
        return tuple(run.first + bit for run in self.runs for bit in range(run.width))

    @property
    def number_text(self) -> str:
        """The bits as specs write them: `3`, `9..10`, or `8..14, 0`."""
        runs = self.pieces or ((self.first, self.last),)
        return ", ".join(str(first) if first == last else f"{first}..{last}" for first, last in runs)

    def joined(self, word: int) -> int:
        """The bits in a word beside each other, as a number without a sign."""
        if not self.pieces:
            return (word & self.mask) >> self.first
        return sum((word >> run.first & run.most) << run.weight for run in self.runs)

    def placed(self, number: int) -> int:
        """The word in which the bits hold a number, and all others are 0."""
        return sum((number >> run.weight & run.most) << run.first for run in self.runs)

    @property
    def width(self) -> int:
        """The number of bits."""
        return sum(run.width for run in self.runs) if self.pieces else self.last - self.first + 1

    @property
    def mask(self) -> int:
        """The word in which all bits of the field, and only these, are 1."""
        return sum(run.most << run.first for run in self.runs) if self.pieces else (1 << self.width) - 1 << self.first


def _unsigned(low: int, high: int, turn: int) -> list[tuple[int, int]]:
    """The interval of a signed number as intervals of its bits in two's complement."""
    if low >= 0 or high < 0:
        return [(low % turn, high % turn)]
    return [(0, high), (low % turn, turn - 1)]


@dataclass(frozen=True, slots=True, kw_only=True)
class State(Fact):
    """A state that some bits show together: the bits in `set` are 1 in it, the bits in `clear` are 0."""

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

    @property
    def initial(self) -> int:
        """The word of which nothing is given: the defaults of its fields of bits, else 0."""
        return sum(bit.placed(bit.default) for bit in self.bits if bit.default is not None)

    @property
    def bounded(self) -> tuple[Bit, ...]:
        """The fields of bits whose range leaves out numbers."""
        return tuple(bit for bit in self.bits if bit.is_bounded)

    def refused_bit(self, word: int) -> Bit | None:
        """The first field of bits whose number in a word is not in its range."""
        return next((b for b in self.bounded if b.ranges is not None and b.number_in(word) not in b.ranges), None)

    def nearest(self, word: int) -> int:
        """The word whose fields of bits are each in their range: the bound nearest to 0 in place of another number."""
        for bit in self.bounded:
            if bit.ranges is not None and bit.number_in(word) not in bit.ranges:
                bound = min((end for interval in bit.ranges.intervals for end in interval), key=abs)
                word = word & ~bit.mask | bit.placed(bound)
        return word

    def named(self, name: str) -> Bit | None:
        """The bit, or field of bits, with a name, None if there is none."""
        return next((bit for bit in self.bits if bit.name == name), None)

    def masked(self, state: State) -> tuple[int, int]:
        """The bits that decide a state, and their values in it."""
        value = sum(bit.mask for bit in self.bits if bit.name in state.set)
        return value | sum(bit.mask for bit in self.bits if bit.name in state.clear), value
