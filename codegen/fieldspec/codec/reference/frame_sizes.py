"""How long the frames of a message are, as far as their first bytes tell: the opinion of the reference."""

from __future__ import annotations

from itertools import dropwhile

from fieldspec.codec.layout.frame import FrameLayout
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.codec.reference.structs import value_construct
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.value import Value

WAITS, OPEN, NONE = -2, -1, 0
"""In place of a size: more bytes are needed; only silence or an end delimiter ends the frame; not a frame."""


@dataclass(frozen=True, slots=True)
class Count:
    """The number in a frame that counts what repeats, `offset` bytes after its beginning."""

    offset: int
    size: int
    value: Value
    order: str
    swapped: bool


@dataclass(frozen=True, slots=True)
class FrameSize:
    """A frame has `fixed` bytes, and `unit` more for each that its `count` says.

    Without a count, a frame `with_end` continues to the next end delimiter.
    """

    fixed: int
    count: Count | None = None
    unit: int = 0
    with_end: bytes = b""

    def of_frame(self, data: bytes) -> int:
        """The size of the frame that some bytes begin with."""
        if self.with_end:
            close = data.find(self.with_end, self.fixed - len(self.with_end))
            return OPEN if close < 0 else close + len(self.with_end)
        count = self.count
        if count is None:
            return self.fixed
        if count.offset + count.size > len(data):
            return WAITS
        construct = value_construct(count.value, count.order, count.swapped)
        return max(NONE, self.fixed + self.unit * int(construct.parse(data[count.offset : count.offset + count.size])))


def frame_size(shape: FrameLayout, record: RecordLayout) -> FrameSize | None:
    """The size of frames with some data; None where they go on as long as bytes come."""
    framing_size = len(shape.start) + shape.header_size + shape.trailer_size + len(shape.end)
    if record.least == record.most:
        return FrameSize(framing_size + record.least)
    if record.spans:
        return _size_of_text(shape, record, framing_size)
    tail = record.fields[-1]
    lists = [field for field in record.fields if field.count is None]
    counts = [field for field in _measuring(record, tail) if record.has_place(field)]
    if lists != [tail] or tail.cases or not record.has_single_list or not counts:
        return None
    count = min(counts, key=lambda field: field.size)
    measure = count.field.measures
    assert measure is not None
    unit = 1 if measure.of == "bytes" else tail.size
    return FrameSize(framing_size + tail.offset - measure.plus * unit, _count(shape, count), unit)


def _size_of_text(shape: FrameLayout, record: RecordLayout, framing_size: int) -> FrameSize | None:
    """The size where values vary in width: by the count of the only one, else by an end delimiter not found within."""
    varying = [span for span in record.spans if span.value is not None]
    other_bytes = sum(span.size for span in record.spans if span.value is None)
    if len(varying) == 1 and varying[0].count is not None:
        count = record.fields[varying[0].count]
        if record.has_place(count):
            return FrameSize(framing_size + other_bytes - varying[0].plus, _count(shape, count), 1)
    names = [span.name for span in dropwhile(lambda span: span.value is None, record.spans)]
    fields = [field for field in record.fields if field.name in names]
    is_apart = bool(shape.end) and shape.end[0] not in _CHARACTERS and all(part.form for part in shape.trailer)
    if not is_apart or not all(_is_apart(field, shape.end[0]) for field in fields):
        return None
    first_bytes = sum(field.size for field in record.fields[: record.fields.index(fields[0])])
    return FrameSize(framing_size + first_bytes, with_end=shape.end)


_CHARACTERS = b"+-. 0123456789ABCDEFabcdef"
"""What numbers that are sent as characters consist of."""


def _is_apart(field: FieldLayout, end: int) -> bool:
    """Whether a byte that is not a character of a number is not in a field: a number as characters, or a separator."""
    value = field.value
    if value is None or field.cases:
        return False
    if value.const is not None and value.type.name == "u8" and not value.digits:
        return value.const != end
    return value.has_characters


def _measuring(record: RecordLayout, tail: FieldLayout) -> list[FieldLayout]:
    """The fields that count the list at the end of a record as binary numbers: framers convert no digits."""
    counting = [field for field in record.fields if (m := field.field.measures) is not None and m.field == tail.name]
    return [field for field in counting if field.value is not None and not field.value.digits]


def _count(shape: FrameLayout, field: FieldLayout) -> Count:
    assert field.value is not None
    return Count(
        len(shape.start) + shape.header_size + field.offset, field.size, field.value, field.order, field.swapped
    )
