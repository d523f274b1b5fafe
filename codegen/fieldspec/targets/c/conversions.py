"""Conversions between counts and physical quantities, in double."""

from __future__ import annotations

from collections.abc import Callable

from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import Encoding, bounds_of
from fieldspec.language.model.value import Conversion
from fieldspec.targets.c.declarations import BLANK, Declaration, Function, comment, describe_fact
from fieldspec.targets.c.expressions import (
    Cast,
    Expression,
    Group,
    Identifier,
    Operation,
    Type,
    add,
    all_of,
    any_of,
    at_least,
    at_most,
    dereference,
    different,
    greater,
    less,
    multiply,
    negate,
    subtract,
)
from fieldspec.targets.c.literals import double, whole_double
from fieldspec.targets.c.machine import literal, machine
from fieldspec.targets.c.naming import Naming
from fieldspec.targets.c.statements import Body, If, Return, Variable, Variables, assign
from fieldspec.targets.c.values import refuse, return_ok, status_type

_DOUBLE = Type("double")
RAW, _REFERENCE, _QUANTITY = Identifier("raw"), Identifier("reference"), Identifier("quantity")
COUNT, _REST, _WHOLE = Identifier("count"), Identifier("rest"), Identifier("whole")


def count_type(conversion: Conversion) -> str:
    """The type of a conversion's counts."""
    return machine(conversion.type.encoding).type


def count_bounds(device: Device, conversion: Conversion) -> tuple[int, int]:
    """The least and the greatest count that a signal of a conversion may have."""
    minimum, maximum = bounds_of(conversion.type.encoding)
    ranges = [device.signals[name].value.ranges for name in conversion.signals]
    known = [intervals for intervals in ranges if intervals is not None]
    if not known or len(known) < len(ranges):
        return minimum, maximum
    low, high = min(intervals.low for intervals in known), max(intervals.high for intervals in known)
    return max(minimum, low), min(maximum, high)


def declare_conversion(naming: Naming, device: Device, conversion: Conversion) -> list[Declaration]:
    """The functions from a count to a quantity and back."""
    full_scale = f"{conversion.full_scale}.0"
    formula = f"reference * (1 - raw / {full_scale})" if conversion.complement else f"reference * raw / {full_scale}"
    paragraphs = [
        f"{conversion.title or conversion.name} = {formula}",
        f"Printed: {conversion.printed}" if conversion.printed else "",
        f"Signals: {', '.join(conversion.signals)}." if conversion.signals else "",
        f"Reference: {', '.join(conversion.references)}." if conversion.references else "",
    ]
    low, high = count_bounds(device, conversion)
    kind = Type(count_type(conversion))
    share: Expression = Operation("/", (Cast("double", RAW), whole_double(conversion.full_scale)))
    if conversion.complement:
        share = subtract(whole_double(1), share)
    return [
        describe_fact(conversion, *paragraphs),
        Function(
            _DOUBLE,
            naming.function("conversion", conversion.name, "from_raw"),
            (Variable(kind, "raw"), Variable(_DOUBLE, "reference")),
            (Return(multiply(_REFERENCE, Group(share))),),
        ),
        BLANK,
        comment(
            "The count of a quantity, the nearest one, of two equally near ones the even one;",
            f"refused where it is not in {low}..{high}, and where the reference is 0.",
        ),
        Function(
            status_type(naming),
            naming.function("conversion", conversion.name, "to_raw"),
            (
                Variable(_DOUBLE, "quantity"),
                Variable(_DOUBLE, "reference"),
                Variable(Type(kind.name, pointer=True), "raw"),
            ),
            _count_of_quantity(naming, conversion, low, high),
        ),
    ]


def _count_of_quantity(naming: Naming, conversion: Conversion, low: int, high: int) -> Body:
    """`count = quantity / reference * 16384.0;`, checked and then rounded to the nearest even count."""
    share: Expression = Operation("/", (_QUANTITY, _REFERENCE))
    if conversion.complement:
        share = Group(subtract(whole_double(1), share))
    usable = any_of([less(_REFERENCE, whole_double(0)), greater(_REFERENCE, whole_double(0))])
    unrounded = (
        *refuse(naming, negate(usable), "err_out_of_range"),
        assign(COUNT, multiply(share, whole_double(conversion.full_scale))),
    )
    return count_of_share(naming, conversion.type.encoding, (low, high), unrounded)


def count_of_share(
    naming: Naming,
    encoding: Encoding,
    bounds: tuple[int, int],
    unrounded: Body,
    refusals: Callable[[Expression], Body] = lambda _: (),
) -> Body:
    """Statements that set `raw` to the whole number next to `count`, which `unrounded` sets, or refuse it.

    It is between two `bounds`; `refusals` are the statements that refuse other whole numbers.
    """
    low, high = bounds
    name, is_signed = machine(encoding).type, bounds_of(encoding)[0] < 0
    zero, unit, two = (literal(encoding, number) for number in (0, 1, 2))
    # Beyond 53 bits a double has no halves: there the bound itself is the last number that fits.
    lower_test = at_least(COUNT, whole_double(low)) if -low > 2**52 else greater(COUNT, _half(2 * low - 1))
    upper_test = less(COUNT, whole_double(high + 1)) if high > 2**52 else less(COUNT, _half(2 * high + 1))
    odd = different(Operation("%", (_WHOLE, two)), zero)
    above = any_of([greater(_REST, double(0.5)), Group(all_of([at_least(_REST, double(0.5)), odd]))])
    below = any_of([less(_REST, double(-0.5)), Group(all_of([at_most(_REST, double(-0.5)), odd]))])
    round_down = If(below, (assign(_WHOLE, Cast(name, subtract(_WHOLE, unit))),))
    return (
        Variables(_DOUBLE, ("count", "rest")),
        Variable(Type(name), "whole"),
        *unrounded,
        *refuse(naming, negate(all_of([lower_test, upper_test])), "err_out_of_range"),
        assign(_WHOLE, Cast(name, COUNT)),
        assign(_REST, subtract(COUNT, Cast("double", _WHOLE))),
        If(above, (assign(_WHOLE, Cast(name, add(_WHOLE, unit))),), (round_down,) if is_signed else ()),
        *refusals(_WHOLE),
        assign(dereference(RAW), _WHOLE),
        return_ok(naming),
    )


def _half(doubled: int) -> Operation:
    """`32767.0 / 2.0`"""
    return Operation("/", (whole_double(doubled), whole_double(2)))
