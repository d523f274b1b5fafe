"""The reference codec of frames and devices."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import construct

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import FrameLayout, LinkLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.part import PartLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.codec.layout.value_texts import spec_text
from fieldspec.codec.reference.escapes import escaped, unescaped
from fieldspec.codec.reference.parts import FrameParts, checksum_of, checksum_text
from fieldspec.codec.reference.records import CodecError, Values, decoded, encoded
from fieldspec.codec.reference.structs import is_sequence, record_struct
from fieldspec.foundation.classes import dataclass, field
from fieldspec.language.model.digits import digits_text

Outline = tuple[bytes, Values]
"""The bytes of all parts of a frame and its data, and the numbers of the parts around the data by name."""


@dataclass(frozen=True, slots=True)
class Decoded:
    """The meaning of a frame. `message` is None for an error reply to a code that the device does not know.

    `head` holds the parts before the body but for the length; the code of an error reply is there without its
    flag. `parts` is the frame's binary form.
    """

    link: str
    direction: str
    message: MessageLayout | None
    error: bool
    head: Values
    values: Values
    parts: bytes = field(repr=False)
    body: RecordLayout | None = field(repr=False)


class FrameCodec:
    """Encodes and decodes the frames of one link."""

    def __init__(self, layout: DeviceLayout, link: LinkLayout) -> None:
        self.layout, self.link = layout, link
        self.framed = {shape.direction: FrameParts(shape) for shape in (link.request, link.response)}

    def parts(self, frame: bytes, direction: str) -> bytes:
        """A frame without its delimiters, as bytes instead of characters. Raises CodecError."""
        link, shape = self.link.link, self.link.frame(direction)
        frame = frame[shape.surplus(frame) :]
        if not frame.startswith(shape.start):
            raise CodecError("wrong_mark", f"the frame does not start with {shape.start.hex(' ')}", 0)
        if not frame.endswith(shape.end) or len(frame) < len(shape.start) + len(shape.end):
            raise CodecError("wrong_mark", f"the frame does not end with {shape.end.hex(' ')}", len(frame))
        inner = frame[len(shape.start) : len(frame) - len(shape.end)]
        if link.transmission == "binary":
            return inner
        for index, char in enumerate(inner):
            if char not in b"0123456789ABCDEFabcdef":
                text = f"byte {char:#04x} is not a hexadecimal character"
                raise CodecError("not_hex", text, len(shape.start) + index)
        if len(inner) % 2:
            raise CodecError("wrong_length", "an odd number of characters", len(frame) - len(shape.end))
        return bytes.fromhex(inner.decode("ascii"))

    def decode(self, frame: bytes, direction: str, message: str = "") -> Decoded:
        """The meaning of a whole frame.

        `message` names the message if the frame does not identify it. Raises CodecError.
        """
        return self.decode_outline(self.outline(frame, direction), direction, message)

    def outline(self, frame: bytes, direction: str) -> Outline:
        """The binary form of a frame with the numbers around its data, right or wrong. Raises CodecError."""
        data, framed = self.parts(frame, direction), self.framed[direction]
        _refuse_short(framed.shape, data)
        if framed.shape.escape is not None:
            data = self._original(framed, data)
        return data, framed.numbers(data)

    def decode_outline(self, outline: Outline, direction: str, message: str = "") -> Decoded:
        """The meaning of a frame with some outline. Raises CodecError."""
        framed, (data, stated) = self.framed[direction], outline
        shape, numbers = framed.shape, {**stated}
        self._check_around(framed, numbers, data)
        inner = data[shape.header_size : len(data) - shape.trailer_size]
        announced, body, error = self._body(framed, numbers, inner, message)
        values = decoded(body, inner, self.layout.device, shape.header_size)
        visible = {name: numbers[name] for name in framed.visible}
        return Decoded(self.link.name, direction, announced, error, visible, values, data, body)

    def frame_numbers(self, frame: bytes, direction: str) -> Values:
        """The parts around the data of a frame, whatever the data are. Raises CodecError where a part is wrong."""
        data, numbers = self.outline(frame, direction)
        self._check_around(self.framed[direction], numbers, data)
        return numbers

    def _check_around(self, framed: FrameParts, numbers: Values, data: bytes) -> None:
        """Raises CodecError where a part around the data is wrong."""
        self._check_digits(framed.digits, numbers, data)
        self._check_lengths(framed, numbers, data, True)
        self._check_sum(framed, numbers, data, True)
        for part in framed.constants:
            if numbers[part.name] != part.constant:
                text = f"{part.name} is {numbers[part.name]}, not {part.constant}"
                raise CodecError("wrong_const", text, part.at(len(data)))

    def has_right_checksum(self, frame: bytes, direction: str) -> bool:
        """Whether a frame has a checksum and it is right, whatever the length in the frame says."""
        framed = self.framed[direction]
        try:
            data, numbers = self.outline(frame, direction)
            self._check_sum(framed, numbers, data, True)
        except CodecError:
            return False
        return bool(framed.checksums)

    def _original(self, framed: FrameParts, data: bytes) -> bytes:
        """The parts before they were escaped, after those around were compared with what was sent."""
        shape = framed.shape
        assert shape.escape is not None
        start, stop = shape.escape_start, len(data) if shape.escape_stop is None else len(data) + shape.escape_stop
        sent_parts = framed.numbers(data, is_sent=True)
        early = (part for part in framed.lengths if part in framed.digits and not part.before_escape)
        self._check_digits(early, sent_parts, data)
        self._check_lengths(framed, sent_parts, data, False)
        self._check_sum(framed, sent_parts, data, False)
        offset = len(shape.start) + start
        result = data[:start] + unescaped(shape.escape, data[start:stop], offset) + data[stop:]
        _refuse_short(shape, result)
        return result

    @staticmethod
    def _check_digits(parts: Iterable[PartLayout], numbers: Values, data: bytes) -> None:
        """Refuses bytes that are not the digits of a number; `numbers` has None for these."""
        for part in parts:
            if numbers[part.name] is None:
                assert part.value is not None
                raise CodecError("unknown_value", f"{part.name} is not {digits_text(part.value)}", part.at(len(data)))

    def _check_lengths(self, framed: FrameParts, numbers: Values, data: bytes, is_original: bool) -> None:
        for part in framed.lengths:
            if _is_sent(framed.shape, part) == is_original:
                continue
            number = numbers[part.name]
            announced = number * part.unit_size + part.base
            if announced != len(data):
                text = f"{part.name} is {number}, but the frame has {len(data)} bytes"
                if announced != number:
                    text = f"{part.name} is {number}, for a frame of {announced} bytes, but there are {len(data)}"
                raise CodecError("wrong_length", text, part.offset)

    def _check_sum(self, framed: FrameParts, numbers: Values, data: bytes, is_original: bool) -> None:
        for part in framed.checksums:
            if _is_sent(framed.shape, part) == is_original:
                continue
            actual, want = numbers[part.name], checksum_of(part, data)
            if actual != want:
                text = f"{part.name} is {checksum_text(actual, part)}, not {checksum_text(want, part)}"
                raise CodecError("wrong_checksum", text, part.at(len(data)))

    def _body(
        self, framed: FrameParts, head: Values, inner: bytes, message: str
    ) -> tuple[MessageLayout | None, RecordLayout, bool]:
        """The message and the record of the body that a head announces, with the data where messages share a code."""
        shape, part = framed.shape, framed.code
        error = self.link.link.exception_response
        if part is None:
            announced = self.link.carried(shape.direction).get(message)
            if announced is None:
                if message in self.link.messages:
                    raise CodecError("unknown_code", self._absence(message, shape.direction))
                raise CodecError("unknown_code", "the frame carries no code: say which message it belongs to")
            if error is not None and shape.direction == "response" and self._is_marked(head, inner):
                return announced, self.layout.records[error.record], True
            return announced, announced.data(shape.direction), False
        code = head[part.name]
        if error is not None and shape.direction == "response" and error.is_marked(code, head):
            head[part.name] = code & ~error.flag
            return self.link.refused_message(code & ~error.flag), self.layout.records[error.record], True
        announced = self.link.message_with_code(code, shape.direction, inner, message)
        if announced is None and code in self.link.ambiguous_codes(shape.direction):
            text = f"several messages have the code {code:#04x}, and only the request identifies the message"
            raise CodecError("unknown_code", text, part.offset)
        if announced is None:
            shared = self.link.subcodes(shape.direction).get(code)
            if shared is not None:
                text = f"no message with the code {code:#04x} has the subcode {shared.number(inner):#x}"
                raise CodecError("unknown_code", text, shape.header_size + shared.offset)
            raise CodecError("unknown_code", f"no message has the code {code:#04x}", part.offset)
        if message and announced.name != message:
            raise CodecError(
                "unknown_code", f"the code {code:#04x} is that of {announced.name}, not of {message}", part.offset
            )
        return announced, announced.data(shape.direction), False

    def _absence(self, message: str, direction: str) -> str:
        """Why a message has no frame in one direction."""
        return (
            f"{message} is not answered on {self.link.name}"
            if direction == "response"
            else f"only the device sends {message}"
        )

    def _is_marked(self, head: Values, inner: bytes) -> bool:
        """Whether a response without a code is an exception response, by a part or by its data."""
        if self.link.mark is not None:
            return self.link.mark.is_in(inner)
        error = self.link.link.exception_response
        return error is not None and error.is_marked(0, head)

    def encode(
        self, direction: str, message: str, values: Mapping[str, Any], *, error: bool = False, code: int | None = None
    ) -> bytes:
        """The frame of a message: the parts of its head and the fields of its body by name.

        For an error reply, `code` may stand in for a message that the device does not know. Raises CodecError.
        """
        shape = self.link.frame(direction)
        announced = self.link.messages.get(message)
        if announced is None and not (error and (code is not None or self.link.has_uncoded_exceptions)):
            raise CodecError("unknown_code", f"there is no message {message!r}")
        if not error and announced is not None and message not in self.link.carried(direction):
            raise CodecError("unknown_code", self._absence(message, direction))
        refusal = self.link.link.exception_response
        if error and refusal is None:
            raise CodecError("unknown_code", f"the link {self.link.name} has no error replies")
        body = (
            self.layout.records[refusal.record]
            if error and refusal
            else announced.data(direction)
            if announced
            else None
        )
        assert body is not None
        names = {part.name for part in shape.header}
        inner = encoded(body, {k: v for k, v in values.items() if k not in names}, self.layout.device)
        if direction == "request" and announced is not None:
            self._refuse_barred(shape, announced, values)
        if code is None and announced is not None:
            code = announced.message.code_of(direction)
        numbers: Values = {}
        for part in shape.parts:
            numbers[part.name] = self._head_value(part, values, error, code)
        coded = shape.role("code")
        if error and refusal and refusal.code is not None and coded and numbers[coded.name] != refusal.code:
            raise CodecError("unknown_code", f"an exception response has the code {refusal.code:#04x}")
        # What is escaped comes first: how many bytes are sent depends on all of its bytes.
        self._complete(direction, numbers, inner, False)
        if shape.escape is not None:
            self._complete(direction, numbers, inner, True)
        return self._marked(direction, self._joined(direction, numbers, inner, True))

    def _complete(self, direction: str, numbers: Values, inner: bytes, is_sent: bool) -> None:
        """Fills in the lengths and the checksums of the sent bytes, or of the bytes before escaping."""
        framed = self.framed[direction]
        for length in framed.lengths:
            if _is_sent(framed.shape, length) == is_sent:
                total = len(self._joined(direction, numbers, inner, is_sent))
                units = length.number(total)
                if units is None:
                    raise CodecError("wrong_length", f"{length.name} cannot say that the frame has {total} bytes")
                numbers[length.name] = units
        for check in framed.checksums:
            if _is_sent(framed.shape, check) == is_sent:
                numbers[check.name] = checksum_of(check, self._joined(direction, numbers, inner, is_sent))

    def _refuse_barred(self, shape: FrameLayout, message: MessageLayout, values: Mapping[str, Any]) -> None:
        """Refuses the broadcast address for a request that cannot be broadcast."""
        barred, part = self.link.barred_address(message), shape.role("unit_address")
        number = values.get(part.name) if part is not None else None
        if part is not None and barred is not None and isinstance(number, int) and number == barred:
            raise CodecError("out_of_range", f"{part.name} is {number}: {message.name} cannot be broadcast")

    def original_parts(self, frame: bytes, direction: str) -> bytes:
        """The binary form of a frame, before its bytes were escaped. Raises CodecError."""
        data, framed = self.parts(frame, direction), self.framed[direction]
        if framed.shape.escape is None:
            return data
        _refuse_short(framed.shape, data)
        return self._original(framed, data)

    def with_checksum(self, direction: str, parts: bytes) -> bytes:
        """The binary form of a frame with the checksums that are right for its other parts."""
        shape = self.link.frame(direction)
        for check in shape.checksums:
            offset = check.at(len(parts))
            data = self._escaped(shape, parts) if _is_sent(shape, check) else parts
            parts = parts[:offset] + check.checksum(data) + parts[offset + check.size :]
        return parts

    def joined_parts(self, direction: str, parts: bytes) -> bytes:
        """The frame of its binary form: escaped, as characters where the link has them, between its delimiters."""
        return self._marked(direction, self._escaped(self.link.frame(direction), parts))

    def _joined(self, direction: str, numbers: Values, body: bytes, is_sent: bool) -> bytes:
        """The parts of a frame as bytes, escaped where they are sent so."""
        framed = self.framed[direction]
        data = framed.data(numbers, body)
        return self._escaped(framed.shape, data) if is_sent else data

    @staticmethod
    def _escaped(shape: FrameLayout, data: bytes) -> bytes:
        """The bytes that are sent for the bytes of the parts."""
        if shape.escape is None:
            return data
        start, stop = shape.escape_start, len(data) + (shape.escape_stop or 0)
        return data[:start] + escaped(shape.escape, data[start:stop]) + data[stop:]

    def _head_value(self, part: PartLayout, values: Mapping[str, Any], error: bool, code: int | None) -> int | bytes:
        if part.role in ("length", "checksum"):
            return bytes(part.size) if part.digits else 0
        if part.constant is not None:
            number = values.get(part.name, part.constant)
            if number != part.constant:
                raise CodecError("wrong_const", f"{part.name} is {number}, not {part.constant}")
            return part.constant
        if part.role == "code":
            if code is None:
                raise CodecError("unknown_code", "the message has no code")
            refusal = self.link.link.exception_response
            own = code | (refusal.flag if error and refusal else 0)
            assert part.value is not None
            if not 0 <= own <= part.value.high:
                raise CodecError("unknown_code", f"{part.name} cannot be {own}")
            return own
        if part.name not in values:
            raise CodecError("missing_value", f"{part.name} is not given")
        number = values[part.name]
        if not isinstance(number, int):
            raise CodecError("wrong_type", f"{part.name} is a whole number, not {spec_text(number)}")
        assert part.value is not None
        refusal = self.link.link.exception_response
        marks = refusal is not None and refusal.part == part.name and part in self.link.response.header
        allowed = refusal.permitted(part.value, error) if refusal is not None and marks else part.value.ranges
        addresses = self.link.link.unit_addresses if part.role == "unit_address" else None
        if addresses is not None and addresses.ranges is not None:
            allowed = addresses.ranges
            if number == addresses.broadcast:
                return number
        if not part.value.low <= number <= part.value.high or (allowed is not None and number not in allowed):
            permitted = allowed.text() if allowed is not None else f"{part.value.low}..{part.value.high}"
            raise CodecError("out_of_range", f"{part.name} is {number}, not in {permitted}")
        return number

    def _marked(self, direction: str, data: bytes) -> bytes:
        shape = self.link.frame(direction)
        inner = data.hex().upper().encode("ascii") if self.link.link.transmission == "hex_ascii" else data
        return shape.further + shape.start + inner + shape.end


def _refuse_short(shape: FrameLayout, data: bytes) -> None:
    """Raises CodecError for fewer bytes than the parts around the body have."""
    minimum = shape.header_size + shape.trailer_size
    if len(data) < minimum:
        raise CodecError("incomplete", f"a frame has at least {minimum} bytes, not {len(data)}", len(data))


def _is_sent(shape: FrameLayout, part: PartLayout) -> bool:
    """Whether a length or a checksum is that of the bytes which are sent, not of those before they are escaped."""
    return shape.escape is not None and not part.before_escape


@dataclass(frozen=True, slots=True)
class DeviceCodec:
    """The codecs of the frames of all links of a device."""

    layout: DeviceLayout
    links: dict[str, FrameCodec]

    @property
    def records(self) -> dict[str, construct.Struct]:
        """The records and the data of messages, `<message>_request` and so on, that construct Structs can read."""
        data = (record for message in self.layout.messages.values() for record in message.bodies)
        records = (*self.layout.records.values(), *data)
        return {record.name: record_struct(record) for record in records if is_sequence(record)}


def codec(layout: DeviceLayout) -> DeviceCodec:
    """The reference codec of a device, by its layout."""
    return DeviceCodec(layout, {name: FrameCodec(layout, link) for name, link in layout.links.items()})
