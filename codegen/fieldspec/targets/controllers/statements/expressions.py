"""Typed expressions."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TypeAlias

from fieldspec.foundation.classes import dataclass


@dataclass(frozen=True, slots=True)
class Elementary:
    """A type that the language has. `family` is bits, unsigned, signed, real or truth; `size` is in bytes."""

    name: str
    family: str
    size: int

    @property
    def low(self) -> int:
        """The least whole number that it holds."""
        return -(1 << (8 * self.size - 1)) if self.family == "signed" else 0

    @property
    def high(self) -> int:
        """The greatest whole number that it holds."""
        return 1 if self.family == "truth" else (1 << (8 * self.size - (self.family == "signed"))) - 1


@dataclass(frozen=True, slots=True)
class EnumType:
    """An enum as the type of a variable, by its name, with the type of its numbers."""

    name: str
    base: Elementary


@dataclass(frozen=True, slots=True)
class StructType:
    """A struct as the type of a variable, by its name; with `is_block`, a function block, whose instance it is."""

    name: str
    is_block: bool = False


@dataclass(frozen=True, slots=True)
class ArrayType:
    """Elements that are numbered from `low` to `high`, both included."""

    low: int
    high: int
    of: Type


Type: TypeAlias = Elementary | EnumType | StructType | ArrayType

BOOL = Elementary("BOOL", "truth", 1)
BYTE, WORD, DWORD, LWORD = (Elementary(n, "bits", s) for n, s in (("BYTE", 1), ("WORD", 2), ("DWORD", 4), ("LWORD", 8)))
USINT, UINT, UDINT, ULINT = (
    Elementary(n, "unsigned", s) for n, s in (("USINT", 1), ("UINT", 2), ("UDINT", 4), ("ULINT", 8))
)
SINT, INT, DINT, LINT = (Elementary(n, "signed", s) for n, s in (("SINT", 1), ("INT", 2), ("DINT", 4), ("LINT", 8)))
TIME = Elementary("TIME", "time", 4)
TIMER = StructType("TON")
REAL, LREAL = Elementary("REAL", "real", 4), Elementary("LREAL", "real", 8)

ELEMENTARY = {
    elementary.name: elementary
    for elementary in (
        *(BOOL, BYTE, WORD, DWORD, LWORD, USINT, UINT, UDINT, ULINT, SINT, INT, DINT, LINT, REAL, LREAL),
    )
}
BITS = {1: BYTE, 2: WORD, 3: DWORD, 4: DWORD, 5: LWORD, 6: LWORD, 7: LWORD, 8: LWORD}
UNSIGNED = {1: USINT, 2: UINT, 3: UDINT, 4: UDINT, 5: ULINT, 6: ULINT, 7: ULINT, 8: ULINT}
SIGNED = {1: SINT, 2: INT, 3: DINT, 4: DINT, 5: LINT, 6: LINT, 7: LINT, 8: LINT}
"""The narrowest types with all numbers of some bytes."""


def sequence(count: int, element: Type) -> ArrayType:
    """An array of some elements, the first one numbered 0."""
    return ArrayType(0, count - 1, element)


def innermost(kind: Type) -> Type:
    """The type of the elements of an array, or of arrays of arrays."""
    while isinstance(kind, ArrayType):
        kind = kind.of
    return kind


class Expression:
    """An expression with a type; numbers that it is combined or compared with are of this type."""

    __slots__ = ()
    type: Type

    def converted(self, to: Elementary) -> Expression:
        """The value in a type, itself where it has that type already."""
        return self if self.type == to else Conversion(self, to)

    def combined(self, operator: str, right: Expression | int) -> Operation:
        """The value and another one, joined by an operator."""
        return Operation(operator, (self, self._operand(right)), self.type)

    def compared(self, operator: str, right: Expression | int) -> Operation:
        """A comparison. Raises ValueError for an expression and itself, since the outcome is known."""
        other = self._operand(right)
        if self == other:
            raise ValueError(f"{self} is compared with itself")
        return Operation(operator, (self, other), BOOL)

    def negated(self) -> Negation:
        """NOT of a truth."""
        return Negation(self)

    def plus(self, increment: int) -> Expression:
        """The sum of an index and a number; two numbers are added here."""
        if isinstance(self, Whole):
            return number(self.value + increment)
        if increment < 0:
            return self.combined("-", -increment)
        return self.combined("+", increment) if increment else self

    def element(self, index: Expression | int) -> Element:
        """An element of an array."""
        assert isinstance(self.type, ArrayType)
        return Element(self, number(index) if isinstance(index, int) else index, self.type.of)

    def _operand(self, right: Expression | int) -> Expression:
        if not isinstance(right, int):
            return right
        assert isinstance(self.type, Elementary)
        return Whole(right, self.type)


@dataclass(frozen=True, slots=True)
class Whole(Expression):
    """A whole number. Where `hexadecimal`, the manual or the algorithm knows it in that form.

    One with a `name` is a constant of the routine that has it.
    """

    value: int
    type: Elementary
    hexadecimal: bool = False
    name: str = ""


@dataclass(frozen=True, slots=True)
class Fraction(Expression):
    """A decimal number, exactly as its digits say."""

    digits: str
    type: Elementary = LREAL


@dataclass(frozen=True, slots=True)
class Truth(Expression):
    """The literal TRUE or FALSE."""

    value: bool
    type: Elementary = BOOL


@dataclass(frozen=True, slots=True)
class Variable(Expression):
    """A parameter or a local variable of the routine, or, within it, what it returns."""

    name: str
    type: Type


@dataclass(frozen=True, slots=True)
class EnumMemberExpression(Expression):
    """A member of a declared enum."""

    member: str
    value: int
    type: EnumType


@dataclass(frozen=True, slots=True)
class Member(Expression):
    """A member of a struct."""

    of: Expression
    name: str
    type: Type


class Output(Member):
    """An output of a block, by the variable that is its instance."""

    __slots__ = ()


@dataclass(frozen=True, slots=True)
class Element(Expression):
    """An element of an array."""

    of: Expression
    index: Expression
    type: Type


@dataclass(frozen=True, slots=True)
class Operation(Expression):
    """Operands joined by one operator: + - * / MOD AND OR XOR = <> < <= > >="""

    operator: str
    operands: tuple[Expression, ...]
    type: Type


@dataclass(frozen=True, slots=True)
class Negation(Expression):
    """NOT of a truth."""

    of: Expression
    type: Elementary = BOOL


@dataclass(frozen=True, slots=True)
class Shift(Expression):
    """Bits moved to the left (SHL) or to the right (SHR); zeros come in."""

    direction: str
    of: Expression
    bits: int
    type: Type


@dataclass(frozen=True, slots=True)
class Conversion(Expression):
    """A value in another elementary type, by the function that is named after both."""

    of: Expression
    type: Elementary


@dataclass(frozen=True, slots=True)
class Call(Expression):
    """A call of a routine with inputs (and variables that it changes), and the targets of its outputs."""

    routine: str
    inputs: tuple[tuple[str, Expression], ...]
    outputs: tuple[tuple[str, Expression], ...]
    type: Type


def number(value: int) -> Whole:
    """A whole number as a literal of INT: an index, a length or an offset."""
    return Whole(value, INT)


def every(tests: Iterable[Expression]) -> Expression:
    """Whether all of some tests hold."""
    operands = tuple(tests)
    return operands[0] if len(operands) == 1 else Operation("AND", operands, BOOL)


def either(tests: Iterable[Expression]) -> Expression:
    """Whether one of some tests holds."""
    operands = tuple(tests)
    return operands[0] if len(operands) == 1 else Operation("OR", operands, BOOL)


def within(tested: Expression, intervals: Iterable[tuple[int, int]]) -> Expression | None:
    """Whether a number lies in one of some intervals; None where every number of its type does.

    Bounds that equal the type's limits are left out: compilers warn of comparisons that always hold.
    """
    kind = tested.type
    assert isinstance(kind, Elementary)
    tests: list[Expression] = []
    for low, high in sorted(intervals):
        if low == high:
            tests.append(tested.compared("=", low))
            continue
        bounds: list[Expression] = []
        if low > kind.low:
            bounds.append(tested.compared(">=", low))
        if high < kind.high:
            bounds.append(tested.compared("<=", high))
        if not bounds:
            return None
        tests.append(every(bounds))
    return either(tests)


def outside(tested: Expression, intervals: Iterable[tuple[int, int]]) -> Expression | None:
    """Whether a whole number lies in none of some intervals; None where every number of its type lies in one."""
    bounds = sorted(intervals)
    is_within, kind = within(tested, bounds), tested.type
    if is_within is None or len(bounds) > 1:
        return None if is_within is None else is_within.negated()
    assert isinstance(kind, Elementary)
    (low, high) = bounds[0]
    if low == high:
        return tested.compared("<>", low)
    tests = [tested.compared("<", low)] if low > kind.low else []
    return either([*tests, *([tested.compared(">", high)] if high < kind.high else [])])


def joined(parts: Iterable[tuple[Expression, int]], size: int) -> Expression:
    """Parts of a number, each moved to its place, as one number of `size` bytes."""
    wide = BITS[size]
    moved = [Shift("SHL", p.converted(wide), bits, wide) if bits else p.converted(wide) for p, bits in parts]
    return moved[0] if len(moved) == 1 else Operation("OR", tuple(moved), wide)


def part(bit_string: Expression, bits: int, to: Elementary) -> Expression:
    """The part of a bit string that begins `bits` above its least significant bit."""
    return (Shift("SHR", bit_string, bits, bit_string.type) if bits else bit_string).converted(to)
