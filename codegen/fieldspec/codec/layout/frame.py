"""The parts of a frame with their offsets, and message data."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from fieldspec.codec.layout.escapes import original_places
from fieldspec.codec.layout.exception_mark import ExceptionMark, exception_mark
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.part import PartLayout
from fieldspec.codec.layout.record import Orders, RecordLayout
from fieldspec.codec.layout.remote_requests import with_remote_codes
from fieldspec.codec.layout.subcodes import Subcode, subcode
from fieldspec.foundation.classes import dataclass, field, replace
from fieldspec.language.model.digits import digit_bounds
from fieldspec.language.model.escape import CAN_REMOTE, Escape
from fieldspec.language.model.link import Link
from fieldspec.language.model.preamble import Preamble
from fieldspec.language.model.sizes import part_size, sent_on


def original_parts(frame: FrameLayout, data: bytes) -> bytes:
    """The bytes of the parts before they were escaped. Raises EscapeError."""
    if frame.escape is None:
        return data
    start, stop = frame.escape_start, len(data) + (frame.escape_stop or 0)
    return data[:start] + bytes(byte for byte, _ in original_places(frame.escape, data[start:stop])) + data[stop:]


def _covers(checksum: PartLayout, other: PartLayout) -> bool:
    """Whether a checksum covers another part. Offsets from the start come before the body, those from the end after."""
    start, stop = _rank(checksum.start), (1, 0) if checksum.stop is None else _rank(checksum.stop)
    return other is not checksum and start <= _rank(other.offset) < stop


def _rank(offset: int) -> tuple[int, int]:
    return (1, offset) if offset < 0 else (0, offset)


@dataclass(frozen=True, slots=True)
class FrameLayout:
    """The parts before the body, `header_size` bytes; then the body; then `trailer_size` bytes.

    All sizes count bytes of the parts, before these are encoded as characters and put between delimiters. The
    `escape` changes the bytes from `escape_start` to `escape_stop`, which are the bounds of a slice as in `PartLayout`.
    `start` and `end` are the delimiters. Those of a `preamble` that every receiver demands are the first of `start`.
    """

    direction: str
    header: tuple[PartLayout, ...]
    header_size: int
    trailer: tuple[PartLayout, ...]
    trailer_size: int
    escape: Escape | None = None
    escape_start: int = 0
    escape_stop: int | None = None
    start: bytes = b""
    end: bytes = b""
    preamble: Preamble | None = None

    @property
    def is_marked(self) -> bool:
        """Whether bytes around the parts show where a frame is."""
        return bool(self.start or self.end or self.preamble)

    @property
    def further(self) -> bytes:
        """The bytes that a sender sends before the start delimiter."""
        return self.preamble.further if self.preamble is not None else b""

    def surplus(self, frame: bytes) -> int:
        """How many bytes of a preamble a frame has before the start delimiter."""
        return self.preamble.surplus(frame) if self.preamble is not None else 0

    def as_sent(self, frame: bytes) -> bytes:
        """A frame with its preamble as long as it is sent."""
        return self.further + frame[self.surplus(frame) :]

    @property
    def parts(self) -> tuple[PartLayout, ...]:
        """All parts but the body, in the order in which they are sent."""
        return (*self.header, *self.trailer)

    def stated_number(self, part: PartLayout, number: int) -> int:
        """The number of a part as people know it: the code of a remote request without its bit."""
        has_remote = part.role == "code" and self.escape is not None and self.escape.remote is not None
        return number & ~CAN_REMOTE if has_remote else number

    def numbers(self, data: bytes) -> dict[str, int]:
        """The numbers of the whole parts before the body, by name; -1 for what is not the digits of a number."""
        numbers = {}
        for part in self.header:
            if part.value is not None and part.offset + part.size <= len(data):
                number = part.read(data[part.offset : part.offset + part.size])
                numbers[part.name] = -1 if number is None else number
        return numbers

    def role(self, role: str) -> PartLayout | None:
        """The first part with a role, None if there is none."""
        return next((part for part in self.parts if part.role == role), None)

    @property
    def lengths(self) -> tuple[PartLayout, ...]:
        """The parts that count bytes, in the order of the wire. Where a frame ends in a stream, the first one tells."""
        return tuple(part for part in self.header if part.role == "length")

    @property
    def checksum(self) -> PartLayout | None:
        """The only checksum, or the first of several in the order in which they are computed; None without one."""
        return next(iter(self.checksums), None)

    @property
    def checksums(self) -> tuple[PartLayout, ...]:
        """All checksums in the order in which they are computed: each after those that it covers."""
        waiting = sorted(
            (part for part in self.parts if part.role == "checksum"), key=lambda part: not part.before_escape
        )
        computed: list[PartLayout] = []
        while waiting:
            ready = next((part for part in waiting if not any(_covers(part, other) for other in waiting)), waiting[0])
            waiting.remove(ready)
            computed.append(ready)
        return tuple(computed)

    @property
    def digits(self) -> tuple[PartLayout, ...]:
        """The parts that are sent as digits, of which a receiver refuses any other bytes."""
        return tuple(part for part in self.parts if part.form and not part.reserved)

    @property
    def constants(self) -> tuple[PartLayout, ...]:
        """The parts whose constants a receiver checks."""
        return tuple(part for part in self.parts if part.constant is not None and not part.reserved)


@dataclass(frozen=True, slots=True)
class LinkLayout:
    """The frames of a link in both directions, and its messages.

    `mark` is what the data of exception responses have where frames carry no code; None without such responses.
    `known` are all messages where an output leaves out some, which it still tells from the others; else it is empty.
    """

    link: Link
    name: str
    request: FrameLayout
    response: FrameLayout
    messages: Mapping[str, MessageLayout]
    mark: ExceptionMark | None = None
    known: Mapping[str, MessageLayout] = field(default_factory=dict)

    def messages_with_code(self, code: int, direction: str = "request") -> list[MessageLayout]:
        """The messages with a code in one direction; several differ in a constant in their data."""
        return [message for message in self._all_messages(direction) if message.message.code_of(direction) == code]

    def refused_message(self, code: int, request_name: str = "") -> MessageLayout | None:
        """The message that an exception response with a code refuses.

        Several messages may have the code, and exception responses have no data that tell them apart: `asked` names
        the message of the request. None if there is no such message, and where this leaves open which one it is.
        """
        messages = [message for message in self._all_messages("request") if message.message.code_of("response") == code]
        requested = (message for message in messages if message.name == request_name)
        return messages[0] if len(messages) == 1 else next(requested, None)

    def codes(self, direction: str) -> list[int]:
        """The codes of the messages in one direction, in ascending order."""
        codes = (message.message.code_of(direction) for message in self.carried(direction).values())
        return sorted({code for code in codes if code is not None})

    @property
    def has_response_codes(self) -> bool:
        """Whether the code of some response differs from its request's code."""
        return any(message.message.has_response_code for message in self.carried("response").values())

    def message_with_code(
        self, code: int, direction: str = "request", data: bytes | None = None, request_name: str = ""
    ) -> MessageLayout | None:
        """The message with a code in one direction, and with some data where several have the code.

        `request_name` names the message of the request, which decides where nothing in the data does. None if there is
        none, and where all of this leaves open which one it is.
        """
        messages = self.messages_with_code(code, direction)
        if len(messages) < 2:
            return messages[0] if messages else None
        shared = subcode(messages, direction)
        if shared is None:
            return next((message for message in messages if message.name == request_name), None)
        return shared.message(data) if data is not None else None

    def shared_codes(self, direction: str) -> list[int]:
        """The codes that several messages have in one direction."""
        codes: set[int] = set()
        shared: set[int] = set()
        for message in self._all_messages(direction):
            if (code := message.message.code_of(direction)) is not None:
                (shared if code in codes else codes).add(code)
        return sorted(shared)

    def ambiguous_codes(self, direction: str) -> dict[int, list[MessageLayout]]:
        """The messages by the code that they share where nothing in their data tells them apart.

        These are responses: their requests identify a response.
        """
        if self.frame(direction).role("code") is None:
            return {}
        groups = ((code, self.messages_with_code(code, direction)) for code in self.shared_codes(direction))
        return {code: messages for code, messages in groups if subcode(messages, direction) is None}

    def is_guessed(self, direction: str, message: str) -> bool:
        """Whether a frame does not tell that it is one of a message: it carries no code, or an ambiguous one."""
        if self.frame(direction).role("code") is None:
            return True
        code = self.messages[message].message.code_of(direction) if message in self.messages else None
        return code in self.ambiguous_codes(direction)

    def announced(self, code: int | None, data: bytes, message: str) -> MessageLayout | None:
        """The message of a request with a code and some data, or the named one where frames carry no code."""
        return self.carried("request").get(message) if code is None else self.message_with_code(code, "request", data)

    def subcodes(self, direction: str) -> dict[int, Subcode]:
        """The subcodes of messages that share a code, by this code."""
        shared = self.shared_codes(direction)
        pairs = ((code, subcode(self.messages_with_code(code, direction), direction)) for code in shared)
        return {code: shared_code for code, shared_code in pairs if shared_code is not None}

    def code_text(self, message: MessageLayout, direction: str) -> str:
        """`0x08`, or `0x08 with 0x0001 at byte 2` for a message that shares its code."""
        code = message.message.code_of(direction)
        if code is None:
            return "no code"
        part = self.frame(direction).role("code")
        remote = code & CAN_REMOTE if self.link.is_can else 0
        text = f"0x{code ^ remote:02X}" if part is None or not part.form else part.number_text(code)
        text += " as a remote request" if remote else ""
        shared = self.subcodes(direction).get(code)
        if shared is None:
            return text
        shape = self.frame(direction)
        place = shape.header_size + shared.offset
        if remote:
            return f"{text} for {' or '.join(shared.texts_of(message))} bytes"
        byte = f"byte {place}" if shape.escape is None else shape.escape.byte_text(place)
        return f"{text} with {' or '.join(shared.texts_of(message))} at {byte}"

    def carried(self, direction: str) -> Mapping[str, MessageLayout]:
        """The messages of one direction on the link: those that users send, and those that the device sends."""
        if direction == "request":
            return {name: message for name, message in self.messages.items() if message.message.is_requested}
        return {name: message for name, message in self.messages.items() if message.message.is_answered_on(self.name)}

    def _all_messages(self, direction: str) -> Iterable[MessageLayout]:
        """The messages in one direction, those too that an output leaves out."""
        link = replace(self, messages=self.known, known={}) if self.known else self
        return link.carried(direction).values()

    @property
    def exchanged(self) -> Mapping[str, MessageLayout]:
        """The messages whose requests are answered on the link."""
        return {name: message for name, message in self.carried("response").items() if message.message.is_requested}

    @property
    def open_identifier(self) -> str:
        """The part of a request's identifier on a CAN bus that users supply; empty where there is none.

        A client cannot choose it: another number is that of another device, or of another service.
        """
        arguments = (part for part in self.request.header if part.role == "plain" and part.is_argument)
        return next((part.name for part in arguments if part.part.bits is not None), "")

    @property
    def has_uncoded_exceptions(self) -> bool:
        """Whether a part or the data mark exception responses, as no response carries a code."""
        return self.link.exception_response is not None and self.response.role("code") is None

    def barred_address(self, message: MessageLayout) -> int | None:
        """The broadcast address, where the spec says that a request cannot be sent to it; None where it may be sent."""
        addresses, part = self.link.unit_addresses, self.request.role("unit_address")
        if message.message.broadcast is not False or addresses is None or part is None or not part.is_argument:
            return None
        return addresses.broadcast

    def framed_addresses(self, direction: str) -> tuple[tuple[int, int], ...]:
        """The intervals of the unit addresses that frames in one direction have: other bytes begin none of them.

        They are empty where all bytes are a unit address. Where only digits are one, they have all of their numbers.
        """
        addresses, part = self.link.unit_addresses, self.frame(direction).role("unit_address")
        if part is None or part.value is None:
            return ()
        if addresses is not None and addresses.ranges is not None:
            return addresses.intervals(direction)
        return (digit_bounds(part.value),) if part.form else ()

    @property
    def barred_messages(self) -> list[str]:
        """The names of the messages whose requests cannot be broadcast."""
        return [name for name, message in self.messages.items() if self.barred_address(message) is not None]

    def frame(self, direction: str) -> FrameLayout:
        """The frame in one direction."""
        return self.request if direction == "request" else self.response


def link_layout(link: Link, messages: Mapping[str, MessageLayout], records: Mapping[str, RecordLayout]) -> LinkLayout:
    """The layout of a link. `messages` are the messages of all links of the device, `records` all its records."""
    link_messages = {name: message for name, message in messages.items() if sent_on(link, message.message)}
    if any(message.message.remote is not None for message in link_messages.values()):
        link = with_remote_codes(link)
    exception = link.exception_response
    mark = exception_mark(exception, records.get(exception.record) if exception is not None else None)
    return LinkLayout(link, link.name, _frame(link, "request"), _frame(link, "response"), link_messages, mark)


def _frame(link: Link, direction: str) -> FrameLayout:
    parts = link.parts(direction)
    orders = Orders(link.byte_order or "big", link.word_order or link.byte_order or "big")
    sizes = [part_size(part) for part in parts]
    body = next((number for number, part in enumerate(parts) if part.role == "body"), len(parts))
    parts_size = sum(sizes)

    def place(number: int) -> int:
        """The offset of a part: from the start; from the end and negative if the part comes after the body."""
        number = link.word_start(direction, number)
        return sum(sizes[:number]) if number <= body else sum(sizes[:number]) - parts_size

    def stop_of(last: int) -> int | None:
        """The bound after a part, None for the end of the frame."""
        return sum(sizes[: last + 1]) if last < body else sum(sizes[: last + 1]) - parts_size or None

    escaped = link.escaped_span(direction)
    placed = []
    for number, part in enumerate(parts):
        first, last = link.span(direction, part) or (0, len(parts) - 1)
        stop = stop_of(last)
        is_escaped = escaped is not None and escaped[0] <= number <= escaped[1]
        value = part.value
        order = (part.byte_order or "little") if part.algorithm else orders.of(value)[0]
        fill = (value.const or 0 if part.reserved else value.const) if value and part.role == "plain" else None
        placed.append(
            PartLayout(
                part,
                part.name,
                part.role,
                place(number),
                sizes[link.word_start(direction, number)],
                value,
                part.algorithm,
                order,
                start=place(first) if part.role == "checksum" else 0,
                stop=stop if part.role == "checksum" else None,
                unit_size=part.unit_size,
                base=parts_size - sum(sizes[first : last + 1]) - part.plus * part.unit_size
                if part.role == "length"
                else 0,
                constant=fill,
                reserved=part.reserved,
                digits=part.digits,
                escaped=is_escaped,
                before_escape=is_escaped or (escaped is not None and part.span.before_escape),
                shift=part.bits[0] if part.bits is not None and not link.is_can else 0,
            )
        )
    header, trailer = tuple(placed[:body]), tuple(placed[body + 1 :])
    start, end = link.delimiters(direction)
    sizes_around = sum(sizes[:body]), sum(sizes[body + 1 :])
    shape = FrameLayout(
        direction, header, sizes_around[0], trailer, sizes_around[1], None, 0, None, start, end, link.preamble
    )
    if escaped is None:
        return shape
    return replace(shape, escape=link.escape, escape_start=place(escaped[0]), escape_stop=stop_of(escaped[1]))
