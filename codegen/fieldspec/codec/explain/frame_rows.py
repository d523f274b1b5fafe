"""The rows of a frame: every byte of it, also of one that is wrong."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from fieldspec.codec.explain import sentences
from fieldspec.codec.explain.body import Body
from fieldspec.codec.explain.errata import errata_of_message, errata_of_words
from fieldspec.codec.explain.explained_frame import Explanation
from fieldspec.codec.explain.registers import NO_REGISTERS, RegisterRows
from fieldspec.codec.explain.row import (
    ExplanationRow,
    Spot,
    end_rows,
    escape_row,
    fact_row,
    start_rows,
    surplus_row,
    unwrapped,
    wrong_row,
)
from fieldspec.codec.explain.spans import accessed_spans
from fieldspec.codec.explain.values import DecodedValue, Meaning, decode_value, repeated_value, whole
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.escapes import EscapeError, original_places
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.part import PartLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.codec.layout.values import Raw
from fieldspec.foundation.classes import replace


def explained_after(
    layout: DeviceLayout, link: str, direction: str, frame: bytes, message: str, request: Explanation | None
) -> Explanation:
    """The explanation of a frame that answers a request which is explained already. Raises as `explained` does."""
    return _Frame(layout, link, direction, frame, message, request).explanation()


def is_damaged(layout: DeviceLayout, link: str, direction: str, frame: bytes) -> bool:
    """Whether a checksum is wrong, so that no reading of the frame in this direction fits."""
    return _Frame(layout, link, direction, frame, "", None).is_damaged


class _Frame:
    """A frame while it is being explained. `data` are the bytes of its parts, `surplus` are those after them.

    `empty_escape` are the bytes that an escape sends for no bytes at all.
    """

    def __init__(
        self, layout: DeviceLayout, link: str, direction: str, frame: bytes, message: str, request: Explanation | None
    ) -> None:
        self.layout, self.link, self.direction, self.frame = layout, layout.links[link].link, direction, frame
        self.shape = layout.links[link].frame(direction)
        self.asked = request
        self.wrapped = unwrapped(self.link, direction, frame)
        self.spot = Spot(frame, len(self.wrapped.start), 2 if self.link.transmission == "hex_ascii" else 1)
        self.unreadable: int | None = None
        self.empty_escape = b""
        self.sent_data, self.surplus = self._without_surplus(self.wrapped.data)
        self.data = self._original(self.sent_data) if self.shape.escape is not None else self.sent_data
        self.named = message or (request.message if request else "")
        self.sent = layout.links[link].carried(direction)
        self.message: MessageLayout | None = self.sent.get(self.named)
        self.error = False
        self.values: dict[str, Raw] = {}
        self.accessed: tuple[int, int] | None = None

    def explanation(self) -> Explanation:
        """The whole explanation. The header comes first, because its code determines the body."""
        if self.unreadable is not None:
            return self._unreadable(self.unreadable)
        rows = [*start_rows(self.wrapped), *self._parts(self.shape.header, 0)]
        registers = NO_REGISTERS
        if len(self.data) >= self.shape.header_size:
            self.error = self.error or self._is_marked()
            body_rows, registers = self._body()
            rows = [*rows, *body_rows, *self._tail()]
        if self.surplus:
            rows.append(surplus_row(self.spot, len(self.data), self.surplus))
        rows = [*rows, *end_rows(self.wrapped)]
        if self.empty_escape:
            row = escape_row(self.spot, self.link, self.shape.escape_start, self.empty_escape)
            rows = sorted((*rows, row), key=lambda row: row.offset)
        errata, name = errata_of_words(self.layout.device, (self.link.place.path,)), ""
        if self.message is not None:
            errata = (*errata, *errata_of_message(self.layout.device, self.message.message))
            name = self.message.name
        return Explanation(
            link=self.link.name,
            direction=self.direction,
            message=name,
            error=self.error,
            frame=self.frame,
            rows=tuple(rows),
            register_rows=registers,
            values=self.values,
            errata=errata,
            accessed=self.accessed,
        )

    @property
    def is_damaged(self) -> bool:
        """Whether the parts are whole, and one of their checksums is wrong."""
        parts_size = self.shape.header_size + self.shape.trailer_size
        if self.unreadable is not None or not self.wrapped.whole or len(self.data) < parts_size:
            return False
        return any(
            part.checksum(self._measured(part)) != self.data[part.at(len(self.data)) :][: part.size]
            for part in self.shape.checksums
        )

    def _is_marked(self) -> bool:
        """Whether a part or the data say that a frame without a code is an exception response."""
        link = self.layout.links[self.link.name]
        refusal = link.link.exception_response
        if refusal is None or self.direction == "request" or not link.has_uncoded_exceptions:
            return False
        if link.mark is not None:
            return link.mark.is_in(self.data[self.shape.header_size : self._body_end()])
        return refusal.is_marked(0, self.shape.numbers(self.data))

    def _body_end(self) -> int:
        """The offset of the first byte after the body."""
        shape, size = self.shape, len(self.data)
        return max(shape.header_size, size - shape.trailer_size) if self.wrapped.whole else size

    def _original(self, escaped_data: bytes) -> bytes:
        """The bytes of the parts before they were escaped; finds out where they are in the frame."""
        shape = self.shape
        assert shape.escape is not None
        if len(escaped_data) < shape.header_size + shape.trailer_size:
            return escaped_data
        start, stop = shape.escape_start, len(escaped_data) + (shape.escape_stop or 0)
        try:
            originals = original_places(shape.escape, escaped_data[start:stop])
        except EscapeError as error:
            self.unreadable = start + error.offset
            return escaped_data
        self.empty_escape = b"" if originals else escaped_data[start:stop]
        # What is sent before the first byte belongs to it.
        inner = [place + start if number else start for number, (_, place) in enumerate(originals)]
        data = bytes((*escaped_data[:start], *(byte for byte, _ in originals), *escaped_data[stop:]))
        end = len(escaped_data) + len(self.surplus)
        self.spot = replace(
            self.spot,
            places=(*range(start), *inner, *range(stop, end + 1)),
            originals=bytes((*data, *self.surplus)),
            escape=shape.escape,
            gap=None if originals else start,
        )
        return data

    def _unreadable(self, offset: int) -> Explanation:
        """The explanation of a frame with bytes that are the escape of nothing, from the byte at `offset` on."""
        start, stop = self.shape.escape_start, len(self.data) + (self.shape.escape_stop or 0)
        text = sentences.NOT_ESCAPED.format(offset=len(self.wrapped.start) + offset)
        if self.shape.escape is not None and self.shape.escape.method == "can":
            text = self.shape.escape.header_fault(self.data[start:stop], offset - start)
        rows = [*start_rows(self.wrapped), *self._unescaped_rows(self.shape.header)]
        rows.append(wrong_row(self.spot, start, self.data[start:stop], "wrong_mark", text))
        rows = [*rows, *self._unescaped_rows(self.shape.trailer)]
        if self.surplus:
            rows.append(surplus_row(self.spot, len(self.data), self.surplus))
        rows = [*rows, *end_rows(self.wrapped)]
        return Explanation(self.link.name, self.direction, self.named, False, self.frame, tuple(rows), NO_REGISTERS, {})

    def _unescaped_rows(self, parts: Iterable[PartLayout]) -> Iterator[ExplanationRow]:
        """The rows of parts that are not escaped."""
        for part in parts:
            if not part.escaped:
                offset = part.at(len(self.data))
                data = self.data[offset : offset + part.size]
                yield self._part(part, offset, data, self._part_text(part, data))

    def _measured(self, part: PartLayout) -> bytes:
        """The bytes whose length or checksum a part has: those that are sent, or those before they are escaped."""
        return self.sent_data if self.shape.escape is not None and not part.before_escape else self.data

    def _without_surplus(self, data: bytes) -> tuple[bytes, bytes]:
        """The bytes of the parts and those after them: length and checksum may show that the frame ends earlier."""
        is_escaped = self.shape.escape is not None
        length = next((part for part in self.shape.lengths if not is_escaped or not part.before_escape), None)
        checks = [part for part in self.shape.checksums if not is_escaped or not part.before_escape]
        if length is None or not checks or not self.wrapped.whole:
            return data, b""
        number = length.read(data[length.offset : length.offset + length.size])
        stated = number * length.unit_size + length.base if number is not None else 0
        early = self.shape.header_size + self.shape.trailer_size <= stated < len(data)
        if early and not _is_right(checks, data) and _is_right(checks, data[:stated]):
            return data[:stated], data[stated:]
        return data, b""

    def _parts(self, parts: Iterable[PartLayout], base: int) -> Iterator[ExplanationRow]:
        """The rows of parts, whose offsets count from `base`, up to the first one that is not whole."""
        for part in parts:
            offset = base + part.offset
            data = self.data[offset : offset + part.size]
            if len(data) < part.size:
                if self.wrapped.whole or data:
                    yield self._short(part, offset, data)
                return
            yield self._part(part, offset, data, self._part_text(part, data))

    def _part(self, part: PartLayout, offset: int, data: bytes, read: DecodedValue) -> ExplanationRow:
        return fact_row(self.layout.device, "part", part.name, part.part, self.spot, offset, data, read, self.link)

    def _short(self, part: PartLayout, offset: int, data: bytes) -> ExplanationRow:
        missing = part.size - len(data)
        text = sentences.missing_text(missing, part.name)
        return wrong_row(self.spot, offset, data, "incomplete", text, part.name, part.part.place.path)

    def _part_text(self, part: PartLayout, raw: bytes) -> DecodedValue:
        """The value of a part, judged by its role."""
        if part.role == "checksum":
            return self._checked(part, raw)
        assert part.value is not None
        if part.reserved:
            return decode_value(self.layout.device, part.value, part.own_bytes(raw), part.order, False, part.reserved)
        read = decode_value(self.layout.device, part.value, part.own_bytes(raw), part.order, False)
        if not isinstance(read.number, int):
            return read
        if part.role == "length":
            return self._judged_length(part, read)
        if part.offset < 0:
            return read
        self.values[part.name] = self.shape.stated_number(part, read.number)
        if part.role == "code":
            return self._code(part, replace(read, number=self.values[part.name]), read.number)
        if part.role == "unit_address":
            return self._unit_address(read)
        stated = self.asked.values.get(part.part.same_as) if self.asked else None
        return read if read.reason or stated is None else repeated_value(read, stated, part.value)

    def _judged_length(self, part: PartLayout, read: DecodedValue) -> DecodedValue:
        """A length, compared with the bytes that it counts."""
        if not self.wrapped.whole:
            return read
        expected = part.number(len(self._measured(part)))
        right = expected is not None and read.number == expected
        return read.judged(right, expected if expected is not None else sentences.ANOTHER_LENGTH, "wrong_length")

    def _checked(self, part: PartLayout, raw: bytes) -> DecodedValue:
        """A checksum, compared with the one that the bytes have."""
        read = DecodedValue(raw.decode("latin-1") if part.digits else whole(raw, part.order))
        if not self.wrapped.whole:
            return read
        expected = part.checksum(self._measured(part))
        text = expected.decode("ascii") if part.digits else expected.hex(" ").upper()
        return read.judged(raw == expected, text, "wrong_checksum")

    def _code(self, part: PartLayout, read: DecodedValue, code: int) -> DecodedValue:
        """The message that a code names. An exception response marks the code."""
        refusal = self.link.exception_response
        head = self.shape.numbers(self.data)
        if refusal is not None and self.direction == "response" and refusal.is_marked(code, head):
            self.error = True
            code = code & ~refusal.flag
            self.values[part.name] = code
            if refusal.code is not None:
                return self._refusing_code(read)
        link = self.layout.links[self.link.name]
        start = self.shape.header_size
        end = max(start, len(self.data) - self.shape.trailer_size)
        if self.error:
            self.message = link.refused_message(code, self.named)
        else:
            self.message = link.message_with_code(code, self.direction, self.data[start:end], self.named)
        if self.message is None:
            if self.error:
                text = sentences.CODE_REFUSED.format(code=f"0x{code:02x}")
                return replace(read, meanings=(Meaning("", "", text, ""),))
            ambiguous = link.ambiguous_codes(self.direction).get(code)
            if ambiguous is not None:
                names = ", ".join(message.name for message in ambiguous)
                return read.judged(False, sentences.SHARED_CODE.format(names=names), "unknown_code")
            expected = self.sent.get(self.named)
            known = ", ".join(link.code_text(message, self.direction) for message in self.sent.values())
            sentence = sentences.PERMITTED_NAMES if known else sentences.CODE_OF_NONE
            several_text = sentence.format(names=known, direction=self.direction)
            text = several_text if expected is None else link.code_text(expected, self.direction)
            return read.judged(False, text, "unknown_code")
        message = self.message.message
        title = message.title or message.label or message.name
        text = sentences.REFUSED_CODE.format(message=title) if self.error else message.title
        meaning = Meaning(message.name, message.label, text, "")
        read = replace(read, meanings=(meaning,), notes=message.notes, facts=(message.place.path,))
        expected = self.sent.get(self.named)
        if expected is None or expected is self.message or self.error:
            return read
        return read.judged(False, link.code_text(expected, self.direction), "unknown_code")

    def _refusing_code(self, read: DecodedValue) -> DecodedValue:
        """The code of all exception responses, which does not say what it answers: only the request does."""
        self.message = self.layout.links[self.link.name].carried("request").get(self.named)
        if self.message is None:
            return replace(read, meanings=(Meaning("", "", sentences.REQUEST_REFUSED, ""),))
        message = self.message.message
        text = sentences.MESSAGE_REFUSED.format(message=message.title or message.label or message.name)
        return replace(read, meanings=(Meaning("", "", text, ""),), notes=message.notes, facts=(message.place.path,))

    def _unit_address(self, read: DecodedValue) -> DecodedValue:
        addresses = self.link.unit_addresses
        if addresses is None or addresses.ranges is None:
            return read
        if read.number == addresses.broadcast:
            return replace(read, meanings=(Meaning("broadcast", "", sentences.BROADCAST, ""),), verdict="", reason="")
        if read.number in addresses.ranges:
            return read
        return read.judged(False, addresses.ranges.text(), "out_of_range")

    def _record(self) -> RecordLayout | None:
        """The record of the body; None where no message is known."""
        if self.error and self.link.exception_response is not None:
            return self.layout.records[self.link.exception_response.record]
        return self.message.data(self.direction) if self.message else None

    def _body(self) -> tuple[list[ExplanationRow], RegisterRows]:
        """The rows of the body, and of the registers that it reads or writes."""
        start, record = self.shape.header_size, self._record()
        end = self._body_end()
        if record is None:
            return list(self._unknown(start, end)), NO_REGISTERS
        message = self.message.message if self.message else None
        request_values = self.asked.values if self.asked else {}
        body = Body(self.layout, record, message or record.record, self.data, start, end, self.spot, request_values)
        self.values.update(body.values)
        rows = [row for row in body.rows if self.wrapped.whole or row.kind != "unexplained" or row.length]
        if message is None or self.error:
            return rows, NO_REGISTERS
        answered_values = request_values if self.direction == "response" else None
        body_bytes = start, self.data[start:end]
        accesses = list(accessed_spans(self.layout, message, record, body_bytes, body.values, answered_values))
        if message.single_access is not None and accesses:
            ((_, span),) = accesses
            self.accessed = span.address, span.end - 1
        return rows, RegisterRows(self.layout, self.spot, [(access.operation, span) for access, span in accesses])

    def _unknown(self, start: int, end: int) -> Iterator[ExplanationRow]:
        """The row of a body that nothing describes."""
        if self.shape.role("code") is None:
            yield wrong_row(self.spot, start, self.data[start:end], "unknown_code", sentences.NO_CODE)
        elif end > start:
            row = wrong_row(self.spot, start, self.data[start:end], "", "")
            yield replace(row, verdict="", doc=sentences.UNKNOWN_DATA)

    def _tail(self) -> Iterator[ExplanationRow]:
        end = max(self.shape.header_size + self.shape.trailer_size, len(self.data))
        return self._parts(self.shape.trailer if self.wrapped.whole else (), end)


def _is_right(checks: Iterable[PartLayout], data: bytes) -> bool:
    """Whether the parts carry the checksums that they should."""
    return all(check.checksum(data) == data[check.at(len(data)) :][: check.size] for check in checks)
