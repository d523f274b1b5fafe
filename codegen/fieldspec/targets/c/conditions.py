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
from fieldspec.targets.c.expressions import (
    Call,
    Cast,
    Expression,
    Group,
    Operation,
    all_of,
    any_of,
    at_least,
    at_most,
    different,
    equal,
    greater,
    less,
    negate,
)
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
            return different(number, literal(encoding, test.number))
        case IsBit():
            return greater(number, unsigned(1))
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
    cast = Cast(machine(UINT64 if is_wide else INT64).type, number)
    known = negate(Call(naming.function("enum", test.enum, "known"), (cast,)))
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
    return negate(_either(tests))


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
            yield different(number, literal(encoding, interval[0]))
        else:
            yield from map(negate, among_test(encoding, [interval], number))


def _between(
    number: Expression, interval: tuple[int, int], limits: tuple[int, int], constant: Callable[[int], Expression]
) -> Expression | None:
    """`number >= low && number <= high`, without a bound that is a limit; None where no bound is left."""
    low, high = interval
    if low == high:
        return equal(number, constant(low))
    bounds = [at_least(number, constant(low))] if low > limits[0] else []
    bounds += [at_most(number, constant(high))] if high < limits[1] else []
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
        return all_of([Group(any_of([less(number, low), greater(number, high)])) for low, high in pairs])
    return negate(any_of([Group(all_of([at_least(number, low), at_most(number, high)])) for low, high in pairs]))


def _part_outside(encoding: Encoding, test: PartWithin, number: Expression) -> Expression:
    """`!((number & 0x70u) <= 0x50u)`"""
    whole, mask = number_of(encoding), test.bit.mask
    assert whole is not None
    size = whole.bits // 8
    masked: Expression = Group(Operation("&", (number, hexadecimal(mask, size))))
    if test.bit.pieces:
        masked = joined_bits(test.bit, Cast(machine(whole).word, number), machine(whole).word, size)
    parts = [
        _between(masked, image, (0, test.bit.greatest_image), lambda bits: hexadecimal(bits, size))
        for image in test.bit.images
    ]
    refused = negate(_either([part for part in parts if part is not None]))
    return all_of([refused, *_beside(encoding, test.sentinels, number)])


_CAN_OVERFLOW = OfPrecision(half=True, single=False, double=False)


def _overflow(naming: Naming, precision: Precision, number: Expression) -> Expression | None:
    """What holds for a number of C that becomes infinite; None where C has it in the same precision."""
    return Call(naming.own("exceeds_half"), (number,)) if _CAN_OVERFLOW(precision) else None
