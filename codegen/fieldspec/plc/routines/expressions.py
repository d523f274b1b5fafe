"""Expressions: frozen trees, each of which knows its type. Nothing is converted unless a node says so."""

from __future__ import annotations

from collections.abc import Iterable
from functools import reduce
from typing import TypeAlias

from fieldspec.classes import dataclass
from fieldspec.plc.routines.types import BITS, BOOL, INT, LREAL, Elementary, EnumType, Type


@dataclass(frozen=True, slots=True)
class Whole:
    """A whole number. Where `hexadecimal`, the manual or the algorithm knows it in that form."""

    value: int
    type: Elementary
    hexadecimal: bool = False


@dataclass(frozen=True, slots=True)
class Fraction:
    """A decimal number, exactly as its digits say."""

    digits: str
    type: Elementary = LREAL


@dataclass(frozen=True, slots=True)
class Truth:
    """TRUE or FALSE."""

    value: bool
    type: Elementary = BOOL


@dataclass(frozen=True, slots=True)
class Variable:
    """A parameter or a local variable of the routine, or, within it, what it returns."""

    name: str
    type: Type


@dataclass(frozen=True, slots=True)
class Listed:
    """A member of a declared enum."""

    member: str
    value: int
    type: EnumType


@dataclass(frozen=True, slots=True)
class Member:
    """A member of a struct."""

    of: Expression
    name: str
    type: Type


@dataclass(frozen=True, slots=True)
class Element:
    """An element of an array."""

    of: Expression
    index: Expression
    type: Type


@dataclass(frozen=True, slots=True)
class Operation:
    """Operands joined by one operator: + - * / MOD AND OR XOR = <> < <= > >="""

    operator: str
    operands: tuple[Expression, ...]
    type: Type


@dataclass(frozen=True, slots=True)
class Negation:
    """NOT of a truth."""

    of: Expression
    type: Elementary = BOOL


@dataclass(frozen=True, slots=True)
class Shift:
    """Bits moved to the left (SHL) or to the right (SHR); zeros come in."""

    direction: str
    of: Expression
    bits: int
    type: Type


@dataclass(frozen=True, slots=True)
class Conversion:
    """A value in another elementary type, by the function that is named after both."""

    of: Expression
    type: Elementary


@dataclass(frozen=True, slots=True)
class Call:
    """What a routine returns for inputs (and variables that it changes), and where it puts its outputs."""

    routine: str
    inputs: tuple[tuple[str, Expression], ...]
    outputs: tuple[tuple[str, Expression], ...]
    type: Type


Expression: TypeAlias = (
    Whole | Fraction | Truth | Variable | Listed | Member | Element | Operation | Negation | Shift | Conversion | Call
)


def number(value: int) -> Whole:
    """An index, a length or an offset."""
    return Whole(value, INT)


def converted(of: Expression, to: Elementary) -> Expression:
    """A value in a type, itself where it has that type already."""
    return of if of.type == to else Conversion(of, to)


def plus(of: Expression, more: int) -> Expression:
    """A sum of an index and a number; two numbers are added here."""
    if isinstance(of, Whole):
        return Whole(of.value + more, INT)
    if more < 0:
        return Operation("-", (of, number(-more)), INT)
    return Operation("+", (of, number(more)), INT) if more else of


def compared(left: Expression, operator: str, right: Expression) -> Operation:
    """A comparison."""
    return Operation(operator, (left, right), BOOL)


def every(tests: Iterable[Expression]) -> Expression:
    """Whether all of some tests hold."""
    found = tuple(tests)
    return found[0] if len(found) == 1 else Operation("AND", found, BOOL)


def either(tests: Iterable[Expression]) -> Expression:
    """Whether one of some tests holds."""
    found = tuple(tests)
    return found[0] if len(found) == 1 else Operation("OR", found, BOOL)


def within(of: Expression, intervals: Iterable[tuple[int, int]], kind: Elementary) -> Expression | None:
    """Whether a number lies in one of some intervals; None where every number of its type does.

    Bounds that are those of the type are left out: compilers warn of comparisons that always hold.
    """
    tests: list[Expression] = []
    for low, high in sorted(intervals):
        if low == high:
            tests.append(compared(of, "=", Whole(low, kind)))
            continue
        bounds: list[Expression] = []
        if low > kind.low:
            bounds.append(compared(of, ">=", Whole(low, kind)))
        if high < kind.high:
            bounds.append(compared(of, "<=", Whole(high, kind)))
        if not bounds:
            return None
        tests.append(every(bounds))
    return either(tests)


def outside(of: Expression, intervals: Iterable[tuple[int, int]], kind: Elementary) -> Expression | None:
    """Whether a whole number lies in none of some intervals; None where every number of its type lies in one."""
    found = sorted(intervals)
    inside = within(of, found, kind)
    if inside is None or len(found) > 1:
        return None if inside is None else Negation(inside)
    (low, high) = found[0]
    if low == high:
        return compared(of, "<>", Whole(low, kind))
    tests = [compared(of, "<", Whole(low, kind))] if low > kind.low else []
    return either([*tests, *([compared(of, ">", Whole(high, kind))] if high < kind.high else [])])


def joined(parts: Iterable[tuple[Expression, int]], size: int) -> Expression:
    """Parts of a number, each moved to its place, as one number of `size` bytes."""
    wide = BITS[size]
    moved = [Shift("SHL", converted(p, wide), bits, wide) if bits else converted(p, wide) for p, bits in parts]
    return moved[0] if len(moved) == 1 else Operation("OR", tuple(moved), wide)


def part(of: Expression, bits: int, to: Elementary) -> Expression:
    """The part of a bit string that begins `bits` above its least significant bit."""
    return converted(Shift("SHR", of, bits, of.type) if bits else of, to)


def added(terms: Iterable[Expression], kind: Elementary) -> Expression:
    """A sum."""
    return reduce(lambda left, right: Operation("+", (left, right), kind), terms)
