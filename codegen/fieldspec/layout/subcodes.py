"""Messages that share a code: the constant in their data that tells them apart."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from fieldspec.classes import TYPE_CHECKING, dataclass
from fieldspec.model.subcodes import Place, constant_at, distinct_place

if TYPE_CHECKING:
    from typing import Literal

    from fieldspec.layout.frame import MessageLayout
    from fieldspec.layout.record import RecordLayout


@dataclass(frozen=True, slots=True)
class Subcode:
    """The field that tells messages of one code apart, `offset` bytes behind the header, and the messages by its value.

    It has `size` bytes. Its number is unsigned; a negative constant counts as the number with the same bits.
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

    def number_of(self, message: MessageLayout) -> int:
        """The number of one of the messages."""
        return next(number for number, other in self.messages.items() if other is message)

    def message(self, data: bytes) -> MessageLayout | None:
        """The message with some data, None where none has their number.

        Data that are too short for the number count as those of the first message, whose decoder refuses them.
        """
        number = self.number(data)
        return next(iter(self.messages.values())) if number is None else self.messages.get(number)


def subcode(messages: Sequence[MessageLayout], direction: str) -> Subcode | None:
    """What tells messages of one code apart in one direction.

    None for a single message, and for responses that only their requests tell apart.
    """
    if len(messages) < 2:
        return None
    constants = [_constants(message.data(direction)) for message in messages]
    place = distinct_place(constants)
    assert place is not None or direction == "response", "requests with one code differ, as a check sees to"
    if place is None:
        return None
    offset, size, order = place
    by_number = {numbers[place]: message for numbers, message in zip(constants, messages, strict=True)}
    return Subcode(offset, size, order, by_number)


def _constants(record: RecordLayout) -> dict[Place, int]:
    constants = (
        constant_at(field.field, field.offset, field.order)
        for field in record.fields
        if not field.cases and record.has_place(field)
    )
    return dict(place_and_number for place_and_number in constants if place_and_number is not None)
