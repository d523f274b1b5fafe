"""Values in pieces: the fields and bits of the message that carries one."""

from __future__ import annotations

from fieldspec.foundation.classes import TYPE_CHECKING, dataclass
from fieldspec.language.model.encoding import is_count, is_signed

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from fieldspec.language.model.enums import Flags
    from fieldspec.language.model.ranges import Ranges
    from fieldspec.language.model.record import Field, Record


@dataclass(frozen=True, slots=True)
class NumberPlace:
    """A number in the unsigned value of a `field`: `width` bits from the bit `shift` on.

    `low` and `high` are the least and the greatest number there.
    """

    field: Field
    shift: int
    width: int
    low: int
    high: int

    @property
    def mask(self) -> int:
        """The bits of the number, at its place in the value of the field."""
        return ((1 << self.width) - 1) << self.shift

    def number(self, value: int) -> int:
        """The number in a value of the field."""
        return (value & self.mask) >> self.shift

    def placed(self, value: int, number: int) -> int:
        """A value of the field with a number in it."""
        return value & ~self.mask | number << self.shift

    def number_behind(self, count: int) -> int:
        """The number of the piece after `count` others."""
        return self.low + count % (self.high - self.low + 1)


def number_places(flags: Mapping[str, Flags], record: Record, name: str) -> Iterator[NumberPlace]:
    """The places in a record with a name: unsigned whole numbers, and bits of the words that fields are."""
    for field in record.fields:
        value = field.value
        if value is None or not is_count(value.encoding) or is_signed(value.encoding) or value.digits or value.width:
            continue
        if field.count is not None or field.repeat is not None or field.reserved or value.parameter is not None:
            continue
        if field.name == name:
            low, high = _bounds(value.ranges, value.type.high)
            yield NumberPlace(field, 0, 8 * value.size, low, high)
        word = flags.get(value.flags)
        for bit in word.bits if word is not None else ():
            if bit.name == name and not bit.signed and not bit.pieces and bit.last < 8 * value.size:
                width = bit.last - bit.first + 1
                yield NumberPlace(field, bit.first, width, 0, (1 << width) - 1)


def _bounds(ranges: Ranges | None, high: int) -> tuple[int, int]:
    return (0, high) if ranges is None else (ranges.low, ranges.high)


def initial_number(field: Field, flags: Mapping[str, Flags]) -> int | None:
    """The value of a field of a request that nothing else decides; None where nothing says it.

    A word has the defaults of its bits, a number 0; where its range leaves that out, it has the least number of that.
    """
    value = field.value
    if value is None:
        return None
    if value.const is not None:
        return value.const
    if isinstance(value.default, int):
        return value.default
    initial = flags[value.flags].initial if value.flags else 0
    return initial if value.ranges is None or initial in value.ranges else value.ranges.low
