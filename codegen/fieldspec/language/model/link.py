"""Links: the frames of one kind of line."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal

from fieldspec.foundation.classes import dataclass, field
from fieldspec.language.model.escape import Escape
from fieldspec.language.model.fact import Citation, Fact, Place
from fieldspec.language.model.preamble import Preamble
from fieldspec.language.model.ranges import Ranges, merged, uncovered
from fieldspec.language.model.value import Value


@dataclass(frozen=True, slots=True)
class PartSpan:
    """Neighbouring parts of a frame, by the names of the first and the last one; an empty name is not printed.

    With `before_escape`, a length or a checksum is that of their original bytes, although it is not escaped itself.
    """

    first: str
    last: str
    before_escape: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Part(Fact):
    """One part of a frame. Its role is unit_address, code, length, body, checksum or plain.

    `byte_order` is the byte order of a checksum, empty where the algorithm decides it. A checksum is sent as bytes, or
    as characters where `digits` says which. `span` is what a length
    counts, in units of `unit_size` bytes and `plus` more, or what a checksum covers. A `reserved` part has no meaning:
    its constant or 0 is sent, and anything is received. `same_as` names the part of the request that a part of the
    response repeats, else it is empty. `bits` are the first and the last bit of a part of an identifier, or of its
    own type; with `is_shared`, the part before it has other bits of the same bytes. The
    computation of `algorithm` begins after the `prefix` and ends after the `suffix`; `stated_algorithm` is the one
    that the spec states.
    """

    role: str
    value: Value | None
    algorithm: str
    byte_order: str
    span: PartSpan
    unit_size: int
    plus: int
    reserved: bool
    digits: str = ""
    same_as: str = ""
    bits: tuple[int, int] | None = None
    is_shared: bool = False
    prefix: bytes = b""
    suffix: bytes = b""
    stated_algorithm: str = ""


@dataclass(frozen=True, slots=True)
class ExceptionResponse:
    """The mark of an exception response, and the record in its body.

    The mark is the bits `flag` in the code of the request; or, where `flag` is 0, a `code` of its own, or a `part`
    before the body with a number that is not `normal`; or, where responses have no code, the constant of a `field` of
    the record.
    """

    flag: int
    record: str
    sources: tuple[Citation, ...] = field(default=(), repr=False)
    code: int | None = None
    part: str = ""
    normal: Ranges | None = None
    field: str = ""

    def is_marked(self, code: int, parts: Mapping[str, object]) -> bool:
        """Whether a response with a code and other parts before the body is an exception response."""
        if self.part:
            return self.normal is not None and self.part in parts and parts[self.part] not in self.normal
        return code == self.code if self.code is not None else bool(code & self.flag)

    @property
    def mark_text(self) -> str:
        """`bit 0x80`, `the code 0xFF`, `status other than 0`, `the constant of command`"""
        if self.field:
            return f"the constant of {self.field}"
        if self.part:
            return f"{self.part} other than {self.normal.text() if self.normal is not None else ''}"
        return f"the code {self.code:#04x}" if self.code is not None else f"bit {self.flag:#04x}"

    def permitted(self, value: Value, is_exception: bool) -> Ranges:
        """The numbers of the `part` in an exception response, or in any other; `value` is that of the part."""
        own = value.ranges.intervals if value.ranges is not None else ((value.type.low, value.type.high),)
        normal = merged(self.normal.intervals if self.normal is not None else ())
        if is_exception:
            return Ranges(tuple(hole for low, high in own for hole in uncovered(low, high, normal)))
        overlaps = [(max(low, first), min(high, last)) for low, high in own for first, last in normal]
        return Ranges(tuple((low, high) for low, high in overlaps if low <= high))


@dataclass(frozen=True, slots=True)
class UnitAddresses:
    """The unit addresses that stations on a line may have."""

    place: Place
    ranges: Ranges | None
    broadcast: int | None
    rule: str
    notes: tuple[str, ...]
    sources: tuple[Citation, ...]

    def intervals(self, direction: str) -> tuple[tuple[int, int], ...]:
        """The unit addresses in frames of one direction: the devices' addresses, and in requests the
        broadcast address.
        """
        known = self.ranges.intervals if self.ranges is not None else ()
        if direction != "request" or self.broadcast is None:
            return known
        return (*known, (self.broadcast, self.broadcast))


LARGEST_SET = 4096
"""How many unit addresses a framer has in a set; of more it has the intervals."""


@dataclass(frozen=True, slots=True)
class Serial:
    """The settings of a serial line; empty where the manual states none."""

    baud: tuple[int, ...]
    default_baud: int | None
    data_bits: tuple[int, ...]
    parity: tuple[str, ...]
    stop_bits: tuple[int, ...]
    start_bits: int | None
    sources: tuple[Citation, ...]
    default_data_bits: int | None = None
    default_parity: str = ""

    @property
    def factory_baud(self) -> int:
        """The baud rate with factory settings, as far as it is stated."""
        return self.default_baud or next(iter(self.baud), 9600)

    @property
    def factory_data_bits(self) -> int:
        """The number of data bits with factory settings, as far as it is stated."""
        return self.default_data_bits or max(self.data_bits, default=8)

    @property
    def factory_parity(self) -> str:
        """The parity with factory settings, as far as it is stated."""
        return self.default_parity or next(iter(self.parity), "none")

    @property
    def factory_stop_bits(self) -> int:
        """The number of stop bits with factory settings, as far as it is stated."""
        return next(iter(self.stop_bits), 1)


@dataclass(frozen=True, slots=True)
class Network:
    """The ports on which the device listens, by protocol; None where the manual states none."""

    tcp: int | None
    udp: int | None
    sources: tuple[Citation, ...]

    @property
    def ports(self) -> tuple[tuple[str, int], ...]:
        """The stated ports: `("tcp", 502)`."""
        protocol_ports = (("tcp", self.tcp), ("udp", self.udp))
        return tuple((protocol, port) for protocol, port in protocol_ports if port is not None)


@dataclass(frozen=True, slots=True, kw_only=True)
class Link(Fact):
    """A frame: `start`, the parts, encoded and escaped, `end`. Requests go to the device, responses come from it.

    The least bytes of a `preamble` are the first ones of `start`. The delimiters of a response are `response_start` and
    `response_end`, in a request they are `start` and `end`; mostly they are the same. `message_name`, `request_name`
    and `response_name` are the manual's names of a message and of the two directions. A device with factory settings
    uses the link that `is_default`.
    """

    title: str
    transmission: str
    start: bytes
    end: bytes
    response_start: bytes
    response_end: bytes
    byte_order: str
    word_order: str
    request: tuple[Part, ...]
    response: tuple[Part, ...]
    message_name: str
    request_name: str
    response_name: str
    exception_response: ExceptionResponse | None
    unit_addresses: UnitAddresses | None
    serial: Serial | None
    silence_characters: Decimal | None
    silence_milliseconds: Decimal | None
    silence_sources: tuple[Citation, ...]
    escape: Escape | None = None
    preamble: Preamble | None = None
    network: Network | None = None
    is_default: bool = False

    @property
    def ports(self) -> tuple[tuple[str, int], ...]:
        """The ports of a network on which the device listens: `("tcp", 502)`."""
        return self.network.ports if self.network is not None else ()

    def marks(self, direction: str) -> tuple[bytes, bytes]:
        """The delimiters in a direction without a preamble."""
        start, end = self.delimiters(direction)
        return start[self.preamble.least if self.preamble is not None else 0 :], end

    @property
    def sends_characters(self) -> bool:
        """Whether people write its frames as characters: parts of them are digits, or all bytes are."""
        values = (part.value for part in (*self.request, *self.response))
        return self.transmission == "hex_ascii" or any(value is not None and value.has_characters for value in values)

    def opening(self, direction: str) -> bytes:
        """The bytes with which each frame in a direction begins: the start delimiter, else a first constant byte."""
        start, _ = self.marks(direction)
        first = next(iter(self.parts(direction)), None)
        value = first.value if first is not None and not first.reserved else None
        if start or value is None or value.const is None or value.size != 1 or value.packed_bits:
            return start
        return bytes((value.const & 0xFF,))

    @property
    def openings(self) -> dict[str, str]:
        """What people see at the beginning of frames that they write as characters, by direction."""
        if not self.sends_characters:
            return {}
        marks = {direction: self.opening(direction).decode("latin-1") for direction in ("request", "response")}
        return {direction: mark for direction, mark in marks.items() if mark and mark.isprintable()}

    @property
    def is_can(self) -> bool:
        """Whether the link is on a CAN bus."""
        return self.escape is not None and self.escape.method == "can"

    def span(self, direction: str, part: Part) -> tuple[int, int] | None:
        """The indices of the first and the last part that a length counts or a checksum covers; None for unknown names.

        Without names, a length counts the whole frame, and a checksum covers everything before it. A span that begins
        after its own part extends to the end of the frame.
        """
        parts = self.parts(direction)
        names = [inner.name for inner in parts]
        if not {part.span.first, part.span.last} <= {"", *names}:
            return None
        own, end = names.index(part.name), len(parts) - 1
        first = self.word_start(direction, names.index(part.span.first) if part.span.first else 0)
        last = own - 1 if part.role == "checksum" and first <= own else end
        return first, names.index(part.span.last) if part.span.last else last

    def escaped_span(self, direction: str) -> tuple[int, int] | None:
        """The indices of the first and the last escaped part; None for unknown names, and without an escape."""
        parts = self.parts(direction)
        names = [part.name for part in parts]
        if self.escape is None or not {self.escape.first, self.escape.last} <= {"", *names}:
            return None
        first = self.word_start(direction, names.index(self.escape.first) if self.escape.first else 0)
        return first, names.index(self.escape.last) if self.escape.last else len(parts) - 1

    def word_start(self, direction: str, index: int) -> int:
        """The index of the first part in the bytes of a part."""
        parts = self.parts(direction)
        while parts[index].is_shared:
            index -= 1
        return index

    def delimiters(self, direction: str) -> tuple[bytes, bytes]:
        """The bytes that open and close a frame in one direction."""
        return (self.start, self.end) if direction == "request" else (self.response_start, self.response_end)

    @property
    def has_common_delimiters(self) -> bool:
        """Whether the frames of both directions have the same delimiters."""
        return self.delimiters("request") == self.delimiters("response")

    def parts(self, direction: str) -> tuple[Part, ...]:
        """The parts of a frame in one direction."""
        return self.request if direction == "request" else self.response

    def direction_name(self, direction: str) -> str:
        """The name of a direction in the manual."""
        return self.request_name if direction == "request" else self.response_name
