"""Address spaces: which addresses there are, what one of them holds, and how the manual numbers them."""

from __future__ import annotations

from fieldspec.classes import dataclass
from fieldspec.model.fact import Fact, Place
from fieldspec.model.value import Ranges
from fieldspec.source import SourceFile, Span

WORD = "word"
"""The unit of spaces in which registers and tables lie."""

WHOLE = Ranges(((0, 0xFFFF),))
"""The addresses of a space of which the spec says nothing: all that 16 bits carry."""


@dataclass(frozen=True, slots=True, kw_only=True)
class AddressSpace(Fact):
    """Addresses that messages of their own read and write.

    `unit` is what one address holds: `word`, `byte` or `bit`. `first_number` is the number that the manual prints for
    the address 0.
    """

    title: str
    unit: str
    bounds: Ranges
    first_number: int


WORDS = AddressSpace(
    name="",
    place=Place("", Span(SourceFile("", ""), 0, 0), {}),
    inferred={},
    standard={},
    allowed={},
    title="Registers",
    unit=WORD,
    bounds=WHOLE,
    first_number=0,
)
"""The one space of a device that declares none."""
