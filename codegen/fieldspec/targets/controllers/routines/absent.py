"""Whether a number stands for a state and is not a quantity: a function for each kind of quantity with sentinels."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.language.model.encoding import is_count, is_real
from fieldspec.language.model.ranges import merged
from fieldspec.targets.controllers.routines.scaling import Quantity, by_name, every_value
from fieldspec.targets.controllers.routines.world import PREFIXES, World
from fieldspec.targets.controllers.statements.expressions import (
    BOOL,
    REAL,
    Elementary,
    Expression,
    Fraction,
    Variable,
    Whole,
    compared,
    either,
    every,
)
from fieldspec.targets.controllers.statements.numbers import is_single
from fieldspec.targets.controllers.statements.routine import Assignment, Declared, Routine


def absent_values(layout: DeviceLayout) -> dict[str, list[Quantity]]:
    """The quantities with sentinels, by the names under which they get functions; those that share one are together."""
    return by_name(quantity for quantity in every_value(layout) if _states(quantity))


def _states(quantity: Quantity) -> bool:
    """Whether a value is a quantity with sentinels. A number without unit and scale is compared with the constants."""
    value = quantity.value
    if is_single(value.encoding):
        return bool(value.sentinels) and not value.absent_nan
    return is_count(value.encoding) and bool(value.sentinels) and (value.scaled or bool(value.unit))


def absent_routines(world: World) -> Iterator[Routine]:
    """`F_METER_VoltageIsAbsent`: TRUE for a number that stands for a state."""
    for name, same in absent_values(world.layout).items():
        first = same[0]
        function = world.routine(name, "is_absent")
        kind = _kind(first)
        number = Variable(f"{PREFIXES[kind.name]}{'Value' if kind is REAL else 'Counts'}", kind)
        owners = ", ".join(dict.fromkeys(quantity.owner for quantity in same if quantity.owner != quantity.name))
        states = ", ".join(f"{sentinel.text} is {sentinel.name}" for sentinel in first.value.sentinels)
        owners_text = f"Of {owners}. " if owners else ""
        yield Routine(
            function,
            "scaling",
            BOOL,
            (Declared(number, "input"),),
            (Assignment(Variable(function, BOOL), _test(first, number, kind)),),
            (
                f"Whether a number of {name} is not a quantity: {states}.",
                f"{owners_text}{world.comment(first.fact, None)}".strip(),
            ),
        )


def _kind(quantity: Quantity) -> Elementary:
    return REAL if is_real(quantity.value.encoding) else quantity.kind


def _test(quantity: Quantity, number: Expression, kind: Elementary) -> Expression:
    """Whether a number is one of the sentinels. Not every controller has a literal of the least number of a type."""
    sentinels = quantity.value.sentinels
    if kind is REAL:
        literals = [Fraction(f"{sentinel.value}.0", REAL) for sentinel in sentinels]
        return either(
            [every([compared(number, ">=", literal), compared(number, "<=", literal)]) for literal in literals]
        )
    return either(
        [
            every([compared(number, ">=", Whole(low, kind)), compared(number, "<=", Whole(high, kind))])
            if kind.low < low < high < kind.high
            else compared(number, ">=", Whole(low, kind))
            if kind.low < low < high
            else compared(number, "=", Whole(low, kind))
            if low == high and not low == kind.low < 0
            else compared(number, "<", Whole(high + 1, kind))
            for low, high in merged(quantity.value.special_intervals)
        ]
    )
