"""Messages that share a code: the field in their data that tells them apart."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from fieldspec.codec.layout.exception_mark import word_order_of
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.foundation.classes import TYPE_CHECKING, dataclass
from fieldspec.language.model.ranges import merged
from fieldspec.language.model.subcodes import Numbers, Place, distinct_place, numbers_at

if TYPE_CHECKING:
    from typing import Literal

    from fieldspec.codec.layout.record import RecordLayout


@dataclass(frozen=True, slots=True)
class Subcode:
    """The field that tells messages of one code apart, `offset` bytes after the header, and the messages by its value.

    It has `size` bytes. Its number is unsigned; a negative constant counts as the number with the same bits. A message
    has one number where the field is a constant, else all of its range.
    """

    offset: int
    size: int
    order: str
    messages: Mapping[int, MessageLayout]

    @property
    def end(self) -> int:
        """The bytes of data that are needed to read it."""
        return self.offset + self.size

    def number(self, data: bytes) -> int | None:
        """The number in some data, None where they are too short."""
        order: Literal["big", "little"] = "little" if self.order == "little" else "big"
        return int.from_bytes(data[self.offset : self.end], order) if len(data) >= self.end else None

    def intervals_of(self, message: MessageLayout) -> list[tuple[int, int]]:
        """The numbers of one of the messages, as intervals with both ends in ascending order."""
        return merged((number, number) for number, other in self.messages.items() if other is message)

    def texts_of(self, message: MessageLayout) -> list[str]:
        """The numbers of one of the messages as hexadecimal: `0x000A`, or `0x00..0x1F`."""
        digits = 2 * self.size
        pairs = ((f"0x{low:0{digits}X}", f"0x{high:0{digits}X}") for low, high in self.intervals_of(message))
        return [low if low == high else f"{low}..{high}" for low, high in pairs]

    def message(self, data: bytes) -> MessageLayout | None:
        """The message with some data, None where none has their number.

        Data that are too short for the number count as data of the first message, whose decoder rejects them.
        """
        number = self.number(data)
        return next(iter(self.messages.values())) if number is None else self.messages.get(number)


def subcode(messages: Sequence[MessageLayout], direction: str) -> Subcode | None:
    """The place and the numbers that tell messages of one code apart in one direction.

    None for a single message, and for responses that only their requests identify.
    """
    if len(messages) < 2:
        return None
    places = [_places(message.data(direction)) for message in messages]
    place = distinct_place(places)
    assert place is not None or direction == "response", "requests with one code differ, as a check sees to"
    if place is None:
        return None
    offset, size, order = place
    by_number = {number: own for numbers, own in zip(places, messages, strict=True) for number in numbers[place]}
    return Subcode(offset, size, order, by_number)


def _places(record: RecordLayout) -> dict[Place, Numbers]:
    places = (
        numbers_at(field.field, field.offset, field.order, word_order_of(field))
        for field in record.fields
        if not field.cases and record.has_place(field)
    )
    return dict(place_and_numbers for place_and_numbers in places if place_and_numbers is not None)
