"""Address spaces: their addresses, the unit at one address, and the numbers that the manual prints."""

from __future__ import annotations

from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.source import SourceFile, Span
from fieldspec.language.model.fact import Fact, Place
from fieldspec.language.model.ranges import Ranges

WORD = "word"
"""The unit of the spaces of registers and tables."""

BYTE = "byte"
"""The unit of the control tables of bus servos and other memories of bytes."""

BIT = "bit"
"""The unit of the spaces of coils and discrete inputs, and the type of the registers there."""

WHOLE = Ranges(((0, 0xFFFF),))
"""The addresses of a space without stated bounds: all 16 bit numbers."""

LEAST_OF_FIVE_DIGITS = 10000
"""Manuals that number registers with five digits print the space in the first one, and count from 1 in the others."""


@dataclass(frozen=True, slots=True, kw_only=True)
class AddressSpace(Fact):
    """Addresses that have their own messages for reading and writing.

    `unit` is the unit at one address: `word`, `byte` or `bit`. `first_number` is the number that the manual prints for
    address 0.
    """

    title: str
    unit: str
    bounds: Ranges
    first_number: int

    @property
    def unit_size(self) -> int:
        """The bytes of a value at one address: 2 in words, and 1 in bytes. A bit counts as a word."""
        return 1 if self.unit == BYTE else 2

    def address_of(self, number: int) -> int | None:
        """The address for which the manual prints a number, such as 40003; None for numbers that may be addresses.

        Where the bounds are not stated, numbers of five or six digits, such as 40001 and 400001, are not addresses.
        """
        address = number - self.first_number
        return address if self.has_numbers_apart and address in self.bounds else None

    @property
    def has_numbers_apart(self) -> bool:
        """Whether no number that the manual prints may be an address."""
        digits = self.bounds == WHOLE and self.first_number > LEAST_OF_FIVE_DIGITS
        return digits or self.bounds.high < self.first_number


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
"""The space of a device that declares none."""
