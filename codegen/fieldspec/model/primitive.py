"""The types that a value may have on the wire."""

from __future__ import annotations

from enum import Enum

from fieldspec.classes import dataclass


class Kind(Enum):
    """What a primitive holds."""

    INTEGER = "integer"
    FLOAT = "float"
    BOOLEAN = "boolean"
    TEXT = "text"
    BYTES = "bytes"


@dataclass(frozen=True, slots=True)
class Primitive:
    """A type: its name, its width in bytes (0 where a length says it), and the letter that `struct` gives it."""

    name: str
    kind: Kind
    size: int
    signed: bool = False
    letter: str = ""

    @property
    def low(self) -> int:
        """The least integer that it holds."""
        return -(1 << (8 * self.size - 1)) if self.signed else 0

    @property
    def high(self) -> int:
        """The greatest integer that it holds; 1 for a boolean."""
        if self.kind is Kind.BOOLEAN:
            return 1
        return (1 << (8 * self.size - self.signed)) - 1


PRIMITIVES = {
    primitive.name: primitive
    for primitive in (
        Primitive("u8", Kind.INTEGER, 1, False, "B"),
        Primitive("i8", Kind.INTEGER, 1, True, "b"),
        Primitive("u16", Kind.INTEGER, 2, False, "H"),
        Primitive("i16", Kind.INTEGER, 2, True, "h"),
        Primitive("u32", Kind.INTEGER, 4, False, "I"),
        Primitive("i32", Kind.INTEGER, 4, True, "i"),
        Primitive("u64", Kind.INTEGER, 8, False, "Q"),
        Primitive("i64", Kind.INTEGER, 8, True, "q"),
        Primitive("f32", Kind.FLOAT, 4, True, "f"),
        Primitive("bool8", Kind.BOOLEAN, 1, False, "B"),
        Primitive("bool16", Kind.BOOLEAN, 2, False, "H"),
        Primitive("text", Kind.TEXT, 0, False, "s"),
        Primitive("bytes", Kind.BYTES, 0, False, "s"),
    )
}
