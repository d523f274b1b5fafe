"""Scales and offsets as macros."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction

from fieldspec.targets.c.declarations import Declaration, Define
from fieldspec.targets.c.literals import INT64, integer
from fieldspec.targets.c.naming import Naming, Noun

_GREATEST_FRACTION = 2**63 - 1


def define_fractions(
    naming: Naming, noun: Noun, names: tuple[str, ...], scale: Decimal | Fraction, offset: Decimal
) -> list[Declaration]:
    """`#define GADGET_REG_SPEED_SCALE_NUMERATOR INT64_C(1)`: a scale and an offset as fractions, where they matter."""
    constants: list[Declaration] = []
    for name, exact, implied in (("scale", scale, 1), ("offset", offset, 0)):
        if exact == implied:
            continue
        fraction = Fraction(exact)
        if max(abs(fraction.numerator), fraction.denominator) <= _GREATEST_FRACTION:
            for part, number in (("numerator", fraction.numerator), ("denominator", fraction.denominator)):
                constants.append(Define(naming.macro(noun, *names, f"{name}_{part}"), integer(number, INT64)))
    return constants
