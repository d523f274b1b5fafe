"""The primitive types of values: their names, and the encodings that they stand for."""

from __future__ import annotations

from enum import Enum

from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.encoding import (
    MACHINE_BITS,
    Octets,
    Precision,
    Real,
    Sign,
    Text,
    Truth,
    Whole,
    bounds_of,
    is_array,
    struct_letter,
)


class Kind(Enum):
    """The kind of value that a primitive type encodes."""

    INTEGER = "integer"
    FLOAT = "float"
    BOOLEAN = "boolean"
    TEXT = "text"
    BYTES = "bytes"


@dataclass(frozen=True, slots=True)
class Primitive:
    """A type: its name, and the encoding of its values, with a size of 0 where a length gives it."""

    name: str
    encoding: Whole | Real | Truth | Text | Octets

    @property
    def kind(self) -> Kind:
        """Its kind."""
        match self.encoding:
            case Whole():
                return Kind.INTEGER
            case Real():
                return Kind.FLOAT
            case Truth():
                return Kind.BOOLEAN
            case Text():
                return Kind.TEXT
            case Octets():
                return Kind.BYTES
            case _:
                assert_never(self.encoding)

    @property
    def size(self) -> int:
        """The bytes of its values, 0 where a length gives them."""
        match self.encoding:
            case Whole() | Real() | Truth():
                return self.encoding.bits // 8
            case Text() | Octets():
                return 0
            case _:
                assert_never(self.encoding)

    @property
    def signed(self) -> bool:
        """Whether it has numbers below zero."""
        match self.encoding:
            case Whole():
                return self.encoding.sign.is_signed
            case Real():
                return True
            case Truth() | Text() | Octets():
                return False
            case _:
                assert_never(self.encoding)

    @property
    def letter(self) -> str:
        """Its letter in `struct`, empty for a number that `struct` and the machine do not have."""
        return struct_letter(self.encoding)

    @property
    def is_number(self) -> bool:
        """Whether it is neither a text nor bytes."""
        return not is_array(self.encoding)

    @property
    def is_odd(self) -> bool:
        """Whether it is a whole number of a width that machines do not have: 24, 40, 48 or 56 bits."""
        return self.is_number and 8 * self.size not in MACHINE_BITS

    @property
    def container(self) -> int:
        """The bytes of the narrowest number of a machine that has all its values."""
        return next((bits // 8 for bits in MACHINE_BITS if bits >= 8 * self.size), self.size)

    @property
    def low(self) -> int:
        """The least integer of the type."""
        return bounds_of(self.encoding)[0]

    @property
    def high(self) -> int:
        """The greatest integer of the type; 1 for a boolean."""
        return bounds_of(self.encoding)[1]


PRIMITIVES = {
    primitive.name: primitive
    for primitive in (
        *(
            Primitive(f"{letter}{bits}", Whole(bits, sign))
            for bits in range(8, 65, 8)
            for letter, sign in (("u", Sign.NONE), ("i", Sign.COMPLEMENT))
        ),
        *(Primitive(f"sm{bits}", Whole(bits, Sign.MAGNITUDE)) for bits in range(8, 65, 8)),
        Primitive("f16", Real(Precision.HALF)),
        Primitive("f32", Real(Precision.SINGLE)),
        Primitive("f64", Real(Precision.DOUBLE)),
        Primitive("bool8", Truth(8)),
        Primitive("bool16", Truth(16)),
        Primitive("bit", Truth(8)),
        Primitive("text", Text(0, None)),
        Primitive("bytes", Octets(0)),
    )
}
