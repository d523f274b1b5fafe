"""The accepted numbers of values, as C conditions that hold for rejected numbers."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from fieldspec.codec.layout.accepted import (
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
    writable_numbers,
)
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.encoding import (
    Digits,
    Encoding,
    Octets,
    OfPrecision,
    Precision,
    Real,
    Text,
    Truth,
    Whole,
    number_of,
)
from fieldspec.language.model.value import Value
from fieldspec.targets.c.expressions import Call, Expression, Group, Operation, all_of, any_of
from fieldspec.targets.c.flags import joined_bits
from fieldspec.targets.c.literals import INT64, TRUE, UINT64, hexadecimal, real, unsigned
from fieldspec.targets.c.machine import literal, machine, machine_whole
from fieldspec.targets.c.naming import Naming


def refused_number(naming: Naming, encoding: Encoding, test: Test, number: Expression) -> Expression | None:
    """What holds for a number that a test refuses; None where the type of C has no such number.

    Raises AssertionError for a test of bytes.
    """
    match test:
        case Equals():
            return number.differs(literal(encoding, test.number))
        case IsBit():
            return number.greater(unsigned(1))
        case Known():
            return _unknown(naming, encoding, test, number)
        case Within():
            return _outside(encoding, test, number)
        case RealWithin():
            return _real_outside(encoding, test, number)
        case PartWithin():
            return _part_outside(encoding, test, number)
        case Fits():
            return _overflow(naming, test.precision, number)
        case HasDigits() | HasCharacters():
            raise AssertionError("a test of bytes and not of a number")
        case _:
            assert_never(test)


def out_of_range_test(value: Value, number: Expression) -> Expression | None:
    """`!(value >= 1u && value <= 12u)`: whether a whole number may not be written; None where all may be."""
    return _outside(value.encoding, writable_numbers(value), number)


def _unknown(naming: Naming, encoding: Encoding, test: Known, number: Expression) -> Expression:
    """`!stop_mode_known((int64_t)value)`"""
    is_wide = any(high > INT64.bounds[1] for _, high in test.members)
    cast = number.cast(machine(UINT64 if is_wide else INT64).type)
    known = Call(naming.function("enum", test.enum, "known"), (cast,)).negated()
    return all_of([known, *_beside(encoding, test.sentinels, number)])


def _outside(encoding: Encoding, test: Within, number: Expression) -> Expression | None:
    """`!(value >= 1u && value <= 12u)`, without the bounds that the type of C has: compilers warn of such tests."""
    whole = number_of(encoding)
    assert whole is not None
    tests: list[Expression] = []
    for interval in (*test.intervals, *test.sentinels):
        bounds = _between(number, interval, machine_whole(whole).bounds, lambda bound: literal(encoding, bound))
        if bounds is None:
            return None
        tests.append(bounds)
    return _either(tests).negated()


def among_test(encoding: Encoding, intervals: Iterable[tuple[int, int]], number: Expression) -> list[Expression]:
    """The tests of which one holds for a whole number in some intervals: `value == 3u`, `(value >= 5u && value <= 9u)`

    An interval has all numbers of the type of C only where the test is `true`.
    """
    whole = number_of(encoding)
    assert whole is not None
    limits = machine_whole(whole).bounds
    tests = [_between(number, interval, limits, lambda bound: literal(encoding, bound)) for interval in intervals]
    return [Group(test) if isinstance(test, Operation) and test.operator == "&&" else test or TRUE for test in tests]


def _beside(encoding: Encoding, intervals: Iterable[tuple[int, int]], number: Expression) -> Iterator[Expression]:
    """The tests that all hold for a whole number in none of some intervals: `value != 3u`, `!(value >= 5u)`"""
    for interval in intervals:
        if interval[0] == interval[1]:
            yield number.differs(literal(encoding, interval[0]))
        else:
            yield from (test.negated() for test in among_test(encoding, [interval], number))


def _between(
    number: Expression, interval: tuple[int, int], limits: tuple[int, int], constant: Callable[[int], Expression]
) -> Expression | None:
    """`number >= low && number <= high`, without a bound that is a limit; None where no bound is left."""
    low, high = interval
    if low == high:
        return number.equals(constant(low))
    bounds = [number.at_least(constant(low))] if low > limits[0] else []
    bounds += [number.at_most(constant(high))] if high < limits[1] else []
    return all_of(bounds) if bounds else None


def _either(tests: list[Expression]) -> Expression:
    return tests[0] if len(tests) == 1 else any_of([Group(test) for test in tests])


def _real_outside(encoding: Encoding, test: RealWithin, number: Expression) -> Expression:
    """`!(value >= -5.0f && value <= 5.0f)`, of which a NaN is out of range, as no comparison holds of it.

    Where a NaN is taken: `(value < -5.0f || value > 5.0f)`, in which none is.
    """
    match encoding:
        case Real():
            pairs = [(real(low, encoding.precision), real(high, encoding.precision)) for low, high in test.intervals]
        case Whole() | Truth() | Digits() | Text() | Octets():
            raise AssertionError("no real number")
        case _:
            assert_never(encoding)
    if test.takes_nan:
        return all_of([Group(any_of([number.less(low), number.greater(high)])) for low, high in pairs])
    return any_of([Group(all_of([number.at_least(low), number.at_most(high)])) for low, high in pairs]).negated()


def _part_outside(encoding: Encoding, test: PartWithin, number: Expression) -> Expression:
    """`!((number & 0x70u) <= 0x50u)`"""
    whole, mask = number_of(encoding), test.bit.mask
    assert whole is not None
    size = whole.bits // 8
    masked: Expression = Group(number & hexadecimal(mask, size))
    if test.bit.pieces:
        masked = joined_bits(test.bit, number.cast(machine(whole).word), machine(whole).word, size)
    parts = [
        _between(masked, image, (0, test.bit.greatest_image), lambda bits: hexadecimal(bits, size))
        for image in test.bit.images
    ]
    refused = _either([part for part in parts if part is not None]).negated()
    return all_of([refused, *_beside(encoding, test.sentinels, number)])


_CAN_OVERFLOW = OfPrecision(half=True, single=False, double=False)


def _overflow(naming: Naming, precision: Precision, number: Expression) -> Expression | None:
    """What holds for a number of C that becomes infinite; None where C has it in the same precision."""
    return Call(naming.own("exceeds_half"), (number,)) if _CAN_OVERFLOW(precision) else None
