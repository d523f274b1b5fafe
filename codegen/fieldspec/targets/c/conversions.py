"""Conversions between counts and physical quantities, in double."""

from __future__ import annotations

from collections.abc import Callable

from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import Encoding, bounds_of
from fieldspec.language.model.value import Conversion
from fieldspec.targets.c.declarations import BLANK, Declaration, Function, comment, describe_fact
from fieldspec.targets.c.expressions import Expression, Group, Identifier, Operation, Type, all_of, any_of
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
    share: Expression = RAW.cast("double") / whole_double(conversion.full_scale)
    if conversion.complement:
        share = whole_double(1) - share
    return [
        describe_fact(conversion, *paragraphs),
        Function(
            _DOUBLE,
            naming.function("conversion", conversion.name, "from_raw"),
            (Variable(kind, "raw"), Variable(_DOUBLE, "reference")),
            (Return(_REFERENCE * Group(share)),),
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
    share: Expression = _QUANTITY / _REFERENCE
    if conversion.complement:
        share = Group(whole_double(1) - share)
    usable = any_of([_REFERENCE.less(whole_double(0)), _REFERENCE.greater(whole_double(0))])
    unrounded = (
        *refuse(naming, usable.negated(), "err_out_of_range"),
        assign(COUNT, share * whole_double(conversion.full_scale)),
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
    lower_test = COUNT.at_least(whole_double(low)) if -low > 2**52 else COUNT.greater(_half(2 * low - 1))
    upper_test = COUNT.less(whole_double(high + 1)) if high > 2**52 else COUNT.less(_half(2 * high + 1))
    odd = (_WHOLE % two).differs(zero)
    above = any_of([_REST.greater(double(0.5)), Group(all_of([_REST.at_least(double(0.5)), odd]))])
    below = any_of([_REST.less(double(-0.5)), Group(all_of([_REST.at_most(double(-0.5)), odd]))])
    round_down = If(below, (assign(_WHOLE, (_WHOLE - unit).cast(name)),))
    return (
        Variables(_DOUBLE, ("count", "rest")),
        Variable(Type(name), "whole"),
        *unrounded,
        *refuse(naming, all_of([lower_test, upper_test]).negated(), "err_out_of_range"),
        assign(_WHOLE, COUNT.cast(name)),
        assign(_REST, COUNT - _WHOLE.cast("double")),
        If(above, (assign(_WHOLE, (_WHOLE + unit).cast(name)),), (round_down,) if is_signed else ()),
        *refusals(_WHOLE),
        assign(RAW.dereferenced(), _WHOLE),
        return_ok(naming),
    )


def _half(doubled: int) -> Operation:
    """`32767.0 / 2.0`"""
    return whole_double(doubled) / whole_double(2)
