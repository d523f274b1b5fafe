"""What self-tests expect of absent values, of those out of range, and of quantities that may be absent or have their
scale elsewhere.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.accepted import passes
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import Digits, Octets, Real, Text, Truth, Whole, bounds_of
from fieldspec.language.model.value import Value
from fieldspec.targets.c.absent import AbsentValue, absent_values
from fieldspec.targets.c.assertions import expect_equal, expect_quantity
from fieldspec.targets.c.expressions import Call, Expression, Identifier, Type
from fieldspec.targets.c.literals import FALSE, TRUE, ZERO, double, whole_double
from fieldspec.targets.c.machine import literal
from fieldspec.targets.c.naming import Naming
from fieldspec.targets.c.quantities import ScaledValue, fixed_values, keeps_counts, scaled_values
from fieldspec.targets.c.sample_values import legal_numbers
from fieldspec.targets.c.statements import CompileIf, Statement, Variable, assign
from fieldspec.targets.c.values import type_name

_GREATEST = 1e38
"""The range of a double on machines where it has 32 bits."""

_WHOLE_FLOATS = 1 << 24
"""Below it, a float has every whole number."""

_RAW, _QUANTITY = Identifier("raw"), Identifier("quantity")


def test_quantities(layout: DeviceLayout, naming: Naming) -> Iterator[list[Statement]]:
    """Each value at its bounds, by the least and the greatest exponent and by 0, and what is refused."""
    for scaled in scaled_values(layout):
        numbers = sorted(set(legal_numbers(layout.device, scaled.value)))
        yield [CompileIf("ifndef", naming.own_macro("without_double"), tuple(_of_value(naming, scaled, numbers)))]


def test_absent(layout: DeviceLayout, naming: Naming) -> Iterator[list[Statement]]:
    """Tests that each sentinel is absent, that its neighbours are not, and that no sentinel becomes a quantity."""
    for absent in absent_values(layout):
        value, function = absent.value, absent.function(naming)
        bounds = sorted({0, *(bound for interval in value.special_intervals for bound in interval)})
        edges = sorted({bound + step for bound in bounds for step in (-1, 0, 1)})
        neighbours = [number for number in edges if value.sentinel(number) is None]
        ends = [(sentinel.name, sentinel.last) for sentinel in value.sentinels if sentinel.last is not None]
        low, high = _neighbour_bounds(value)
        yield [
            *(
                expect_equal(f"{function} {sentinel.name}", Call(function, (constant,)), TRUE)
                for sentinel in value.sentinels
                if (constant := Identifier(absent.constant(naming, sentinel)))
            ),
            *(
                expect_equal(f"{function} {state} {last}", Call(function, (literal(value.encoding, last),)), TRUE)
                for state, last in ends
            ),
            *(
                expect_equal(f"{function} {number}", Call(function, (literal(value.encoding, number),)), FALSE)
                for number in neighbours
                if low <= number <= high
            ),
        ]
    for absent in fixed_values(layout):
        numbers = sorted(set(legal_numbers(layout.device, absent.value)))
        expected = list(_of_fixed(naming, absent, numbers))
        if expected:
            body = (Variable(Type("double"), "quantity", value=whole_double(0)), *expected)
            yield [CompileIf("ifndef", naming.own_macro("without_double"), body)]


def test_out_of_range(device: Device, naming: Naming, ranged: AbsentValue) -> Iterator[list[Statement]]:
    """Tests at the ends of what is stated of a value, and beside them, which numbers are out of range."""
    conditions = ranged.conditions(device)
    if not conditions:
        return
    value, function = ranged.value, ranged.range_function(naming)
    low, high = _neighbour_bounds(value)
    intervals = value.ranges.intervals if value.ranges is not None else ()
    bits = device.flags[value.flags].bounded if value.flags else ()
    ends = {end for interval in (*intervals, *value.special_intervals) for end in interval}
    ends |= {end for bit in bits for interval in bit.images for end in interval}
    numbers = sorted({end + step for end in ends for step in (-1, 0, 1)})
    yield [
        expect_equal(f"{function} {number}", Call(function, (literal(value.encoding, number),)), expected)
        for number in numbers
        if low <= number <= high
        and (expected := FALSE if all(passes(own.test, number) for own in conditions) else TRUE)
    ]


def _of_fixed(naming: Naming, absent: AbsentValue, numbers: list[int]) -> Iterator[Statement]:
    """Each count by its scale and back; a sentinel is refused in both directions."""
    value, names = absent.value, absent.names
    from_raw, to_raw = (naming.function(absent.noun, *names, end) for end in ("from_raw", "to_raw"))
    ok, out_of_range = naming.status("ok"), naming.status("err_out_of_range")
    goes_back = keeps_counts(value.encoding) and not value.offset
    quantities = {number: float(value.in_unit(number)) for number in numbers}
    small = {number: quantity for number, quantity in quantities.items() if abs(quantity) <= _GREATEST}
    if goes_back and small:
        yield Variable(Type(type_name(value)), "raw", value=ZERO)
    for number, expected in small.items():
        description = f"{absent.title} {number}"
        reading = Call(from_raw, (literal(value.encoding, number), _QUANTITY.address()))
        writing = Call(to_raw, (_QUANTITY, _RAW.address()))
        if value.sentinel(number) is not None:
            yield expect_equal(description, reading, out_of_range)
            if goes_back:
                yield assign(_QUANTITY, double(expected))
                yield expect_equal(f"{description} back", writing, out_of_range)
            continue
        yield expect_equal(description, reading, ok)
        yield from expect_quantity(_QUANTITY, expected, description)
        if goes_back:
            yield expect_equal(f"{description} back", writing, ok)
            yield expect_equal(f"{description} back", _RAW, literal(value.encoding, number))


def _of_value(naming: Naming, scaled: ScaledValue, numbers: list[int]) -> Iterator[Statement]:
    name, value, exponent = scaled.title, scaled.value, scaled.exponent
    from_raw, to_raw = scaled.function(naming, "from_raw"), scaled.function(naming, "to_raw")
    ok, out_of_range = naming.status("ok"), naming.status("err_out_of_range")
    ranges = exponent.value.ranges
    assert ranges is not None
    yield Variable(Type(type_name(value)), "raw", value=ZERO)
    yield Variable(Type("double"), "quantity", value=whole_double(0))
    exact = keeps_counts(value.encoding)
    for power in sorted({ranges.intervals[0][0], ranges.intervals[-1][1], 0} & _whole(exponent.value)):
        for number in numbers:
            description, expected = f"{name} {number} by {power}", float(value.scaled_by(power).in_unit(number))
            reading = Call(
                from_raw,
                (literal(value.encoding, number), literal(exponent.value.encoding, power), _QUANTITY.address()),
            )
            if value.sentinel(number) is not None:
                yield expect_equal(description, reading, out_of_range)
                continue
            if abs(expected) > _GREATEST:
                continue
            yield expect_equal(description, reading, ok)
            yield from expect_quantity(_QUANTITY, expected, description)
            if exact:
                arguments = (_QUANTITY, literal(exponent.value.encoding, power), _RAW.address())
                yield expect_equal(f"{description} back", Call(to_raw, arguments), ok)
                yield expect_equal(f"{description} back", _RAW, literal(value.encoding, number))
    excessive = ranges.high + 1
    if excessive <= bounds_of(exponent.value.encoding)[1]:
        refused: tuple[Expression, ...] = (
            whole_double(0),
            literal(exponent.value.encoding, excessive),
            _RAW.address(),
        )
        yield expect_equal(f"{name} by {excessive}", Call(to_raw, refused), out_of_range)
    high = float(value.scaled_by(ranges.low).in_unit(4 * value.high + 4))
    if high < _GREATEST:
        refused = (double(high), literal(exponent.value.encoding, ranges.low), _RAW.address())
        yield expect_equal(f"{name} beyond", Call(to_raw, refused), out_of_range)


def _whole(exponent: Value) -> set[int]:
    """All whole numbers that an exponent may be."""
    intervals = exponent.ranges.intervals if exponent.ranges is not None else ()
    return {number for low, high in intervals for number in range(low, high + 1)}


def _neighbour_bounds(value: Value) -> tuple[int, int]:
    """The bounds of the whole numbers of which C has each one in the type of a value."""
    match value.encoding:
        case Real():
            return 1 - _WHOLE_FLOATS, _WHOLE_FLOATS - 1
        case Whole() | Digits() | Truth() | Text() | Octets():
            return bounds_of(value.encoding)
        case _:
            assert_never(value.encoding)
