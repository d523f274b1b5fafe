"""Fields that are not always sent and lists, and the bits of an earlier field that say how many elements they have."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.foundation.classes import TYPE_CHECKING, dataclass
from fieldspec.language.model.counts import bit_count
from fieldspec.language.model.enums import Enum
from fieldspec.language.model.record import Field, Record
from fieldspec.language.model.stated_bits import stated_bits

if TYPE_CHECKING:
    from typing import Any


def masked(number: int, mask: int | None) -> int:
    """The bits of a number that decide something, in their place; all where there is no mask."""
    return number if mask is None else number & mask


@dataclass(frozen=True, slots=True)
class PresenceLayout:
    """A field is sent if the bits `mask` of the number of the field `by` are one of `numbers`.

    The numbers are a range where any of these bits suffices. Where there are no `numbers`, these bits are a number of
    their own: `unit` for each element of a list, plus `plus`.
    """

    by: str
    mask: int
    numbers: tuple[int, ...] | range
    unit: int = 1
    plus: int = 0

    @property
    def is_any(self) -> bool:
        """Whether the field is sent if any of the bits is 1."""
        return isinstance(self.numbers, range)

    @property
    def number_list(self) -> list[int]:
        """The numbers with which the field is sent; none where any of the bits suffices."""
        return [] if self.is_any else [*self.numbers]

    @property
    def shift(self) -> int:
        """The lowest of the bits."""
        return (self.mask & -self.mask).bit_length() - 1

    def bits_in(self, number: int) -> int:
        """The number in the bits."""
        return (number & self.mask) >> self.shift

    def bits_text(self, content: object) -> str:
        """`4 in bits 0..3`: what the bits should contain."""
        return f"{content} in bits {self.shift}..{self.mask.bit_length() - 1}"

    def is_met(self, number: int) -> bool:
        """Whether a number says that the field is sent."""
        return number & self.mask in self.numbers

    def elements(self, number: int) -> int | None:
        """How many elements a number says that there are, None where it cannot be right; 1 if the field is sent."""
        if self.numbers:
            return int(self.is_met(number))
        elements, rest = divmod(self.bits_in(number) - self.plus, self.unit)
        return None if rest or elements < 0 else elements

    def fits(self, number: int, elements: int) -> bool:
        """Whether a number is right about how many elements there are."""
        if self.numbers:
            return self.is_met(number) == bool(elements)
        return self.bits_in(number) == elements * self.unit + self.plus

    def filled(self, number: int, elements: int) -> int:
        """A number whose bits are right about the elements of a list, which it counts."""
        return number & ~self.mask | (elements * self.unit + self.plus) << self.shift & self.mask

    def text(self, name: str, number: int) -> str:
        """The statement of a number about the field with a name."""
        if not self.numbers:
            return f"{self.by} is {number}, which counts {self.bits_in(number)} for {name}"
        return f"{self.by} is {number}, which says that {name} is{'' if self.is_met(number) else ' not'} sent"


def presence_layout(record: Record, name: str, size: int, enums: Mapping[str, Enum]) -> PresenceLayout | None:
    """The bits that say whether a field of a record is sent, or how many elements of some bytes it has; None where no
    bits do.
    """
    if (count := bit_count(record, name)) is not None:
        return bit_presence(count[0], size)
    field = record.named(name)
    presence = field.presence if field is not None else None
    selector = record.named(presence.by) if presence is not None else None
    if presence is None or selector is None or selector.value is None:
        return None
    return PresenceLayout(presence.by, *stated_bits(presence, selector.value, enums))


def bit_presence(count: Field, size: int) -> PresenceLayout:
    """The bits of a field that count another one, whose elements have some bytes."""
    measure = count.bit_measure
    assert measure is not None
    assert measure.bits is not None
    low, high = measure.bits
    unit = size if measure.of == "bytes" else 1
    return PresenceLayout(count.name, (2 << high) - (1 << low), (), unit, measure.plus)


def presence_data(presence: PresenceLayout) -> dict[str, Any]:
    """A presence as programs in JavaScript have it."""
    data = {"by": presence.by, "mask": presence.mask}
    if not presence.numbers:
        return {**data, "unit": presence.unit, "plus": presence.plus}
    return {**data, "numbers": presence.number_list}
