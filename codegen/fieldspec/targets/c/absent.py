"""States of values that are read: the constants of special values, and the functions that tell them, and values out of
range, from others.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial

from fieldspec.codec.layout.accepted import Condition, range_conditions
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import RegisterLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import Digits, Octets, Real, Text, Truth, Whole, infinity
from fieldspec.language.model.registers import ParameterSet
from fieldspec.language.model.value import Sentinel, Value
from fieldspec.targets.c.conditions import among_test, refused_number
from fieldspec.targets.c.declarations import Declaration, Define, Function, comment, escape_comment
from fieldspec.targets.c.expressions import VALUE, Expression, Group, Type, all_of, any_of
from fieldspec.targets.c.literals import FALSE, hexadecimal
from fieldspec.targets.c.machine import literal, macro_literal, of_bits, to_bits
from fieldspec.targets.c.naming import Naming, Noun
from fieldspec.targets.c.runtime_files import all_records, is_bit
from fieldspec.targets.c.statements import Return, Variable
from fieldspec.targets.c.values import type_name
from fieldspec.targets.pieces import Run, register_runs


@dataclass(frozen=True, slots=True)
class AbsentValue:
    """A value that may be in a state, the noun under which `Naming` has it, and the words of its names.

    An answer of the device is `answered`; that of a `trigger` is not what was written.
    """

    noun: Noun
    names: tuple[str, ...]
    value: Value
    answered: bool = False
    trigger: bool = False

    @property
    def title(self) -> str:
        """The value in comments: `power`, `module.current`."""
        return ".".join(self.names)

    def conditions(self, device: Device) -> tuple[Condition, ...]:
        """The conditions without which it is out of range."""
        value = self.value.as_answer(self.trigger) if self.answered else self.value
        return range_conditions(device, value, self.trigger)

    def constant(self, naming: Naming, sentinel: Sentinel) -> str:
        """The name of the constant of a sentinel: `GADGET_REG_POWER_ABSENT_NOT_MEASURED`"""
        return naming.macro(self.noun, *self.names, "absent", sentinel.name)

    def function(self, naming: Naming) -> str:
        """The name of the function that tells the sentinels apart: `gadget_reg_power_is_absent`"""
        return naming.function(self.noun, *self.names, "is_absent")

    def range_function(self, naming: Naming) -> str:
        """The name of the function that tells numbers out of range apart: `gadget_reg_power_is_out_of_range`"""
        return naming.function(self.noun, *self.names, "is_out_of_range")


def absent_values(layout: DeviceLayout) -> Iterator[AbsentValue]:
    """All values with sentinels: signals, fields and their cases, registers, parameters."""
    return (value for _, values in _runs(layout, lambda value: bool(value.sentinels)) for value in values())


def ranged_values(layout: DeviceLayout) -> Iterator[Run[AbsentValue]]:
    """All values of which a range is stated, in the same places: they may be out of it where they are read."""
    return _runs(layout, lambda value: value.ranges is not None or bool(value.flags))


def _runs(layout: DeviceLayout, holds: Callable[[Value], bool]) -> Iterator[Run[AbsentValue]]:
    """The values of which something holds."""
    yield (), partial(_of_fields, layout, holds)
    for run, facts in register_runs(layout):
        yield facts, partial(_of_registers, run, holds)
    for parameters in layout.device.parameters.values():
        facts = (parameters, layout.device.enums, layout.device.flags)
        yield facts, partial(_of_parameters, parameters, holds)


def _of_fields(layout: DeviceLayout, holds: Callable[[Value], bool]) -> Iterator[AbsentValue]:
    """Those of signals and of fields of records."""
    for signal in layout.device.signals.values():
        if holds(signal.value):
            yield AbsentValue("signal", (signal.name,), signal.value)
    for record in all_records(layout):
        for field in record.fields:
            if field.value is not None and not field.field.reserved and holds(field.value):
                yield AbsentValue("record", (record.name, field.name), field.value)
            for case in field.cases:
                if holds(case.value):
                    yield AbsentValue("record", (record.name, field.name, case.name), case.value)


def _of_registers(rows: Sequence[RegisterLayout], holds: Callable[[Value], bool]) -> Iterator[AbsentValue]:
    for row in rows:
        if holds(row.register.value) and not is_bit(row) and not row.register.reserved:
            yield AbsentValue("register", (row.name,), row.register.value, True, row.register.trigger)


def _of_parameters(parameters: ParameterSet, holds: Callable[[Value], bool]) -> Iterator[AbsentValue]:
    for parameter in parameters.parameters:
        if parameter.reserved:
            continue
        names = (parameters.name, parameter.name)
        inner_values = [((*names, inner.name), inner.value) for inner in parameter.subindices if not inner.reserved]
        for full_names, value in ((names, parameter.value), *inner_values):
            if holds(value):
                yield AbsentValue("parameter", full_names, value, True, parameter.trigger)


def declare_absent(naming: Naming, absent: AbsentValue) -> list[Declaration]:
    """A constant for each sentinel, and the function that says whether a value is one of them.

    `#define GADGET_REG_POWER_ABSENT_NOT_MEASURED (-32768)`, `bool gadget_reg_power_is_absent(int16_t value)`
    """
    value = absent.value
    states = ", ".join(sentinel.name for sentinel in value.sentinels)
    any_nan = f"Every NaN stands for {_nan_name(value)}." if value.absent_nan else ""
    constants = [
        Define(
            absent.constant(naming, sentinel),
            sentinel_literal(naming, value, sentinel),
            escape_comment(f"{absent.title}: {sentinel.name}. {sentinel.doc}".rstrip()),
        )
        for sentinel in value.sentinels
    ]
    constants += [
        Define(f"{absent.constant(naming, sentinel)}_LAST", macro_literal(value.encoding, sentinel.last))
        for sentinel in value.sentinels
        if sentinel.last is not None
    ]
    return [
        *constants,
        comment(f"Whether {absent.title} is not a quantity: {states}.", any_nan),
        Function(
            Type("bool"),
            absent.function(naming),
            (Variable(Type(type_name(value)), "value"),),
            (Return(_absent_test(naming, value)),),
        ),
    ]


def declare_out_of_range(naming: Naming, device: Device, ranged: AbsentValue) -> list[Declaration]:
    """The function that says whether a value that is read is out of range; none where it cannot be.

    `bool gadget_reg_power_is_out_of_range(int16_t value)`
    """
    value = ranged.value
    conditions = ranged.conditions(device)
    if not conditions:
        return []
    refusals = [refused_number(naming, value.encoding, condition.test, VALUE) for condition in conditions]
    tests = [test for test in refusals if test is not None]
    return [
        comment(f"Whether {ranged.title} is outside of its stated range."),
        Function(
            Type("bool"),
            ranged.range_function(naming),
            (Variable(Type(type_name(value)), "value"),),
            (Return(any_of(list(map(Group, tests)) if len(tests) > 1 else tests) if tests else FALSE),),
        ),
    ]


def _nan_name(value: Value) -> str:
    return next(sentinel.name for sentinel in value.sentinels if sentinel.is_nan)


def sentinel_literal(naming: Naming, value: Value, sentinel: Sentinel) -> Expression:
    """A sentinel as a constant of the type of its value; a NaN by a function, as no constant of C has its bits."""
    if not sentinel.is_nan:
        return macro_literal(value.encoding, sentinel.value)
    return of_bits(naming, value.encoding, hexadecimal(sentinel.value, value.size))


def _absent_test(naming: Naming, value: Value) -> Expression:
    """`value == 65535u`. Floating-point numbers are compared in order, as compilers warn of `==`.

    A NaN is recognized by its bits, because with -ffast-math compilers may remove comparisons with it.
    """
    encoding = value.encoding
    match encoding:
        case Whole() | Digits() | Truth() | Text() | Octets():
            return any_of(among_test(encoding, value.special_intervals, VALUE))
        case Real():
            numbers = [literal(encoding, number) for number, _ in value.special_intervals]
            tests: list[Expression] = [
                Group(all_of([VALUE.at_least(number), VALUE.at_most(number)])) for number in numbers
            ]
        case _:
            assert_never(encoding)
    if value.absent_nan:
        bits, size = to_bits(naming, encoding, VALUE), value.size
        magnitude = Group(bits & hexadecimal((1 << (8 * size - 1)) - 1, size))
        tests.append(magnitude.greater(hexadecimal(infinity(encoding.precision), size)))
    return any_of(tests)
