"""Values: encoding, range, scale, handling; signals and conversions."""

from __future__ import annotations

from decimal import Context, Decimal

from fieldspec.foundation.classes import TYPE_CHECKING, attributes, dataclass, replace
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.digits import NO_CHARACTERS, digit_bounds
from fieldspec.language.model.encoding import Digits, Encoding, Octets, Real, Text, Truth, Whole, is_octets, sign_of
from fieldspec.language.model.fact import Citation, Fact
from fieldspec.language.model.primitives import Primitive
from fieldspec.language.model.ranges import Ranges, merged, uncovered
from fieldspec.language.model.text_form import UTF_16, TextForm

if TYPE_CHECKING:
    from fractions import Fraction
    from typing import Final


@dataclass(frozen=True, slots=True)
class Handling:
    """The memory of a value, what reading does to it, and the fact with the opposite sense.

    `memory` is `volatile`, `nonvolatile`, or empty where the manual does not state it. `saved_by` is the path of the
    fact that saves a value which would be lost without power. `endurance` is the number of writes that the memory
    endures: a number, `limited`, `unlimited`, or empty. `opposite_of` is a path, or empty.
    """

    memory: str = ""
    saved_by: str = ""
    endurance: str = ""
    clears_on_read: bool = False
    opposite_of: str = ""


UNSPECIFIED = Handling()
"""The handling of a value where the manual states none."""

HANDLING_KEYS = attributes(Handling)
"""The keys of specs that state the handling; the attributes have the same names."""


# Wide enough for the product of a 64-bit count and any scale that the language takes.
_EXACT = Context(prec=120)


OUT_OF_RANGE: Final = "out_of_range"
"""The state of a number that is read outside of what is stated of it, which is a quantity all the same."""


@dataclass(frozen=True, slots=True)
class Sentinel:
    """A value that means a state and not a quantity: a count, or for a float a number.

    For a NaN, `value` has its bits and `is_nan` is true; every NaN that is read means this state. Where all counts of
    an interval mean it, `value` is the least, which is written for it, and `last` the greatest; else `last` is None.
    """

    value: int
    name: str
    doc: str
    sources: tuple[Citation, ...]
    is_nan: bool = False
    last: int | None = None

    @property
    def interval(self) -> tuple[int, int]:
        """The least and the greatest count that mean it."""
        return self.value, self.value if self.last is None else self.last

    @property
    def text(self) -> str:
        """The value on the wire: `65535`, `65024..65279`, or `NaN 0x7FC00000`."""
        if self.last is not None:
            return f"{self.value}..{self.last}"
        return f"NaN 0x{self.value:08X}" if self.is_nan else str(self.value)


MOST_PLACES = 22
"""The greatest size of an exponent in a register: 10^22 is the last power of ten that an f64 has exactly."""


def power_of_ten(scale_by: str) -> str:
    """The scale whose exponent is in a register, as texts write it after a count: the sign `times`, `10^power_sf`."""
    return f"\N{MULTIPLICATION SIGN}10^{scale_by}"


@dataclass(frozen=True, slots=True)
class SizeCase:
    """A number of bytes, and the members of an enum that stand for it; the first one is written."""

    when: tuple[str, ...]
    bytes: int


@dataclass(frozen=True, slots=True)
class ParameterSizes:
    """How many bytes of a field are the value of a parameter: the field `by`, which has an enum, says it."""

    by: str
    cases: tuple[SizeCase, ...]


@dataclass(frozen=True, slots=True)
class ParameterPart:
    """The role of a value in an access to numbered parameters of a set or of a space: number, subindex or value.

    `sizes` is None where all bytes of a field are the value.
    """

    set: str
    part: str
    number: str
    sizes: ParameterSizes | None = None


@dataclass(frozen=True, slots=True)
class Value:
    """A value on the wire: `size` in bytes; value in the unit = raw * scale + offset.

    `scale` is a fraction where no decimal number is it, and `scale_text` what the spec writes. `ranges`,
    `write_ranges`, `default` and `const` are raw counts. `write_ranges` is None where the same values may be read and
    written. `enum` and `flags` are names, or empty. `byte_order` and `word_order` are empty where the value has the
    orders of its link. `digits` is the form of the digits that it is sent as, empty for a binary number, and
    CODEC where the codec of a package with the name `codec` reads and writes it; `places` is how many digits follow a
    point. `scale_by` names the register with the exponent of a scale that is read from the device, else it is empty;
    `unit` then begins with that power of ten. `text_form` is how a text is sent, None for ASCII that is padded with
    zeros. `width` is the most bytes of a value that varies in width, else
    it is 0; `size` is then that of the image that codecs work on, with leading zeros and a sign, or zeros after a text.
    The image of bytes has a mark of one byte more.
    `has_blanks` says that decimal digits have blanks in place of leading zeros, and a sign below zero only.
    `write_word_order` is empty where a write has the words in the order of a read. A number of a packed
    list has `packed_bits` on the wire, fewer than its type; it is 0 for all others.
    """

    type: Primitive
    size: int
    characters: int | None
    byte_order: str
    scale: Decimal | Fraction
    scale_text: str
    offset: Decimal
    unit: str
    ranges: Ranges | None
    default: int | str | None
    const: int | None
    enum: str
    flags: str
    parameter: ParameterPart | None
    sentinels: tuple[Sentinel, ...]
    write_ranges: Ranges | None = None
    word_order: str = ""
    digits: str = ""
    places: int = 0
    scale_by: str = ""
    text_form: TextForm | None = None
    width: int = 0
    has_blanks: bool = False
    codec: str = ""
    write_word_order: str = ""
    packed_bits: int = 0

    @property
    def encoding(self) -> Encoding:
        """How it is on the wire."""
        encoding = self.type.encoding
        match encoding:
            case Whole():
                if not self.digits:
                    return encoding
                return Digits(encoding, self.digits, self.size, self.places, self.has_blanks)
            case Real() | Truth():
                return encoding
            case Text():
                return Text(self.size, self.text_form)
            case Octets():
                return Octets(self.size)
            case _:
                assert_never(encoding)

    @property
    def quantity_unit(self) -> str:
        """The unit of the quantity; that of a count begins with the power of ten of `scale_by`."""
        return self.unit.removeprefix(power_of_ten(self.scale_by)).lstrip() if self.scale_by else self.unit

    def number_size(self, size: int) -> int:
        """The size of its binary number, for a value in `size` bytes: for digits, the size of the type."""
        return self.type.size if self.digits else size

    @property
    def packed_number(self) -> Whole | None:
        """The number in the bits of an element of a packed list; None for other values."""
        return Whole(self.packed_bits, sign_of(self.type.encoding)) if self.packed_bits else None

    @property
    def packed_text(self) -> str:
        """`packed into 12 bits`; empty where it has whole bytes."""
        return f"packed into {self.packed_bits} bit{'s' * (self.packed_bits > 1)}" if self.packed_bits else ""

    @property
    def low(self) -> int:
        """The least raw value that the wire can carry."""
        if self.packed_number is not None:
            return self.packed_number.bounds[0]
        return max(self.type.low, digit_bounds(self)[0]) if self.digits else self.type.low

    @property
    def high(self) -> int:
        """The greatest raw value that the wire can carry."""
        if self.packed_number is not None:
            return self.packed_number.bounds[1]
        return min(self.type.high, digit_bounds(self)[1]) if self.digits else self.type.high

    @property
    def scale_number(self) -> Decimal | str:
        """The scale as a decimal number, or as the fraction that the spec writes."""
        return self.scale if isinstance(self.scale, Decimal) else self.scale_text

    @property
    def writable_ranges(self) -> Ranges | None:
        """The counts that may be written in addition to sentinels; None where only the type bounds them."""
        ranges = self.ranges if self.write_ranges is None else self.write_ranges
        return Ranges(((self.low, self.high),)) if ranges is None and (self.digits or self.packed_bits) else ranges

    @property
    def has_words(self) -> bool:
        """Whether it consists of several words of 16 bits, whose order matters."""
        is_number = self.type.is_number and not self.is_as_sent and not self.packed_bits
        return is_number and self.size > 2 and self.size % 2 == 0

    def write_swapped(self, swapped: bool) -> bool:
        """Whether the words of a write are swapped, by whether the words of a read are."""
        return swapped != bool(self.write_word_order)

    @property
    def write_order_text(self) -> str:
        """`high word first when it is written`; empty where a write has the words in the order of a read."""
        words = {"": "", "big": "high", "little": "low"}[self.write_word_order]
        return f"{words} word first when it is written" if words else ""

    @property
    def least_width(self) -> int:
        """The fewest bytes of a value that varies in width: one digit, or no character."""
        return 1 if self.digits else 0

    @property
    def least_size(self) -> int:
        """The fewest bytes of the value."""
        return self.least_width if self.width else self.size

    @property
    def is_marked(self) -> bool:
        """Whether a mark follows its bytes in an image: bytes that vary in width may have any content."""
        return bool(self.width) and is_octets(self.type.encoding)

    @property
    def image_size(self) -> int:
        """Its bytes in the image of a record, with the mark."""
        return self.size + self.is_marked

    @property
    def has_order(self) -> bool:
        """Whether the order of its bytes matters."""
        if self.text_form is not None and (self.text_form.encoding == UTF_16 or self.text_form.is_turned):
            return True
        return (self.type.size > 1 or self.packed_bits > 0) and not self.is_as_sent

    @property
    def has_characters(self) -> bool:
        """Whether its digits are characters, of which the first is the most significant whatever the byte order."""
        return self.digits not in ("", *NO_CHARACTERS)

    @property
    def is_as_sent(self) -> bool:
        """Whether its bytes are in the order of the wire whatever the byte order: characters and bytes of a codec."""
        return self.has_characters or bool(self.codec)

    @property
    def is_low_first(self) -> bool:
        """Whether hexadecimal digits begin with the digits of the lowest byte."""
        return self.digits.endswith("hex") and self.byte_order == "little"

    @property
    def scaled(self) -> bool:
        """Whether the quantity differs from the raw value."""
        return self.scale != 1 or self.offset != 0

    def sentinel(self, raw: float) -> Sentinel | None:
        """The sentinel with a raw count, or with a floating-point number."""
        if raw != raw:
            return next((sentinel for sentinel in self.sentinels if sentinel.is_nan), None)
        for sentinel in self.sentinels:
            low, high = sentinel.interval
            if low <= raw <= high and not sentinel.is_nan:
                return sentinel
        return None

    @property
    def special_intervals(self) -> tuple[tuple[int, int], ...]:
        """The intervals of the sentinels, without a NaN."""
        return tuple(sentinel.interval for sentinel in self.sentinels if not sentinel.is_nan)

    @property
    def quantity_intervals(self) -> list[tuple[int, int]]:
        """The counts that are quantities, in ascending order: those in range that no sentinel has."""
        special = merged(self.special_intervals)
        intervals = self.ranges.intervals if self.ranges is not None else ((self.low, self.high),)
        return sorted({part for low, high in intervals for part in uncovered(low, high, special)})

    @property
    def absent_nan(self) -> bool:
        """Whether a NaN is a sentinel."""
        return any(sentinel.is_nan for sentinel in self.sentinels)

    def as_answer(self, trigger: bool) -> Value:
        """The value in a response: a constant binds only what is written.

        Reading a `trigger` does not return what was written, so a closed enum does not bind the response either. Its
        type does: a truth value is 0 or 1, and digits are digits.
        """
        enum = "" if trigger else self.enum
        return self if self.const is None and enum == self.enum else replace(self, const=None, enum=enum)

    def for_writing(self) -> Value:
        """The value with the range of writing as its only range."""
        return self if self.write_ranges is None else replace(self, ranges=self.write_ranges, write_ranges=None)

    def in_unit(self, raw: float) -> Decimal:
        """The quantity of a raw count: the exact one, or 120 digits of it where the scale is not a decimal number."""
        if isinstance(self.scale, Decimal):
            number = Decimal(repr(raw)) if isinstance(raw, float) else raw
            return _EXACT.add(_EXACT.multiply(number, self.scale), self.offset)
        exact = int(raw) * self.scale
        return _EXACT.add(_EXACT.divide(exact.numerator, exact.denominator), self.offset)

    def scaled_by(self, exponent: int) -> Value:
        """The value with the scale that an exponent makes of it, which is the number in the register `scale_by`."""
        scale = Decimal(1).scaleb(exponent)
        return replace(self, scale=scale, scale_text=f"{scale:f}", scale_by="", unit=self.quantity_unit)

    def from_unit(self, number: Decimal | Fraction) -> int | None:
        """The raw count of a quantity; None where it is not a whole number of counts."""
        from fractions import Fraction

        raw = (Fraction(number) - Fraction(self.offset)) / Fraction(self.scale)
        return raw.numerator if raw.denominator == 1 else None


_LARGEST_TERM = 10**18
"""The greatest numerator and denominator of a scale that is not a decimal number."""


def exact_scale(text: str) -> Decimal | Fraction | None:
    """`100/2^14` as an exact number: a fraction where it is not a decimal number of at most 60 places.

    None for a divisor of 0, and where numerator or denominator of such a fraction have more than 18 digits.
    """
    above, _, below = text.partition("/")
    base, _, power = below.partition("^")
    divisor = int(base) ** int(power or "1")
    if divisor == 0:
        return None
    from fractions import Fraction

    number = Fraction(above) / divisor
    for places in range(61):
        if (number * 10**places).denominator == 1:
            return Decimal((number * 10**places).numerator).scaleb(-places, _EXACT)
    return number if max(number.numerator, number.denominator) <= _LARGEST_TERM else None


@dataclass(frozen=True, slots=True, kw_only=True)
class Signal(Fact):
    """A value that fields of messages place. `direction` is request, response, or empty where it is not printed."""

    value: Value
    direction: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Conversion(Fact):
    """quantity = reference * raw / full_scale; with `complement`, reference * (1 - raw / full_scale).

    `signals` are the signals that it applies to, `type` is the type of the raw value, and `references` are the paths
    of the facts with the reference value. `printed` is the formula as printed.
    """

    title: str
    signals: tuple[str, ...]
    type: Primitive
    full_scale: int
    complement: bool
    references: tuple[str, ...]
    printed: str

    def quantity(self, raw: int, reference: Fraction) -> Fraction:
        """The quantity of a raw count."""
        share = reference * raw / self.full_scale
        return reference - share if self.complement else share
