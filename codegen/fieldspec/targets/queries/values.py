"""The columns of a value, and what is wrong with it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from decimal import Decimal
from fractions import Fraction

from fieldspec.codec.layout.accepted import (
    Condition,
    Equals,
    Fits,
    HasCharacters,
    HasDigits,
    IsBit,
    Known,
    PartWithin,
    RealWithin,
    Test,
    Within,
    range_conditions,
)
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import (
    Digits,
    Octets,
    Real,
    Text,
    Truth,
    Whole,
    is_array,
    is_count,
    is_real,
    sign_of,
)
from fieldspec.language.model.enums import Bit
from fieldspec.language.model.ranges import merged
from fieldspec.language.model.value import OUT_OF_RANGE, Value
from fieldspec.targets.fact_texts import unit_word
from fieldspec.targets.queries.dialect import DecimalScale, Dialect, Slot

Reader = Callable[[str, int], str]
"""The expression of something about the value at an offset of some bytes."""

MOST_DIGITS = 38
"""The digits of a decimal number in DuckDB and in Polars."""


@dataclass(frozen=True, slots=True)
class ValueColumn:
    """A column of a value: the words after the name of the value, and its expression."""

    suffix: str
    read: Reader


@dataclass(frozen=True, slots=True)
class ValueRule:
    """Something that a value breaks: the reason, and the condition."""

    reason: str
    breaks: Reader


@dataclass(frozen=True, slots=True)
class ValueQuery:
    """The expressions of a value with its orders. `enums` are the enums as the dialect refers to them.

    `exponent` reads the exponent of a scale that is elsewhere, None where there is none; `exponents` are the numbers
    that it may be. The stated numbers of a `trigger` are for writes only, not for reads.
    """

    device: Device
    dialect: Dialect
    enums: dict[str, str]
    value: Value
    order: str
    swapped: bool
    exponent: Reader | None = None
    exponents: tuple[tuple[int, int], ...] = ()
    trigger: bool = False

    def number(self, data: str, offset: int) -> str:
        """The expression of the raw number at an offset of the data. Raises AssertionError for a text and for bytes."""
        encoding = self.value.encoding
        slot = Slot(offset, self.value.size, self.order, self.swapped, sign_of(encoding))
        match encoding:
            case Real():
                return self.dialect.real(data, slot, encoding.precision)
            case Whole() | Truth() | Digits():
                return self.dialect.whole(data, slot)
            case Text() | Octets():
                raise AssertionError("a text or bytes are not a number")
            case _:
                assert_never(encoding)

    def word(self, data: str, offset: int) -> str:
        """The expression of the raw number as a word without a sign."""
        return self.dialect.whole(data, Slot(offset, self.value.size, self.order, self.swapped))

    def raw(self, data: str, offset: int) -> str:
        """The raw number as a text; texts and bytes as they are."""
        return "" if is_array(self.value.encoding) else self.dialect.as_text(self.number(data, offset))

    def columns(self) -> Iterator[ValueColumn]:
        """The columns: the value as people read it, the raw number where it differs, and the state."""
        encoding, value, dialect = self.value.encoding, self.value, self.dialect
        match encoding:
            case Text():
                yield ValueColumn("", lambda data, offset: dialect.text(dialect.piece(data, offset, value.size)))
            case Octets():
                yield ValueColumn("", lambda data, offset: dialect.piece(data, offset, value.size))
            case Truth() if not value.enum:
                yield ValueColumn("", lambda data, offset: dialect.truth(self.number(data, offset)))
            case Whole() | Digits() | Truth():
                yield from self._count_columns()
            case Real():
                yield from self._number_columns()
            case _:
                assert_never(encoding)
        if value.sentinels or range_conditions(self.device, value, self.trigger):
            yield ValueColumn("state", self._state)

    def _count_columns(self) -> Iterator[ValueColumn]:
        """The columns of a whole number."""
        value, dialect = self.value, self.dialect
        if value.enum:
            yield ValueColumn(
                "", lambda data, offset: dialect.member(self.number(data, offset), self.enums[value.enum])
            )
            yield ValueColumn("raw", self.number)
        elif value.flags:
            yield ValueColumn("", self.word)
            yield from self._bits()
        elif value.scaled or self.exponent is not None:
            yield ValueColumn(unit_word(value.quantity_unit), self._quantity)
            yield ValueColumn("raw", self.number)
        else:
            yield from self._number_columns()

    def _number_columns(self) -> Iterator[ValueColumn]:
        """The column of a number without names and scale, and the raw number where some stand for a state."""
        if self.value.sentinels:
            yield ValueColumn("", lambda data, offset: self._absent(self.number(data, offset), data, offset))
            yield ValueColumn("raw", self.number)
        else:
            yield ValueColumn("", self.number)

    def faults(self) -> Iterator[ValueRule]:
        """The reasons for which a codec refuses the value, in the order of its tests."""
        encoding, value, dialect = self.value.encoding, self.value, self.dialect
        match encoding:
            case Truth():
                yield ValueRule(
                    "unknown_value",
                    lambda data, offset: dialect.negated(dialect.is_in(self.number(data, offset), [(0, 1)])),
                )
            case Text():
                yield ValueRule(
                    "unknown_value", lambda data, offset: dialect.not_ascii(dialect.piece(data, offset, value.size))
                )
            case Whole() | Digits():
                yield from self._count_faults()
            case Real() | Octets():
                return
            case _:
                assert_never(encoding)

    def _count_faults(self) -> Iterator[ValueRule]:
        dialect, const = self.dialect, self.value.const
        if const is not None:
            yield ValueRule(
                "wrong_const", lambda data, offset: dialect.compared(self.number(data, offset), "<>", str(const))
            )
        enum = self.device.enums.get(self.value.enum)
        if enum is not None and not enum.open:
            yield ValueRule("unknown_value", lambda data, offset: dialect.negated(self._is_known(data, offset, False)))

    def findings(self) -> Iterator[ValueRule]:
        """The findings of an audit about the value: rejected by a codec, or accepted in spite of the spec."""
        yield from self.faults()
        value, dialect = self.value, self.dialect
        enum, flags = self.device.enums.get(value.enum), self.device.flags.get(value.flags)
        if not (is_count(value.encoding) or is_real(value.encoding)):
            return
        if enum is not None and enum.open:
            yield ValueRule("unlisted_value", lambda data, offset: dialect.negated(self._is_known(data, offset, True)))
        conditions = range_conditions(self.device, value)
        if conditions:
            yield ValueRule(OUT_OF_RANGE, lambda data, offset: self._out_of_range(conditions, data, offset))
        if flags is not None:
            used = sum(bit.mask for bit in flags.bits if not bit.reserved)
            spare = ((1 << 8 * value.size) - 1) & ~used
            if spare:
                yield ValueRule("reserved_bits", lambda data, offset: dialect.mask(self.word(data, offset), spare))

    def _out_of_range(self, conditions: tuple[Condition, ...], data: str, offset: int) -> str:
        """Whether a number is out of range; empty where none can be."""
        tests = [self._refused(condition.test, data, offset) for condition in conditions]
        return self.dialect.either(*tests) if len(tests) > 1 else "".join(tests)

    def _refused(self, test: Test, data: str, offset: int) -> str:
        """Whether a number does not pass a test of what is stated of it."""
        value, dialect, number = self.value, self.dialect, self.number(data, offset)
        match test:
            case Within():
                condition = dialect.negated(dialect.is_in(number, [*test.intervals, *test.sentinels]))
            case RealWithin():
                condition = dialect.negated(dialect.is_in(number, test.intervals, floating=True))
                return dialect.both(dialect.negated(dialect.is_nan(number)), condition) if test.takes_nan else condition
            case PartWithin():
                bit = test.bit
                part = dialect.bits(self.word(data, offset), bit)
                condition = dialect.negated(dialect.is_in(part, bit.ranges.intervals if bit.ranges is not None else ()))
                is_other = dialect.negated(dialect.is_in(number, test.sentinels)) if test.sentinels else ""
                return dialect.both(is_other, condition) if is_other else condition
            case Equals() | IsBit() | HasDigits() | HasCharacters() | Known() | Fits():
                raise AssertionError("a codec refuses what does not pass")
            case _:
                assert_never(test)
        enum = self.device.enums.get(value.enum)
        if enum is not None and not enum.open:
            condition = dialect.both(self._is_known(data, offset, False), condition)
        return condition

    def _is_known(self, data: str, offset: int, unavailable: bool) -> str:
        """Whether an enum lists a number, or it is a sentinel."""
        members = self.device.enums[self.value.enum].members
        numbers = (member.value for member in members if unavailable or not member.unavailable)
        intervals = merged([*((number, number) for number in numbers), *self.value.special_intervals])
        return self.dialect.is_in(self.number(data, offset), intervals)

    def _absent(self, column: str, data: str, offset: int) -> str:
        if not self.value.sentinels:
            return column
        intervals = self.value.special_intervals
        return self.dialect.absent(column, self.number(data, offset), intervals, self.value.absent_nan)

    def _state(self, data: str, offset: int) -> str:
        names = {sentinel.interval: sentinel.name for sentinel in self.value.sentinels if not sentinel.is_nan}
        nan = next((sentinel.name for sentinel in self.value.sentinels if sentinel.is_nan), "")
        condition = self._out_of_range(range_conditions(self.device, self.value, self.trigger), data, offset)
        return self.dialect.cases(
            self.number(data, offset), names, nan, (condition, OUT_OF_RANGE) if condition else None
        )

    def _quantity(self, data: str, offset: int) -> str:
        value, number = self.value, self.number(data, offset)
        if self.exponent is not None:
            return self._absent(self.dialect.power(number, self.exponent(data, offset), self.exponents), data, offset)
        return self._absent(quantity(self.dialect, number, value, (value.type.low, value.type.high)), data, offset)

    def _bits(self) -> Iterator[ValueColumn]:
        for bit in self.device.flags[self.value.flags].bits:
            if not bit.reserved:
                yield from self._bit(bit)

    def _bit(self, bit: Bit) -> Iterator[ValueColumn]:
        def number(data: str, offset: int) -> str:
            return self.dialect.bits(self.word(data, offset), bit)

        if bit.enum:
            yield ValueColumn(
                bit.name, lambda data, offset: self.dialect.member(number(data, offset), self.enums[bit.enum])
            )
            yield ValueColumn(f"{bit.name}_raw", number)
        elif bit.scale != 1 or bit.offset != 0:
            value = bit.as_value
            bounds = (bit.low, bit.high)
            yield ValueColumn(
                f"{bit.name}_{unit_word(bit.unit)}",
                lambda data, offset: quantity(self.dialect, number(data, offset), value, bounds),
            )
            yield ValueColumn(f"{bit.name}_raw", number)
        elif bit.width == 1 and not bit.is_number:
            yield ValueColumn(bit.name, lambda data, offset: self.dialect.bit(self.word(data, offset), bit.first))
        else:
            yield ValueColumn(bit.name, number)


def quantity(dialect: Dialect, number: str, value: Value, bounds: tuple[int, int]) -> str:
    """The quantity of a number between `bounds`: exact where it is a decimal number of at most 38 digits."""
    scale = decimal_scale(value, bounds)
    return (
        dialect.ratio(number, Fraction(value.scale), Fraction(value.offset))
        if scale is None
        else dialect.decimal(number, scale)
    )


def decimal_scale(value: Value, bounds: tuple[int, int]) -> DecimalScale | None:
    """The scale of a value whose counts are between `bounds`; None where its quantities are not decimal numbers."""
    if not isinstance(value.scale, Decimal):
        return None
    scale, offset = Fraction(value.scale), Fraction(value.offset)
    places = next(
        (n for n in range(MOST_DIGITS) if not (scale * 10**n).denominator > 1 and (offset * 10**n).denominator == 1),
        None,
    )
    if places is None:
        return None
    digits = max(len(str(abs(bound))) for bound in bounds)
    greatest = max(abs(bound * scale) + abs(offset) for bound in bounds)
    precision = len(str(int(greatest))) + places
    factor = max(len(str(int(abs(scale) * 10**places))), places)
    if digits + factor + bool(offset) > MOST_DIGITS or precision > MOST_DIGITS:
        return None
    return DecimalScale(value.scale, value.offset, digits, places, precision)
