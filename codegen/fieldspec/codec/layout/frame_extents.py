"""Where frames end in a stream of bytes, as far as their code, a subcode, a count or an end delimiter determines it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from itertools import dropwhile

from fieldspec.codec.layout.frame import FrameLayout, LinkLayout
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.codec.layout.subcodes import Subcode
from fieldspec.foundation.classes import dataclass, field

FIXED, BY_COUNT, DELIMITED, OPEN = "fixed", "by_count", "delimited", "open"

_DIGITS = b"+-. 0123456789ABCDEFabcdef"
"""The characters of all numbers that are sent as digits."""


@dataclass(frozen=True, slots=True)
class FrameExtent:
    """How long a frame is, with its delimiters and all parts.

    A fixed one has `length` bytes. One by count has `length` bytes and `unit` more for each that a count says: this is
    `offset` bytes after the start delimiter and has `size` bytes and the `order`; `is_turned` if the bytes of its
    16-bit words have the opposite one. A delimited one has at least `length` bytes and ends with the next end
    delimiter. What ends an open one is in no single place of it: only decoding it shows whether an end delimiter is
    its own, and without one it ends with silence.
    """

    kind: str
    length: int = 0
    offset: int = 0
    size: int = 0
    order: str = "big"
    is_turned: bool = False
    unit: int = 0


_OPEN = FrameExtent(OPEN)


@dataclass(frozen=True, slots=True)
class FrameExtents:
    """The extents of all frames in one direction.

    `by_code` has the extents of codes that determine them, `by_subcode` for other codes the subcode of their messages,
    and the extents by its number. `refusal` is that of exception responses which a bit of the code marks.
    """

    by_code: Mapping[int, FrameExtent]
    by_subcode: Mapping[int, tuple[Subcode, Mapping[int, FrameExtent]]] = field(default_factory=dict)
    refusal: FrameExtent | None = None

    @property
    def all_extents(self) -> Iterator[FrameExtent]:
        """The extents of all frames that may occur."""
        yield from self.by_code.values()
        for _, extents in self.by_subcode.values():
            yield from extents.values()
        if self.refusal is not None:
            yield self.refusal

    def of_message(self, name: str, code: int) -> FrameExtent:
        """The extent of the frames of a message with a code."""
        if code in self.by_code:
            return self.by_code[code]
        shared, extents = self.by_subcode[code]
        return next(extents[number] for number, own in shared.messages.items() if own.name == name)

    def has(self, kind: str) -> bool:
        """Whether some frames have an extent of a kind."""
        return any(extent.kind == kind for extent in self.all_extents)


def frame_extents(
    link: LinkLayout,
    direction: str,
    messages: Iterable[tuple[str, int | None, RecordLayout]],
    refusal: RecordLayout | None,
) -> FrameExtents:
    """The extents of the frames of some messages: name, code and data; `refusal` are the extents of exception
    responses.
    """
    frame, error = link.frame(direction), link.link.exception_response
    code_extents: dict[int, set[FrameExtent]] = {}
    names: dict[str, FrameExtent] = {}
    for name, code, record in messages:
        names[name] = _extent(frame, record)
        if code is not None:
            code_extents.setdefault(code, set()).add(names[name])
    by_code = {code: next(iter(own)) if len(own) == 1 else _OPEN for code, own in code_extents.items()}
    refused = _extent(frame, refusal) if refusal is not None and error is not None else None
    if error is not None and refused is not None and not error.flag:
        by_code |= {error.code: refused} if error.code is not None else {}
        if error.part:
            # The code determines the length only where exception responses are as long as others.
            return FrameExtents({code: extent if extent == refused else _OPEN for code, extent in by_code.items()})
    by_subcode = {}
    for code, shared in link.subcodes(direction).items():
        if len(code_extents.get(code, ())) > 1:
            by_subcode[code] = shared, {number: names[own.name] for number, own in shared.messages.items()}
            del by_code[code]
    return FrameExtents(by_code, by_subcode, refused if error is not None and error.flag else None)


def _extent(frame: FrameLayout, record: RecordLayout) -> FrameExtent:
    framing_size = len(frame.start) + frame.header_size + frame.trailer_size + len(frame.end)
    if record.least == record.most:
        return FrameExtent(FIXED, framing_size + record.least)
    count, other_bytes = record.count_of_text or (None, 0)
    if count is not None and record.has_place(count):
        return _by_count(frame, count, framing_size + other_bytes, 1)
    if record.spans:
        is_delimited = bool(frame.end) and not _may_contain(frame, record, frame.end[0])
        return FrameExtent(DELIMITED, framing_size + record.first_bytes) if is_delimited else _OPEN
    tail = record.fields[-1]
    counts = [field for field in record.fields if record.has_place(field) and _measures(field, tail)]
    count = min(counts, key=lambda field: field.size, default=None)  # one byte is read faster than two
    if count is None or count.field.measures is None or tail.cases or not record.has_single_list:
        return _OPEN
    unit, plus = count.field.measures.unit(tail.size), count.field.measures.plus
    return _by_count(frame, count, framing_size + tail.offset - plus * unit, unit)


def _by_count(frame: FrameLayout, count: FieldLayout, length: int, unit: int) -> FrameExtent:
    order, is_turned = count.order, count.swapped
    if is_turned:
        order = "little" if order == "big" else "big"
    return FrameExtent(BY_COUNT, length, frame.header_size + count.offset, count.size, order, is_turned, unit)


def _measures(count: FieldLayout, tail: FieldLayout) -> bool:
    """Whether a field counts another one as a binary number: framers convert no digits."""
    measures, value = count.field.measures, count.value
    return measures is not None and measures.field == tail.name and value is not None and not value.digits


def _may_contain(frame: FrameLayout, record: RecordLayout, byte: int) -> bool:
    """Whether a byte may be in a frame after those that precede the first value that varies in width."""
    fields = {field.name: field for field in record.fields}
    varying = dropwhile(lambda span: span.value is None, record.spans)
    return any(_may_be_in(fields[span.name], byte) for span in varying) or any(
        byte in _DIGITS if part.form else True for part in frame.trailer
    )


def _may_be_in(own: FieldLayout, byte: int) -> bool:
    value = own.value
    if value is None or own.cases:
        return True
    if value.has_characters:
        return byte in _DIGITS
    return value.const == byte if value.const is not None and value.type.name == "u8" else True
