"""IEEE 754 numbers of 32 bits and their bits. Conversions between DWORD and REAL mean different things in dialects."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.language.model.primitives import Kind
from fieldspec.targets.controllers.routines.world import World, values_of
from fieldspec.targets.controllers.statements.expressions import (
    BOOL,
    DINT,
    DWORD,
    INT,
    REAL,
    UDINT,
    Conversion,
    Fraction,
    Negation,
    Operation,
    Shift,
    Whole,
    compared,
    either,
    every,
    number,
    plus,
)
from fieldspec.targets.controllers.statements.routine import Assignment, Draft, Loop, Routine, when

_BIAS = 127
_FRACTION_BITS = 23


def real_routines(world: World) -> Iterator[Routine]:
    """The functions that convert between REAL and its 32 bits, where the device has such numbers."""
    if any(value.type.kind is Kind.FLOAT for value in values_of(world.layout)):
        yield _from_bits(world)
        yield _to_bits(world)


def _real(digits: str) -> Fraction:
    return Fraction(digits, REAL)


def _dword(value: int) -> Whole:
    return Whole(value, DWORD)


def _from_bits(world: World) -> Routine:
    draft = Draft(
        world.routine("real_from_bits"),
        "numbers",
        world.status,
        "The number whose 32 bits by IEEE 754 are given. Infinities, and what is no number, are refused.",
    )
    bits = draft.declare("dwBits", DWORD, "input")
    value = draft.declare("rValue", REAL, "output")
    exponent, index = draft.local("iExponent"), draft.local("iAt")
    fraction = draft.local("udiFraction", UDINT)
    field = Operation("AND", (Shift("SHR", bits, _FRACTION_BITS, DWORD), _dword(0xFF)), DWORD)
    draft.add(
        [
            Assignment(value, _real("0.0")),
            Assignment(exponent, Conversion(field, INT)),
            Assignment(fraction, Conversion(Operation("AND", (bits, _dword((1 << _FRACTION_BITS) - 1)), DWORD), UDINT)),
        ]
    )
    draft.refuse(compared(exponent, "=", number(255)), "no_number")
    hidden = Operation("+", (fraction, Whole(1 << _FRACTION_BITS, UDINT)), UDINT)
    zero = compared(exponent, "=", number(0))
    draft.add(
        [
            when(zero, [Assignment(exponent, number(1))], [Assignment(fraction, hidden)]),
            Assignment(value, Conversion(fraction, REAL)),
            Assignment(exponent, plus(exponent, -_BIAS - _FRACTION_BITS)),
            Loop(index, number(1), exponent, (Assignment(value, Operation("*", (value, _real("2.0")), REAL)),)),
            Assignment(exponent, Operation("-", (number(0), exponent), INT)),
            Loop(index, number(1), exponent, (Assignment(value, Operation("/", (value, _real("2.0")), REAL)),)),
            when(
                compared(Operation("AND", (bits, _dword(1 << 31)), DWORD), "<>", _dword(0)),
                [Assignment(value, Operation("-", (_real("0.0"), value), REAL))],
            ),
        ]
    )
    return draft.finished()


def _to_bits(world: World) -> Routine:
    draft = Draft(
        world.routine("bits_from_real"),
        "numbers",
        world.status,
        "The 32 bits of a number by IEEE 754. Infinities, and what is no number, are refused.",
    )
    value = draft.declare("rValue", REAL, "input")
    bits = draft.declare("dwBits", DWORD, "output")
    rest = draft.local("rRest", REAL)
    exponent, index = draft.local("iExponent"), draft.local("iAt")
    fraction = draft.local("diFraction", DINT)
    negative = draft.local("xNegative", BOOL)
    zero = _real("0.0")
    two, unit = _real("2.0"), _real("1.0")
    # Only what is no number is none of these; only an infinity is its own half.
    ordered = either([compared(value, "<", zero), compared(value, "=", zero), compared(value, ">", zero)])
    half = Operation("/", (value, two), REAL)
    draft.add(
        [
            Assignment(bits, _dword(0)),
            Assignment(negative, compared(value, "<", zero)),
            Assignment(rest, value),
            when(negative, [Assignment(rest, Operation("-", (zero, value), REAL))]),
        ]
    )

    draft.refuse(Negation(ordered), "no_number")
    draft.refuse(every([compared(rest, ">", unit), compared(half, "=", value)]), "no_number")
    draft.add([when(compared(rest, "=", zero), [*draft.status.give(draft.result, "ok")])])
    shrink = when(
        compared(rest, ">=", two),
        [Assignment(rest, Operation("/", (rest, two), REAL)), Assignment(exponent, plus(exponent, 1))],
    )
    grow = when(
        every([compared(rest, "<", unit), compared(exponent, ">", number(1))]),
        [Assignment(rest, Operation("*", (rest, two), REAL)), Assignment(exponent, plus(exponent, -1))],
    )
    scaled = Operation("*", (rest, _real("8388608.0")), REAL)
    draft.add(
        [
            Assignment(exponent, number(_BIAS)),
            Loop(index, number(1), number(_BIAS), (shrink,)),
            Loop(index, number(1), number(_BIAS), (grow,)),
            Assignment(fraction, Conversion(scaled, DINT)),
            when(
                compared(fraction, ">=", Whole(1 << _FRACTION_BITS, DINT)),
                [Assignment(fraction, Operation("-", (fraction, Whole(1 << _FRACTION_BITS, DINT)), DINT))],
                [Assignment(exponent, number(0))],
            ),
            Assignment(
                bits,
                Operation(
                    "OR",
                    (Shift("SHL", Conversion(exponent, DWORD), _FRACTION_BITS, DWORD), Conversion(fraction, DWORD)),
                    DWORD,
                ),
            ),
            when(negative, [Assignment(bits, Operation("OR", (bits, _dword(1 << 31)), DWORD))]),
        ]
    )
    return draft.finished()
