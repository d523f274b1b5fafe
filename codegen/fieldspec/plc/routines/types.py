"""The types of expressions and variables."""

from __future__ import annotations

from typing import TypeAlias

from fieldspec.classes import dataclass


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
    """A declared enum and the type of its numbers."""

    name: str
    base: Elementary


@dataclass(frozen=True, slots=True)
class StructType:
    """A declared struct."""

    name: str


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
REAL, LREAL = Elementary("REAL", "real", 4), Elementary("LREAL", "real", 8)

ELEMENTARY = {
    one.name: one
    for one in (*(BOOL, BYTE, WORD, DWORD, LWORD, USINT, UINT, UDINT, ULINT, SINT, INT, DINT, LINT, REAL, LREAL),)
}
BITS = {1: BYTE, 2: WORD, 4: DWORD, 8: LWORD}
UNSIGNED = {1: USINT, 2: UINT, 4: UDINT, 8: ULINT}
SIGNED = {1: SINT, 2: INT, 4: DINT, 8: LINT}


def sequence(count: int, of: Type) -> ArrayType:
    """An array of some elements, the first one numbered 0."""
    return ArrayType(0, count - 1, of)


def innermost(kind: Type) -> Type:
    """The type of the elements of an array, or of arrays of arrays."""
    while isinstance(kind, ArrayType):
        kind = kind.of
    return kind
