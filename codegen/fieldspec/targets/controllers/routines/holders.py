"""Where values lie: bytes, or words whose numbers a fieldbus or a serial driver has put together already."""

from __future__ import annotations

from collections.abc import Iterable
from typing import ClassVar, TypeAlias

from fieldspec.foundation.classes import dataclass, replace
from fieldspec.targets.controllers.statements.expressions import BYTE, WORD, Expression, Whole, joined, part
from fieldspec.targets.controllers.statements.routine import Assignment, Statement
from fieldspec.targets.controllers.structs import places


@dataclass(frozen=True, slots=True)
class Bytes:
    """An array of bytes, the index of one of them, and the offset of a record after it.

    `unit` is the number of bytes in an element.
    """

    unit: ClassVar[int] = 1
    array: Expression
    first: Expression
    start: int = 0

    def behind(self, offset: int) -> Bytes:
        """The same array from some bytes further on: the offset is added to that of the record."""
        return replace(self, start=self.start + offset)

    def moved(self, first: Expression) -> Bytes:
        """The same array with a record that begins at another index."""
        return Bytes(self.array, first)

    def index(self) -> Expression:
        """The index of the element where the record begins, None where that is within an element."""
        return self.first.plus(self.start)

    def byte(self, offset: int) -> Expression:
        """The byte at an offset in the record."""
        return self.array.element(self.first.plus(self.start + offset))

    def byte_stored(self, offset: int, byte: Expression) -> Statement:
        """The statement that stores a byte at an offset in the record."""
        return Assignment(self.byte(offset), byte)

    def number(self, offset: int, size: int, order: str, swapped: bool) -> Expression:
        """The bit string of a number of `size` bytes at an offset in the record."""
        parts = [(self.byte(offset + index), bits) for index, bits in enumerate(places(size, order, swapped))]
        return joined(_highest_first(parts), size)

    def stored(self, offset: int, size: int, order: str, swapped: bool, bits: Expression) -> list[Statement]:
        """The statements that store a bit string at an offset; `bits` is a variable or a literal."""
        steps = enumerate(places(size, order, swapped))
        return [self.byte_stored(offset + index, _part(bits, moved, 1)) for index, moved in steps]


@dataclass(frozen=True, slots=True)
class Words:
    """An array of words, an index and an offset as of bytes; `order` is the order of a word's bytes on the wire."""

    unit: ClassVar[int] = 2
    array: Expression
    first: Expression
    order: str
    start: int = 0

    def behind(self, offset: int) -> Words:
        """The same array from some bytes further on: the offset is added to that of the record."""
        return replace(self, start=self.start + offset)

    def moved(self, first: Expression) -> Words:
        """The same array with a record that begins at another index."""
        return Words(self.array, first, self.order)

    def index(self) -> Expression | None:
        """The index of the element where the record begins, None where that is within an element."""
        return None if self.start % 2 else self.first.plus(self.start // 2)

    def _word(self, offset: int) -> Expression:
        return self.array.element(self.first.plus((self.start + offset) // 2))

    def _above(self, offset: int) -> bool:
        """Whether a byte is the more significant one of its word."""
        return ((self.start + offset) % 2 == 0) == (self.order == "big")

    def byte(self, offset: int) -> Expression:
        """The byte at an offset in the record."""
        return part(self._word(offset), 8 if self._above(offset) else 0, BYTE)

    def byte_stored(self, offset: int, byte: Expression) -> Statement:
        """The statement that stores a byte at an offset in the record. The other byte of the word stays as it is."""
        word, above = self._word(offset), self._above(offset)
        other_byte = word.combined("AND", 0x00FF if above else 0xFF00)
        return Assignment(word, other_byte.combined("OR", joined([(byte, 8 if above else 0)], 2)))

    def _steps(self, offset: int, size: int, order: str, swapped: bool) -> list[int] | None:
        """By how many bits each word is moved, None where the value does not consist of whole words as they are."""
        if size % 2 or (self.start + offset) % 2 or order != self.order:
            return None
        steps = [16 * index for index in range(size // 2)]
        return steps if (order == "big") == swapped else steps[::-1]

    def number(self, offset: int, size: int, order: str, swapped: bool) -> Expression:
        """The bit string of a number of `size` bytes at an offset in the record."""
        steps = self._steps(offset, size, order, swapped)
        if steps is None:
            parts = [(self.byte(offset + index), bits) for index, bits in enumerate(places(size, order, swapped))]
        else:
            parts = [(self._word(offset + 2 * index), bits) for index, bits in enumerate(steps)]
        return joined(_highest_first(parts), size)

    def stored(self, offset: int, size: int, order: str, swapped: bool, bits: Expression) -> list[Statement]:
        """The statements that store a bit string at an offset; `bits` is a variable or a literal."""
        steps = self._steps(offset, size, order, swapped)
        if steps is None:
            bytewise = enumerate(places(size, order, swapped))
            return [self.byte_stored(offset + index, _part(bits, moved, 1)) for index, moved in bytewise]
        return [Assignment(self._word(offset + 2 * index), _part(bits, moved, 2)) for index, moved in enumerate(steps)]


Holder: TypeAlias = Bytes | Words
"""An array, the index of one of its elements, and the offset of a record after that element."""


def _highest_first(parts: Iterable[tuple[Expression, int]]) -> list[tuple[Expression, int]]:
    return sorted(parts, key=lambda place: -place[1])


def _part(bits: Expression, moved: int, size: int) -> Expression:
    """A byte or a word of a bit string; of a literal, the literal."""
    kind = BYTE if size == 1 else WORD
    if isinstance(bits, Whole):
        return Whole(bits.value >> moved & kind.high, kind)
    return part(bits, moved, kind) if moved else bits.converted(kind)
