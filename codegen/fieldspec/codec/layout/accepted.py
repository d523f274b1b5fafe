"""The numbers and bytes that a value takes: what readers refuse, what they let pass and remark, what writers refuse.

These are the only places that say what a range, a constant, a closed enum, a special value and a bounded part of a word
mean together. Conditions are in the order in which codecs refuse. What readers let pass and remark is a value all the
same: outputs say that it is out of range where they say for which state a special value stands.
"""

from __future__ import annotations

from fieldspec.foundation.classes import TYPE_CHECKING, dataclass
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.encoding import (
    Digits,
    Encoding,
    Octets,
    Precision,
    Real,
    Text,
    Truth,
    Whole,
    bounds_of,
    real_bits,
)
from fieldspec.language.model.ranges import Ranges, merged
from fieldspec.language.model.value import OUT_OF_RANGE

if TYPE_CHECKING:
    from collections.abc import Iterable
    from typing import Literal

    from fieldspec.language.model.device import Device
    from fieldspec.language.model.enums import Bit
    from fieldspec.language.model.value import Sentinel, Value

    Reason = Literal["wrong_const", "unknown_value", "out_of_range"]

REASONS: tuple[Reason, ...] = ("wrong_const", "unknown_value", "out_of_range")
"""Why a value is refused."""


@dataclass(frozen=True, slots=True)
class Equals:
    """It is this number."""

    number: int


@dataclass(frozen=True, slots=True)
class IsBit:
    """It is 0 or 1."""


@dataclass(frozen=True, slots=True)
class HasDigits:
    """The bytes are the digits of a number."""

    digits: Digits


@dataclass(frozen=True, slots=True)
class HasCharacters:
    """The bytes, or the characters, are a valid text."""

    text: Text


@dataclass(frozen=True, slots=True)
class Known:
    """It is a member of a closed enum, whose members are the intervals `members`, or one of some special values.

    Special values are intervals, here and in the tests below.
    """

    enum: str
    members: tuple[tuple[int, int], ...]
    sentinels: tuple[tuple[int, int], ...]


@dataclass(frozen=True, slots=True)
class Within:
    """It is in one of some intervals, or one of some special values that are in none of them."""

    intervals: tuple[tuple[int, int], ...]
    sentinels: tuple[tuple[int, int], ...] = ()


@dataclass(frozen=True, slots=True)
class RealWithin:
    """It is in one of some intervals; a NaN is where `takes_nan`."""

    intervals: tuple[tuple[float, float], ...]
    takes_nan: bool


@dataclass(frozen=True, slots=True)
class PartWithin:
    """The bits of a part of a word are in one of some intervals, or the word is one of some special values."""

    bit: Bit
    sentinels: tuple[tuple[int, int], ...]


@dataclass(frozen=True, slots=True)
class Fits:
    """It is not a finite number that becomes infinite in a precision."""

    precision: Precision


Test = Equals | IsBit | HasDigits | HasCharacters | Known | Within | RealWithin | PartWithin | Fits
"""What holds for the numbers that are accepted."""


@dataclass(frozen=True, slots=True)
class Condition:
    """A test, and the reason for which a value is refused that does not pass it."""

    test: Test
    reason: Reason


@dataclass(frozen=True, slots=True)
class AcceptedSet:
    """The numbers that a value accepts: conditions that readers enforce, that readers only remark, and that writers
    enforce.

    `sentinels` are the numbers that stand for a state.
    """

    reading: tuple[Condition, ...]
    remarked: tuple[Condition, ...]
    writing: tuple[Condition, ...]
    sentinels: tuple[Sentinel, ...]


def accepted(device: Device, value: Value) -> AcceptedSet:
    """The numbers that a value accepts. A condition that one before it implies is left out."""
    encoding = value.encoding
    reading = _reading(device, value, encoding)
    writing = _writing(device, value, encoding)
    return AcceptedSet(tuple(reading), _remarked_alone(device, value, reading), tuple(writing), value.sentinels)


def _remarked_alone(device: Device, value: Value, reading: list[Condition]) -> tuple[Condition, ...]:
    """The conditions that a reader only remarks."""
    remarked = _remarked(device, value, value.encoding)
    return tuple(_needed([*reading, *remarked])[len(reading) :]) if remarked else ()


def _reading(device: Device, value: Value, encoding: Encoding) -> list[Condition]:
    """The conditions that a reader enforces."""
    match encoding:
        case Whole():
            return _needed([*_constant(value), *_enum(device, value)])
        case Digits():
            return [
                Condition(HasDigits(encoding), "unknown_value"),
                *_needed([*_constant(value), *_enum(device, value)]),
            ]
        case Truth():
            return [Condition(IsBit(), "unknown_value")]
        case Text():
            return [Condition(HasCharacters(encoding), "unknown_value")]
        case Real() | Octets():
            return []
        case _:
            assert_never(encoding)


def _remarked(device: Device, value: Value, encoding: Encoding) -> list[Condition]:
    """The conditions that a reader ignores and an explainer remarks."""
    match encoding:
        case Whole() | Digits():
            tests: list[Test] = [*_parts(device, value)]
            if value.ranges is not None and not value.ranges.includes(value.low, value.high):
                tests.insert(0, _within(value, value.ranges))
            return [Condition(test, OUT_OF_RANGE) for test in tests]
        case Real():
            return _real_range(value)
        case Truth() | Text() | Octets():
            return []
        case _:
            assert_never(encoding)


def _writing(device: Device, value: Value, encoding: Encoding) -> list[Condition]:
    """The conditions that a writer enforces."""
    match encoding:
        case Whole() | Digits():
            writable = Condition(writable_numbers(value), "out_of_range")
            numbers = _needed([*_constant(value), *_enum(device, value), writable])
            return [*numbers, *(Condition(test, "out_of_range") for test in _parts(device, value))]
        case Real():
            return _needed([*_real_range(value), Condition(Fits(encoding.precision), "out_of_range")])
        case Truth():
            return [Condition(IsBit(), "out_of_range")]
        case Text():
            return [Condition(HasCharacters(encoding), "unknown_value")]
        case Octets():
            return []
        case _:
            assert_never(encoding)


@dataclass(frozen=True, slots=True)
class StatedNumbers:
    """The stated numbers of a value that may be read with other numbers too: some intervals, with ranges of parts of a
    word. Without intervals, every number is. Special values are beside them.
    """

    intervals: tuple[tuple[float, float], ...]
    bits: tuple[Bit, ...]


def range_conditions(device: Device, value: Value, trigger: bool = False) -> tuple[Condition, ...]:
    """The conditions without which a value that is read is out of range. A register or parameter is read as its answer.

    A `trigger` does not return the written number, so nothing is stated of it.
    """
    return () if trigger else _remarked_alone(device, value, _reading(device, value, value.encoding))


def stated_numbers(device: Device, value: Value, trigger: bool = False) -> StatedNumbers | None:
    """The numbers beside which a value that is read is out of range; None where no number is."""
    intervals: tuple[tuple[float, float], ...] = ()
    bits: list[Bit] = []
    for condition in range_conditions(device, value, trigger):
        match condition.test:
            case Within() | RealWithin():
                intervals = value.ranges.intervals if value.ranges is not None else ()
            case PartWithin():
                bits.append(condition.test.bit)
            case Equals() | IsBit() | HasDigits() | HasCharacters() | Known() | Fits():
                continue  # readers refuse what does not pass
            case _:
                assert_never(condition.test)
    return StatedNumbers(intervals, tuple(bits)) if intervals or bits else None


def passes(test: Test, content: float | str | bytes | None) -> bool:
    """Whether a content passes a test; None stands for bytes that are not digits, or no characters, of a value."""
    match test:
        case HasDigits() | HasCharacters():
            return content is not None
        case Equals() | IsBit() | Known() | Within() | RealWithin() | PartWithin() | Fits():
            return isinstance(content, int | float) and _number_passes(test, content)
        case _:
            assert_never(test)


def _number_passes(test: Equals | IsBit | Known | Within | RealWithin | PartWithin | Fits, number: float) -> bool:
    match test:
        case Equals():
            return number == test.number
        case IsBit():
            return number in (0, 1)
        case Known():
            return _is_in(number, test.sentinels) or _is_in(number, test.members)
        case Within():
            return _is_in(number, test.sentinels) or _is_in(number, test.intervals)
        case RealWithin():
            return (test.takes_nan and number != number) or _is_in(number, test.intervals)
        case PartWithin():
            return _is_in(number, test.sentinels) or _part_is_in(test.bit, int(number))
        case Fits():
            return _fits(number, test.precision)
        case _:
            assert_never(test)


def _part_is_in(bit: Bit, word: int) -> bool:
    return _is_in(bit.joined(word) if bit.pieces else word & bit.mask, bit.images)


def _is_in(number: float, intervals: Iterable[tuple[float, float]]) -> bool:
    for low, high in intervals:  # noqa: SIM110 (called for each number that is received; `any` takes twice the time)
        if low <= number <= high:
            return True
    return False


def _constant(value: Value) -> list[Condition]:
    return [] if value.const is None else [Condition(Equals(value.const), "wrong_const")]


def _enum(device: Device, value: Value) -> list[Condition]:
    enum = device.enums.get(value.enum)
    if enum is None or enum.open:
        return []
    members = merged((member.value, member.value) for member in enum.members if not member.unavailable)
    return [Condition(Known(enum.name, tuple(members), value.special_intervals), "unknown_value")]


def writable_numbers(value: Value) -> Within:
    """The whole numbers that may be written: the numbers of the range for writing; without it, all numbers of the
    encoding.
    """
    ranges = value.writable_ranges
    if ranges is None:
        return Within((bounds_of(value.encoding),))
    return _within(value, ranges)


def _within(value: Value, ranges: Ranges) -> Within:
    """The numbers in some ranges, and the special values that are not."""
    further = tuple(interval for interval in value.special_intervals if not ranges.includes(*interval))
    return Within(tuple(sorted(ranges.intervals)), further)


def _real_range(value: Value) -> list[Condition]:
    if value.ranges is None:
        return []
    intervals = tuple(sorted([*value.ranges.intervals, *value.special_intervals]))
    return [Condition(RealWithin(intervals, value.absent_nan), "out_of_range")]


def _parts(device: Device, value: Value) -> list[PartWithin]:
    if not value.flags:
        return []
    return [PartWithin(bit, value.special_intervals) for bit in device.flags[value.flags].bounded]


def _needed(conditions: list[Condition]) -> list[Condition]:
    """The conditions without those that one before them implies."""
    return [
        condition
        for index, condition in enumerate(conditions)
        if not any(_implies(earlier.test, condition.test) for earlier in conditions[:index])
    ]


def _implies(first: Test, second: Test) -> bool:
    """Whether every number that passes one test passes another one."""
    match first, second:
        case RealWithin(), Fits():
            return all(_fits(bound, second.precision) for interval in first.intervals for bound in interval)
    outer, inner = _intervals(second), _intervals(first)
    if outer is None or inner is None:
        return False
    return all(any(low <= first and last <= high for low, high in outer) for first, last in inner)


def _fits(number: float, precision: Precision) -> bool:
    """Whether a finite number does not become infinite in a precision."""
    try:
        real_bits(precision, number)
    except OverflowError:
        return False
    return True


def _intervals(test: Test) -> list[tuple[int, int]] | None:
    """The whole numbers that pass a test; None if the value is not a whole number."""
    match test:
        case Equals():
            return [(test.number, test.number)]
        case IsBit():
            return [(0, 1)]
        case Known():
            return merged([*test.members, *test.sentinels])
        case Within():
            return merged([*test.intervals, *test.sentinels])
        case HasDigits() | HasCharacters() | RealWithin() | PartWithin() | Fits():
            return None
        case _:
            assert_never(test)
