"""What self-tests expect of quantities whose scale is read from the device."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.backends.c.assertions import expect, expect_equal
from fieldspec.backends.c.expressions import (
    ZERO,
    Call,
    Expression,
    Identifier,
    Type,
    address_of,
    at_least,
    at_most,
    double,
    integer,
    whole_double,
)
from fieldspec.backends.c.naming import Naming
from fieldspec.backends.c.quantities import EXACT_BYTES, ScaledValue, scaled_values
from fieldspec.backends.c.sample_values import legal_numbers
from fieldspec.backends.c.statements import CompileIf, Statement, Variable
from fieldspec.backends.c.values import type_name
from fieldspec.layout.device import DeviceLayout
from fieldspec.model.value import Value

_GREATEST = 1e38
"""What a double can be on machines where it has 32 bits."""

_RAW, _QUANTITY = Identifier("raw"), Identifier("quantity")


def test_quantities(layout: DeviceLayout, naming: Naming) -> Iterator[list[Statement]]:
    """Each value at its bounds, by the least and the greatest exponent and by 0, and what is refused."""
    for scaled in scaled_values(layout):
        numbers = sorted(set(legal_numbers(layout.device, scaled.value)))
        yield [CompileIf("ifndef", naming.own_macro("without_double"), tuple(_of_value(naming, scaled, numbers)))]


def _of_value(naming: Naming, scaled: ScaledValue, numbers: list[int]) -> Iterator[Statement]:
    name, value, exponent = scaled.title, scaled.value, scaled.exponent
    from_raw, to_raw = scaled.function(naming, "from_raw"), scaled.function(naming, "to_raw")
    ok, out_of_range = naming.status("ok"), naming.status("err_out_of_range")
    ranges = exponent.value.ranges
    assert ranges is not None
    yield Variable(Type(type_name(value)), "raw", value=ZERO)
    yield Variable(Type("double"), "quantity", value=whole_double(0))
    exact = value.type.size <= EXACT_BYTES
    for power in sorted({ranges.intervals[0][0], ranges.intervals[-1][1], 0} & _whole(exponent.value)):
        for number in numbers:
            what, wanted = f"{name} {number} by {power}", float(value.scaled_by(power).in_unit(number))
            reading = Call(from_raw, (_literal(value, number), _literal(exponent.value, power), address_of(_QUANTITY)))
            if value.sentinel(number) is not None:
                yield expect_equal(what, reading, out_of_range)
                continue
            if abs(wanted) > _GREATEST:
                continue
            near = abs(wanted) * 1e-12
            yield expect_equal(what, reading, ok)
            yield expect(at_least(_QUANTITY, double(wanted - near)), what)
            yield expect(at_most(_QUANTITY, double(wanted + near)), what)
            if exact:
                arguments = (_QUANTITY, _literal(exponent.value, power), address_of(_RAW))
                yield expect_equal(f"{what} back", Call(to_raw, arguments), ok)
                yield expect_equal(f"{what} back", _RAW, _literal(value, number))
    beyond = ranges.high + 1
    if beyond <= exponent.value.type.high:
        refused: tuple[Expression, ...] = (whole_double(0), _literal(exponent.value, beyond), address_of(_RAW))
        yield expect_equal(f"{name} by {beyond}", Call(to_raw, refused), out_of_range)
    high = float(value.scaled_by(ranges.low).in_unit(4 * value.high + 4))
    if high < _GREATEST:
        refused = (double(high), _literal(exponent.value, ranges.low), address_of(_RAW))
        yield expect_equal(f"{name} beyond", Call(to_raw, refused), out_of_range)


def _whole(exponent: Value) -> set[int]:
    """All exponents of a range."""
    intervals = exponent.ranges.intervals if exponent.ranges is not None else ()
    return {number for low, high in intervals for number in range(low, high + 1)}


def _literal(value: Value, number: int) -> Expression:
    return integer(number, value.type.container, value.type.signed)
