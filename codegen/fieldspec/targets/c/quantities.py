"""Conversions of counts to quantities and back, in double: of values whose scale is elsewhere, or with sentinels."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.exponents import ExponentLayout, exponent_of
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.encoding import Encoding, bounds_of, is_count, number_of
from fieldspec.language.model.ranges import Ranges
from fieldspec.language.model.value import Value
from fieldspec.targets.c.absent import AbsentValue, absent_values
from fieldspec.targets.c.conditions import among_test, out_of_range_test
from fieldspec.targets.c.conversions import COUNT, RAW, count_of_share
from fieldspec.targets.c.declarations import BLANK, Comment, Declaration, Function, comment
from fieldspec.targets.c.expressions import Call, Expression, Group, Identifier, Type, all_of, any_of
from fieldspec.targets.c.literals import whole_double
from fieldspec.targets.c.machine import literal
from fieldspec.targets.c.naming import Naming, Noun
from fieldspec.targets.c.statements import Body, Variable, assign
from fieldspec.targets.c.values import refuse, return_ok, status_type, type_name

_DOUBLE = Type("double")
_QUANTITY, _EXPONENT = Identifier("quantity"), Identifier("exponent")

_EXACT_BITS = 48
"""A double has 53 bits, of which a conversion there and back may lose one or two: a count of 56 bits is rounded."""


def keeps_counts(encoding: Encoding) -> bool:
    """Whether a count becomes a quantity and the same count again."""
    whole = number_of(encoding)
    return whole is not None and whole.bits <= _EXACT_BITS


@dataclass(frozen=True, slots=True)
class ScaledValue:
    """A value whose exponent is in another field or register, with the noun and the words of its names."""

    noun: Noun
    names: tuple[str, ...]
    value: Value
    exponent: ExponentLayout

    @property
    def title(self) -> str:
        """The value in comments: `power`, `module.current`."""
        return ".".join(self.names)

    def function(self, naming: Naming, end: str) -> str:
        """The name of the function `from_raw` or `to_raw`."""
        return naming.function(self.noun, *self.names, end)


def scaled_values(layout: DeviceLayout) -> list[ScaledValue]:
    """The registers and the fields whose scale is read from the device."""
    records = [*layout.records.values(), *(body for message in layout.messages.values() for body in message.bodies)]
    return [
        *(
            ScaledValue("register", (row.name,), row.register.value, exponent)
            for row in layout.registers
            if (exponent := exponent_of(row.register.value, layout.registers)) is not None
        ),
        *(
            ScaledValue("record", (record.name, field.name), field.value, exponent)
            for record in records
            for field in record.fields
            if field.value is not None and (exponent := exponent_of(field.value, layout.registers, record)) is not None
        ),
    ]


def declare_quantity(naming: Naming, scaled: ScaledValue) -> list[Declaration]:
    """The functions from the count of a value to its quantity and back, by the exponent.

    `codec_status reg_power_from_raw(int16_t raw, int16_t exponent, double *quantity)`, `reg_power_to_raw(...)`
    """
    value, exponent = scaled.value, scaled.exponent
    signed_exponent = _EXPONENT.cast("int32_t")
    unit = f", in {value.quantity_unit}" if value.quantity_unit else ""
    valid = refuse(
        naming, Group(_is_in(exponent.value, exponent.value.ranges, _EXPONENT)).negated(), "err_out_of_range"
    )
    text = comment(
        f"{scaled.title} = raw * 10^{exponent.name}{unit}; refused for a count that stands for an absent value,",
        f"and for an exponent that {exponent.name} may not have.",
    )
    return _both_ways(
        naming,
        value,
        lambda word: scaled.function(naming, word),
        (text, "for such a count or exponent"),
        Call(naming.own("times_power"), (RAW.cast("double"), signed_exponent)),
        Call(naming.own("over_power"), (_QUANTITY, signed_exponent)),
        (Variable(Type(type_name(exponent.value)), "exponent"),),
        valid,
    )


def _both_ways(
    naming: Naming,
    value: Value,
    function: Callable[[str], str],
    texts: tuple[Comment, str],
    quantity: Expression,
    count: Expression,
    parameters: tuple[Variable, ...] = (),
    valid: Body = (),
) -> list[Declaration]:
    """The functions from the count of a value to its quantity and back, with further parameters that are `valid`.

    They are named by `function`. `texts` are the comment of the first, and what the second refuses besides.
    """
    kind, ranges = type_name(value), _writable(value)
    return [
        texts[0],
        Function(
            status_type(naming),
            function("from_raw"),
            (Variable(Type(kind), "raw"), *parameters, Variable(Type("double", pointer=True), "quantity")),
            (
                *valid,
                *_refuse_absent(naming, value, RAW),
                assign(_QUANTITY.dereferenced(), quantity),
                return_ok(naming),
            ),
        ),
        BLANK,
        comment(
            "The count of a quantity, the nearest one, of two equally near ones the even one; refused where it",
            f"is not in {ranges.text()}, and {texts[1]}.",
        ),
        Function(
            status_type(naming),
            function("to_raw"),
            (Variable(_DOUBLE, "quantity"), *parameters, Variable(Type(kind, pointer=True), "raw")),
            count_of_share(
                naming,
                value.encoding,
                (ranges.low, ranges.high),
                (*valid, assign(COUNT, count)),
                lambda whole: (*_refuse_gaps(naming, value, whole), *_refuse_absent(naming, value, whole)),
            ),
        ),
    ]


def fixed_values(layout: DeviceLayout) -> list[AbsentValue]:
    """The values with sentinels whose counts have a fixed scale."""
    return [
        absent
        for absent in absent_values(layout)
        if is_count(absent.value.encoding)
        and absent.value.scaled
        and not (absent.value.scale_by or absent.value.enum or absent.value.flags or absent.value.const is not None)
    ]


def declare_fixed_quantity(naming: Naming, absent: AbsentValue) -> list[Declaration]:
    """The functions from the count of a value with sentinels to its quantity and back.

    `codec_status reg_voltage_from_raw(int16_t raw, double *quantity)`, `reg_voltage_to_raw(...)`
    """
    value = absent.value
    scale, offset = Fraction(value.scale), Fraction(value.offset)
    unit = f", in {value.quantity_unit}" if value.quantity_unit else ""
    text = comment(f"{absent.title} as a quantity{unit}; refused for a count that stands for {_states(value)}.")
    return _both_ways(
        naming,
        value,
        lambda word: naming.function(absent.noun, *absent.names, word),
        (text, f"where it stands for {_states(value)}"),
        _plus(_times(RAW.cast("double"), scale), offset),
        _times(_QUANTITY if not offset else Group(_plus(_QUANTITY, -offset)), 1 / scale),
    )


def _states(value: Value) -> str:
    return " or ".join(sentinel.name for sentinel in value.sentinels)


def _times(number: Expression, ratio: Fraction) -> Expression:
    """`number * 3.0 / 7.0`: by whole numbers, which rounds less than by a decimal factor."""
    product = number if ratio.numerator == 1 else number * whole_double(ratio.numerator)
    return product if ratio.denominator == 1 else product / whole_double(ratio.denominator)


def _plus(number: Expression, addend: Fraction) -> Expression:
    """`number + 1.0 / 2.0`"""
    if not addend:
        return number
    whole = whole_double(abs(addend.numerator))
    term = whole if addend.denominator == 1 else whole / whole_double(addend.denominator)
    return number + term if addend > 0 else number - term


def _writable(value: Value) -> Ranges:
    return value.writable_ranges or Ranges(((value.low, value.high),))


def _is_in(value: Value, ranges: Ranges | None, number: Expression) -> Expression:
    """The test whether a number is in ranges that are narrower than its type."""
    encoding, tests = value.encoding, []
    for low, high in ranges.intervals if ranges is not None else ():
        bounds = [number.at_least(literal(encoding, low))] if low > 0 or bounds_of(encoding)[0] < 0 else []
        tests.append(Group(all_of([*bounds, number.at_most(literal(encoding, high))])))
    return any_of(tests)


def _refuse_gaps(naming: Naming, value: Value, number: Expression) -> Body:
    """Refuses a number between the intervals of a range; the ends of the whole range are tested before."""
    ranges = value.writable_ranges
    test = out_of_range_test(value, number) if ranges is not None and len(ranges.intervals) > 1 else None
    return refuse(naming, test, "err_out_of_range") if test is not None else ()


def _refuse_absent(naming: Naming, value: Value, number: Expression) -> Body:
    """Refuses the numbers that stand for an absent value."""
    encoding = value.encoding
    tests = among_test(encoding, value.special_intervals, number)
    return refuse(naming, any_of(tests), "err_out_of_range") if tests else ()
