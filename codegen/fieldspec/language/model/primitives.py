"""The primitive types of values: their names, and the encodings that they stand for."""

from __future__ import annotations

from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.encoding import (
    Octets,
    Precision,
    Real,
    Sign,
    Text,
    Truth,
    Whole,
    bounds_of,
    is_array,
)


@dataclass(frozen=True, slots=True)
class Primitive:
    """A type: its name, and the encoding of its values, with a size of 0 where a length gives it."""

    name: str
    encoding: Whole | Real | Truth | Text | Octets

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
    def is_number(self) -> bool:
        """Whether it is neither a text nor bytes."""
        return not is_array(self.encoding)

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
