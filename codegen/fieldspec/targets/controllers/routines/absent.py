"""States of numbers that are read: functions that tell special values, and numbers out of range, from others."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.accepted import Within, range_conditions
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.language.model.encoding import is_count, is_real
from fieldspec.targets.controllers.routines.quantities import Quantity, by_name, every_value, has_scale
from fieldspec.targets.controllers.routines.stated import is_special, outside_stated
from fieldspec.targets.controllers.routines.world import PREFIXES, World
from fieldspec.targets.controllers.statements.expressions import (
    BOOL,
    REAL,
    Elementary,
    EnumType,
    Expression,
    Type,
    Variable,
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
        kind = _kind(first)
        number = _parameter(kind)
        states = ", ".join(f"{sentinel.text} is {sentinel.name}" for sentinel in first.value.sentinels)
        remark = f"Whether a number of {name} is not a quantity: {states}."
        yield _test(
            world, world.routine(name, "is_absent"), same, number, is_special(first.value, number, kind), remark
        )


def ranged_values(world: World) -> dict[str, list[Quantity]]:
    """The values that may be read out of range, by the names under which they get functions.

    Functions for quantities mark the counts of those that have a scale, and two constants say a single interval.
    """
    return by_name(quantity for quantity in every_value(world.layout) if _has_function(world, quantity))


def _has_function(world: World, quantity: Quantity) -> bool:
    value = quantity.answer
    if value is None or has_scale(value) or not (is_count(value.encoding) or is_single(value.encoding)):
        return False
    match range_conditions(world.layout.device, value, quantity.trigger):
        case ():
            return False
        case (condition,):
            test, kind = condition.test, world.type_of(value)
            is_interval = isinstance(test, Within) and len(test.intervals) == 1 and not test.sentinels
            return not is_interval or isinstance(kind, EnumType) or bool(value.flags)
        case _:
            return True


def range_routines(world: World) -> Iterator[Routine]:
    """`F_METER_NextPointIsOutOfRange`: TRUE for a number that is read and neither stated nor a special value."""
    for name, same in ranged_values(world).items():
        value = same[0].answer
        assert value is not None
        number = _parameter(world.type_of(value))
        test = outside_stated(world, value, same[0].trigger, number)
        remark = f"Whether a number of {name} is out of its range."
        if test is not None:
            yield _test(world, world.routine(name, "is_out_of_range"), same, number, test, remark)


def _parameter(kind: Type) -> Variable:
    is_count_type = isinstance(kind, Elementary) and kind.family in ("signed", "unsigned")
    prefix = PREFIXES[kind.name] if isinstance(kind, Elementary) else "e"
    return Variable(f"{prefix}{'Counts' if is_count_type else 'Value'}", kind)


def _test(
    world: World, function: str, same: list[Quantity], number: Variable, test: Expression, remark: str
) -> Routine:
    owners = ", ".join(dict.fromkeys(quantity.owner for quantity in same if quantity.owner != quantity.name))
    owners_text = f"Of {owners}. " if owners else ""
    facts = f"{owners_text}{world.comment(same[0].fact, None)}".strip()
    body = (Assignment(Variable(function, BOOL), test),)
    return Routine(function, "scaling", BOOL, (Declared(number, "input"),), body, (remark, facts))


def _kind(quantity: Quantity) -> Elementary:
    return REAL if is_real(quantity.value.encoding) else quantity.kind
