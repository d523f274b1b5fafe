"""Places of parts and fields in a frame, as tables print them."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.inner_lists import InnerLists
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.foundation.classes import dataclass


@dataclass(frozen=True, slots=True)
class Position:
    """A place in a frame: `fixed` bytes plus multiples of the steps, as in `3 + 16k`."""

    fixed: int
    steps: tuple[tuple[int, str], ...] = ()

    def shifted(self, offset: int) -> Position:
        """The place `offset` bytes further."""
        return Position(self.fixed + offset, self.steps)

    def stepped(self, size: int, letter: str) -> Position:
        """The place of each of several elements."""
        return Position(self.fixed, (*self.steps, (size, letter)))

    def text(self, length: int, start: int = 0, width: int = 1) -> str:
        """`4`, `4..7`, `3 + 16k`: bytes, or characters where each byte is `width` of them after `start`."""
        first = start + self.fixed * width
        last = first + length * width - 1
        steps = "".join(_step(size * width, letter) for size, letter in self.steps)
        if first == last:
            return f"{first}{steps}"
        return f"({first}..{last}){steps}" if steps else f"{first}..{last}"


def _step(size: int, letter: str) -> str:
    """` + 16k`, ` + k`, ` + 2 times length of weight`."""
    times = " times " if " " in letter and not letter.startswith(" ") else ""
    return f" + {size}{times}{letter}" if size > 1 else f" + {letter}"


def placed_fields(record: RecordLayout) -> Iterator[tuple[FieldLayout, Position]]:
    """The fields that the spec states, in the order of the wire, each with the place where it begins."""
    starts = [Position(0)] * len(record.fields)
    if record.inner_lists is not None:
        starts = _starts_around(record, record.inner_lists)
    elif record.spans:
        starts = _varying_starts(record)
    for field, start in zip(record.sent_fields, starts, strict=True):
        if not field.field.is_implied:
            yield field, start.shifted(field.offset)


def _starts_around(record: RecordLayout, inner: InnerLists) -> list[Position]:
    """The start of each field that follows lists in a record, less its offset: `4 + 2 times number of samples`."""
    lists = {own.name: own for own in inner.lists}
    position = Position(0)
    starts = []
    for field in record.sent_fields:
        own = lists.get(field.name)
        if own is None:
            starts.append(position)
            continue
        starts.append(position.shifted(own.first - own.room))
        if own.packing is not None and own.least == own.most:
            position = position.shifted(own.sent_size(own.most))
            continue
        if own.parts is not None or own.decision is not None or own.packing is not None:
            position = position.stepped(1, f"bytes of {field.name}")
            continue
        number = f"number of {field.name}"
        position = position.stepped(field.size, f" times {number}" if field.size > 1 else number)
    return starts


def _varying_starts(record: RecordLayout) -> list[Position]:
    """Where each field of a record begins whose values vary in width, less its offset: `3 + length of weight`."""
    starts = []
    position = Position(0)
    for field, span in zip(record.fields, record.spans, strict=True):
        starts.append(position.shifted(-field.offset))
        varies = span.value is not None
        position = position.stepped(1, f"length of {span.name}") if varies else position.shifted(span.size)
    return starts
