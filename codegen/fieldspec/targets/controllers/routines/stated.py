"""Tests of what a spec states of a number: special values, the range of a value, the ranges of parts of a word."""

from __future__ import annotations

from collections.abc import Iterator

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
    range_conditions,
)
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.enums import Bit
from fieldspec.language.model.ranges import bound_text, merged
from fieldspec.language.model.value import Value
from fieldspec.targets.controllers.routines.named_numbers import image_of
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.statements.expressions import (
    BITS,
    REAL,
    UNSIGNED,
    Elementary,
    EnumMemberExpression,
    EnumType,
    Expression,
    Fraction,
    either,
    every,
    outside,
)
from fieldspec.targets.controllers.statements.numbers import whole_type


def outside_stated(world: World, value: Value, trigger: bool, tested: Expression) -> Expression | None:
    """Whether a number that is read is out of range; None where none is, as for a `trigger`."""
    conditions = range_conditions(world.layout.device, value, trigger)
    tests = [test for condition in conditions for test in _outside(world, value, condition.test, tested)]
    return either(tests) if tests else None


def _outside(world: World, value: Value, test: Test, tested: Expression) -> Iterator[Expression]:
    match test:
        case Within():
            intervals = [*test.intervals, *test.sentinels]
            if isinstance(tested.type, EnumType):
                yield from _members_outside(world, value, tested.type, intervals, tested)
                return
            kind = whole_type(value.encoding)
            wrong = outside(tested.converted(kind), intervals)
            if wrong is not None:
                yield wrong
        case RealWithin():
            yield outside_real(value, tested)
        case PartWithin():
            wrong = outside_part(test.bit, value.size, tested)
            if wrong is not None:
                kind = whole_type(value.encoding)
                special = outside(tested.converted(kind), test.sentinels) if test.sentinels else None
                yield wrong if special is None else every([special, wrong])
        case Equals() | IsBit() | HasDigits() | HasCharacters() | Known() | Fits():
            return  # readers refuse what does not pass
        case _:
            assert_never(test)


def _members_outside(
    world: World, value: Value, kind: EnumType, intervals: list[tuple[int, int]], tested: Expression
) -> Iterator[Expression]:
    """Whether a variable is one of the members that lie in none of some intervals."""
    names = world.names.enum_members[value.enum]
    for member in world.layout.device.enums[value.enum].members:
        if not any(low <= member.value <= high for low, high in intervals):
            yield tested.compared("=", EnumMemberExpression(names[member.name], member.value, kind))


def outside_part(bit: Bit, size: int, tested: Expression) -> Expression | None:
    """Whether the bits of a part of a word of `size` bytes are out of their range; None where they cannot be."""
    bits, kind = BITS[size], UNSIGNED[size]
    return outside(image_of(bit, tested.converted(bits), bits).converted(kind), bit.images)


def outside_real(value: Value, tested: Expression) -> Expression:
    """Whether a floating-point number is neither in range nor a sentinel."""
    pairs = list(value.ranges.intervals) if value.ranges is not None else []
    pairs += value.special_intervals
    intervals = [
        every([tested.compared(">=", Fraction(_real(low), REAL)), tested.compared("<=", Fraction(_real(high), REAL))])
        for low, high in sorted(pairs)
    ]
    return either(intervals).negated()


def _real(bound: float) -> str:
    """The text of a bound with a decimal point."""
    return f"{bound}.0" if isinstance(bound, int) else bound_text(bound)


def is_special(value: Value, number: Expression, kind: Elementary) -> Expression:
    """Whether a number is one of the sentinels. Not every controller has a literal of the least number of a type."""
    sentinels = value.sentinels
    if kind is REAL:
        literals = [Fraction(f"{sentinel.value}.0", REAL) for sentinel in sentinels]
        return either([every([number.compared(">=", literal), number.compared("<=", literal)]) for literal in literals])
    return either(
        [
            every([number.compared(">=", low), number.compared("<=", high)])
            if kind.low < low < high < kind.high
            else number.compared(">=", low)
            if kind.low < low < high
            else number.compared("=", low)
            if low == high and not low == kind.low < 0
            else number.compared("<", high + 1)
            for low, high in merged(value.special_intervals)
        ]
    )
