"""The operations of a query language. Every function returns an expression, and null for a null."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from decimal import Decimal
from fractions import Fraction
from typing import Protocol, TypeAlias

from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.encoding import Precision, Sign
from fieldspec.language.model.enums import Bit

Body: TypeAlias = Callable[[str], str]
"""The expression of something about the bytes of one element."""


@dataclass(frozen=True, slots=True)
class Slot:
    """A number in `size` bytes at `offset`. `order` and `swapped` as in `FieldLayout`."""

    offset: int
    size: int
    order: str
    swapped: bool
    sign: Sign = Sign.NONE

    @property
    def places(self) -> tuple[int, ...]:
        """The places of its bytes from the beginning of the data, the most significant one first."""
        places = list(range(self.offset, self.offset + self.size))
        if self.order != "big":
            places.reverse()
        if self.swapped:
            words = [places[index : index + 2] for index in range(0, self.size, 2)]
            places = [place for word in reversed(words) for place in word]
        return tuple(places)

    @property
    def runs(self) -> list[tuple[int, int]]:
        """The first place and the number of neighbouring bytes that are in the order of the number."""
        runs: list[tuple[int, int]] = []
        for place in self.places:
            if runs and sum(runs[-1]) == place:
                runs[-1] = (runs[-1][0], runs[-1][1] + 1)
            else:
                runs.append((place, 1))
        return runs


@dataclass(frozen=True, slots=True)
class DecimalScale:
    """quantity = count * scale + offset as an exact decimal number.

    `digits` are the digits of the greatest count, `places` follow the point, and `precision` are all digits of a
    quantity.
    """

    scale: Decimal
    offset: Decimal
    digits: int
    places: int
    precision: int


class Dialect(Protocol):
    """A language of queries. `data` is the expression of some bytes; a condition is null where a value in it is."""

    def whole(self, data: str, slot: Slot) -> str:
        """The literal of a whole number."""

    def real(self, data: str, slot: Slot, precision: Precision) -> str:
        """The expression of a floating-point number."""

    def bits(self, word: str, bit: Bit) -> str:
        """The number in some bits of an unsigned number."""

    def bit(self, word: str, place: int) -> str:
        """Whether a bit of an unsigned number is 1."""
        return self.mask(word, 1 << place)

    def mask(self, word: str, mask: int) -> str:
        """Whether one of some bits of an unsigned number is 1."""

    def piece(self, data: str, offset: int, size: int) -> str:
        """The expression of `size` bytes of the data from an offset on."""

    def text(self, data: str) -> str:
        """ASCII without the zeros at its end; null for other bytes."""

    def not_ascii(self, data: str) -> str:
        """Whether some byte is not ASCII."""

    def truth(self, number: str) -> str:
        """0 as false, 1 as true, other numbers as null."""

    def member(self, number: str, enum: str) -> str:
        """The name of a number by an enum; null where it has none."""

    def cases(
        self,
        number: str,
        names: Mapping[tuple[int, int], str],
        nan: str = "",
        other: tuple[str, str] | None = None,
    ) -> str:
        """The names of the numbers in some intervals, of a NaN, and of others where a condition holds; else null."""

    def absent(self, value: str, number: str, intervals: Sequence[tuple[int, int]], nan: bool = False) -> str:
        """A value that is null for the numbers in some intervals, and for a NaN."""

    def decimal(self, number: str, scale: DecimalScale) -> str:
        """The expression of an exact quantity from a number in counts."""

    def ratio(self, number: str, scale: Fraction, offset: Fraction) -> str:
        """number * scale + offset as a floating-point number."""

    def power(self, number: str, exponent: str, intervals: Sequence[tuple[int, int]]) -> str:
        """number * 10^exponent as a floating-point number; null for an exponent that is in none of the intervals."""

    def is_in(self, number: str, intervals: Sequence[tuple[float, float]], floating: bool = False) -> str:
        """Whether a number is in one of some intervals."""

    def is_nan(self, number: str) -> str:
        """Whether a floating-point number is not a number."""

    def size(self, data: str) -> str:
        """The expression of the number of bytes of the data."""

    def compared(self, left: str, operator: str, right: str) -> str:
        """A comparison: `<`, `>`, `=` or `<>`."""

    def both(self, *conditions: str) -> str:
        """Whether all conditions are true."""

    def either(self, *conditions: str) -> str:
        """Whether a condition is true."""

    def negated(self, condition: str) -> str:
        """Whether a condition is false."""

    def units(self, data: str, offset: int, unit: int) -> str:
        """The whole units of bytes from an offset to the end."""
        rest = f"({self.size(data)} - {offset})"
        return f"({rest} // {unit})" if unit > 1 else rest

    def each(self, data: str, offset: int, size: int, count: int | None, body: Body) -> str:
        """The list of what `body` says of each element; without a count, of all elements to the end."""

    def some(self, data: str, offset: int, size: int, count: int | None, body: Body) -> str:
        """Whether the condition of `body` is true for some element."""

    def sized(self, data: str, minimum: int, maximum: int | None, offset: int, unit: int) -> str:
        """The bytes where there are `minimum` to `maximum`, and whole units of them from an offset on; else null."""

    def chosen(self, data: str, condition: str) -> str:
        """The bytes where a condition is true, else null."""

    def first(self, *values: str) -> str:
        """The first value that is not null."""

    def first_of(self, data: str, offset: int, size: int, count: int | None, body: Body) -> str:
        """The first of what `body` says of each element that is not null."""

    def reason(self, refusals: Sequence[tuple[str, str]]) -> str:
        """The reason after the first condition that is true; null where none is."""

    def words(self, address: str, size: int, unit: int = 2) -> str:
        """The bytes at an address of the registers whose words, from the address `start` on, are the payload.

        An address has `unit` bytes.
        """

    def single_bit(self, address: int) -> str:
        """The bit at an address where the payload has those from the address `start` on."""

    def argument(self, name: str) -> str:
        """An argument of the query that is a number."""

    def step(self, name: str) -> str:
        """The name of an intermediate result."""

    def as_text(self, value: str) -> str:
        """A number as a text."""
