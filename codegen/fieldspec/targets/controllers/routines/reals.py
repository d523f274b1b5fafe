"""IEEE 754 numbers of 16 and 32 bits and their bits. Conversions of bits to REAL mean different things in dialects."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.encoding import Precision, Real, significant_bits
from fieldspec.targets.controllers.routines.drafts import Draft
from fieldspec.targets.controllers.routines.world import World, encodings_of, real_words, values_of
from fieldspec.targets.controllers.statements.expressions import (
    BOOL,
    DINT,
    DWORD,
    INT,
    REAL,
    UDINT,
    UINT,
    WORD,
    Elementary,
    Expression,
    Fraction,
    Shift,
    Variable,
    Whole,
    either,
    every,
    number,
)
from fieldspec.targets.controllers.statements.routine import Assignment, Condition, Loop, Routine, Statement, when


def real_routines(world: World) -> Iterator[Routine]:
    """The functions that convert between REAL and its 32 bits, or the 16 of a half, where the device has such numbers.

    Numbers of 64 bits are left out before.
    """
    # A controller makes a REAL of 32 bits that a choice gives by itself, and none of 16.
    singles = {value.encoding for value in values_of(world.layout)}
    for precision, encodings in ((Precision.SINGLE, singles), (Precision.HALF, encodings_of(world.layout))):
        if Real(precision) in encodings:
            yield _from_bits(world, precision)
            yield _to_bits(world, precision)


@dataclass(frozen=True, slots=True)
class _Form:
    """The parts of a number: the type of its bits, that of their number, and the bits of its fraction."""

    bits: Elementary
    unsigned: Elementary
    fraction_name: str
    fraction: int
    exponent: int

    @property
    def bias(self) -> int:
        """The bias of exponents."""
        return (1 << (self.exponent - 1)) - 1

    @property
    def last(self) -> int:
        """The exponent of infinities, and of what is not a number."""
        return (1 << self.exponent) - 1

    @property
    def sign(self) -> Whole:
        """The bit of numbers below zero."""
        return self.literal(1 << (8 * self.bits.size - 1))

    def literal(self, value: int) -> Whole:
        """A bit string."""
        return Whole(value, self.bits)


def _form(precision: Precision) -> _Form:
    fraction = significant_bits(precision) - 1
    exponent = precision.value - 1 - fraction
    match precision:
        case Precision.HALF:
            return _Form(WORD, UINT, "uiFraction", fraction, exponent)
        case Precision.SINGLE:
            return _Form(DWORD, UDINT, "udiFraction", fraction, exponent)
        case Precision.DOUBLE:
            raise AssertionError("functions do not convert numbers of 64 bits")
        case _:
            assert_never(precision)


def outside_precision(precision: Precision, value: Expression) -> Expression | None:
    """Whether a number of a REAL becomes infinite in a precision; None where none does."""
    match precision:
        case Precision.HALF:
            # The greatest number is 65504, and what is at least half a step greater is rounded to the next one.
            return either([value.compared(">=", _real("65520.0")), value.compared("<=", _real("-65520.0"))])
        case Precision.SINGLE | Precision.DOUBLE:
            return None
        case _:
            assert_never(precision)


def _real(digits: str) -> Fraction:
    return Fraction(digits, REAL)


def _from_bits(world: World, precision: Precision) -> Routine:
    form = _form(precision)
    words, bits_name = real_words(precision)
    draft = Draft(
        world,
        world.routine("real_from", *words),
        "numbers",
        f"The number whose {precision.value} bits by IEEE 754 are given. Infinities, and what is not a number, are"
        " refused.",
    )
    bits = draft.declare(bits_name, form.bits, "input")
    value = draft.declare("rValue", REAL, "output")
    exponent, index = draft.local("iExponent"), draft.local("iAt")
    fraction = draft.local(form.fraction_name, form.unsigned)
    mask = form.literal((1 << form.fraction) - 1)
    field = Shift("SHR", bits, form.fraction, form.bits).combined("AND", form.literal(form.last))
    draft.add(
        [
            Assignment(value, _real("0.0")),
            Assignment(exponent, field.converted(INT)),
            Assignment(fraction, bits.combined("AND", mask).converted(form.unsigned)),
        ]
    )
    draft.refuse(exponent.compared("=", form.last), "no_number")
    hidden = fraction.combined("+", 1 << form.fraction)
    zero = exponent.compared("=", 0)
    draft.add(
        [
            when(zero, [Assignment(exponent, number(1))], [Assignment(fraction, hidden)]),
            Assignment(value, fraction.converted(REAL)),
            Assignment(exponent, exponent.plus(-form.bias - form.fraction)),
            Loop(index, number(1), exponent, (Assignment(value, value.combined("*", _real("2.0"))),)),
            Assignment(exponent, number(0).combined("-", exponent)),
            Loop(index, number(1), exponent, (Assignment(value, value.combined("/", _real("2.0"))),)),
            when(
                bits.combined("AND", form.sign).compared("<>", form.literal(0)),
                [Assignment(value, _real("0.0").combined("-", value))],
            ),
        ]
    )
    return draft.finished()


def _to_bits(world: World, precision: Precision) -> Routine:
    form = _form(precision)
    words, bits_name = real_words(precision)
    exceeding = outside_precision(precision, Variable("rValue", REAL))
    rounded = "" if exceeding is None else "rounded to the nearest, of two to the even one. "
    draft = Draft(
        world,
        world.routine(*words, "from_real"),
        "numbers",
        f"The {precision.value} bits of a number by IEEE 754{', ' * bool(rounded)}{rounded or '. '}"
        "Infinities, and what is not a number, are refused.",
    )
    value = draft.declare("rValue", REAL, "input")
    bits = draft.declare(bits_name, form.bits, "output")
    rest = draft.local("rRest", REAL)
    exponent, index = draft.local("iExponent"), draft.local("iAt")
    fraction = draft.local("diFraction", DINT)
    negative = draft.local("xNegative", BOOL)
    zero = _real("0.0")
    two, unit = _real("2.0"), _real("1.0")
    # Only what is not a number is none of these; only an infinity is its own half.
    ordered = either([value.compared("<", zero), value.compared("=", zero), value.compared(">", zero)])
    half = value.combined("/", two)
    draft.add(
        [
            Assignment(bits, form.literal(0)),
            Assignment(negative, value.compared("<", zero)),
            Assignment(rest, value),
            when(negative, [Assignment(rest, zero.combined("-", value))]),
        ]
    )

    draft.refuse(ordered.negated(), "no_number")
    draft.refuse(every([rest.compared(">", unit), half.compared("=", value)]), "no_number")
    if exceeding is not None:
        draft.refuse(exceeding, "out_of_range")
    draft.add([when(rest.compared("=", zero), [*draft.status.give(draft.result, "ok")])])
    shrink = when(
        rest.compared(">=", two),
        [Assignment(rest, rest.combined("/", two)), Assignment(exponent, exponent.plus(1))],
    )
    grow = when(
        every([rest.compared("<", unit), exponent.compared(">", 1)]),
        [Assignment(rest, rest.combined("*", two)), Assignment(exponent, exponent.plus(-1))],
    )
    scaled = rest.combined("*", _real(f"{1 << form.fraction}.0"))
    hidden = Whole(1 << form.fraction, DINT)
    draft.add(
        [
            Assignment(exponent, number(form.bias)),
            Loop(index, number(1), number(form.bias), (shrink,)),
            Loop(index, number(1), number(form.bias), (grow,)),
            *([] if exceeding is None else [Assignment(rest, scaled)]),
            Assignment(fraction, (scaled if exceeding is None else rest).converted(DINT)),
            *([] if exceeding is None else _to_nearest(draft, rest, fraction, exponent, hidden)),
            when(
                fraction.compared(">=", hidden),
                [Assignment(fraction, fraction.combined("-", hidden))],
                [Assignment(exponent, number(0))],
            ),
            Assignment(
                bits,
                Shift("SHL", exponent.converted(form.bits), form.fraction, form.bits).combined(
                    "OR", fraction.converted(form.bits)
                ),
            ),
            when(negative, [Assignment(bits, bits.combined("OR", form.sign))]),
        ]
    )
    return draft.finished()


def _to_nearest(
    draft: Draft, exact: Variable, fraction: Variable, exponent: Variable, hidden: Whole
) -> list[Statement]:
    """The statements that round a fraction, however the dialect converts, and carry into the exponent."""
    rest = draft.local("rFraction", REAL)
    odd = fraction.combined("MOD", 2).compared("<>", 0)
    half, less = _real("0.5"), _real("-0.5")
    up = either([rest.compared(">", half), every([rest.compared("=", half), odd])])
    down = either([rest.compared("<", less), every([rest.compared("=", less), odd])])
    unit, full = Whole(1, DINT), Whole(2 * hidden.value, DINT)
    carried: list[Statement] = [Assignment(fraction, hidden), Assignment(exponent, exponent.plus(1))]
    return [
        Assignment(rest, exact.combined("-", fraction.converted(REAL))),
        Condition(
            (
                (up, (Assignment(fraction, fraction.combined("+", unit)),)),
                (down, (Assignment(fraction, fraction.combined("-", unit)),)),
            )
        ),
        when(fraction.compared("=", full), carried),
    ]
