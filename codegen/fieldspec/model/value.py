"""How a number, a text or some bytes lie on the wire, and what they mean."""

from __future__ import annotations

from decimal import Context, Decimal

from fieldspec.classes import dataclass, replace
from fieldspec.model.fact import Citation
from fieldspec.model.primitive import Primitive
from fieldspec.model.ranges import Ranges

# Wide enough for the product of a 64-bit count and any scale that the language takes.
_EXACT = Context(prec=120)


@dataclass(frozen=True, slots=True)
class Sentinel:
    """A value that stands for something else than a quantity: a count, of a float a number.

    Of a float that is no number, `value` is its bits, and `is_nan` says so; every NaN stands for it.
    """

    value: int
    name: str
    doc: str
    sources: tuple[Citation, ...]
    is_nan: bool = False

    @property
    def text(self) -> str:
        """What it is on the wire: `65535`, or `NaN 0x7FC00000`."""
        return f"NaN 0x{self.value:08X}" if self.is_nan else str(self.value)


@dataclass(frozen=True, slots=True)
class ParameterPart:
    """That a value is the number, the value, or all values, of a set of numbered parameters, or of a space of sets."""

    set: str
    part: str
    number: str


@dataclass(frozen=True, slots=True)
class Value:
    """A value on the wire: `size` in bytes; value in the unit = raw * scale + offset.

    `scale_text` is the scale as the spec writes it. `ranges`, `write_ranges`, `default` and `const` are raw counts.
    `write_ranges` are given where others may be written than reading gives. `enum` and `flags` are names, empty where
    there is none.
    """

    type: Primitive
    size: int
    characters: int | None
    byte_order: str
    scale: Decimal
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

    @property
    def written_ranges(self) -> Ranges | None:
        """The counts that may be written, None where nothing bounds them but the type. Sentinels may be, too."""
        return self.ranges if self.write_ranges is None else self.write_ranges

    @property
    def scaled(self) -> bool:
        """Whether the value in the unit is another number than the raw one."""
        return self.scale != 1 or self.offset != 0

    def sentinel(self, raw: float) -> Sentinel | None:
        """The sentinel with a raw count, or with a floating-point number."""
        if raw != raw:
            return next((sentinel for sentinel in self.sentinels if sentinel.is_nan), None)
        return next((sentinel for sentinel in self.sentinels if sentinel.value == raw and not sentinel.is_nan), None)

    @property
    def absent_nan(self) -> bool:
        """Whether a NaN stands for an absent value."""
        return any(sentinel.is_nan for sentinel in self.sentinels)

    def as_answer(self, trigger: bool) -> Value:
        """The value as a device answers it: a constant binds only what is written.

        What reading a `trigger` gives is not what was written, so a closed enum does not bind the answer either.
        """
        enum = "" if trigger else self.enum
        return self if self.const is None and enum == self.enum else replace(self, const=None, enum=enum)

    def as_written(self) -> Value:
        """The value as it may be written: its range is that of writing."""
        return self if self.write_ranges is None else replace(self, ranges=self.write_ranges, write_ranges=None)

    def in_unit(self, raw: int) -> Decimal:
        """A raw count in the unit, exactly."""
        return _EXACT.add(_EXACT.multiply(raw, self.scale), self.offset)

    def from_unit(self, number: Decimal) -> int | None:
        """The raw count of a value in the unit, or None where it is no whole number of counts."""
        from fractions import Fraction

        raw = (Fraction(number) - Fraction(self.offset)) / Fraction(self.scale)
        return raw.numerator if raw.denominator == 1 else None


def exact_scale(text: str) -> Decimal | None:
    """`100/2^14` as an exact number, or None where it is none with at most 60 decimals."""
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
    return None
