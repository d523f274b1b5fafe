"""The addresses that a frame reads or writes, with the bytes at them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from fieldspec.codec.layout.bits import unpacked_bits
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.codec.layout.values import Raw
from fieldspec.codec.layout.word_digits import has_word_digits, word_bytes
from fieldspec.foundation.classes import dataclass, replace
from fieldspec.language.model.address_space import BIT, BYTE, WORD
from fieldspec.language.model.device import Device
from fieldspec.language.model.record import Message, RegisterAccess


@dataclass(frozen=True, slots=True)
class Piece:
    """Bytes at `at` in the parts of a frame, and the bytes of the value that they carry.

    These are other bytes for a bit, one with 0 or 1, and for hexadecimal digits.
    """

    at: int
    raw: bytes
    content: bytes


@dataclass(frozen=True, slots=True)
class Span:
    """`words` from `address` on in a space. `data` are their bytes in the frame, at `at` in its parts, or empty.

    In a space of bits, `words` counts these, and `bits` has those that the frame carries, in order. A single one is
    None if its number means neither 0 nor 1. In other spaces, `bits` is None. In a space of bytes, `words` counts
    bytes, and an address has a `unit_size` of 1. `digits` are the hexadecimal digits that the frame has for `data`, two
    for each byte; empty if it has the bytes themselves.
    """

    space: str
    address: int
    words: int
    at: int
    data: bytes
    bits: tuple[int | None, ...] | None = None
    unit_size: int = 2
    digits: bytes = b""

    @property
    def end(self) -> int:
        """The address after the last word."""
        return self.address + self.words

    @property
    def unit(self) -> str:
        """What one address of the space has: `word`, `byte` or `bit`."""
        return BIT if self.bits is not None else WORD if self.unit_size == 2 else BYTE

    def piece(self, address: int, size: int, skip: int = 0) -> Piece | None:
        """The piece of the frame with a value of `size` bytes, `skip` bytes after an address; None unless the frame
        has all of it."""
        if self.bits is not None:
            return self._bit(address - self.address, self.bits)
        start = self.unit_size * (address - self.address) + skip
        if start < 0 or start + size > len(self.data):
            return None
        content = self.data[start : start + size]
        if self.digits:
            return Piece(self.at + 2 * start, self.digits[2 * start : 2 * (start + size)], content)
        return Piece(self.at + start, content, content)

    def _bit(self, index: int, bits: tuple[int | None, ...]) -> Piece | None:
        bit = bits[index] if 0 <= index < len(bits) else None
        if bit is None:
            return None
        start, end = (0, len(self.data)) if len(bits) == 1 else (index // 8, index // 8 + 1)
        return Piece(self.at + start, self.data[start:end], bytes([bit]))

    def unlisted(self, first: int, end: int) -> tuple[int, bytes]:
        """The offset and the bytes of neighbouring words; none for bits, which share bytes with others."""
        piece = self.piece(first, self.unit_size * (end - first)) if self.bits is None else None
        return (piece.at, piece.raw) if piece is not None else (0, b"")


def accessed(
    device: Device,
    access: RegisterAccess,
    values: Mapping[str, Raw],
    request_values: Mapping[str, Raw],
    offset: int,
    data: bytes,
) -> Span | None:
    """The words or bits that a message accesses, by its own values or values of the request that it answers.

    `data` are the bytes of the words, at `offset` in the parts; empty if the message does not carry them. None if the
    words are unknown.
    """
    start = values.get(access.start, request_values.get(access.start))
    if not isinstance(start, int):
        return None
    space = device.space(access.space)
    is_bits, size = space.unit == BIT, space.unit_size
    if access.set is not None:
        number = values.get(access.values) if data else None
        bit = 1 if number == access.set else 0 if number == access.clear else None
        return Span(access.space, int(start), 1, offset, data, (bit,))
    carried = 8 * len(data) if is_bits else len(data) // size
    count = values.get(access.count, request_values.get(access.count)) if access.count else None
    unstated = carried if access.count else 1 if is_bits else max(carried, 1)
    words = int(count) if isinstance(count, int) else unstated
    if is_bits:
        return Span(access.space, int(start), words, offset, data, tuple(unpacked_bits(data))[:words])
    return Span(access.space, int(start), words, offset, data[: carried * size], unit_size=size)


def accessed_spans(
    layout: DeviceLayout,
    message: Message,
    record: RecordLayout,
    body: tuple[int, bytes],
    values: Mapping[str, Raw],
    request_values: Mapping[str, Raw] | None,
) -> Iterator[tuple[RegisterAccess, Span]]:
    """The accesses of a message with what they access. If there are several, a response has the reading ones.

    `body` is where the data begin in the parts of a frame, and their bytes. `request_values` are the values of the
    request that a response answers, None for a request.
    """
    start, data = body
    is_single, is_response = message.single_access is not None, request_values is not None
    for access in message.accesses:
        if is_response and not is_single and access.operation == "write":
            continue
        is_carried = is_single or (access.operation == "read") == is_response
        field = record.named(access.values) if is_carried else None
        offset, content = (field.offset, data[field.offset : field.end]) if field is not None else (0, b"")
        carried = word_bytes(field, content) if field is not None else b""
        # The request of what a response answers may have fields of the same names as the response.
        own = values if is_single or not is_response else {}
        span = accessed(layout.device, access, own, request_values or {}, start + offset, carried)
        if span is not None and field is not None and has_word_digits(field):
            span = replace(span, digits=content)
        if span is not None:
            yield access, span
